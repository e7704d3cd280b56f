#!/bin/bash -eu
# Builds every fuzzer the way OSS-Fuzz and ClusterFuzzLite ask for it: compilers, flags and engine
# come from CC, CXX, CFLAGS, CXXFLAGS and LIB_FUZZING_ENGINE; the sources are in SRC/tightflip,
# intermediate files go to WORK, and what runs to OUT: NAME_fuzzer, NAME_fuzzer_seed_corpus.zip,
# NAME_fuzzer.options and, of text formats, NAME_fuzzer.dict.
source="$SRC/tightflip"
build="$WORK/tightflip"

# OpenMesh's package is compiled against another standard library than fuzzers are in the images that
# run this: other kernels are left out unless TIGHTFLIP_OTHER_KERNELS=ON says that they link.
# Build type None, and anew each time: the flags are the caller's alone.
cmake --fresh -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=None -DTIGHTFLIP_BUILD_FUZZERS=ON \
    -DTIGHTFLIP_BUILD_TESTS=OFF -DTIGHTFLIP_BUILD_TOOLS=OFF -DTIGHTFLIP_INSTALL=OFF \
    -DTIGHTFLIP_OTHER_KERNELS="${TIGHTFLIP_OTHER_KERNELS:-OFF}" \
    -DLIB_FUZZING_ENGINE="$LIB_FUZZING_ENGINE"
cmake --build "$build" --parallel "$(nproc)"

tool="$build/fuzz/tightflip_fuzz"
for name in $("$tool" list | cut -f 1); do
    cp "$build/fuzz/${name}_fuzzer" "$OUT/"

    seeds="$WORK/seeds/$name"
    rm -rf "$seeds" "$OUT/${name}_fuzzer_seed_corpus.zip"
    mkdir -p "$seeds"
    "$tool" seeds "$name" "$seeds"
    regressions="$source/fuzz/regressions/$name"
    if [ -d "$regressions" ]; then
        for input in "$regressions"/*; do
            cp "$input" "$seeds/regression-$(basename "$input")"
        done
    fi
    (cd "$seeds" && zip -q -r "$OUT/${name}_fuzzer_seed_corpus.zip" .)

    printf '[libfuzzer]\ntimeout = 10\n' > "$OUT/${name}_fuzzer.options"
    dictionary="$source/fuzz/dictionaries/$name.dict"
    if [ -f "$dictionary" ]; then
        cp "$dictionary" "$OUT/${name}_fuzzer.dict"
        echo "dict = ${name}_fuzzer.dict" >> "$OUT/${name}_fuzzer.options"
    fi
done
