#!/usr/bin/env bash
# The layer check must object to each kind of wrong include: plants them one by one in a copy.
set -euo pipefail
source=$1 copy=$2
rm -rf "$copy"
mkdir -p "$copy"
cp -r "$source"/{kernel,geometry,properties,fuzz,tools} "$copy"
check() { "$source/scripts/check-layers" "$copy" >/dev/null; }
check || { echo "the copy itself is refused"; exit 1; }

plant() {
    local file=$copy/$1 include=$2
    echo "#include <$include>" >>"$file"
    if check; then
        echo "$1 may include <$include>"
        exit 1
    fi
    sed -i '$d' "$file"
}
plant kernel/src/audit.cpp tightflip/geometry/mesh_file.hpp
plant kernel/src/audit.cpp Eigen/Core
plant kernel/include/tightflip/kernel/flip.hpp boost/graph/adjacency_list.hpp
plant kernel/include/tightflip/kernel/flip.hpp gtest/gtest.h
plant geometry/src/obj.cpp tightflip/properties/claims.hpp
plant properties/src/claims.cpp rapidcheck.h
plant properties/include/tightflip/properties/claims.hpp gtest/gtest.h
plant tools/src/main.cpp gtest/gtest.h
check
