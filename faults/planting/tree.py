"""The copy of the project in which faults are planted."""

import os
import shutil
from contextlib import contextmanager
from pathlib import Path

LEFT_OUT = {".git", "build", "out"}
INTACT = ".intact"  # follows the name of a source while a fault is in its place


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
    """Makes the tree equal to the project. What changed is new, whatever its time in the project,
    so that everything made from it is made again; a fault that a kill left in the tree is taken out
    first, and nothing is made again because of it."""
    root, tree = Path(root), Path(tree)
    for intact in tree.rglob(f"*{INTACT}"):
        os.replace(intact, intact.with_name(intact.name.removesuffix(INTACT)))
    wanted = set(project_files(root))
    if tree.is_dir():
        for path in set(project_files(tree)) - wanted:
            (tree / path).unlink()
    for path in wanted:
        source, copy = root / path, tree / path
        if copy.is_file() and source.read_bytes() == copy.read_bytes():
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, copy)
        shutil.copymode(source, copy)


@contextmanager
def planted(fault, tree):
    """The tree with that fault in it, for as long as the context lasts."""
    copy = Path(tree) / fault.path
    content = copy.read_text()
    said = fault.objection(content)
    if said:
        raise RuntimeError(f"{fault.name}: {said}")
    intact = copy.with_name(copy.name + INTACT)  # with its time
    os.replace(copy, intact)
    try:
        copy.write_text(fault.planted(content))
        yield
    finally:
        os.replace(intact, copy)
