"""The parts of a campaign that need no fuzzer: files, shares of time, engines' output, coverage
and documents."""

import os
import stat
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

from campaign import (build, child, corpus, document, durable, engine_afl, engine_libfuzzer,
                      line_coverage, schedule, state, toolchain)
from campaign.programs import UsageError


class InDirectory(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.directory = Path(place.name)

    def file(self, name, text):
        path = self.directory / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path


class DurableTest(InDirectory):
    def test_a_failed_write_leaves_the_old_text(self):
        path = self.file("a", "old")
        with self.assertRaises(UnicodeEncodeError):
            durable.write_text(path, "new \udc80")
        self.assertEqual(path.read_text(), "old")

    def test_what_cannot_be_read_is_named(self):
        path = self.file("a.json", "{")
        with self.assertRaisesRegex(ValueError, "a.json cannot be read"):
            durable.read_json(path)
        self.assertIsNone(durable.read_json(self.directory / "none.json"))

    def test_a_lock_is_held_by_one(self):
        first = durable.lock(self.directory / "lock")
        self.assertIsNone(durable.lock(self.directory / "lock"))
        first.close()
        durable.lock(self.directory / "lock").close()


class StateTest(InDirectory):
    def test_saved_and_loaded_it_is_the_same(self):
        one = state.State(seconds=2.5, starts=3, engine="afl", compiler="c")
        one.target("alpha").executions = 7
        one.target("alpha").unusable["x"] = "why"
        one.save(self.directory / "state.json")
        self.assertEqual(state.load(self.directory / "state.json"), (one, None))

    def test_another_format_starts_anew(self):
        for text in ('{"format": 2, "targets": {}}', '[]', '{"format": 1}', "",
                     '{"format": 1, "targets": {"a": {"no": 1}}}'):
            path = self.file("state.json", text)
            loaded, complaint = state.load(path)
            self.assertEqual(loaded, state.State())
            self.assertIn("state.json", complaint)
            self.assertFalse(path.exists())
            self.assertEqual((self.directory / "state.json.unreadable").read_text(), text)


class CorpusTest(InDirectory):
    def test_what_was_set_aside_is_not_overwritten(self):
        for text in ("first", "second"):
            path = corpus.free_name(self.directory / "aside", "a")
            self.file(path.relative_to(self.directory), text)
        self.assertEqual([path.read_text() for path in corpus.inputs(self.directory / "aside")],
                         ["first", "second"])

    def test_a_replacement_killed_halfway_is_undone(self):
        self.file("alpha.old/a", "kept")
        corpus.recover(self.directory / "alpha")
        self.assertEqual((self.directory / "alpha" / "a").read_text(), "kept")

    def test_a_replacement_killed_at_the_end_is_finished(self):
        self.file("alpha.old/a", "old")
        self.file("alpha/a", "merged")
        corpus.recover(self.directory / "alpha")
        self.assertEqual((self.directory / "alpha" / "a").read_text(), "merged")
        self.assertFalse((self.directory / "alpha.old").exists())

    def test_equal_inputs_are_added_once(self):
        (self.directory / "alpha").mkdir()
        for name in ("x", "y"):
            corpus.add(self.directory / "alpha", self.file(name, "same"))
        self.assertEqual(len(corpus.inputs(self.directory / "alpha")), 1)


def _runs(stat_file):
    try:
        return " Z " not in stat_file.read_text(encoding="utf-8")
    except OSError:
        return False


class ChildTest(InDirectory):
    def test_what_runs_too_long_ends_with_everything_it_started(self):
        log = self.directory / "log"
        passed = []
        code = child.run(["sh", "-c", "sleep 60 & echo $!; wait"], log, threading.Event(),
                         seconds=0.5, tick=passed.append)
        self.assertIsNone(code)
        self.assertAlmostEqual(sum(passed), 0.5, delta=0.5)
        started = Path(f"/proc/{log.read_text().strip()}/stat")
        until = time.monotonic() + 10  # a signal that was sent takes effect a little later
        while _runs(started) and time.monotonic() < until:
            time.sleep(0.01)
        self.assertFalse(_runs(started))

    def test_output_and_exit_code_are_kept(self):
        log = self.directory / "log"
        code = child.run(["sh", "-c", "echo $WORD; echo err >&2; exit 7"], log, threading.Event(),
                         {"WORD": "out"})
        self.assertEqual((code, log.read_text()), (7, "out\nerr\n"))


class ScheduleTest(unittest.TestCase):
    def test_turns_share_the_time_evenly(self):
        for jobs in range(1, 7):
            for targets in range(1, 13):
                turns = schedule.number_of_turns(36000, jobs, targets)
                self.assertEqual(turns % targets, 0)
                self.assertEqual(turns % jobs, 0)
                self.assertLess(36000 * jobs / turns, 36000)

    def test_turns_are_near_the_preferred_length(self):
        self.assertEqual(schedule.number_of_turns(36000, 2, 12), 2 * 36000 / 300)
        self.assertEqual(schedule.number_of_turns(60, 1, 2), 2)

    def test_the_target_with_the_least_is_next(self):
        targets, seconds = ["a", "b", "c"], {"a": 5.0, "b": 3.0, "c": 3.0}
        self.assertEqual(schedule.next_target(targets, seconds, []), "b")
        self.assertEqual(schedule.next_target(targets, seconds, ["b"]), "c")
        self.assertEqual(schedule.next_target(targets, seconds, ["b", "c"]), "a")

    def play(self, targets, jobs, seconds, overhead):
        """[(target, begin, length)] of all turns, where a turn takes `overhead` of target and
        length beyond its length."""
        shares, turns = schedule.Schedule(targets, jobs, 0.0, seconds), []
        had, at_work = dict.fromkeys(targets, 0.0), []
        for _ in range(jobs):
            at_work.append((0.0, None))
        while at_work:
            at_work.sort(key=lambda one: one[0])
            now, slot = at_work.pop(0)
            if slot:
                shares.end(slot, now)
            if seconds - now < schedule.LEAST_SECONDS:
                continue
            slot = shares.begin(had, now)
            length = slot.until - now
            self.assertGreater(length, 0)
            turns.append((slot.target, now, length))
            had[slot.target] += length
            at_work.append((slot.until + overhead(slot.target, length), slot))
        return turns

    def test_where_nothing_takes_longer_turns_are_equal_and_all_jobs_end_together(self):
        for jobs, number in ((1, 1), (2, 18), (2, 3), (3, 2), (4, 18), (5, 7)):
            targets = [f"t{index}" for index in range(number)]
            turns = self.play(targets, jobs, 180.0, lambda target, length: 0.0)
            self.assertEqual(len(turns), schedule.number_of_turns(180.0, jobs, number))
            for _, begin, length in turns:
                self.assertAlmostEqual(length, 180.0 * jobs / len(turns))
            names = [target for target, _, _ in turns]
            self.assertEqual({names.count(target) for target in targets},
                             {len(turns) // number})

    def test_every_target_has_a_turn_though_turns_take_longer_than_they_should(self):
        targets = [f"t{index:02}" for index in range(18)]
        for least, overhead in ((3, lambda target, length: 7.0),
                                (4, lambda target, length: length / 2),
                                (1, lambda target, length: 70.0 * (target == "t05")),
                                (1, lambda target, length: 100.0 * (target in ("t01", "t02"))),
                                (10, lambda target, length: -length / 2)):
            for jobs in (2, 3, 4):
                turns = self.play(targets, jobs, 360.0 / jobs, overhead)
                self.assertEqual({target for target, _, _ in turns}, set(targets))
                self.assertGreaterEqual(min(length for _, _, length in turns[:18]), least)
                for _, begin, length in turns:
                    self.assertLessEqual(begin + length, 360.0 / jobs + 1e-9)
                    self.assertLessEqual(length, 20.0 + 1e-9)


class EngineTest(InDirectory):
    def test_libfuzzer_figures_of_all_runs_of_a_turn(self):
        self.file("run-1.log", "#2\tINITED cov: 20 ft: 21 corp: 1/1b exec/s: 0 rss: 31Mb\n"
                               "#1024\tNEW    cov: 25 ft: 30 corp: 2/9b lim: 4 exec/s: 512\n"
                               "==1== ERROR: libFuzzer: deadly signal\n    #0 0x1 in f\n"
                               "stat::number_of_executed_units: 1030\n")
        self.file("run-2.log", "#64\tREDUCE cov: 24 ft: 30 corp: 2/9b lim: 4 exec/s: 512\n")
        done = engine_libfuzzer.progress(self.directory)
        self.assertEqual((done.executions, done.edges), (1094, 25))

    def test_libfuzzer_failing_inputs_by_kind(self):
        for name in ("crash-1", "timeout-2", "oom-3", "leak-4", "slow-unit-5", "taken.crash-6"):
            self.file(f"artifacts/{name}", "")
        self.assertEqual([kind for kind, _ in engine_libfuzzer.artifacts(self.directory)],
                         ["crash", "leak", "oom", "timeout"])

    def test_afl_figures_and_failing_inputs(self):
        self.file("out/default/fuzzer_stats", "execs_done        : 1234\nedges_found       : 56\n")
        self.file("out/default/crashes/README.txt", "")
        self.file("out/default/crashes/id:000000,sig:06", "")
        self.file("out/default/hangs/id:000000,src:1", "")
        done = engine_afl.progress(self.directory)
        self.assertEqual((done.executions, done.edges), (1234, 56))
        self.assertEqual([kind for kind, _ in engine_afl.artifacts(self.directory)],
                         ["crash", "timeout"])


class ToolchainTest(InDirectory):
    def compiler(self, script):
        path = self.file("clang++", f"#!/bin/sh\n{script}\n")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return str(path)

    def test_a_missing_compiler_is_named_with_the_packages(self):
        with self.assertRaises(UsageError) as raised:
            toolchain.find_clang({"CXX": "no-such-clang++"})
        self.assertIn("no-such-clang++: it is not installed", str(raised.exception))
        for package in ("libclang-rt-14-dev", "clang-16", "libclang-rt-19-dev"):
            self.assertIn(package, str(raised.exception))

    def test_a_compiler_without_the_runtime_says_what_it_misses(self):
        broken = self.compiler("echo 'ld: cannot find libclang_rt.fuzzer.a' >&2; exit 1")
        with self.assertRaisesRegex(UsageError, "cannot find libclang_rt.fuzzer.a"):
            toolchain.find_clang({"CXX": broken})

    def test_the_chosen_compiler_is_taken_where_it_works(self):
        good = self.compiler("exit 0")
        self.assertEqual(toolchain.find_clang({"CXX": good}), good)

    def test_debian_names_are_tried_in_their_order(self):
        self.compiler("exit 0")
        with mock.patch.dict(os.environ, PATH=f"{self.directory}:{os.environ['PATH']}"):
            self.assertEqual(toolchain.find_clang({}), "clang++")


    def test_where_nothing_can_be_installed_all_packages_are_named(self):
        refusal = UsageError("no right to")
        with (mock.patch.object(toolchain, "CANDIDATES", ("no-such-clang++",)),
              mock.patch.dict(os.environ), mock.patch.object(build, "install") as install):
            os.environ.pop("CXX", None)
            install.side_effect = refusal
            with self.assertRaisesRegex(UsageError, "libclang-rt-14-dev.*libclang-rt-19-dev"):
                build.find_clang()
            install.assert_called_once_with("packages_fuzz")


class LineCoverageTest(unittest.TestCase):
    TRACE = ("SF:/project/kernel/src/a.cpp\nDA:3,0\nDA:4,2\nDA:5,0\nDA:6,0\nend_of_record\n"
             "SF:/project/kernel/include/a.hpp\nDA:1,1\nend_of_record\n"
             "SF:/project/kernel/tests/a_test.cpp\nDA:1,0\nend_of_record\n"
             "SF:/usr/include/vector\nDA:1,0\nend_of_record\n")

    def test_lines_of_sources_and_headers_count(self):
        coverage = line_coverage.LineCoverage(line_coverage.parse_lcov(self.TRACE, "/project"))
        self.assertEqual(coverage.files("kernel"), ["kernel/include/a.hpp", "kernel/src/a.cpp"])
        self.assertEqual(coverage.total("kernel"), line_coverage.Count(5, 2))
        self.assertEqual(coverage.total("kernel").text(), "2 of 5, 40.00 %")
        self.assertEqual(coverage.missed("kernel/src/a.cpp"), [3, 5, 6])
        self.assertEqual(coverage.files("geometry"), [])

    def test_ranges_of_lines(self):
        self.assertEqual(line_coverage.ranges([3, 5, 6, 7, 9]), "3, 5-7, 9")
        self.assertEqual(line_coverage.ranges([]), "")


class DocumentTest(unittest.TestCase):
    BLOCKS = [document.Heading("A < B"),
              document.Table(["name", "of", "n"], [["x|y", "<3", "1,000"]]),
              document.Code("```\n<code>")]

    def test_markdown(self):
        self.assertEqual(document.to_markdown(self.BLOCKS),
                         "## A < B\n\n| name | of | n |\n| --- | --- | ---: |\n"
                         "| x\\|y | <3 | 1,000 |\n\n"
                         "````text\n```\n<code>\n````\n")

    def test_html(self):
        page = document.to_html("T", self.BLOCKS)
        for part in ("<h2>A &lt; B</h2>", "<td>x|y</td><td>&lt;3</td><td class=n>1,000</td>",
                     "&lt;code&gt;</pre>"):
            self.assertIn(part, page)


if __name__ == "__main__":
    unittest.main()
