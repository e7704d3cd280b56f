"""Campaigns on fuzzers that imitate libFuzzer: turns, findings, interruptions, bad input."""

import json
import os
import signal
import time
import unittest

from campaign.tests.fake_programs import FakeProgramsCase

SECONDS = 1 / 60  # in minutes


class CampaignTest(FakeProgramsCase):
    def state(self):
        return json.loads((self.campaign / "state.json").read_text(encoding="utf-8"))

    def test_every_target_gets_the_same_share_and_a_line_a_turn(self):
        code, out, _ = self.run_campaign("--minutes", str(6 * SECONDS), "--jobs", "2")
        self.assertEqual(code, 0, out)
        times = [one["seconds"] for one in self.state()["targets"].values()]
        self.assertEqual(len(times), 3)
        self.assertLess(max(times) - min(times), 4, times)  # turns of two seconds
        self.assertGreater(sum(times), 7)  # more than one job has
        for name in ("alpha", "beta", "gamma"):
            self.assertRegex(out, rf"round 1 {name}: \+[\d,]+ executions")
            self.assertGreater(self.state()["targets"][name]["executions"], 50)
        self.assertIn("| alpha | 0:00:0", self.report())

    def test_every_target_has_a_turn_though_one_takes_long_to_read_its_seeds(self):
        self.given_corpus("alpha", {"slow": "SLOW"})
        code, out, _ = self.run_campaign("--minutes", str(7 * SECONDS), "--jobs", "1",
                                         "--timeout", "1")
        self.assertEqual(code, 0, out)
        for name in ("alpha", "beta", "gamma"):
            self.assertEqual(self.state()["targets"][name]["turns"], 1, out)
        self.assertGreater(self.state()["targets"]["gamma"]["executions"], 10)
        self.assertIn("each of 3 targets gets 2.3 s, which may not be enough to start and to read "
                      "the seeds; 0.2 minutes give it 5 s", out)

    def test_failing_inputs_are_kept_once_a_kind_minimised_and_in_words(self):
        self.plan("alpha", "new one", "CLAIM topology 1 2 3", "CLAIM topology 7", "new two",
                  "CLAIM inverse 4", "OVERFLOW 1", "OVERFLOW 22", "HANG 1", "HANG 333")
        code, out, _ = self.run_until(lambda: "known" in self.corpus("alpha"), "--targets", "alpha",
                                      "--timeout", "1", "--jobs", "1")
        self.assertEqual(code, 1, out)
        found = {path.name: json.loads((path / "finding.json").read_text())
                 for path in self.findings("alpha")}
        by_signature = {one["signature"]: one["times"] for one in found.values()}
        overflow = ("heap-buffer-overflow in tightflip::kernel::Triangulation::twin"
                    " < tightflip::fuzz::objection")
        hang = "timeout in tightflip::kernel::connect < tightflip::fuzz::objection"
        self.assertEqual(by_signature, {"claim: topology": 2, "claim: inverse": 1, overflow: 2,
                                        hang: 2}, out)
        topology = next(path for path in self.findings("alpha")
                        if found[path.name]["signature"] == "claim: topology")
        self.assertEqual((topology / "input").read_text(), "CLAIM topology 1 2 3")
        self.assertEqual((topology / "minimised").read_text(), "CLAIM topology")
        self.assertEqual((topology / "script.txt").read_text().strip(), "in words: CLAIM topology")
        self.assertIn("topology: edge 14", (topology / "output.txt").read_text())
        self.assertIn("### alpha: claim: topology", self.report())
        self.assertIn("in words: CLAIM topology", self.report())
        self.assertEqual(sorted(self.corpus("alpha")), ["known", "new one", "new two"])

    def test_the_engine_minimises_what_the_tool_cannot(self):
        self.plan("alpha", "CLAIM topology STUBBORN")
        self.run_until(lambda: "known" in self.corpus("alpha"), "--targets", "alpha", "--jobs", "1")
        finding, = self.findings("alpha")
        self.assertEqual((finding / "minimised").read_text(), "CLAIM topology")

    def test_killed_and_started_again_it_has_lost_nothing(self):
        self.plan("alpha", "kept", "CLAIM early 1")
        process = self.start("--targets", "alpha", "--minutes", str(60 * SECONDS), "--jobs", "1")
        for line in process.stdout:
            if "claim: early" in line:
                break
        time.sleep(0.5)
        before = set(_children(process.pid))
        self.assertTrue(before)
        process.kill()
        process.communicate()
        time.sleep(0.5)
        self.assertFalse([pid for pid in before if _runs(pid)], "fuzzers outlived the campaign")
        # Found, but not yet looked at when the campaign died.
        work, = (self.campaign / "work").iterdir()
        (work / "artifacts" / "crash-0").write_text("CLAIM late 2")
        code, out, _ = self.run_campaign("--targets", "alpha", "--minutes", str(2 * SECONDS),
                                         "--jobs", "1")
        self.assertEqual(code, 1, out)
        self.assertIn("claim: early", self.report())
        self.assertIn("claim: late", self.report())
        self.assertIn("kept", self.corpus("alpha"))
        self.assertEqual(self.state()["starts"], 2)
        self.assertGreater(self.state()["targets"]["alpha"]["executions"], 10)
        self.assertEqual(list((self.campaign / "work").iterdir()), [])

    def test_time_of_all_starts_counts_together(self):
        arguments = ("--targets", "alpha", "--minutes", str(2 * SECONDS), "--jobs", "1")
        self.run_campaign(*arguments)
        code, out, _ = self.run_campaign(*arguments)
        self.assertEqual(code, 0, out)
        self.assertIn("it has had its 0:00:02; with more time it continues", out)
        self.assertEqual(self.state()["targets"]["alpha"]["turns"], 1)

    def test_ctrl_c_ends_with_a_report(self):
        code, _, err = self.run_until(lambda: "known" in self.corpus("alpha"), "--targets", "alpha")
        self.assertEqual(code, 3, err)
        self.assertIn("It ended early: interrupted.", self.report())

    def test_a_nearly_full_disk_ends_it_with_a_report(self):
        code, _, err = self.run_campaign("--targets", "alpha", "--keep-free", "1000000000")
        self.assertEqual(code, 3)
        self.assertIn("the disk is nearly full", err)
        self.assertIn("the disk is nearly full", self.report())

    def test_files_no_engine_could_read_are_set_aside_and_named(self):
        corpus = self.given_corpus("alpha", {"good": "good", "large": " " * 2_000_000})
        (corpus / "dangling").symlink_to("nowhere")
        (corpus / "folder").mkdir()
        _, out, _ = self.run_until(lambda: "known" in self.corpus("alpha"), "--targets", "alpha")
        self.assertIn("corpus file dangling set aside: a link to nothing", out)
        self.assertIn("| alpha | folder | not a regular file |", self.report())
        self.assertIn("| alpha | large | more than 1048576 bytes |", self.report())
        aside = self.campaign / "set-aside" / "alpha"
        self.assertEqual(sorted(path.name for path in aside.iterdir()),
                         ["dangling", "folder", "large"])
        self.assertTrue((corpus / "good").exists())

    def test_a_corpus_file_that_fails_by_itself_does_not_stop_the_target(self):
        self.given_corpus("alpha", {"0": "CLAIM old 1"})
        code, out, _ = self.run_until(lambda: "known" in self.corpus("alpha"), "--targets", "alpha")
        self.assertEqual(code, 1, out)
        self.assertIn("| alpha | 0 | it fails by itself |", self.report())
        self.assertIn("known", self.corpus("alpha"))

    def test_a_large_corpus_is_merged(self):
        self.given_corpus("alpha", {f"{number}": f"{'ab'[number % 2]}{number}"
                                    for number in range(250)})
        code, out, _ = self.run_campaign("--targets", "alpha", "--minutes", str(2 * SECONDS),
                                         "--jobs", "1")
        self.assertEqual(code, 0, out)
        self.assertIn("corpus merged, 251 -> 4 inputs", out)
        self.assertEqual(sorted(text[0] for text in self.corpus("alpha")), list("abks"))

    def test_a_merge_that_takes_too_long_is_given_up(self):
        self.given_corpus("alpha", {f"{number}": f"MERGES LONG {number}" for number in range(250)})
        _, out, _ = self.run_campaign("--targets", "alpha", "--minutes", str(2 * SECONDS),
                                      "--jobs", "1")
        self.assertIn("alpha: corpus of 251 inputs not merged", out)
        self.assertEqual(len(self.corpus("alpha")), 251)

    def test_an_unknown_target_is_refused_with_those_that_there_are(self):
        code, _, err = self.run_campaign("--targets", "alpha,delta")
        self.assertEqual(code, 2)
        self.assertEqual(err.strip(), "there is no target delta; there are: alpha, beta, gamma")

    def test_an_engine_that_does_not_run_ends_it(self):
        (self.programs / "alpha_fuzzer").write_text("#!/bin/sh\necho no way; exit 9\n")
        code, _, err = self.run_campaign("--targets", "alpha", "--minutes", "1")
        self.assertEqual(code, 3)
        self.assertIn("alpha: the engine ended with 9: no way", err)

    def test_a_state_that_cannot_be_read_is_put_aside(self):
        self.campaign.mkdir()
        (self.campaign / "state.json").write_text('{"format": 1, "targ')
        code, out, _ = self.run_campaign("--targets", "alpha", "--minutes", str(1.5 * SECONDS))
        self.assertEqual(code, 0, out)
        self.assertIn("state.json cannot be read", out)
        self.assertTrue((self.campaign / "state.json.unreadable").exists())

    def test_one_campaign_a_directory(self):
        process = self.start("--targets", "alpha", "--minutes", "10")
        while not (self.campaign / "state.json").exists() and process.poll() is None:
            time.sleep(0.05)
        code, _, err = self.run_campaign("--targets", "alpha")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=20)
        self.assertEqual(code, 2)
        self.assertIn("another campaign is at work", err)

    def test_the_report_alone(self):
        self.plan("alpha", "CLAIM topology 1")
        self.run_campaign("--targets", "alpha", "--minutes", str(3 * SECONDS))
        report = self.report()
        (self.campaign / "report.md").unlink()
        code, _, _ = self.run_campaign("--targets", "alpha", "--minutes", str(3 * SECONDS),
                                       "--report")
        self.assertEqual(code, 1)
        self.assertEqual(self.report(), report)
        self.assertIn("<h3>alpha: claim: topology</h3>",
                      (self.campaign / "report.html").read_text(encoding="utf-8"))


def _children(pid):
    """Processes that the process started, by /proc."""
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                with open(f"/proc/{entry}/stat", encoding="utf-8") as file:
                    if int(file.read().rpartition(")")[2].split()[1]) == pid:
                        yield int(entry)
            except OSError:
                pass


def _runs(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


if __name__ == "__main__":
    unittest.main()
