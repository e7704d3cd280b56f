"""scripts/fuzz-campaign: the arguments, the start and the end of a campaign."""

import argparse
import math
import os
import signal
import sys
from pathlib import Path

from campaign import build, coverage_runs, durable, report, toolchain
from campaign.campaign import Campaign, Settings
from campaign.engines import ENGINES
from campaign.programs import TOOL, Programs, UsageError, choose
from campaign.turn import Limits

HELD, FAILED, UNUSABLE, STOPPED = 0, 1, 2, 3  # exit codes


def _arguments(words):
    parser = argparse.ArgumentParser(
        prog="scripts/fuzz-campaign",
        description="Fuzzes the targets in turns, keeps their corpora, collects what fails, each "
                    "kind once, minimised and in words, and writes a report. Started again, it "
                    "continues. Exit code 0: nothing failed; 1: there are findings; 2: it could "
                    "not start; 3: stopped before its time, nothing failed so far.")
    parser.add_argument("--targets", default="", metavar="NAMES",
                        help="names with commas between them (default: all)")
    time = parser.add_mutually_exclusive_group()
    time.add_argument("--hours", type=float, help="how long by the clock, all starts together")
    time.add_argument("--minutes", type=float, help="the same in minutes (default: 10 a target)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1,
                        help="fuzzers at a time (default: one a core, here %(default)s)")
    parser.add_argument("--engine", choices=ENGINES, default="libfuzzer")
    parser.add_argument("--directory", type=Path, default=build.ROOT / "build" / "fuzz-campaign",
                        help="everything the campaign has (default: build/fuzz-campaign)")
    parser.add_argument("--report", action="store_true", help="only write the report anew")
    parser.add_argument("--no-coverage", action="store_true",
                        help="leave line coverage out of the report; it takes a build of its own")
    parser.add_argument("--programs", type=Path, metavar="DIRECTORY",
                        help=f"use {TOOL} and NAME_fuzzer of this directory, build nothing, and "
                             "leave line coverage out")
    parser.add_argument("--timeout", type=int, default=10, metavar="SECONDS",
                        help="an input that takes longer is a finding (default: %(default)s)")
    parser.add_argument("--memory", type=int, default=2048, metavar="MEGABYTES",
                        help="an input that takes more is a finding (default: %(default)s)")
    parser.add_argument("--keep-free", type=int, default=500, metavar="MEGABYTES",
                        help="ends when less of the disk is free (default: %(default)s)")
    given = parser.parse_args(words)
    for name in ("hours", "minutes", "jobs", "timeout", "memory"):
        value = getattr(given, name)
        if value is not None and not (value > 0 and math.isfinite(value)):
            parser.error(f"--{name} must be positive")
    if given.targets.strip(",") != given.targets or ",," in given.targets:
        parser.error("--targets takes names with one comma between two of them")
    return given


def _settings(given):
    engine = ENGINES[given.engine]
    wanted = [name for name in given.targets.split(",") if name]
    if given.programs:
        programs, compiler = Programs(given.programs, build.DICTIONARIES), ""
        targets = choose(programs.targets(), wanted)
        programs.require_fuzzers(targets)
    else:
        print("building the fuzzers", flush=True)
        programs, compiler, targets = build.fuzzers(engine, wanted, os.cpu_count() or 1)
        compiler = toolchain.version(compiler)
    minutes = 60 * given.hours if given.hours else given.minutes or 10 * len(targets) / given.jobs
    return Settings(engine, programs, targets, given.directory.resolve(), 60 * minutes, given.jobs,
                    given.keep_free, Limits(given.timeout, given.memory), compiler)


def _end_by_signals(campaign):
    """The first Ctrl-C ends in order, the second at once."""
    def end(number, _):
        signal.signal(number, signal.SIG_DFL)
        campaign.end("interrupted")
        print("ending; the report follows", flush=True)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, end)


def _coverage(given, campaign):
    """By the corpora; None where it is not wanted, or cannot be had."""
    if given.no_coverage or given.programs or campaign.ended_by:
        return None
    print("measuring line coverage", flush=True)
    try:
        built = coverage_runs.CoverageBuild(build.find_clang(), [TOOL], os.cpu_count() or 1)
        corpora = [campaign.directory / "corpus"]
        return built.by_inputs(coverage_runs.inputs_of(campaign.settings.targets, corpora))
    except (UsageError, RuntimeError) as error:
        print(f"no line coverage: {error}", file=sys.stderr)
        return None


def _say(text):
    print(text, flush=True)


def main(words):
    given = _arguments(words)
    try:
        settings = _settings(given)
        settings.directory.mkdir(parents=True, exist_ok=True)
        lock = durable.lock(settings.directory / "lock")
        if lock is None:
            raise UsageError(f"another campaign is at work in {settings.directory}")
        campaign = Campaign(settings, _say)
        if not given.report:
            _end_by_signals(campaign)
            campaign.run()
    except (UsageError, OSError) as error:
        print(error, file=sys.stderr)
        return UNUSABLE
    try:
        print(report.write(campaign, _coverage(given, campaign)))
    except OSError as error:
        campaign.end(str(error))
    if campaign.ended_by:
        print(f"ended before its time: {campaign.ended_by}", file=sys.stderr)
    if any(campaign.findings.of(target) for target in settings.targets):
        return FAILED
    return STOPPED if campaign.ended_by else HELD


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
