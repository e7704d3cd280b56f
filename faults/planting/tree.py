"""The copy of the project in which faults are planted."""

import os
import shutil
from contextlib import contextmanager
from pathlib import Path

LEFT_OUT = {".git", "build", "out"}


def project_files(root):
    """Every file of the project, from the root; build folders are not of the project."""
    for folder, folders, names in os.walk(root):
        top = Path(folder) == Path(root)
        folders[:] = sorted(name for name in folders
                            if name != "__pycache__"
                            and not (top and (name in LEFT_OUT or name.startswith("build-"))))
        for name in sorted(names):
            yield (Path(folder) / name).relative_to(root)


def copy_project(root, tree):
    """Makes the tree equal to the project. Times are copied too, so a fault that was left in the
    tree by a kill is gone afterwards and nothing is built again because of it."""
    root, tree = Path(root), Path(tree)
    wanted = set(project_files(root))
    if tree.is_dir():
        for path in set(project_files(tree)) - wanted:
            (tree / path).unlink()
    for path in wanted:
        source, copy = root / path, tree / path
        if copy.is_file() and source.stat().st_mtime_ns == copy.stat().st_mtime_ns \
                and source.read_bytes() == copy.read_bytes():
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, copy)


@contextmanager
def planted(fault, tree):
    """The tree with that fault in it, for as long as the context lasts."""
    copy = Path(tree) / fault.path
    content = copy.read_text()
    said = fault.objection(content)
    if said:
        raise RuntimeError(f"{fault.name}: {said}")
    times = copy.stat()
    copy.write_text(fault.planted(content))
    try:
        yield
    finally:
        copy.write_text(content)
        os.utime(copy, ns=(times.st_atime_ns, times.st_mtime_ns))
