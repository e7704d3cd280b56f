"""What is known so far, on disk after every fault, so that a run can be killed and continued."""

import hashlib
import json
import os
from pathlib import Path


class Record:
    def __init__(self, path, tree):
        self.path, self.tree = Path(path), Path(tree)
        kept = {}
        if self.path.is_file():
            try:
                kept = json.loads(self.path.read_text())
            except json.JSONDecodeError:
                pass  # half a file is none
        self.baseline = kept.get("baseline", {})
        self.results = kept.get("results", {})
        self.hashes = {}

    def save(self):
        part = self.path.with_suffix(".part")
        part.write_text(json.dumps({"baseline": self.baseline, "results": self.results}, indent=1))
        os.replace(part, self.path)

    def forget(self, names):
        for name in names:
            self.results.pop(name, None)

    def keep(self, fault, verdict):
        files = sorted(str(path.relative_to(self.tree)) for path in verdict.files
                       if self.tree in path.parents)
        self.results[fault.name] = {
            "result": verdict.result, "by": verdict.by, "what": verdict.what,
            "seconds": round(verdict.seconds, 1), "tried": verdict.tried,
            "files": files, "digest": self.digest(fault, files)}
        self.save()

    def known(self, fault):
        """The result, if everything it stands on is as it was."""
        kept = self.results.get(fault.name)
        if kept and kept["digest"] == self.digest(fault, kept["files"]):
            return kept
        return None

    def last_noticed_by(self, fault):
        return self.results.get(fault.name, {}).get("by")

    def digest(self, fault, files):
        total = hashlib.sha256("\0".join([fault.path, fault.text, fault.replacement]).encode())
        for name in files:
            total.update(self.hash_of(name).encode())
        return total.hexdigest()

    def hash_of(self, name):
        if name not in self.hashes:
            path = self.tree / name
            self.hashes[name] = \
                hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "absent"
        return self.hashes[name]
