#!/usr/bin/env bash
# The example writes pictures of its own part and of a file, and names what it cannot read.
# Usage: example.sh FBRDF EXAMPLE WORK
set -euo pipefail
fbrdf=$1 example=$2 work=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$fbrdf" fit lambert:albedo=0.5 -o grey.fbrdf --form io --quiet
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >triangle.obj
echo 'no surface' >empty.stl
draws() { "$here/../../support/with_x.sh" "$example" --off-screen "$@" >log 2>&1; }
fails() { local expected=$1 status=0; shift; draws "$@" || status=$?; [ $status -eq "$expected" ] || { echo "found status $status, expected $expected"; cat log; exit 1; }; }
for mesh in '' triangle.obj; do
  draws picture.png grey.fbrdf $mesh || { cat log; exit 1; }
  [ "$(head -c 4 picture.png | tail -c 3)" = PNG ] || { echo "found no PNG"; exit 1; }
  rm picture.png
done
fails 2 picture.png
fails 3 picture.png missing.fbrdf
grep -q 'missing.fbrdf: found no such file, expected a material' log || { cat log; exit 1; }
fails 3 picture.png grey.fbrdf empty.stl
fails 3 picture.png grey.fbrdf mesh.vtk
grep -q 'mesh.vtk: found no surface, expected a .ply, .stl or .obj' log || { cat log; exit 1; }
