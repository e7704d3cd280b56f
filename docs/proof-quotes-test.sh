#!/usr/bin/env bash
# docs/proof.md must say what Coq checks: each of its ```coq blocks is a contiguous piece of a file
# of kernel/proof, and each `theorem` | `file` of its tables is there, named in headlines.v too.
set -euo pipefail
source=$1
page=$source/docs/proof.md
proof=$source/kernel/proof
status=0

declare -A text
for file in "$proof"/*.v; do text[$file]=$'\n'$(<"$file")$'\n'; done

# quoted BLOCK LINE: whether some file has these lines, one after the other.
quoted() {
    local file
    for file in "${!text[@]}"; do
        [[ ${text[$file]} == *$'\n'"$1"* ]] && return 0
    done
    echo "$page:$2: no file of kernel/proof has this:"
    printf '%s' "$1"
    status=1
}
blocks=0 block='' inside='' number=0
while IFS= read -r line || [ -n "$line" ]; do
    number=$((number + 1))
    if [ -z "$inside" ]; then
        [ "$line" = '```coq' ] && inside=$number && block=''
    elif [ "$line" = '```' ]; then
        quoted "$block" "$inside"
        inside='' blocks=$((blocks + 1))
    else
        block+=$line$'\n'
    fi
done <"$page"
[ -z "$inside" ] || { echo "$page:$inside: this block has no end"; status=1; }

# Rows that end in | `theorem` | `file.v` |, also with several theorems.
# shellcheck disable=SC2016
row='s/^\|.*\| *((`[a-zA-Z_0-9]+`(, )?)+) *\| *(`[a-z_]+\.v`) *\|$/\1|\4/p'
rows=0
while IFS='|' read -r names file; do
    file=${file//[\` ]/}
    for name in ${names//[\`,]/ }; do
        rows=$((rows + 1))
        grep -qE "^(Theorem|Lemma|Corollary) $name\b" "$proof/$file" || {
            echo "$page: $file has no theorem $name"
            status=1
        }
        grep -qE "^Print Assumptions ${file%.v}\.$name\.$" "$proof/headlines.v" || {
            echo "$page: headlines.v does not ask what $name rests on"
            status=1
        }
    done
done < <(sed -nE "$row" "$page")

if [ "$blocks" -eq 0 ] || [ "$rows" -eq 0 ]; then
    echo "$page quotes nothing"
    status=1
fi
echo "$blocks quotations, $rows theorems"
exit $status
