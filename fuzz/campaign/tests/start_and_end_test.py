"""What a campaign is given and where it writes: arguments, directories, a disk that is full."""

import os
import resource
import subprocess
import tempfile
import unittest
from pathlib import Path

from campaign import durable
from campaign.tests.fake_programs import FUZZ, FakeProgramsCase

SECOND = 1 / 60  # in minutes


class ArgumentsTest(FakeProgramsCase):
    def test_times_are_positive_numbers(self):
        for words in (("--minutes", "nan"), ("--hours", "inf"), ("--minutes", "0"),
                      ("--jobs", "-1")):
            code, _, err = self.run_campaign(*words)
            self.assertEqual(code, 2, words)
            self.assertIn(f"{words[0]} must be positive", err)

    def test_no_name_between_commas_is_not_all_targets(self):
        for names in (",", "alpha,", "alpha,,beta"):
            code, _, err = self.run_campaign("--targets", names)
            self.assertEqual(code, 2, names)
            self.assertIn("one comma between two", err)

    def test_directories_are_those_of_the_caller(self):
        place = self.programs.parent
        done = subprocess.run(
            [FUZZ.parent / "scripts" / "fuzz-campaign", "--programs", "bin", "--directory", "here",
             "--targets", "alpha", "--minutes", str(1.5 * SECOND)],
            cwd=place, capture_output=True, check=False, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((place / "here" / "report.md").exists())


class FullDiskTest(FakeProgramsCase):
    def test_a_report_that_cannot_be_written_is_named(self):
        self.campaign.mkdir()
        (self.campaign / "report.md.part").mkdir()  # in the way
        code, _, err = self.run_campaign("--targets", "alpha", "--minutes", str(1.5 * SECOND))
        self.assertEqual(code, 3, err)
        self.assertIn("report.md", err)
        self.assertIn("ended before its time", err)


class DurableTest(unittest.TestCase):
    def test_what_cannot_be_written_leaves_the_old_file_and_no_other(self):
        with tempfile.TemporaryDirectory() as place:
            path = Path(place) / "file"
            durable.write_text(path, "old")
            before = resource.getrlimit(resource.RLIMIT_FSIZE)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
            try:
                with self.assertRaises(OSError) as raised:
                    durable.write_text(path, "new" * 1000)
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, before)
            self.assertIn(str(path), str(raised.exception))
            self.assertEqual(path.read_text(encoding="utf-8"), "old")
            self.assertEqual(os.listdir(place), ["file"])


if __name__ == "__main__":
    unittest.main()
