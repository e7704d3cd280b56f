"""One fault: which program notices it."""

import re
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from .build import run
from .programs import ROOMS
from .tree import planted

# What is undefined is no constant either.
ASSERTED = re.compile("static assertion failed|non-constant condition for static assertion")
KILLED, HUNG, SURVIVED, UNCOMPILED = "killed", "killed by time limit", "survived", "does not compile"


@dataclass
class Verdict:
    result: str
    by: str = ""  # the program that noticed
    what: str = ""  # its first test that failed
    seconds: float = 0
    tried: int = 0
    files: frozenset = field(default_factory=frozenset)  # what the verdict stands on


def rank(program, fault, tree, last):
    """The suite's order for a fault: who noticed it last time, the test of that name, tests that
    include the header of that name, the rest of the room, the other rooms; cheap ones first."""
    source = Path(fault.path)
    changed = Path(tree) / fault.path
    compiles = sum(changed in unit.files for unit in program.units)
    near = 4
    if program.source is not None:
        stem = program.source.stem[:-len("_test")]
        text = (Path(tree) / program.source).read_text()
        if program.name == last:
            near = 0
        elif stem == source.stem or program.source.stem in fault.near:
            near = 1
        elif source.stem.startswith(f"{stem}_") or stem.startswith(f"{source.stem}_"):
            near = 2
        elif f"/{source.stem}.hpp" in text or f'"{source.stem}.hpp' in text:
            near = 3
    own = source.parts[0] == program.room
    return (near if own or near == 0 else 4, not own, ROOMS.index(program.room),
            program.seconds + 3 * compiles)


class Trial:
    def __init__(self, fault, programs, build, folder, scratch, last):
        self.fault, self.build = fault, build
        self.folder, self.scratch = folder, scratch
        self.changed = build.tree / fault.path
        concerned = [p for p in programs if any(self.changed in u.files for u in p.units)]
        self.programs = sorted(concerned,
                               key=lambda program: rank(program, fault, build.tree, last))
        self.compiled = {}  # unit's object -> the object with the fault, or None

    def run(self):
        began = time.monotonic()
        folder = self.folder
        folder.mkdir(parents=True, exist_ok=True)
        for path in folder.iterdir():
            path.unlink()
        with planted(self.fault, self.build.tree):
            verdict = self.ask_all()
        verdict.seconds = time.monotonic() - began
        return verdict

    def ask_all(self):
        files = set()
        for tried, program in enumerate(self.programs, 1):
            files |= program.files()
            result, what = self.ask(program)
            if result is not None:
                return Verdict(result, program.name, what, tried=tried,
                               files=program.files() if result != UNCOMPILED else files)
        return Verdict(SURVIVED, tried=len(self.programs), files=frozenset(files))

    def ask(self, program):
        units = [unit for unit in program.units if self.changed in unit.files]
        missing = [unit for unit in units if unit.object not in self.compiled]
        with ThreadPoolExecutor(self.build.jobs) as pool:
            list(pool.map(self.compile, missing))
        broken = [unit for unit in units if self.compiled[unit.object] is None]
        if broken:
            log = (self.folder / "compiler.txt").read_text(errors="replace")
            ours = all(unit.source == self.build.tree / (program.source or "") for unit in broken)
            if ours and ASSERTED.search(log):
                return KILLED, "a static assertion"
            return UNCOMPILED, broken[0].source.name
        if not program.runs:
            return None, ""
        executable = self.folder / "planted"
        known = [self.compiled.get(path, path) for path in program.objects]
        pulled = [self.compiled[unit.object] for unit in units
                  if unit.object not in program.objects]
        command = [*program.link.head, *map(str, known + pulled), "-o", str(executable),
                   *program.link.libraries]
        if run(command, self.folder / "compiler.txt", cwd=program.link.folder):
            return UNCOMPILED, f"{program.name} does not link"
        outcome = program.run(executable, self.scratch, program.time_limit)
        executable.unlink()
        if outcome.passed:
            return None, ""
        return (HUNG if outcome.hung else KILLED), outcome.what

    def compile(self, unit):
        output = self.folder / f"{unit.object.parent.name}_{unit.object.name}"
        if output.exists():
            output = self.folder / f"{len(self.compiled)}_{output.name}"
        good = unit.compile(output, self.folder / "compiler.txt")
        self.compiled[unit.object] = output if good else None
