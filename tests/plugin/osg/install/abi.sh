#!/usr/bin/env bash
# A plugin loads with no other version of libosgFbrdf.so than it was built with, also where that is what osgDB finds by
# name: osgconv names the one that is missing, and reads with the right one.
# Usage: abi.sh CMAKE BUILD WORK
set -euo pipefail
cmake=$1 build=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$cmake" --install "$build" --prefix "$work/prefix" >/dev/null
"$build/bin/fbrdf" fit lambert:albedo=0.5 -o grey.fbrdf --form io --quiet
library=$(find prefix -name libosgFbrdf.so)
folder=$(dirname "$library")
version=$(basename "$(readlink "$library")")
# The words of the system are looked for in English.
converts() { env -u LD_LIBRARY_PATH LC_ALL=C OSG_LIBRARY_PATH="$folder" osgconv grey.fbrdf ball.osgt >log 2>&1 && [ -s ball.osgt ]; }
fail() { echo "$1"; cat log; exit 1; }
converts || fail "found no material with $version, expected one"
rm ball.osgt
mv "$(realpath "$library")" "$folder/libosgFbrdf.so.99.0"
rm "$folder/$version"
ln -sf libosgFbrdf.so.99.0 "$library"
if converts; then fail "found a material read with another version, expected an error"; fi
grep -q "$version: cannot open" log || fail "found no word of $version"
