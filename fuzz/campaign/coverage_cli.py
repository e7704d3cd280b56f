"""scripts/coverage: line coverage of the libraries by the fuzz inputs and by the tests."""

import argparse
import os
import sys
from pathlib import Path

from campaign import build, coverage_runs, report
from campaign.coverage_runs import ALL, CoverageBuild
from campaign.document import Heading, to_markdown
from campaign.line_coverage import LAYERS
from campaign.programs import TOOL, UsageError

_RUNS = ("inputs", "tests")


def _arguments(words):
    parser = argparse.ArgumentParser(
        prog="scripts/coverage",
        description="Builds with clang's line coverage and prints, as Markdown, which lines of "
                    "kernel, geometry and properties the fuzz inputs and the tests execute. Exit "
                    "code 1 where a goal is missed.")
    parser.add_argument("runs", nargs="*", metavar="RUN",
                        help="inputs: the seed corpora and regressions; tests: the unit and "
                             "property tests (default: both)")
    parser.add_argument("--corpus", type=Path, action="append", default=[], metavar="DIRECTORY",
                        help="further inputs, in one directory a target, such as the corpus of a "
                             "campaign")
    parser.add_argument("--tests", default="kernel,properties", metavar="LAYERS",
                        help="whose tests run (default: %(default)s)")
    parser.add_argument("--layers", default="kernel", metavar="LAYERS",
                        help="which layers are listed file by file (default: %(default)s)")
    parser.add_argument("--inputs-at-least", type=float, default=0, metavar="PERCENT",
                        help="goal for the kernel's lines by the inputs")
    parser.add_argument("--tests-at-least", type=float, default=0, metavar="PERCENT",
                        help="goal for the kernel's lines by the tests")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args(words)
    for name, value, known in (("RUN", given.runs, _RUNS), ("--tests", _names(given.tests), LAYERS),
                               ("--layers", _names(given.layers), LAYERS)):
        unknown = [one for one in value if one not in known]
        if unknown:
            parser.error(f"{name}: there is no {', '.join(unknown)}; there are: {', '.join(known)}")
    return given


def _names(text):
    return [name for name in text.split(",") if name]


def _print(title, coverage, all_of_it, layers):
    blocks = [Heading(title), *report.coverage_blocks(coverage)[1:]]
    for layer in layers:
        blocks += report.file_blocks(all_of_it, layer)
    print(to_markdown(blocks), flush=True)


def main(words):
    given = _arguments(words)
    runs, layers = given.runs or _RUNS, _names(given.layers)
    tested = _names(given.tests) if "tests" in runs else []
    try:
        names = ([TOOL] if "inputs" in runs else []) + [f"{layer}_tests" for layer in tested]
        built = CoverageBuild(build.find_clang(), names, given.jobs)
        reached = {}
        if "inputs" in runs:
            targets = built.programs().targets()
            coverage = built.by_inputs(coverage_runs.inputs_of(targets, given.corpus), _complain)
            _print("Line coverage by the fuzz inputs", coverage, coverage[ALL], layers)
            reached["inputs"] = (coverage[ALL].total("kernel"), given.inputs_at_least)
        if "tests" in runs:
            coverage = built.by_tests(tested, given.jobs, _complain)
            _print("Line coverage by the tests", {f"tests of {' and '.join(tested)}": coverage},
                   coverage, layers)
            reached["tests"] = (coverage.total("kernel"), given.tests_at_least)
    except (UsageError, RuntimeError) as error:
        _complain(error)
        return 2
    missed = {name: goal for name, (count, goal) in reached.items() if count.percent() < goal}
    for name, goal in missed.items():
        _complain(f"the {name} execute {reached[name][0].text()} of the kernel's lines; "
                  f"the goal is {goal} %")
    return 1 if missed else 0


def _complain(text):
    print(text, file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
