"""Which lines of the libraries were executed, by LLVM's source-based coverage."""

import subprocess
from dataclasses import dataclass
from pathlib import Path

from campaign import toolchain

LAYERS = ("kernel", "geometry", "properties")


@dataclass
class Count:
    lines: int = 0
    covered: int = 0

    def percent(self):
        return 100 * self.covered / self.lines if self.lines else 100.0

    def text(self):
        return f"{self.covered:,} of {self.lines:,}, {self.percent():.2f} %"


class LineCoverage:
    """Executed and missed lines, by file."""

    def __init__(self, executions):
        self._executions = executions  # file relative to the root -> line -> times executed

    def files(self, layer):
        """The sources and public headers of a layer, in order."""
        prefixes = (f"{layer}/src/", f"{layer}/include/")
        return [name for name in sorted(self._executions) if name.startswith(prefixes)]

    def count(self, name):
        lines = self._executions[name]
        return Count(len(lines), sum(1 for times in lines.values() if times))

    def total(self, layer):
        counts = [self.count(name) for name in self.files(layer)]
        return Count(sum(one.lines for one in counts), sum(one.covered for one in counts))

    def missed(self, name):
        """The numbers of the lines that were not executed."""
        return sorted(line for line, times in self._executions[name].items() if not times)


def ranges(numbers):
    """'3-5, 9' of [3, 4, 5, 9]."""
    parts = []
    for number in numbers:
        if parts and number == parts[-1][1] + 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def parse_lcov(text, root):
    """The lines of an lcov trace that lie below the root."""
    executions, lines = {}, None
    for record in text.splitlines():
        key, _, value = record.partition(":")
        if key == "SF":
            path = Path(value)
            inside = path.is_relative_to(root)
            lines = executions.setdefault(str(path.relative_to(root)), {}) if inside else {}
        elif key == "DA":
            number, times = map(int, value.split(",")[:2])
            lines[number] = lines.get(number, 0) + times
    return executions


def measure(compiler, profiles, objects, root):
    """Of the raw profiles that runs of the objects wrote. The lines of all objects count."""
    merged = profiles / "all.profdata"
    raw = sorted(str(path) for path in profiles.glob("**/*.profraw"))
    _run([toolchain.llvm_tool(compiler, "llvm-profdata"), "merge", "-sparse", "-o", str(merged),
          *raw])
    first, *rest = map(str, objects)
    others = [word for name in rest for word in ("-object", name)]
    text = _run([toolchain.llvm_tool(compiler, "llvm-cov"), "export", "-format=lcov",
                 f"-instr-profile={merged}", first, *others])
    return LineCoverage(parse_lcov(text, root))


def _run(command):
    done = subprocess.run(command, capture_output=True, check=False, text=True, errors="replace")
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]} ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout
