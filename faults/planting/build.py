"""The test programs as the build system made them: what is compiled how, from which files, and
what each program is linked from."""

import json
import os
import re
import shlex
import subprocess
from dataclasses import dataclass, field
from pathlib import Path


class CannotBuild(Exception):
    pass


def run(command, log, **options):
    with open(log, "ab") as out:
        out.write(f"$ {command if isinstance(command, str) else shlex.join(command)}\n".encode())
        out.flush()
        return subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, **options).returncode


@dataclass
class Unit:
    """One object file of the intact build."""
    source: Path
    object: Path
    command: list  # without the output
    folder: Path
    _files: frozenset = None

    @property
    def files(self):
        """The files of the tree it was compiled from."""
        if self._files is None:
            text = Path(f"{self.object}.d").read_text().replace("\\\n", " ")
            words = text.partition(":")[2].split()
            self._files = frozenset(Path(os.path.normpath(self.folder / word)) for word in words)
        return self._files

    def compile(self, output, log):
        return run(self.command + ["-o", str(output)], log, cwd=self.folder) == 0


@dataclass
class Link:
    """How one program is linked."""
    folder: Path
    head: list  # compiler and flags
    objects: list
    libraries: list
    output: Path

    def archives(self):
        return [self.folder / word for word in self.libraries if word.endswith(".a")]


class Build:
    """A configured build folder of the tree, with CMake's Makefiles."""

    def __init__(self, tree, folder, jobs, log):
        self.tree, self.folder, self.jobs, self.log = Path(tree), Path(folder), jobs, log

    def configure(self, options):
        if run(["cmake", "-S", str(self.tree), "-B", str(self.folder), "-G", "Unix Makefiles",
                "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *options], self.log):
            raise CannotBuild("cmake does not configure the tree")

    def make(self, targets):
        if run(["cmake", "--build", str(self.folder), "--parallel", str(self.jobs), "--target",
                *targets], self.log):
            raise CannotBuild("the tree does not build without a fault")

    def units(self):
        launcher = shlex.split(os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", ""))
        result = {}
        for entry in json.loads((self.folder / "compile_commands.json").read_text()):
            words = shlex.split(entry["command"])
            at = words.index("-o")
            folder = Path(entry["directory"])
            path = Path(os.path.normpath(folder / words[at + 1]))
            result[path] = Unit(Path(entry["file"]), path, launcher + words[:at] + words[at + 2:],
                                folder)
        return result

    def links(self):
        """Of every program, by its name."""
        result = {}
        for path in sorted(self.folder.glob("**/CMakeFiles/*.dir/link.txt")):
            words = shlex.split(path.read_text())
            if "-o" not in words:
                continue  # an archive
            folder = path.parent.parent.parent
            at = words.index("-o")
            is_object = [word.endswith(".o") for word in words[:at]]
            place = lambda word: Path(os.path.normpath(folder / word))
            result[path.parent.stem] = Link(
                folder, [w for w, o in zip(words[:at], is_object) if not o],
                [place(w) for w, o in zip(words[:at], is_object) if o], words[at + 2:],
                place(words[at + 1]))
        return result

    def ctest(self):
        """The tests CTest knows that are one command of the build, as name and command."""
        said = subprocess.run(["ctest", "--test-dir", str(self.folder), "--show-only=json-v1"],
                              capture_output=True, text=True, check=True).stdout
        for test in json.loads(said)["tests"]:
            if test.get("command"):
                yield test["name"], test["command"]


MEMBER = re.compile(r"(\S+\.a)\(([^)]+\.o)\)")


def members_linked(link, objects, output, log):
    """Links the program; returns the objects from the tree's own archives that went into it."""
    map_file = Path(f"{output}.map")
    command = [*link.head, *map(str, objects), "-o", str(output), *link.libraries,
               f"-Wl,-Map={map_file}"]
    if run(command, log, cwd=link.folder):
        raise CannotBuild(f"cannot link {output.name}")
    said = map_file.read_text().partition("Memory Configuration")[0]
    map_file.unlink()
    found = {(os.path.normpath(link.folder / archive), name)
             for archive, name in MEMBER.findall(said)}
    return found


def archive_members(folder):
    """(archive, member name) -> object of the intact build."""
    result = {}
    for path in Path(folder).glob("**/CMakeFiles/*.dir/link.txt"):
        words = shlex.split(path.read_text().splitlines()[0])
        if Path(words[0]).name != "ar":
            continue
        base = path.parent.parent.parent
        archive = os.path.normpath(base / words[2])
        for word in words[3:]:
            result[archive, Path(word).name] = Path(os.path.normpath(base / word))
    return result
