"""A directory with programs that imitate the built ones, and campaigns on them."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

FUZZ = Path(__file__).resolve().parents[2]
FAKE = Path(__file__).with_name("fake_fuzzer.py")
NAMES = ("alpha", "beta", "gamma")


class FakeProgramsCase(unittest.TestCase):
    """self.programs: the directory; self.campaign: where campaigns keep what they have."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.programs, self.campaign = Path(place.name) / "bin", Path(place.name) / "campaign"
        self.programs.mkdir()
        for name in ("tightflip_fuzz", *(f"{name}_fuzzer" for name in NAMES)):
            shutil.copy(FAKE, self.programs / name)
            (self.programs / name).chmod(0o755)

    def plan(self, target, *inputs):
        """What the target's fuzzer comes upon, one after the other."""
        (self.programs / f"{target}.plan").write_text("\n".join(inputs), encoding="utf-8")

    def start(self, *words):
        command = [sys.executable, "-B", "-m", "campaign", "--programs", str(self.programs),
                   "--directory", str(self.campaign), *words]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=os.environ | {"PYTHONPATH": str(FUZZ), "PYTHONSAFEPATH": "1"})

    def run_campaign(self, *words):
        """(exit code, stdout, stderr)."""
        process = self.start(*words)
        out, err = process.communicate(timeout=60)
        return process.returncode, out, err

    def run_until(self, reached, *words):
        """The same, of a campaign that is interrupted once `reached` holds. Machines differ in how
        much they do in a second."""
        process = self.start("--minutes", "2", *words)
        until = time.monotonic() + 50
        while not reached() and process.poll() is None and time.monotonic() < until:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=30)
        return process.returncode, out, err

    def corpus(self, target):
        """What the inputs of the target's corpus hold."""
        paths = sorted((self.campaign / "corpus" / target).glob("*"))
        return [path.read_text(encoding="utf-8") for path in paths if path.is_file()]

    def given_corpus(self, target, inputs):
        """A corpus that is there before the campaign; text by name. Its directory."""
        directory = self.campaign / "corpus" / target
        directory.mkdir(parents=True)
        for name, text in inputs.items():
            (directory / name).write_text(text, encoding="utf-8")
        return directory

    def report(self):
        return (self.campaign / "report.md").read_text(encoding="utf-8")

    def findings(self, target):
        return sorted((self.campaign / "findings" / target).glob("*"))
