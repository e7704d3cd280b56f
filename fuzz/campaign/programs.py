"""The built programs: one fuzzer a target, and tightflip_fuzz, which writes seeds, replays,
minimises and puts inputs in words. Any directory with programs of these names serves."""

import os
import shutil
import subprocess
from pathlib import Path

TOOL = "tightflip_fuzz"


class UsageError(Exception):
    """The campaign cannot start as asked; the text says why, and what would help."""


def choose(known, wanted):
    """The names asked for, all where none is. UsageError lists those that there are."""
    unknown = [name for name in wanted if name not in known]
    if unknown:
        raise UsageError(f"there is no target {', '.join(unknown)}; there are: {', '.join(known)}")
    return list(dict.fromkeys(wanted)) or list(known)


class Programs:
    def __init__(self, directory, dictionaries, environment=None):
        """environment: what the tool runs with besides the campaign's own."""
        self.directory = Path(directory).resolve()
        self.dictionaries = Path(dictionaries)
        self._environment = os.environ | (environment or {})
        self.tool = self.directory / TOOL
        if not self.tool.is_file():
            raise UsageError(f"there is no program {self.tool}")

    def fuzzer(self, target):
        return self.directory / f"{target}_fuzzer"

    def dictionary(self, target):
        """The dictionary of a text target, or None."""
        path = self.dictionaries / f"{target}.dict"
        return path if path.is_file() else None

    def targets(self):
        """Names and descriptions in the order of the tool's table."""
        done = self._ask("list")
        pairs = (line.partition("\t") for line in done.stdout.decode().splitlines() if line)
        return {name: description for name, _, description in pairs}

    def require_fuzzers(self, targets):
        missing = [name for name in targets if not self.fuzzer(name).is_file()]
        if missing:
            raise UsageError(f"no fuzzer in {self.directory} for: {', '.join(missing)}")

    def write_seeds(self, target, directory):
        """Anew, as this version has them."""
        shutil.rmtree(directory, ignore_errors=True)
        directory.mkdir(parents=True)
        self._ask("seeds", target, directory)

    def show(self, target, path):
        """The input in words."""
        return self._ask("show", target, path).stdout.decode(errors="replace")

    def minimise_command(self, target, path, result):
        return [self.tool, "minimise", target, path, result]

    def replay_command(self, target, paths):
        return [self.tool, "replay", target, *paths]

    def _ask(self, *words):
        try:
            return subprocess.run([self.tool, *words], stdin=subprocess.DEVNULL, check=True,
                                  capture_output=True, timeout=600, env=self._environment)
        except subprocess.CalledProcessError as error:
            last = error.stderr.decode(errors="replace").strip().splitlines()[-1:]
            raise UsageError(f"{TOOL} {words[0]} ended with {error.returncode}: "
                             + "".join(last)) from error
        except (OSError, subprocess.TimeoutExpired) as error:
            raise UsageError(f"{TOOL} {words[0]}: {error}") from error
