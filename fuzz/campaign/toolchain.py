"""Which clang builds fuzzers here."""

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from campaign.programs import UsageError

# Debian 12's, in the order in which they are tried; clang 14 is its default.
CANDIDATES = ("clang++", "clang++-14", "clang++-16", "clang++-19")
PACKAGES = ("clang and libclang-rt-14-dev", "clang-16 and libclang-rt-16-dev",
            "clang-19 and libclang-rt-19-dev")

_PROBE = """#include <algorithm>
#include <cstdint>
#include <ranges>
#include <string>
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return std::ranges::count(std::string(data, data + size), 'x') < 0 ? 1 : 0;
}
"""


def complaint(compiler):
    """Why the compiler does not build a fuzzer, or None."""
    if shutil.which(compiler) is None:
        return "it is not installed"
    with tempfile.TemporaryDirectory() as directory:
        source = Path(directory) / "probe.cpp"
        source.write_text(_PROBE, encoding="utf-8")
        done = subprocess.run(
            [compiler, "-std=c++20", "-fsanitize=fuzzer,address,undefined", str(source),
             "-o", f"{directory}/probe"],
            capture_output=True, check=False, text=True, errors="replace")
    if done.returncode == 0:
        return None
    errors = [line for line in done.stderr.splitlines() if "error" in line or "cannot find" in line]
    return (errors or done.stderr.splitlines() or ["it fails"])[0].strip()


def find_clang(environment=os.environ):
    """The first compiler that builds a fuzzer: CXX where it is set, else Debian's names. UsageError
    says what is wrong with each and which packages bring one."""
    chosen = environment.get("CXX")
    complaints = {}
    for compiler in [chosen] if chosen else CANDIDATES:
        complaints[compiler] = complaint(compiler)
        if complaints[compiler] is None:
            return compiler
    tried = "\n".join(f"  {name}: {why}" for name, why in complaints.items())
    raise UsageError(f"no clang here builds fuzzers:\n{tried}\n"
                     f"Any one of these pairs of Debian packages does: {'; '.join(PACKAGES)}"
                     + ("; or unset CXX" if chosen else ""))


def version(compiler):
    """The first line a compiler says of itself."""
    done = subprocess.run([compiler, "--version"], capture_output=True, check=False, text=True)
    return done.stdout.splitlines()[0] if done.stdout else compiler


def llvm_tool(compiler, name):
    """The path of llvm-cov and its like of the compiler's own version: formats differ between
    versions. UsageError names the package."""
    done = subprocess.run([compiler, f"-print-prog-name={name}"], capture_output=True, check=False,
                          text=True)
    path = shutil.which(done.stdout.strip())
    if path is None:
        major = re.search(r"version (\d+)", version(compiler))
        package = f"llvm-{major.group(1)}" if major else "llvm"
        raise UsageError(f"there is no {name} for {compiler}; the Debian package {package} has it")
    return path
