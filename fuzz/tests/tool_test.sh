#!/usr/bin/env bash
# The program tightflip_fuzz from outside: tool_test.sh PROGRAM TARGET..., where the targets are
# those that the build makes fuzzers of.
set -euo pipefail
program=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0

# expect CODE PATTERN ARGUMENT...: the exit code, and a line of what is printed.
expect() {
    local code=$1 pattern=$2 got=0 text
    shift 2
    text=$("$program" "$@" 2>&1) || got=$?
    if [ "$got" -ne "$code" ] || ! grep -qE -- "$pattern" <<<"$text"; then
        printf 'tightflip_fuzz %s: exit code %s, expected %s and "%s":\n%s\n' \
            "$*" "$got" "$code" "$pattern" "$text"
        status=1
    fi
}

listed=$("$program" list | cut -f 1 | sort)
if [ "$listed" != "$(printf '%s\n' "$@" | sort)" ]; then
    printf 'CMakeLists.txt and targets.cpp name different targets:\n%s\n' "$listed"
    status=1
fi
expect 2 'usage:'
expect 2 'usage:' fly
expect 2 'usage:' show flip_script
expect 2 'usage:' list more
expect 2 "no target 'no_such'; there are:.* flip_script" replay no_such --seeds
expect 2 'usage:' replay flip_script --sedes --seeds
expect 2 'usage:' seeds flip_script --directory "$folder/never"
expect 2 'usage:' list --seeds
expect 0 'seed no_flip: .*tetrahedron' replay flip_script --verbose --seeds

expect 0 'seeds in ' seeds flip_script "$folder/seeds"
expect 0 '[0-9]+ inputs, every claim held$' replay flip_script "$folder/seeds"
expect 0 'tetrahedron, V = 4' show flip_script "$folder/seeds/tetrahedron_every_edge"
expect 0 'flip 6: edge 5 joins' show flip_script "$folder/seeds/tetrahedron_every_edge"
"$program" seeds flip_script "$folder/again" >"$folder/log"
diff -r "$folder/seeds" "$folder/again" || status=1

# Corrupt files of a corpus are named and passed over; of those asked for, it is an error.
printf '\002other version' >"$folder/seeds/zz_other"
expect 0 'skipped .*zz_other: of another version' replay flip_script "$folder/seeds"
expect 2 'skipped .*zz_other: of another version' replay flip_script "$folder/seeds/zz_other"
expect 2 'zz_other: of another version' show flip_script "$folder/seeds/zz_other"
expect 2 'zz_other: of another version' minimise flip_script "$folder/seeds/zz_other" "$folder/out"
expect 2 'missing' replay flip_script "$folder/missing"
expect 2 'missing' show flip_script "$folder/missing"
expect 2 '0 inputs' replay flip_script "$folder/seeds/zz_other"
mkfifo "$folder/seeds/zz_pipe"
expect 0 'skipped .*zz_pipe: is no regular file' replay flip_script "$folder/seeds"
expect 2 'skipped .*zz_pipe: is no regular file' replay flip_script "$folder/seeds/zz_pipe"
mkdir "$folder/empty"
expect 2 '0 inputs' replay flip_script "$folder/empty"

expect 0 'nothing to make smaller' minimise flip_script "$folder/seeds/no_flip" "$folder/out"
[ ! -e "$folder/out" ] || { echo "minimise wrote an input that holds"; status=1; }
: >"$folder/file"
expect 2 'file' seeds flip_script "$folder/file/in_a_file"
exit $status
