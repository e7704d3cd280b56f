"""A turn: one target has one job for a while."""

import shutil
import time
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from campaign import child
from campaign.programs import Programs

LEAST_SECONDS = 1.0
_ENDED_AT_ONCE = 3  # runs in a row that end before their time and leave no failing input


@dataclass
class Limits:
    """Of one input; beyond them it is a finding."""

    input_seconds: int = 10
    megabytes: int = 2048


@dataclass
class Turn:
    target: str
    engine: ModuleType
    programs: Programs
    work: Path  # of this turn alone; removed once everything in it is taken over
    corpus: Path
    seeds: Path
    limits: Limits

    def run(self, seconds, stop, tick, on_failing_input):
        """Runs the engine until the time is over; again where it stopped at a failing input.
        Returns a complaint where the engine does not run at all."""
        self.work.mkdir(parents=True)
        self.engine.prepare(self)
        until = time.monotonic() + seconds
        runs = in_vain = 0
        while not stop.is_set() and until - time.monotonic() >= LEAST_SECONDS:
            runs += 1
            left = until - time.monotonic()
            before = len(self.engine.artifacts(self.work))
            output = self.work / f"run-{runs}.log"
            code = child.run(self.engine.command(self, left), output, stop,
                             self.engine.environment(), left + 60, tick)
            if len(self.engine.artifacts(self.work)) > before:
                in_vain = 0
                on_failing_input(self)
            elif code == 0:
                break
            elif code is not None:
                in_vain += 1
                if in_vain == _ENDED_AT_ONCE:
                    return f"the engine ended with {code}: {last_line(output)}"
        return None

    def merge(self, stop):
        """A directory with a part of the corpus that covers as much; None where that failed."""
        merged = self.work / "merged"
        merged.mkdir()
        code = child.run(self.engine.merge_command(self, merged), self.work / "merge.log", stop,
                         self.engine.environment())
        if code != 0 or not any(merged.iterdir()):
            return None
        return merged

    def remove(self):
        shutil.rmtree(self.work, ignore_errors=True)


def last_line(path):
    lines = path.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return lines[-1] if lines else "it printed nothing"
