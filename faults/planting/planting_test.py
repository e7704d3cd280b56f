import os
import tempfile
import unittest
from pathlib import Path

from planting.catalogue import Wrong, objections, read_catalogue
from planting.programs import run_limited, what_happened
from planting.record import Record
from planting.report import Score, report, shortfalls
from planting.tree import copy_project, planted
from planting.trial import KILLED, SURVIVED, UNCOMPILED, Verdict

ENTRY = """= a/source.cpp source_test

turns-back | lost sign
- return x;
+ return -x;
"""


class InFolder(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = Path(self.place.name)
        (self.folder / "root/a").mkdir(parents=True)
        (self.folder / "root/a/source.cpp").write_text("int f(int x) {\n    return x;\n}\n")
        (self.folder / "faults").mkdir()

    def tearDown(self):
        self.place.cleanup()

    def read(self, text):
        (self.folder / "faults/kernel.faults").write_text(text)
        return read_catalogue(self.folder / "faults")


class Catalogue(InFolder):
    def test_reads_an_entry(self):
        [fault] = self.read(ENTRY)
        self.assertEqual((fault.name, fault.kind, fault.room, fault.path, fault.near),
                         ("turns-back", "lost sign", "kernel", "a/source.cpp", ["source_test"]))
        self.assertEqual(fault.planted("{ return x; }"), "{ return -x; }")

    def test_an_empty_replacement_deletes(self):
        [fault] = self.read(ENTRY.replace("+ return -x;", "+"))
        self.assertEqual(fault.planted("{return x;}"), "{}")

    def test_refuses_what_is_no_entry(self):
        for text in ("turns-back | lost sign\n", ENTRY.replace("lost sign", "no such kind"),
                     ENTRY.replace("turns-back", "Turns Back"), ENTRY + ENTRY,
                     "= a/source.cpp\n- return x;\n", "= a/source.cpp\nturns-back\n"):
            with self.subTest(text), self.assertRaises(Wrong):
                self.read(text)

    def test_objects_to_what_does_not_fit(self):
        root = self.folder / "root"
        self.assertEqual(objections(self.read(ENTRY), root), [])
        twice = ENTRY + "\nturns-back-again | lost sign\n- return x;\n+ return -x;\n"
        for text, said in ((ENTRY.replace("- return x;", "- return y;"), "occurs 0 times"),
                           (ENTRY.replace("- return x;", "- x"), "occurs 2 times"),
                           (ENTRY.replace("a/source.cpp", "a/none.cpp"), "there is no file"),
                           (ENTRY.replace("-x", "x"), "by itself"), (twice, "is the same as")):
            [objection] = objections(self.read(text), root)
            self.assertIn(said, objection)


class Tree(InFolder):
    def test_a_fault_is_there_and_gone(self):
        root, tree = self.folder / "root", self.folder / "tree"
        copy_project(root, tree)
        copy = tree / "a/source.cpp"
        before, time = copy.read_text(), copy.stat().st_mtime_ns
        with planted(self.read(ENTRY)[0], tree):
            self.assertIn("return -x;", copy.read_text())
        self.assertEqual((copy.read_text(), copy.stat().st_mtime_ns), (before, time))

    def test_copying_again_takes_away_what_a_kill_left(self):
        root, tree = self.folder / "root", self.folder / "tree"
        copy_project(root, tree)
        time = (tree / "a/source.cpp").stat().st_mtime_ns
        [fault] = self.read(ENTRY)
        if os.fork() == 0:
            with planted(fault, tree):
                os._exit(0)  # as a kill ends it
        os.wait()
        self.assertIn("return -x;", (tree / "a/source.cpp").read_text())
        (tree / "a/foreign.cpp").write_text("")
        copy_project(root, tree)
        self.assertIn("return x;", (tree / "a/source.cpp").read_text())
        self.assertEqual((tree / "a/source.cpp").stat().st_mtime_ns, time)
        self.assertEqual([path.name for path in (tree / "a").iterdir()], ["source.cpp"])

    # A change of yesterday that is copied today is newer than what was made this morning.
    def test_what_changed_is_new_in_the_tree(self):
        root, tree = self.folder / "root", self.folder / "tree"
        copy_project(root, tree)
        time = (tree / "a/source.cpp").stat().st_mtime_ns
        (root / "a/source.cpp").write_text("int f(int x) {\n    return 2 * x;\n}\n")
        os.utime(root / "a/source.cpp", ns=(0, 0))
        copy_project(root, tree)
        self.assertIn("2 * x", (tree / "a/source.cpp").read_text())
        self.assertGreater((tree / "a/source.cpp").stat().st_mtime_ns, time)


class Results(InFolder):
    def test_stand_until_a_file_changes(self):
        [fault] = self.read(ENTRY)
        root, path = self.folder / "root", self.folder / "results.json"
        verdict = Verdict(KILLED, "kernel.source_test", "Turns.Back", 1, 1,
                          frozenset({root / "a/source.cpp"}))
        Record(path, root).keep(fault, verdict)
        self.assertEqual(Record(path, root).known(fault)["by"], "kernel.source_test")
        (root / "a/source.cpp").write_text("int f(int x) {\n    return x;\n}\n// new\n")
        self.assertIsNone(Record(path, root).known(fault))
        path.write_text('{"results": {"turns-')
        self.assertIsNone(Record(path, root).known(fault))

    def test_the_score_leaves_out_what_does_not_compile(self):
        faults = self.read(ENTRY + "".join(
            f"\nfault-{i} | lost sign\n- return x;\n+ return {i};\n" for i in range(3)))
        results = (KILLED, SURVIVED, UNCOMPILED, KILLED)
        known = {fault.name: {"result": result, "by": "", "what": "", "seconds": 1, "tried": 1}
                 for fault, result in zip(faults, results)}
        score = Score(faults, known)
        self.assertEqual((score.noticed, score.judged), (2, 3))
        self.assertEqual(len(list(shortfalls(faults, known))), 2)
        self.assertIn("**fault-0**", report(faults, known))
        self.assertEqual(list(shortfalls(faults[:1], known)), [])


class Programs(InFolder):
    def test_say_which_test_failed(self):
        self.assertEqual(what_happened("[ RUN      ] A.B\n[  FAILED  ] A.B (3 ms)\n", 1, False),
                         "A.B")
        self.assertEqual(what_happened("[ RUN      ] A.B\n", -11, False), "A.B: SIGSEGV")
        self.assertEqual(what_happened("[ RUN      ] A.B\n", -9, True), "A.B: no end")
        self.assertEqual(what_happened("", 3, False), "exit 3")

    def test_are_ended_by_the_clock_with_their_children(self):
        outcome = run_limited(["sh", "-c", "sleep 60 & wait"], self.folder / "scratch", 0.2)
        self.assertTrue(outcome.hung and not outcome.passed)
        self.assertLess(outcome.seconds, 30)


if __name__ == "__main__":
    unittest.main()
