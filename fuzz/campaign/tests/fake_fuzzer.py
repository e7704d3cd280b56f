#!/usr/bin/env python3
"""Behaves like NAME_fuzzer with libFuzzer in it, and as tightflip_fuzz, but runs nothing. What an
input does is written in it: CLAIM, OVERFLOW and HANG fail, SLOW takes a minute, anything else is
fine. What is found when is in the file NAME.plan beside this program: one input a line, taken one
after the other by all runs together; then only inputs that are known already."""

import hashlib
import shutil
import sys
import time
from pathlib import Path

HERE = Path(sys.argv[0]).resolve().parent
NAMES = ("alpha", "beta", "gamma")
OVERFLOW = """=================================================================
==7==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x60200000{0:04x} at pc 0x5{0:04x}
READ of size 4 at 0x60200000{0:04x} thread T0
    #0 0x55{0:04x} in tightflip::kernel::Triangulation::twin(int) const /src/triangulation.hpp:91:9
    #1 0x55{0:04x} in tightflip::fuzz::objection(std::span<unsigned char const>) /src/target.cpp:9:5
    #2 0x55{0:04x} in LLVMFuzzerTestOneInput /src/fuzzer_main.cpp:12:5

SUMMARY: AddressSanitizer: heap-buffer-overflow
"""
CLAIM = """
{1}: edge {0} has twin {0}
start: tetrahedron
==7== ERROR: libFuzzer: deadly signal
    #0 0x55 in __sanitizer_print_stack_trace (/fuzzer+0x1)
"""
HANG = """ALARM: working on the last Unit for 1 seconds
==7== ERROR: libFuzzer: timeout after 1 seconds
    #0 0x55{0:04x} in tightflip::kernel::place_{0}() /src/a.cpp:1:1
    #1 0x55{0:04x} in tightflip::kernel::connect(int) /src/connect.cpp:9:1
    #2 0x55{0:04x} in tightflip::fuzz::objection(std::span<unsigned char const>) /src/t.cpp:9:5
    #3 0x55{0:04x} in LLVMFuzzerTestOneInput /src/fuzzer_main.cpp:12:5
"""


def failure(data):
    """(kind, what is printed) of an input that fails."""
    number = len(data)
    if b"CLAIM" in data:
        return "crash", CLAIM.format(number, data.split()[1].decode())
    if b"OVERFLOW" in data:
        return "crash", OVERFLOW.format(number)
    if b"HANG" in data:
        return "timeout", HANG.format(number)
    return None


def execute(data, prefix):
    """Ends the program where the input fails."""
    failed = failure(data)
    if b"SLOW" in data:
        time.sleep(60)
    if failed:
        kind, text = failed
        print(text, flush=True)
        if prefix is not None:
            Path(f"{prefix}{kind}-{hashlib.sha1(data).hexdigest()}").write_bytes(data)
        print("stat::number_of_executed_units: 1")
        sys.exit(70 if kind == "timeout" else 77)


def next_planned(name):
    plan, taken = HERE / f"{name}.plan", HERE / f"{name}.taken"
    lines = plan.read_bytes().splitlines() if plan.exists() else []
    number = int(taken.read_text()) if taken.exists() else 0
    if number >= len(lines):
        return b"known"
    taken.write_text(str(number + 1))
    return lines[number]


def fuzz(name, flags, directories):
    prefix = flags["artifact_prefix"]
    seen = set()
    for directory in directories:
        for path in sorted(directory.iterdir()):
            data = path.read_bytes()
            execute(data, prefix)
            seen.add(data)
    until, count = time.monotonic() + float(flags["max_total_time"]), 0
    while time.monotonic() < until:
        count += 1
        data = next_planned(name)
        execute(data, prefix)
        if data not in seen:
            seen.add(data)
            (directories[0] / hashlib.sha1(data).hexdigest()).write_bytes(data)
            print(f"#{count}\tNEW    cov: {len(seen)} ft: 9 corp: {len(seen)}/9b exec/s: 9",
                  flush=True)
        time.sleep(0.01)
    print(f"#{count}\tDONE   cov: {len(seen)} ft: 9 corp: {len(seen)}/9b exec/s: 9")
    print(f"stat::number_of_executed_units: {count}")


def merge(directories):
    """Of inputs with the same first byte, the first. MERGES LONG takes a second."""
    first = {}
    for directory in directories[1:]:
        for path in sorted(directory.iterdir()):
            data = path.read_bytes()
            first.setdefault(data[:1], path)
            time.sleep(1 if b"MERGES LONG" in data else 0)
    for path in first.values():
        shutil.copy(path, directories[0] / path.name)


def minimise(source, result):
    """Cuts the input off after its first two words."""
    Path(result).write_bytes(b" ".join(Path(source).read_bytes().split()[:2]))


def tool(words):
    if words[0] == "list":
        print("\n".join(f"{name}\twhat {name} takes" for name in NAMES))
    elif words[0] == "seeds":
        Path(words[2], "seed").write_bytes(b"seed of " + words[1].encode())
    elif words[0] == "show":
        print("in words:", Path(words[2]).read_text(errors="replace"))
    elif words[0] == "minimise" and b"STUBBORN" not in Path(words[2]).read_bytes():
        minimise(words[2], words[3])


def main():
    name = Path(sys.argv[0]).name
    if name == "tightflip_fuzz":
        return tool(sys.argv[1:])
    flags = dict(word[1:].split("=") for word in sys.argv[1:] if word.startswith("-"))
    paths = [Path(word) for word in sys.argv[1:] if not word.startswith("-")]
    if "minimize_crash" in flags:
        return minimise(paths[0], flags["exact_artifact_path"])
    if "merge" in flags:
        return merge(paths)
    if "max_total_time" in flags:
        return fuzz(name.removesuffix("_fuzzer"), flags, paths)
    for path in paths:
        execute(path.read_bytes(), None)
    return None


if __name__ == "__main__":
    main()
