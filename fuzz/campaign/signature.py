"""What two failing inputs have in common when they show the same fault: the claim that did not
hold, or the report of the sanitizer with the innermost frames of the stack."""

import re

FRAMES = 3

# From a programming language's runtime, the sanitizers or the engine: they say nothing of a fault.
_FOREIGN_FUNCTION = re.compile(
    r"^(std::|__|_start|main$|fuzzer::|LLVMFuzzer|gsignal|raise|abort|operator (new|delete)"
    r"|malloc|calloc|realloc|free$|memcpy|memmove|memset|pthread_|start_thread|clone)")
_FOREIGN_PLACE = re.compile(
    r"/usr/(include|lib)|\(/lib|compiler-rt|sanitizer_common|libc\.so|/csu/|libFuzzer")
_FRAME = re.compile(r"^\s*#\d+ 0x[0-9a-f]+ +(?:in )?(.+)$")
_ERROR = re.compile(
    r"ERROR: (?:Address|Leak|Memory)Sanitizer: (?:detected |attempting |requested )?"
    r"(.*?)(?: on | 0x|:|$)", re.MULTILINE)
_UNDEFINED = re.compile(r"^(?:\S*/)?([^/\s]+?):(\d+):\d+: runtime error: (.*)$")


def _function_of(frame):
    """The function's name without arguments and template arguments; without symbols, the place in
    the program."""
    if frame.startswith("("):
        return re.sub(r"^\((?:.*/)?|[ )].*$", "", frame)
    found = re.match(r"(.*?) (?:\(?/\S+|<null>)", frame)
    name = found.group(1) if found else frame
    name = re.sub(r"\[abi:\w+\]", "", name)
    previous = None
    while previous != name:  # innermost brackets first
        previous = name
        name = re.sub(r"<[^<>]*>", "", name) if "operator" not in name else name
        name = re.sub(r"\([^()]*\)", "", name)
    return name.replace(" const", "").strip()


def frames(output):
    """Names of the project's own functions on the first stack that is printed, innermost first."""
    own, within = [], False
    for line in output.splitlines():
        found = _FRAME.match(line)
        if not found:
            if within and own:
                break
            continue
        within = True
        function = _function_of(found.group(1))
        if "LLVMFuzzerTestOneInput" in found.group(1):
            break
        if not _FOREIGN_PLACE.search(found.group(1)) and not _FOREIGN_FUNCTION.match(function):
            own.append(function)
    return own


def objection(output):
    """The line that says what does not hold: a target prints it after a blank line, before the
    engine says that it aborted. None where there is no such line."""
    lines = output.splitlines()
    for blank, line in zip(lines, lines[1:]):
        if re.match(r"==\d+==|=====", line):
            return None
        if blank == "" and line != "":
            return line
    return None


def _undefined(output):
    for line in output.splitlines():
        found = _UNDEFINED.match(line)
        if found:
            what = re.sub(r"0x[0-9a-f]+|-?\d+", "N", found.group(3))
            return f"undefined behaviour: {what} ({found.group(1)}:{found.group(2)})"
    return None


def of(kind, output):
    """One line; equal for inputs that show the same fault. kind: crash, timeout, oom or leak."""
    own = frames(output)
    if kind in ("timeout", "oom"):  # where exactly the clock or the memory ran out is chance
        return f"{kind} in {' < '.join(own[-2:])}" if own else kind
    undefined = _undefined(output)
    if undefined is not None:
        return undefined
    error = _ERROR.search(output)
    if error:
        what = error.group(1)
        return f"{what} in {' < '.join(own[:FRAMES])}" if own else what
    objected = objection(output)
    if objected is not None:
        return f"claim: {objected.split(':', 1)[0]}"
    return f"{kind} in {' < '.join(own[:FRAMES])}" if own else kind
