"""scripts/coverage on programs that imitate the instrumented ones: where their counts go, and the
goals."""

import contextlib
import io
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from campaign import build, coverage_cli, line_coverage
from campaign.coverage_runs import CoverageBuild

# As an instrumented program does: default.profraw in its working directory, unless told otherwise.
_COUNTED = """#!/bin/sh
profile=${LLVM_PROFILE_FILE:-default.profraw}
mkdir -p "$(dirname "$profile")" && echo "$0 $*" >>"$profile"
"""
_TOOL = _COUNTED + "[ $1 != list ] || printf 'alpha\\twhat\\nbeta\\twhat\\n'\n"


class CoverageTest(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.root = Path(place.name)
        self.built = self.root / "build" / "coverage"
        # The build runs programs as well: it lists the tests.
        for path, text in ((self.root / "bin" / "cmake", _COUNTED),
                           (self.root / "bin" / "ctest", _COUNTED),
                           (self.root / "bin" / "clang++", _COUNTED),
                           (self.built / "fuzz" / "tightflip_fuzz", _TOOL),
                           (self.built / "kernel" / "kernel_tests", _COUNTED)):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            path.chmod(0o755)
        (self.root / "here").mkdir()
        self.addCleanup(os.chdir, Path.cwd())
        os.chdir(self.root / "here")
        path = f"{self.root / 'bin'}:{os.environ['PATH']}"
        lines = line_coverage.LineCoverage({"kernel/src/a.cpp": {1: 1, 2: 1, 3: 0, 4: 1}})
        for patch in (mock.patch.dict(os.environ, PATH=path),
                      mock.patch.object(build, "ROOT", self.root),
                      mock.patch.object(build, "install"),
                      mock.patch.object(build, "find_clang", return_value="clang++"),
                      mock.patch.object(CoverageBuild, "_measure", return_value=lines)):
            patch.start()
            self.addCleanup(patch.stop)
        os.environ.pop("LLVM_PROFILE_FILE", None)

    def run_coverage(self, *words):
        """(exit code, stdout, stderr)."""
        with (contextlib.redirect_stdout(io.StringIO()) as out,
              contextlib.redirect_stderr(io.StringIO()) as err):
            code = coverage_cli.main(words)
        return code, out.getvalue(), err.getvalue()

    def counted(self, name):
        """What ran for that part, by program."""
        text = "".join(path.read_text(encoding="utf-8")
                       for path in sorted((self.built / "profiles" / name).glob("**/*.profraw")))
        return sorted(line.replace(str(self.root), "") for line in text.splitlines())

    def test_what_is_not_measured_leaves_no_counts_outside_and_none_among_the_measured(self):
        code, _, err = self.run_coverage("--tests", "kernel")
        self.assertEqual((code, err), (0, ""))
        left = [path.relative_to(self.root) for path in self.root.glob("**/*.profraw")
                if not path.is_relative_to(self.built / "profiles")]
        self.assertEqual(left, [])
        tool = "/build/coverage/fuzz/tightflip_fuzz"
        self.assertEqual(self.counted("inputs"), [f"{tool} replay alpha --seeds",
                                                  f"{tool} replay beta --seeds"])
        self.assertEqual([line.split()[0] for line in self.counted("tests")], ["/bin/ctest"])
        self.assertIn(f"{tool} list", self.counted("uncounted"))

    def test_goals_decide_on_the_exit_code(self):
        for words, code in (((), 0), (("--inputs-at-least", "75"), 0),
                            (("--inputs-at-least", "75.1"), 1), (("--tests-at-least", "76"), 1)):
            self.assertEqual(self.run_coverage("--tests", "kernel", *words)[0], code)
        _, _, err = self.run_coverage("inputs", "--inputs-at-least", "80")
        self.assertEqual(err, "the inputs execute 3 of 4, 75.00 % of the kernel's lines; the goal "
                              "is 80.0 %\n")


if __name__ == "__main__":
    unittest.main()
