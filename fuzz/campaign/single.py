"""scripts/fuzz: one target for some seconds, in the foreground."""

import os
import re
import sys
from pathlib import Path

from campaign import build, engine_libfuzzer
from campaign.programs import UsageError, choose
from campaign.turn import Limits

_UNUSABLE = 2  # exit code


def _arguments(words):
    known = build.listed_targets()
    if len(words) != 2:
        raise UsageError(f"usage: scripts/fuzz TARGET SECONDS (targets: {' '.join(known)})")
    target, seconds = words
    choose(known, [target])
    if not re.fullmatch("[1-9][0-9]*", seconds):
        raise UsageError(f"'{seconds}' is no number of seconds")
    return target, int(seconds)


def main(words):
    """Does not return where the fuzzer runs: exit code and Ctrl-C are the fuzzer's own."""
    try:
        target, seconds = _arguments(words)
        print("building the fuzzer", flush=True)
        programs, *_ = build.fuzzers(engine_libfuzzer, [target], os.cpu_count() or 1)
        directory = build.directory_of(engine_libfuzzer)
        corpus, seeds, findings = (Path(directory, name)
                                   for name in (f"corpus/{target}", f"seeds/{target}", "findings"))
        for path in (corpus, findings):
            path.mkdir(parents=True, exist_ok=True)
        programs.write_seeds(target, seeds)
    except (UsageError, OSError) as error:
        print(error, file=sys.stderr)
        return _UNUSABLE
    command = engine_libfuzzer.fuzz_command(programs, target, seconds, Limits(), findings,
                                            [corpus, seeds])
    os.execv(command[0], list(map(str, command)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
