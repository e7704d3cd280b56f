#!/bin/bash -eu
exec "$SRC/tightflip/fuzz/oss-fuzz/build.sh"
