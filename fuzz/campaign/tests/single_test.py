"""scripts/fuzz: what it refuses, and what it runs."""

import contextlib
import io
import os
import unittest
from pathlib import Path
from unittest import mock

from campaign import build, single
from campaign.programs import Programs, UsageError
from campaign.tests.fake_programs import FakeProgramsCase


class SingleTest(FakeProgramsCase):
    def setUp(self):
        super().setUp()
        self.root = self.campaign
        (self.root / "fuzz").mkdir(parents=True)
        (self.root / "fuzz" / "CMakeLists.txt").write_text("set(targets\n    alpha\n    beta)\n")
        for name, value in (("ROOT", self.root), ("install", lambda *lists: None)):
            patch = mock.patch.object(build, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def run_single(self, *words):
        """(exit code, stderr)."""
        with (contextlib.redirect_stdout(io.StringIO()),
              contextlib.redirect_stderr(io.StringIO()) as err):
            code = single.main(words)
        return code, err.getvalue().strip()

    def test_wrong_arguments_are_refused_before_anything_is_built(self):
        usage = "usage: scripts/fuzz TARGET SECONDS (targets: alpha beta)"
        unknown = "there is no target delta; there are: alpha, beta"
        with mock.patch.object(build, "fuzzers") as built:
            for words, text in (((), usage), (("alpha",), usage), (("alpha", "1", "2"), usage),
                                (("delta", "5"), unknown),
                                *((("alpha", wrong), f"'{wrong}' is no number of seconds")
                                  for wrong in ("0", "5s", "-5", ""))):
                self.assertEqual(self.run_single(*words), (2, text))
            built.assert_not_called()

    def test_a_compiler_that_builds_no_fuzzers_is_refused_with_those_that_do(self):
        with mock.patch.dict(os.environ, CXX="no-such-clang++"):
            code, err = self.run_single("alpha", "5")
        self.assertEqual(code, 2)
        self.assertIn("no-such-clang++: it is not installed", err)
        self.assertIn("clang and libclang-rt-14-dev", err)

    def test_the_fuzzer_of_the_target_runs_on_its_seeds_and_what_it_found_before(self):
        programs = Programs(self.programs, self.root)
        here = self.root / "build" / "fuzz"
        (here / "seeds" / "alpha").mkdir(parents=True)
        (here / "seeds" / "alpha" / "of another version").touch()
        with (mock.patch.object(build, "fuzzers", return_value=(programs, "clang++", ["alpha"])),
              mock.patch.object(os, "execv", side_effect=SystemExit) as execute,
              self.assertRaises(SystemExit)):
            self.run_single("alpha", "5")
        (program, command), _ = execute.call_args
        self.assertEqual(Path(program), self.programs / "alpha_fuzzer")
        self.assertIn("-max_total_time=5", command)
        self.assertIn(f"-artifact_prefix={here}/findings/", command)
        self.assertEqual(command[-2:], [f"{here}/corpus/alpha", f"{here}/seeds/alpha"])
        self.assertTrue((here / "findings").is_dir() and (here / "corpus" / "alpha").is_dir())
        seed, = (here / "seeds" / "alpha").iterdir()
        self.assertEqual(seed.read_text(), "seed of alpha")

    def test_a_build_that_fails_is_shown(self):
        with mock.patch.object(build, "fuzzers", side_effect=UsageError("make ended with 2")):
            self.assertEqual(self.run_single("alpha", "5"), (2, "make ended with 2"))


if __name__ == "__main__":
    unittest.main()
