"""The suite as many small programs: one for each test file, and the fuzz targets' replays."""

import os
import resource
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from .build import CannotBuild, archive_members, members_linked

# The rooms in the order in which they are asked, and their test programs.
TESTS = {"kernel": ["kernel_tests"], "geometry": ["geometry_tests"],
         "properties": ["properties_tests", "broken_kernel_tests"], "fuzz": ["fuzz_tests"]}
ROOMS = tuple(TESTS)
MEMORY = 2 << 30  # bytes a test program may reserve: what goes wrong often allocates
FILE_SIZE = 1 << 30


@dataclass
class Outcome:
    passed: bool
    seconds: float
    hung: bool = False
    what: str = ""  # the first test that failed, or how the program ended


@dataclass
class Program:
    name: str
    room: str
    source: Path  # the test file, from the root; None for a replay
    link: object
    objects: list  # given to the linker by name
    arguments: list
    units: list = None  # all units of the tree that go into it
    seconds: float = None  # without a fault
    runs: bool = True  # otherwise only its static assertions are asked

    @property
    def time_limit(self):
        return 30 + 10 * self.seconds

    def files(self):
        return frozenset().union(*(unit.files for unit in self.units))

    def run(self, executable, scratch, limit):
        return run_limited([str(executable), *self.arguments], scratch, limit)


def limit_resources():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_SIZE, FILE_SIZE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run_limited(command, scratch, limit):
    scratch.mkdir(parents=True, exist_ok=True)
    environment = os.environ | {"TEST_TMPDIR": f"{scratch}/", "TMPDIR": str(scratch)}
    began = time.monotonic()
    with open(scratch / "output.txt", "w+b") as output:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=subprocess.STDOUT, cwd=scratch, env=environment,
                                   preexec_fn=limit_resources, start_new_session=True)
        try:
            code, hung = process.wait(limit), False
        except subprocess.TimeoutExpired:
            hung = True
        except BaseException:
            os.killpg(process.pid, signal.SIGKILL)
            raise
        if hung:
            os.killpg(process.pid, signal.SIGKILL)
            code = process.wait()
        output.seek(0)
        text = output.read().decode(errors="replace")
    return Outcome(code == 0, time.monotonic() - began, hung, what_happened(text, code, hung))


def what_happened(text, code, hung):
    if code == 0:
        return ""
    started = failed = None
    for line in text.splitlines():
        if line.startswith("[ RUN      ] "):
            started = line[13:].strip()
        elif line.startswith("[  FAILED  ] ") and failed is None:
            failed = line[13:].partition(",")[0].partition(" (")[0].strip()
    if failed:
        return failed
    ending = "no end" if hung else signal.Signals(-code).name if code < 0 else f"exit {code}"
    return f"{started}: {ending}" if started else ending


def suite(build):
    """The programs of the suite, by room."""
    links, units = build.links(), build.units()
    result = []
    for room, name in ((room, name) for room, names in TESTS.items() for name in names):
        link = links.get(name)
        if link is None:
            raise CannotBuild(f"there is no program {name}")
        tests = [path for path in link.objects if path.name.endswith("_test.cpp.o")]
        others = [path for path in link.objects if path not in tests]
        for path in tests:
            source = units[path].source.relative_to(build.tree)
            result.append(Program(f"{room}.{source.stem}", room, source, link, [path, *others],
                                  ["--gtest_fail_fast"]))
    return result


def replays(build):
    """What CTest runs of the fuzz targets besides their unit tests."""
    by_output = {str(link.output): link for link in build.links().values()}
    result = []
    for name, command in build.ctest():
        link = by_output.get(command[0])
        if name.startswith("fuzz.") and link is not None \
                and not any(word.startswith("--gtest") for word in command):
            result.append(Program(name, "fuzz", None, link, link.objects, command[1:]))
    return result


def prepare(programs, build, folder, scratch, record, say):
    """Links every program without a fault, to learn what goes into it, and runs it once."""
    units, members = build.units(), archive_members(build.folder)
    folder.mkdir(parents=True, exist_ok=True)
    for program in programs:
        kept = record.baseline.get(program.name)
        stamps = newest(program.objects + program.link.archives())
        if kept is None or kept["stamp"] != stamps:
            executable = folder / "intact"
            found = members_linked(program.link, program.objects, executable, build.log)
            objects = program.objects + [members[key] for key in sorted(found) if key in members]
            outcome = program.run(executable, scratch, 1200)
            kept = {"stamp": stamps, "seconds": round(outcome.seconds, 3),
                    "passes": outcome.passed, "what": outcome.what,
                    "objects": [str(path) for path in objects]}
            record.baseline[program.name] = kept
            record.save()
            say(f"{program.name} {'passes' if outcome.passed else 'FAILS'} without a fault in "
                f"{outcome.seconds:.2f} s {outcome.what}")
        if not kept["passes"]:
            say(f"{program.name} fails without a fault, so that only its compilation is asked")
        program.runs = kept["passes"]
        program.seconds = kept["seconds"]
        program.units = [units[Path(path)] for path in kept["objects"] if Path(path) in units]


def newest(paths):
    return max(path.stat().st_mtime_ns for path in paths if path.exists())
