"""Programs that run beside the campaign and do not outlive it."""

import os
import shutil
import signal
import subprocess
import time

TICK = 0.25  # seconds between two looks at a running program

# Killed with -9, a campaign cannot end its children: the kernel does it (Linux, util-linux).
_WITH_PARENT = ["setpriv", "--pdeathsig", "KILL", "--"] if shutil.which("setpriv") else []


def run(command, output, stop, environment=None, seconds=None, tick=lambda passed: None):
    """Runs the command with its output in a file until it ends, `stop` is set or the seconds are
    over; the exit code, or None where it had to be ended. A session of its own: Ctrl-C in a
    terminal reaches the campaign alone, which then ends its children in order. tick: is told from
    time to time how many seconds passed."""
    begun = told = time.monotonic()
    with open(output, "wb") as file:
        process = subprocess.Popen(
            _WITH_PARENT + [str(word) for word in command], stdin=subprocess.DEVNULL, stdout=file,
            stderr=subprocess.STDOUT, env=os.environ | (environment or {}), start_new_session=True)
        try:
            while True:
                ended = _ended_within(process, TICK)
                now = time.monotonic()
                tick(now - told)
                told = now
                if ended:
                    return process.returncode
                if stop.is_set() or (seconds is not None and now - begun > seconds):
                    return None
        finally:
            end(process)


def _ended_within(process, seconds):
    try:
        process.wait(seconds)
        return True
    except subprocess.TimeoutExpired:
        return False


def end(process):
    """Asks the program and its children to end, then insists."""
    for number, patience in ((signal.SIGTERM, 5), (signal.SIGKILL, 5)):
        try:
            os.killpg(process.pid, number)
        except ProcessLookupError:
            break
        _ended_within(process, patience)
