"""The report, in Markdown."""

from collections import Counter
from statistics import median

from .trial import HUNG, KILLED, SURVIVED, UNCOMPILED

LEAST = {"kernel": 1.0}  # share of its faults a room must kill
LEAST_OVERALL = 0.95


class Score:
    def __init__(self, faults, known):
        self.known = {fault.name: known[fault.name] for fault in faults if fault.name in known}
        self.count = Counter(kept["result"] for kept in self.known.values())
        self.planned = len(faults)

    @property
    def noticed(self):
        return self.count[KILLED] + self.count[HUNG]

    @property
    def judged(self):
        return self.noticed + self.count[SURVIVED]

    @property
    def share(self):
        return self.noticed / self.judged if self.judged else 1.0

    @property
    def seconds(self):
        return median(kept["seconds"] for kept in self.known.values()) if self.known else 0.0

    def row(self, name):
        score = f"{100 * self.share:.1f} %" if self.judged else "-"
        return (f"| {name} | {self.planned} | {self.noticed} | {self.count[HUNG]} "
                f"| {self.count[SURVIVED]} | {self.count[UNCOMPILED]} "
                f"| {self.planned - len(self.known)} | {score} "
                f"| {self.seconds:.1f} |")


HEAD = ("| {} | planted | killed | of these by the time limit | survived | does not compile "
        "| not yet run | score | median seconds |\n|---|---|---|---|---|---|---|---|---|")


def table(title, faults, known, of):
    groups = sorted({of(fault) for fault in faults})
    yield HEAD.format(title)
    for group in groups:
        yield Score([fault for fault in faults if of(fault) == group], known).row(group)
    yield Score(faults, known).row("all")
    yield ""


def listed(title, faults, known, result):
    chosen = [fault for fault in faults
              if fault.name in known and known[fault.name]["result"] == result]
    if not chosen:
        return
    yield f"## {title}\n"
    for fault in chosen:
        kept = known[fault.name]
        said = f" ({kept['by']}: {kept['what']})" if kept["by"] else ""
        yield f"**{fault.name}**: {fault.kind}, `{fault.path}`{said}\n"
        yield "```diff"
        yield from (f"- {line}" for line in fault.before)
        yield from (f"+ {line}" for line in fault.after)
        yield "```\n"


def report(faults, known):
    lines = ["# Planted faults\n"]
    lines += table("room", faults, known, lambda fault: fault.room)
    lines += table("kind", faults, known, lambda fault: fault.kind)
    lines += listed("Survived", faults, known, SURVIVED)
    lines += listed("Killed by the time limit", faults, known, HUNG)
    lines += listed("Does not compile", faults, known, UNCOMPILED)
    lines.append("## Who noticed\n")
    lines.append("| fault | killed by | seconds | programs asked |\n|---|---|---|---|")
    for fault in faults:
        kept = known.get(fault.name)
        if kept and kept["result"] in (KILLED, HUNG):
            lines.append(f"| {fault.name} | {kept['by']}: {kept['what']} | {kept['seconds']} "
                         f"| {kept['tried']} |")
    return "\n".join(lines) + "\n"


def shortfalls(faults, known):
    """What keeps the score from what is asked of it."""
    rooms = [(f"the faults in {room}", [f for f in faults if f.room == room], share)
             for room, share in LEAST.items()]
    for name, group, least in [*rooms, ("all faults", faults, LEAST_OVERALL)]:
        score = Score(group, known)
        if score.share < least:
            yield (f"{score.noticed} of {score.judged} of {name} were noticed, "
                   f"{100 * least:.0f} % are asked for")
