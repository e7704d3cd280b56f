#!/usr/bin/env bash
# Builds the pkg-config example against an installed tree and runs it on a mesh.
set -euo pipefail
source=$1 build=$2 pkgconfig=$3 mesh=$4 compiler=$5 flags=$6
rm -rf "$build"
cp -r "$source" "$build"
cd "$build"
export PKG_CONFIG_PATH=$pkgconfig
make CXX="$compiler" CXXFLAGS="-O1 $flags"
./example "$mesh"
