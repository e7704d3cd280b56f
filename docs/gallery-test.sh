#!/usr/bin/env bash
# gallery-test.sh SOURCE SCRATCH COMMAND: the gallery is what the command makes now. Pictures are
# compared byte by byte where their points are the same on every machine and no edge is bowed, and
# the measurements and tables as they are printed, but for the total curvature of a torus, which is
# all rounding.
set -euo pipefail
source=$1 scratch=$2
rm -rf "$scratch"
TIGHTFLIP=$3 "$source/scripts/gallery" "$scratch"

drawn=$(cd "$scratch/gallery" && printf '%s\n' *)
diff <(cd "$source/docs/gallery" && printf '%s\n' *) <(echo "$drawn")
diff <(grep -o '(gallery/[^)]*)' "$source/docs/gallery.md" | sed 's/.*\/\(.*\))/\1/' |
    LC_ALL=C sort) <(echo "$drawn" | LC_ALL=C sort)
for picture in schoenhardt-prism twisted-prism{,-midway,-hull} skewed-cylinder{,-3,-embedded} \
    delaunay tightest cube-grid; do
    cmp {"$scratch","$source/docs"}"/gallery/$picture.svg"
done
words() {
    sed '/ total curvature \(0\|[^,]*e-\)/d' "$1"
}
diff <(words "$source/docs/gallery.md") <(words "$scratch/gallery.md")
