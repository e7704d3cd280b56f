"""Builds the fuzzers, and what else a campaign runs, with CMake."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from campaign import engine_afl, toolchain
from campaign.programs import TOOL, Programs, UsageError, choose

ROOT = Path(__file__).resolve().parents[2]
DICTIONARIES = ROOT / "fuzz" / "dictionaries"


def fuzzers(engine, wanted, build_jobs):
    """(programs, compiler, targets). With AFL++ the same sources are built as any fuzzing engine
    has them built: by CXX, CXXFLAGS and LIB_FUZZING_ENGINE."""
    targets = choose(listed_targets(), wanted)
    install("packages_build", "packages_kernels")
    compiler, options, environment = _choose(engine)
    directory = directory_of(engine)
    configure("fuzz", directory, compiler, options, environment)
    make(directory, [TOOL, *(f"{target}_fuzzer" for target in targets)], build_jobs)
    programs = find_programs(directory)
    programs.require_fuzzers(targets)
    return programs, compiler, targets


def directory_of(engine):
    return ROOT / "build" / ("fuzz" if engine.NAME == "libfuzzer" else f"fuzz-{engine.NAME}")


def listed_targets():
    """The list of the build, so that a wrong name is known before anything is built."""
    text = (ROOT / "fuzz" / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^set\(targets\s([^)]*)\)", text, re.MULTILINE).group(1).split()


def _choose(engine):
    """(compiler, options, environment). Flags and engine are said each time: CMake itself looks at
    the environment only when it first sees a directory."""
    flags, link, environment = os.environ.get("CXXFLAGS", ""), "", {}
    if engine.NAME == engine_afl.NAME:
        install("packages_afl")
        compiler, link = "afl-clang-fast++", "-fsanitize=fuzzer"
        environment = {"AFL_QUIET": "1"}
        flags = f"-fsanitize=address,undefined -fno-sanitize-recover=all {flags}".strip()
    else:
        compiler, link = find_clang(), os.environ.get("LIB_FUZZING_ENGINE", "")
    return (compiler, [f"-DCMAKE_CXX_FLAGS={flags}", f"-DLIB_FUZZING_ENGINE={link}"], environment)


def find_clang():
    """Of the compilers here, or of those that the packages bring."""
    try:
        return toolchain.find_clang()
    except UsageError as none_here:
        if "CXX" in os.environ:
            raise
        try:
            install("packages_fuzz")
        except UsageError:
            raise none_here from None
        return toolchain.find_clang()


def install(*lists):
    """The Debian packages of these lists of scripts/packages.sh, as far as they are missing."""
    names = " ".join(f'"${{{name}[@]}}"' for name in lists)
    script = f". scripts/packages.sh; install_missing {names}"
    if subprocess.run(["bash", "-c", script], cwd=ROOT, check=False).returncode != 0:
        raise UsageError("the packages that are missing could not be installed")


def configure(preset, directory, compiler, options=(), environment=None):
    fresh = ["--fresh"] if _compiler_of(directory) not in (None, shutil.which(compiler)) else []
    run(["cmake", "--preset", preset, "-B", str(directory), *fresh,
          f"-DCMAKE_CXX_COMPILER={compiler}", *options], environment)


def _compiler_of(directory):
    """The compiler a directory was made for; None of a new one. CMake cannot change it later."""
    cache = directory / "CMakeCache.txt"
    text = cache.read_text(encoding="utf-8") if cache.is_file() else ""
    found = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", text, re.MULTILINE)
    return found and shutil.which(found.group(1))


def make(directory, names, build_jobs, environment=None):
    run(["cmake", "--build", str(directory), "--parallel", str(build_jobs), "--target", *names],
        environment)


def find_programs(directory, environment=None):
    tool = next(iter(directory.glob(f"**/{TOOL}")), directory / TOOL)
    return Programs(tool.parent, DICTIONARIES, environment)


def run(command, environment=None):
    """What the build prints is shown only where it fails."""
    command = list(map(str, command))
    done = subprocess.run(command, cwd=ROOT, env=os.environ | (environment or {}), check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    if done.returncode != 0:
        raise UsageError(f"{done.stdout}\n{' '.join(command)} ended with {done.returncode}")
