"""How the time is shared: the target with the least time so far goes next, for one slice."""

import math

PREFERRED_SECONDS = 300.0


def slice_seconds(remaining, jobs, targets):
    """The length of a turn: near the preferred one, and such that all targets have equally many
    turns and all jobs end together."""
    together = jobs // math.gcd(jobs, targets)  # rounds after which every job has had as many turns
    each = remaining * jobs / targets  # seconds of a target
    rounds = max(together, together * round(each / PREFERRED_SECONDS / together))
    return each / rounds


def next_target(targets, seconds, running):
    """The target with the fewest jobs now, of these the one with the least time, of these the
    first. seconds: time so far by name; running: names, one a job at work."""
    return min(targets, key=lambda name: (running.count(name), seconds[name],
                                          targets.index(name)))
