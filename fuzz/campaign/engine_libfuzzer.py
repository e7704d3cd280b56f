"""libFuzzer as the engine."""

import re
from dataclasses import dataclass

NAME = "libfuzzer"
MINIMISE_SECONDS = 30
KINDS = ("crash", "timeout", "oom", "leak")
_STATUS = re.compile(r"^#(\d+)\s", re.MULTILINE)
_EXECUTED = re.compile(r"^stat::number_of_executed_units: *(\d+)", re.MULTILINE)
_COVERED = re.compile(r"\bcov: (\d+)")


@dataclass
class Progress:
    executions: int = 0
    edges: int = 0


def environment():
    return {}


def command(turn, seconds):
    """libFuzzer stops at the first failing input: a turn runs it again until its time is over."""
    artifacts = turn.work / "artifacts"
    artifacts.mkdir(exist_ok=True)
    return fuzz_command(turn.programs, turn.target, seconds, turn.limits, artifacts,
                        [turn.corpus, turn.seeds])


def fuzz_command(programs, target, seconds, given, artifacts, directories):
    """libFuzzer writes new inputs to the first of the directories and only reads the others."""
    dictionary = programs.dictionary(target)
    return [programs.fuzzer(target), f"-max_total_time={max(1, round(seconds))}",
            "-print_final_stats=1", f"-artifact_prefix={artifacts}/", *limits(given),
            *([f"-dict={dictionary}"] if dictionary else []), *directories]


def limits(given):
    return [f"-timeout={given.input_seconds}", f"-rss_limit_mb={given.megabytes}"]


def reproduce_command(programs, target, path, given):
    return [programs.fuzzer(target), *limits(given), path]


def minimise_command(programs, target, path, result):
    return [programs.fuzzer(target), "-minimize_crash=1", f"-max_total_time={MINIMISE_SECONDS}",
            f"-exact_artifact_path={result}", path]


def merge_command(turn, merged):
    return [turn.programs.fuzzer(turn.target), "-merge=1", *limits(turn.limits),
            f"-artifact_prefix={turn.work}/", merged, turn.corpus, turn.seeds]


def prepare(turn):
    """Nothing: corpus and seeds are read where they are."""


def collect(turn):
    """Nothing: new inputs are in the corpus already."""


def progress(work):
    """What all runs of a turn printed, also of one that was killed."""
    done = Progress()
    for path in work.glob("run-*.log"):
        text = path.read_text(encoding="utf-8", errors="replace")
        counts = [int(count) for count in _STATUS.findall(text) + _EXECUTED.findall(text)]
        done.executions += max(counts, default=0)
        done.edges = max([done.edges, *map(int, _COVERED.findall(text))])
    return done


def artifacts(work):
    """(kind, path) of every failing input of the turn. A slow unit is no failure."""
    paths = sorted((work / "artifacts").glob("*-*"))
    pairs = ((path.name.partition("-")[0], path) for path in paths)
    return [(kind, path) for kind, path in pairs if kind in KINDS]
