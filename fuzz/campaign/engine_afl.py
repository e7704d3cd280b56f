"""AFL++ as the engine, on the same entry points: afl-clang-fast++ links its own driver for
-fsanitize=fuzzer."""

import os

from campaign import corpus
from campaign.engine_libfuzzer import Progress

NAME = "afl"
MOST_ARTIFACTS = 50  # of one turn: AFL++ keeps a crash for every new path to it
_KINDS = {"crashes": "crash", "hangs": "timeout"}


def environment():
    """No screen and no questions; AFL++ insists on sanitizers that abort without a symbolizer.
    Unless allowed to, afl-cmin refuses to work below /tmp, where a campaign may be."""
    sanitizer = "abort_on_error=1:symbolize=0:halt_on_error=1"
    return {"AFL_NO_UI": "1", "AFL_SKIP_CPUFREQ": "1", "AFL_NO_AFFINITY": "1",
            "AFL_ALLOW_TMP": "1", "AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES": "1",
            "ASAN_OPTIONS": f"{sanitizer}:detect_leaks=0:allocator_may_return_null=1",
            "UBSAN_OPTIONS": sanitizer}


def command(turn, seconds):
    dictionary = turn.programs.dictionary(turn.target)
    return ["afl-fuzz", "-i", turn.work / "in", "-o", turn.work / "out",
            "-V", max(1, round(seconds)), "-m", "none", "-t", f"{turn.limits.input_seconds * 1000}",
            *(["-x", dictionary] if dictionary else []), "--", turn.programs.fuzzer(turn.target)]


def reproduce_command(programs, target, path, given):
    return [programs.fuzzer(target), path]


def minimise_command(programs, target, path, result):
    return ["afl-tmin", "-m", "none", "-i", path, "-o", result, "--", programs.fuzzer(target)]


def merge_command(turn, merged):
    return ["afl-cmin", "-m", "none", "-t", f"{turn.limits.input_seconds * 1000}",
            "-i", turn.corpus, "-o", merged, "--", turn.programs.fuzzer(turn.target)]


def prepare(turn):
    """AFL++ takes one directory: seeds and corpus by hard links. It leaves out empty files."""
    directory = turn.work / "in"
    directory.mkdir()
    for source in (turn.seeds, turn.corpus):
        for path in corpus.inputs(source):
            if path.stat().st_size > 0:
                os.link(path, directory / f"{source.parent.name}-{path.name}")


def collect(turn):
    """What the turn's queue holds beyond what it began with joins the corpus."""
    for path in sorted(turn.work.glob("out/*/queue/id:*")):
        if ",orig:" not in path.name:
            corpus.add(turn.corpus, path)


def progress(work):
    done = Progress()
    for path in work.glob("out/*/fuzzer_stats"):
        pairs = (line.partition(":") for line in path.read_text(encoding="utf-8").splitlines())
        stats = {key.strip(): value.strip() for key, _, value in pairs}
        done.executions += int(stats.get("execs_done", 0))
        done.edges = max(done.edges, int(stats.get("edges_found", 0)))
    return done


def artifacts(work):
    found = [(kind, path) for directory, kind in _KINDS.items()
             for path in sorted(work.glob(f"out/*/{directory}/id:*"))]
    return found[:MOST_ARTIFACTS]
