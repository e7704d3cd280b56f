# The Debian packages of each job, and how to install those that are missing. Sourced, not run.
packages_build=(g++ cmake make libeigen3-dev libcgal-dev libcli11-dev libfmt-dev nlohmann-json3-dev)
packages_report=(libjs-three libjs-chart.js)
packages_test=("${packages_build[@]}" "${packages_report[@]}" libgtest-dev libgmock-dev
               librapidcheck-dev libboost-graph-dev libopenmesh-dev librsvg2-bin pkg-config chromium
               python3)
packages_bench=("${packages_build[@]}" libbenchmark-dev libopenmesh-dev)
packages_kernels=(libopenmesh-dev)  # which conformance and fuzz targets compare, beside CGAL
packages_fuzz=("${packages_kernels[@]}" clang libclang-rt-14-dev llvm python3)
packages_afl=(afl++)
packages_proof=(coq libcoq-mathcomp-ssreflect libcoq-mathcomp-fingroup libcoq-mathcomp-algebra ocaml)
packages_lint=("${packages_fuzz[@]}" clang-format clang-tidy git)

# install_missing PACKAGE...: installs with apt-get what dpkg does not know to be installed.
install_missing() {
    local missing=() package
    for package in "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
            missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    command -v apt-get >/dev/null || {
        echo "these packages are missing, by their names in Debian, and there is no apt-get:" \
             "${missing[*]}" >&2
        return 2
    }
    echo "installing: ${missing[*]}" >&2
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || {
            echo "these Debian packages are missing, and neither root nor sudo is at hand:" \
                 "apt-get install ${missing[*]}" >&2
            return 2
        }
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -qq >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}
