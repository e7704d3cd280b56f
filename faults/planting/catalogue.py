"""The catalogue: faults/ROOM.faults, as faults/README.md describes it."""

import re
from dataclasses import dataclass, field
from pathlib import Path

NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
KINDS = (
    "wrong twin", "swapped corner", "missing update", "off by one", "wrong refusal",
    "missing refusal", "stale cache", "lost sign", "tolerance instead of exact", "unchecked count",
    "wrong constant", "dropped case", "wrong order", "lost error", "wrong operator",
    "wrong operand", "early exit",
)


class Wrong(Exception):
    """What is wrong with the catalogue, with the place."""


@dataclass
class Fault:
    name: str
    kind: str
    room: str
    path: str  # of the source, from the root
    place: str  # of the entry, FILE:LINE
    near: list  # tests to ask first, where none has the source's name
    before: list = field(default_factory=list)
    after: list = field(default_factory=list)

    @property
    def text(self):
        return "\n".join(self.before)

    @property
    def replacement(self):
        return "\n".join(self.after)

    def objection(self, content):
        """Why the fault cannot be planted in that text, or nothing."""
        found = content.count(self.text)
        if found != 1:
            return f"its text occurs {found} times in {self.path}"
        return None

    def planted(self, content):
        return content.replace(self.text, self.replacement)


def read_room(path):
    room, source, near, faults = path.stem, None, [], []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        place = f"{path.parent.name}/{path.name}:{number}"
        if line.startswith("= "):
            source, *near = line[2:].split()
        elif line.startswith(("- ", "+ ")) or line in ("-", "+"):
            if not faults or faults[-1].path != source:
                raise Wrong(f"{place}: a text before any fault")
            (faults[-1].before if line[0] == "-" else faults[-1].after).append(line[2:])
        elif line.strip() and not line.startswith("#"):
            name, bar, kind = (part.strip() for part in line.partition("|"))
            if source is None:
                raise Wrong(f"{place}: a fault before any '= SOURCE'")
            if not bar or not NAME.fullmatch(name):
                raise Wrong(f"{place}: expected 'name | kind', found '{line}'")
            if kind not in KINDS:
                raise Wrong(f"{place}: there is no kind '{kind}'")
            faults.append(Fault(name, kind, room, source, place, near))
    return faults


def read_catalogue(folder):
    faults = [fault for path in sorted(Path(folder).glob("*.faults")) for fault in read_room(path)]
    seen = {}
    for fault in faults:
        if fault.name in seen:
            raise Wrong(f"{fault.place}: '{fault.name}' is already at {seen[fault.name]}")
        seen[fault.name] = fault.place
    return faults


def objections(faults, root):
    """One line for each entry that no longer fits the sources."""
    texts, twins, result = {}, {}, []
    for fault in faults:
        if fault.path not in texts:
            path = Path(root) / fault.path
            texts[fault.path] = path.read_text() if path.is_file() else None
        content = texts[fault.path]
        changed = None
        if content is None:
            said = f"there is no file {fault.path}"
        elif not fault.text.strip():
            said = "it has no text to replace"
        elif fault.text == fault.replacement:
            said = "it replaces a text by itself"
        else:
            said = fault.objection(content)
            changed = None if said else (fault.path, fault.planted(content))
        if changed in twins:
            said = f"it is the same as '{twins[changed]}'"
        elif changed:
            twins[changed] = fault.name
        if said:
            result.append(f"{fault.place}: {fault.name}: {said}")
    return result
