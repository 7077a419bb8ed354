# SPDX-License-Identifier: Apache-2.0
#
# Sourced by the other scripts: strict mode, the repository's root as working folder, and what they
# share.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

die() {
    echo "$(basename "$0"): $*" >&2
    exit 2
}

# cxx_files FOLDER...: all C++, C and CUDA files below those of the folders that exist, but
# what a build of the Python package leaves.
cxx_files() {
    local folder present=()
    for folder; do
        if [ -d "$folder" ]; then present+=("$folder"); fi
    done
    find "${present[@]}" -path bindings/python/build -prune -o -type f \
        \( -name '*.h' -o -name '*.cpp' -o -name '*.c' -o -name '*.cu' \) -print | LC_ALL=C sort
}

# first_program NAME...: the first of these programs that is installed.
first_program() {
    local name
    for name; do
        if command -v "$name" > /dev/null; then
            echo "$name"
            return
        fi
    done
    die "needs $1; run: scripts/setup test"
}
