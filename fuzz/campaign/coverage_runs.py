"""Runs whose line coverage is asked for: replayed inputs, and the tests of a layer."""

import os
import shutil
import subprocess

from campaign import build, line_coverage

ALL = "all targets"
_MOST_PROFILES = 8  # files that the processes of a run share, each adding its counts


class CoverageBuild:
    """The libraries, the tool and the tests, built so that they count what is executed."""

    def __init__(self, compiler, names, build_jobs):
        self.compiler, self.directory = compiler, build.ROOT / "build" / "coverage"
        # Whatever runs counts, and leaves default.profraw where it runs unless told otherwise.
        self._uncounted = _profiles_to(self.directory / "profiles" / "uncounted")
        build.install("packages_test")
        build.configure("coverage", self.directory, compiler, environment=self._uncounted)
        build.make(self.directory, names, build_jobs, self._uncounted)

    def programs(self):
        return build.find_programs(self.directory, self._uncounted)

    def by_inputs(self, directories, say=print):
        """Coverage by the seeds and the inputs in the directories of each target; all together
        first. directories: target -> list."""
        programs = self.programs()
        profiles = self._fresh_profiles("inputs")
        coverage = {ALL: None}
        for target, paths in directories.items():
            command = programs.replay_command(target, ["--seeds", *paths])
            self._run(command, profiles / target, say)
            coverage[target] = self._measure(profiles / target, [programs.tool])
        coverage[ALL] = self._measure(profiles, [programs.tool])
        return coverage

    def by_tests(self, layers, jobs, say=print):
        """Coverage by the unit and property tests of the layers."""
        profiles = self._fresh_profiles("tests")
        pattern = f"^({'|'.join(layers)})\\."
        self._run(["ctest", "--test-dir", self.directory, "-R", pattern, "-j", jobs,
                   "--output-on-failure"], profiles, say)
        return self._measure(profiles, [next(self.directory.glob(f"**/{layer}_tests"))
                                        for layer in layers])

    def _fresh_profiles(self, name):
        profiles = self.directory / "profiles" / name
        shutil.rmtree(profiles, ignore_errors=True)
        profiles.mkdir(parents=True)
        return profiles

    def _run(self, command, profiles, say):
        done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", env=os.environ | _profiles_to(profiles))
        if done.returncode != 0:
            say(f"{' '.join(map(str, command[:3]))} ended with {done.returncode}:\n"
                + "\n".join(done.stdout.splitlines()[-20:]))

    def _measure(self, profiles, programs):
        return line_coverage.measure(self.compiler, profiles, [*programs, self._everything()],
                                     build.ROOT)

    def _everything(self):
        """The libraries in one, so that what no program took from them counts as not executed."""
        result = self.directory / "everything.so"
        libraries = [next(self.directory.glob(f"**/libtightflip_{layer}.a"))
                     for layer in line_coverage.LAYERS]
        build.run([self.compiler, "-shared", "-fprofile-instr-generate", "-Wl,--whole-archive",
                   *libraries, "-Wl,--no-whole-archive", "-o", result])
        return result


def _profiles_to(directory):
    return {"LLVM_PROFILE_FILE": f"{directory}/%{_MOST_PROFILES}m.profraw"}


def inputs_of(targets, directories):
    """target -> those of the directories' subdirectories of that name that exist, and the
    regressions."""
    roots = [build.ROOT / "fuzz" / "regressions", *directories]
    return {target: [root / target for root in roots if (root / target).is_dir()]
            for target in targets}
