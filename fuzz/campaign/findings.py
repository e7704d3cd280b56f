"""Failing inputs, one of each kind of failure: named by what they have in common, minimised and put
in words. A finding is a directory:

    input        as the engine found it
    minimised    the same failure, shorter; absent where nothing shorter was found
    script.txt   the shortest of them in words
    output.txt   what the fuzzer prints for it
    finding.json target, kind, signature, how often it was found
"""

import hashlib
import os
import shutil
import threading
from dataclasses import asdict, dataclass
from pathlib import Path

from campaign import child, durable, signature
from campaign.programs import UsageError

MINIMISE_SECONDS = 120


@dataclass
class Finding:
    target: str
    kind: str  # crash, timeout, oom or leak
    signature: str
    times: int = 1
    reproduces: bool = True
    minimised: bool = False  # whether it was tried; shorter or not

    def name(self):
        return f"{self.kind}-{hashlib.sha1(self.signature.encode()).hexdigest()[:10]}"


class Findings:
    def __init__(self, directory, programs, engine, limits):
        self.directory = directory
        self._programs, self._engine, self._limits = programs, engine, limits
        self._lock = threading.Lock()  # one failing input after the other
        self.all = {}  # (target, name) -> Finding
        self.unreadable = []  # what is wrong with records of findings
        for path in sorted(directory.glob("*/*/finding.json")):
            try:
                finding = Finding(**durable.read_json(path))
                self.all[finding.target, finding.name()] = finding
            except (ValueError, TypeError) as error:
                self.unreadable.append(f"{path}: {error}; it counts as not found yet")

    def of(self, target):
        return [finding for finding in list(self.all.values()) if finding.target == target]

    def path(self, finding):
        return self.directory / finding.target / finding.name()

    def shortest(self, finding):
        minimised = self.path(finding) / "minimised"
        return minimised if minimised.exists() else self.path(finding) / "input"

    def take(self, target, kind, path, printed, stop):
        """Records the failing input; the finding where it is a new one. printed: what the engine
        printed when it found it, for inputs that do not fail a second time."""
        with self._lock:
            scratch = self.directory / f".{target}.part"
            shutil.rmtree(scratch, ignore_errors=True)
            scratch.mkdir(parents=True)
            shutil.copyfile(path, scratch / "input")
            code, output = self._run(target, scratch / "input", scratch / "output.txt", stop)
            if stop.is_set() and code is None:
                return None  # it stays where it is, for the next start
            reproduces = code != 0
            if not reproduces:
                (scratch / "output.txt").write_text(printed, encoding="utf-8")
            name = signature.of(kind, output if reproduces else printed)
            finding = Finding(target, kind, name, reproduces=reproduces)
            known = self.all.get((target, finding.name()))
            if known is not None:
                shutil.rmtree(scratch)
                known.times += 1
                self._save(known)
                return None
            (scratch / "script.txt").write_text(self._words(target, path), encoding="utf-8")
            durable.write_json(scratch / "finding.json", asdict(finding))
            self.path(finding).parent.mkdir(parents=True, exist_ok=True)
            shutil.rmtree(self.path(finding), ignore_errors=True)
            os.replace(scratch, self.path(finding))
            self.all[target, finding.name()] = finding
            self._minimise(finding, stop)
            return finding

    def minimise_rest(self, stop):
        """What an earlier start had no time for."""
        with self._lock:
            for finding in list(self.all.values()):
                if not finding.minimised:
                    self._minimise(finding, stop)

    def _minimise(self, finding, stop):
        """By the tool, or by the engine where the tool sees nothing fail. Keeps the result if it
        fails in the same way, seen by a run of its own."""
        if stop.is_set() or not finding.reproduces:
            return
        directory = self.path(finding)
        result, log = directory / "minimised.part", directory / "minimise.log"
        for command in (self._programs.minimise_command(finding.target, directory / "input", result),
                        self._engine.minimise_command(self._programs, finding.target,
                                                      directory / "input", result)):
            if command and not result.exists():
                child.run(command, log, stop, seconds=MINIMISE_SECONDS)
        if stop.is_set():
            return
        if result.exists():
            code, output = self._run(finding.target, result, log, stop)
            shorter = result.stat().st_size < (directory / "input").stat().st_size
            if code != 0 and shorter and signature.of(finding.kind, output) == finding.signature:
                words = self._words(finding.target, result)
                (directory / "script.txt").write_text(words, encoding="utf-8")
                (directory / "output.txt").write_text(output, encoding="utf-8")
                os.replace(result, directory / "minimised")
            result.unlink(missing_ok=True)
        log.unlink(missing_ok=True)
        finding.minimised = True
        self._save(finding)

    def _run(self, target, path, log, stop):
        """(exit code, output) of the fuzzer on this input alone."""
        command = self._engine.reproduce_command(self._programs, target, path, self._limits)
        code = child.run(command, log, stop, seconds=3 * self._limits.input_seconds + 10)
        return code, Path(log).read_text(encoding="utf-8", errors="replace")

    def _words(self, target, path):
        try:
            return self._programs.show(target, path)
        except UsageError as error:
            return f"{error}\n"

    def _save(self, finding):
        durable.write_json(self.path(finding) / "finding.json", asdict(finding))
