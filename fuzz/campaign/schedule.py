"""How the time is shared: the target with the least time so far goes next, for as long as lets
every target come as often as planned. What turns take beyond their time (an engine that reads its
seeds slowly, a merge, a finding to look into) is taken from all later ones alike, not from the
targets that come last."""

import math
from dataclasses import dataclass

PREFERRED_SECONDS = 300.0  # of a turn
USEFUL_SECONDS = 5.0  # a sanitized fuzzer starts and reads its seeds in about two
LEAST_SECONDS = 1.0  # in less, no engine gets to work


def number_of_turns(seconds, jobs, targets):
    """Such that turns are near the preferred length, all targets have equally many and all jobs end
    together."""
    together = jobs // math.gcd(jobs, targets)  # rounds after which every job has had as many turns
    each = seconds * jobs / targets  # seconds of a target
    return targets * max(together, together * round(each / PREFERRED_SECONDS / together))


def next_target(targets, seconds, running):
    """The target with the fewest jobs now, of these the one with the least time, of these the
    first. seconds: time so far by name; running: names, one a job at work."""
    return min(targets, key=lambda name: (running.count(name), seconds[name],
                                          targets.index(name)))


@dataclass(eq=False)
class Slot:
    """The time of a turn."""

    target: str
    until: float


class Schedule:
    """The turns from now until the end, on a clock of seconds that the caller reads."""

    def __init__(self, targets, jobs, now, until):
        self.each = (until - now) * jobs / len(targets)  # seconds of a target
        self._targets, self._jobs, self._until = targets, jobs, until
        self._turns = number_of_turns(until - now, jobs, len(targets))  # still to begin
        self._planned = self.each * len(targets) / self._turns  # seconds of a turn
        self._running = []
        self._ended, self._overrun = 0, 0.0  # turns, and what they took beyond their time together

    def begin(self, seconds, now):
        """The next turn's slot; `end` takes it back. seconds: time so far by target."""
        target = next_target(self._targets, seconds, [slot.target for slot in self._running])
        # Of one that is over its time nobody knows more than that: as much longer again.
        busy = sum(abs(slot.until - now) for slot in self._running)
        share = ((self._until - now) * self._jobs - busy) / max(1, self._turns)
        share = max(share / 2, share - self._overrun / max(1, self._ended))
        length = max(LEAST_SECONDS, min(self._planned, share))
        self._turns -= 1
        slot = Slot(target, min(now + length, self._until))
        self._running.append(slot)
        return slot

    def end(self, slot, now):
        self._running.remove(slot)
        self._ended += 1
        self._overrun += max(0.0, now - slot.until)

    def is_alone(self, slot):
        """Whether no other job has the same target now."""
        return [other.target for other in self._running].count(slot.target) == 1
