"""The campaign: jobs take turns with the targets until the time is over, and everything it has is
on disk, so that a start after any end continues it."""

import shutil
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType

from campaign import corpus
from campaign import state as states
from campaign.engines import ENGINES
from campaign.findings import Findings
from campaign.programs import Programs
from campaign.schedule import LEAST_SECONDS, USEFUL_SECONDS, Schedule
from campaign.turn import Limits, Turn

SAVE_SECONDS = 10.0
_MERGE_FROM = 200  # inputs; below, there is nothing to gain
_MERGE_GROWTH = 2  # times the inputs after the last merge
_MERGE_SHARE = 0.25  # of the target's time so far, at most


@dataclass
class Settings:
    engine: ModuleType
    programs: Programs
    targets: list
    directory: Path
    seconds: float  # of all starts together
    jobs: int = 1
    megabytes_free: int = 500  # the campaign ends before the disk is full
    limits: Limits = field(default_factory=Limits)
    compiler: str = ""


class Campaign:
    def __init__(self, settings, say=print):
        self.settings = settings
        self.directory = settings.directory
        self.state, complaint = states.load(self.directory / "state.json")
        self.findings = Findings(self.directory / "findings", settings.programs, settings.engine,
                                 settings.limits)
        self.ended_by = ""  # why it ended before its time; empty: it did not
        self._say = say
        self._stop = threading.Event()
        self._lock = threading.Lock()  # of state and _schedule
        self._tidying = threading.Lock()  # of what is set aside: jobs may share a corpus
        self._schedule = None
        self._turns = 0
        for text in [*([complaint] if complaint else []), *self.findings.unreadable]:
            say(text)

    def end(self, why):
        """Ends the jobs in order; from any thread and from signal handlers."""
        self.ended_by = self.ended_by or why
        self._stop.set()

    def run(self):
        settings = self.settings
        self.state.starts += 1
        self.state.engine, self.state.compiler = settings.engine.NAME, settings.compiler
        for target in settings.targets:
            self._open(target)
        self._save()
        self._take_over_left_turns()
        self.findings.minimise_rest(self._stop)
        remaining = settings.seconds - self.state.seconds
        if remaining >= LEAST_SECONDS:
            self._share(remaining)
        else:
            self._say(f"it has had its {hours(settings.seconds)}; with more time it continues")
        self._guarded(self._save)

    def _share(self, remaining):
        """Jobs beside each other; this thread keeps the time, the state and an eye on the disk."""
        begun, before = time.monotonic(), self.state.seconds
        until = begun + remaining
        self._schedule = Schedule(self.settings.targets, self.settings.jobs, begun, until)
        self._warn_of_short_shares()
        jobs = [threading.Thread(target=self._job, args=(until,))
                for _ in range(self.settings.jobs)]
        for job in jobs:
            job.start()
        saved = begun
        while any(job.is_alive() for job in jobs):
            time.sleep(0.1)
            now = time.monotonic()
            self.state.seconds = before + min(now, until) - begun
            if now - saved >= SAVE_SECONDS:
                saved = now
                self._watch_disk()
                self._guarded(self._save)

    def _warn_of_short_shares(self):
        each, targets = self._schedule.each, self.settings.targets
        if each < USEFUL_SECONDS:
            enough = USEFUL_SECONDS * len(targets) / self.settings.jobs / 60
            self._say(f"each of {len(targets)} targets gets {each:.1f} s, which may not be enough "
                      f"to start and to read the seeds; {enough:.1f} minutes give it "
                      f"{USEFUL_SECONDS:.0f} s")

    def _job(self, until):
        while not self._stop.is_set() and until - time.monotonic() >= LEAST_SECONDS:
            self._guarded(self._turn)

    def _guarded(self, action):
        """A full disk, or anything unforeseen, ends the campaign with its report, not without."""
        try:
            action()
        except Exception as error:  # pylint: disable=broad-except
            self.end(f"{type(error).__name__}: {error}")

    def _turn(self):
        self._watch_disk()
        if self._stop.is_set():
            return
        with self._lock:
            seconds = {name: self.state.target(name).seconds for name in self.settings.targets}
            slot = self._schedule.begin(seconds, time.monotonic())
            target = slot.target
            self._turns += 1
            turn = self._new_turn(self.settings.engine, target,
                                  f"{self.settings.engine.NAME}.{target}."
                                  f"{self.state.starts}-{self._turns}")
        try:
            self._drop_unusable(target)
            complaint = turn.run(slot.until, self._stop,
                                 lambda passed: self._add_seconds(target, passed),
                                 self._take_findings)
            if complaint:
                self.end(f"{target}: {complaint}")
            self._take_over(turn)
            self._merge(turn, slot)
            turn.remove()
        finally:
            with self._lock:
                self._schedule.end(slot, time.monotonic())

    def _new_turn(self, engine, target, name):
        return Turn(target, engine, self.settings.programs, self.directory / "work" / name,
                    self.directory / "corpus" / target, self.directory / "seeds" / target,
                    self.settings.limits)

    def _open(self, target):
        """Directories and seeds."""
        self.state.target(target)
        directory = self.directory / "corpus" / target
        corpus.recover(directory)
        directory.mkdir(parents=True, exist_ok=True)
        self.settings.programs.write_seeds(target, self.directory / "seeds" / target)

    def _drop_unusable(self, target):
        for directory in ("corpus", "seeds"):
            with self._tidying:
                unusable = corpus.set_aside_unusable(self.directory / directory / target,
                                                     self.directory / "set-aside" / target)
            for name, why in unusable.items():
                self._say(f"{target}: corpus file {name} set aside: {why}")
            self._note_unusable(target, unusable)

    def _note_unusable(self, target, unusable):
        with self._lock:
            self.state.target(target).unusable.update(unusable)

    def _add_seconds(self, target, seconds):
        with self._lock:
            self.state.target(target).seconds += seconds

    def _take_findings(self, turn):
        """Failing inputs become findings. One that is in the corpus would stop every run at its
        beginning: it leaves the corpus."""
        logs = sorted(turn.work.glob("run-*.log"), key=lambda path: path.stat().st_mtime)
        printed = logs[-1].read_text(encoding="utf-8", errors="replace") if logs else ""
        for kind, path in turn.engine.artifacts(turn.work):
            finding = self.findings.take(turn.target, kind, path, printed, self._stop)
            if finding:
                self._say(f"{turn.target}: {finding.kind}: {finding.signature}; see "
                          f"{self.findings.path(finding)}")
            self._set_aside_failing(turn, path)
            if not self._stop.is_set():
                path.rename(path.with_name(f"taken.{path.name}"))

    def _set_aside_failing(self, turn, failing):
        content = failing.read_bytes()
        with self._tidying:
            for directory in (turn.corpus, turn.seeds):
                for path in corpus.inputs(directory):
                    if path.stat().st_size == len(content) and path.read_bytes() == content:
                        aside = self.directory / "set-aside" / turn.target
                        aside.mkdir(parents=True, exist_ok=True)
                        path.rename(corpus.free_name(aside, path.name))
                        self._note_unusable(turn.target, {path.name: "it fails by itself"})

    def _take_over(self, turn):
        """Everything a turn leaves: inputs, findings and figures."""
        turn.engine.collect(turn)
        self._take_findings(turn)
        done = turn.engine.progress(turn.work)
        with self._lock:
            target = self.state.target(turn.target)
            target.turns += 1
            target.executions += done.executions
            target.edges = max(target.edges, done.edges)
        self._say(self._line(turn.target, done))
        self._save()

    def _take_over_left_turns(self):
        """Of a campaign that was killed: its turns' files are still there."""
        for work in sorted((self.directory / "work").glob("*.*.*")):
            engine, target, _ = work.name.split(".")
            if target in self.settings.targets and engine in ENGINES:
                turn = self._new_turn(ENGINES[engine], target, work.name)
                self._take_over(turn)
                turn.remove()

    def _merge(self, turn, slot):
        """What takes too long is tried again when the corpus has doubled."""
        size = len(corpus.inputs(turn.corpus))
        with self._lock:
            target = self.state.target(turn.target)
            alone = self._schedule.is_alone(slot)
            due = size >= max(_MERGE_FROM, _MERGE_GROWTH * target.merged_inputs)
        if not due or not alone or self._stop.is_set():
            return
        merged = turn.merge(_MERGE_SHARE * target.seconds, self._stop)
        if merged is not None:
            corpus.replace(turn.corpus, merged)
        elif self._stop.is_set():
            return
        target.merged_inputs = len(corpus.inputs(turn.corpus))
        self._say(f"{turn.target}: corpus " + (f"of {size} inputs not merged" if merged is None else
                                               f"merged, {size} -> {target.merged_inputs} inputs"))

    def _line(self, name, done):
        """One line a turn: where the campaign is, and how the target does."""
        target = self.state.target(name)
        rate = target.executions / target.seconds if target.seconds else 0
        return (f"[{hours(self.state.seconds)} of {hours(self.settings.seconds)}] "
                f"round {target.turns} {name}: +{done.executions:,} executions, {rate:,.0f}/s, "
                f"corpus {len(corpus.inputs(self.directory / 'corpus' / name)):,}, "
                f"edges {target.edges:,}, findings {len(self.findings.of(name))}")

    def _watch_disk(self):
        free = shutil.disk_usage(self.directory).free // 1_000_000
        if free < self.settings.megabytes_free:
            self.end(f"the disk is nearly full: {free} MB free, at least "
                     f"{self.settings.megabytes_free} MB are kept")

    def _save(self):
        with self._lock:
            self.state.save(self.directory / "state.json")


def hours(seconds):
    seconds = round(seconds)
    return f"{seconds // 3600}:{seconds // 60 % 60:02}:{seconds % 60:02}"
