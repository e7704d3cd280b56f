"""Corpus directories: one input a file."""

import hashlib
import os
import shutil

MOST_BYTES = 1 << 20  # what is larger came from elsewhere: targets take a few kilobytes


def complaint(path):
    """Why the file cannot serve as an input, or None."""
    if path.is_symlink() and not path.exists():
        return "a link to nothing"
    if not path.is_file():
        return "not a regular file"
    try:
        with open(path, "rb") as file:
            if len(file.read(MOST_BYTES + 1)) > MOST_BYTES:
                return f"more than {MOST_BYTES} bytes"
    except OSError as error:
        return error.strerror
    return None


def set_aside_unusable(directory, aside):
    """Moves what no engine could read out of the corpus; names with reasons."""
    unusable = {}
    for path in sorted(directory.iterdir()):
        why = complaint(path)
        if why is not None:
            unusable[path.name] = why
            aside.mkdir(parents=True, exist_ok=True)
            os.replace(path, free_name(aside, path.name))
    return unusable


def free_name(directory, name):
    """A path in the directory that nothing has yet, so that nothing set aside is overwritten."""
    path, number = directory / name, 1
    while path.exists() or path.is_symlink():
        number += 1
        path = directory / f"{name}.{number}"
    return path


def inputs(directory):
    """The files of the corpus, in the order of their names."""
    if not directory.is_dir():
        return []
    return sorted(path for path in directory.iterdir() if path.is_file())


def content_name(path):
    """The name libFuzzer gives an input: equal inputs have equal names."""
    return hashlib.sha1(path.read_bytes()).hexdigest()


def add(directory, path):
    """Copies an input into the corpus, by temporary name and rename."""
    target = directory / content_name(path)
    if not target.exists():
        part = directory.parent / f".{directory.name}.{target.name}.part"
        shutil.copyfile(path, part)
        os.replace(part, target)


def replace(directory, merged):
    """Puts the merged corpus in the place of the directory. Killed between the two renames, the
    next start finds the old corpus by `recover`."""
    old = directory.with_name(directory.name + ".old")
    os.replace(directory, old)
    os.replace(merged, directory)
    shutil.rmtree(old)


def recover(directory):
    """Ends a `replace` that was killed."""
    old = directory.with_name(directory.name + ".old")
    if old.is_dir():
        if directory.is_dir():
            shutil.rmtree(old)
        else:
            os.replace(old, directory)
