"""What a campaign knows of itself between two starts. Corpora and findings are not in it: they are
files of their own, and are read from their directories."""

from dataclasses import asdict, dataclass, field, fields

from campaign import durable

FORMAT = 1


@dataclass
class TargetState:
    """What was done for one target so far."""

    seconds: float = 0.0
    turns: int = 0
    executions: int = 0
    edges: int = 0
    merged_inputs: int = 0  # inputs in the corpus after the last merge
    unusable: dict = field(default_factory=dict)  # name of a corpus file -> why it was set aside


@dataclass
class State:
    seconds: float = 0.0  # of all starts together, by the clock on the wall
    starts: int = 0
    engine: str = ""
    compiler: str = ""
    targets: dict = field(default_factory=dict)

    def target(self, name):
        return self.targets.setdefault(name, TargetState())

    def save(self, path):
        value = {"format": FORMAT} | {f.name: getattr(self, f.name) for f in fields(self)}
        # Copies: the turns add names while this is written.
        value["targets"] = {name: asdict(one) for name, one in list(self.targets.items())}
        durable.write_json(path, value)


def load(path):
    """(state, complaint): a state that cannot be read is put aside under another name, and the
    figures start anew; the complaint says so."""
    try:
        value = durable.read_json(path)
        if value is None:
            return State(), None
        if not isinstance(value, dict) or value.pop("format", None) != FORMAT:
            raise ValueError(f"{path} cannot be read: it is not a state of format {FORMAT}")
        targets = {name: TargetState(**one) for name, one in value.pop("targets").items()}
        return State(targets=targets, **value), None
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        aside = path.with_name(path.name + ".unreadable")
        path.replace(aside)
        return State(), f"{error}; it is now {aside.name}, and the figures start anew"
