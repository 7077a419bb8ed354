# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
#
# What all findings do alike. Source it: the working folder becomes a temporary one, where `fetch` unpacks
# packages below usr/. Nothing is installed. Exit codes: 0 as found, 1 changed, 2 could not be tried.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

changed() {
    echo "changed: $1"
    exit 1
}

untried() {
    echo "could not be tried: $1"
    exit 2
}

# Downloads these packages of Debian 12, NAME=VERSION each, without those that they depend on.
fetch() {
    local package file
    for package in "$@"; do
        apt-get download "$package" &> log || untried "$package: $(tail -n 1 log)"
    done
    for file in ./*.deb; do
        # shellcheck disable=SC2016 # dpkg-deb's variables
        dpkg-deb --show --showformat '${Package} ${Version}\n' "$file"
        dpkg-deb --extract "$file" .
        rm "$file"
    done
    libraries=$(echo "$folder"/usr/lib/*-linux-gnu)
    export LD_LIBRARY_PATH=$libraries
}

# Compiles main.cpp with the packages, and with these options of g++.
compile() {
    g++ -std=c++17 -isystem usr/include main.cpp -o main -L "$libraries" "$@" &> log ||
        untried "$(head -n 1 log)"
    needs_all main
}

# Makes sure that a program finds its libraries.
needs_all() {
    ! ldd "$1" | grep 'not found' || untried "install what the packages depend on"
}
