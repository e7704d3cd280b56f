"""A turn: one target has one job for a while."""

import shutil
import time
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from campaign import child
from campaign.programs import Programs
from campaign.schedule import LEAST_SECONDS

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

    def run(self, until, stop, tick, on_failing_input):
        """Runs the engine until that moment of the monotonic clock; again where it stopped at a
        failing input. It is ended if it takes longer than one input may: reading its seeds, an
        engine does not look at the time. Returns a complaint where it does not run at all."""
        self.work.mkdir(parents=True)
        self.engine.prepare(self)
        runs = in_vain = 0
        while not stop.is_set():
            left = until - time.monotonic()
            if runs > 0 and left < LEAST_SECONDS:
                break
            runs += 1
            before = len(self.engine.artifacts(self.work))
            output = self.work / f"run-{runs}.log"
            code = child.run(self.engine.command(self, left), output, stop,
                             self.engine.environment(), left + self.limits.input_seconds, tick)
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

    def merge(self, seconds, stop):
        """A directory with a part of the corpus that covers as much; None where that failed, or
        took too long."""
        merged = self.work / "merged"
        merged.mkdir()
        code = child.run(self.engine.merge_command(self, merged), self.work / "merge.log", stop,
                         self.engine.environment(), seconds)
        if code != 0 or not any(merged.iterdir()):
            return None
        return merged

    def remove(self):
        shutil.rmtree(self.work, ignore_errors=True)


def last_line(path):
    lines = path.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return lines[-1] if lines else "it printed nothing"
