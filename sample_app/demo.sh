#!/usr/bin/env bash
# Installs what is missing, builds, fits a real material, renders it, and prints where the pictures and the report are.
# Usage: sample_app/demo.sh [REFLECTANCE]    REFLECTANCE: a file or an analytic model to fit instead
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
origin=$PWD
cd "$root"
mkdir -p build/demo
out=build/demo
log=$out/demo.log
: >"$log"

bash cmake/install-packages.sh build "$log" || { echo "fbrdf: set-up failed; the log is $root/$log" >&2; exit 1; }
step "configuring" "$log" cmake --preset demo -DFBRDF_TESTS=OFF
step "building" "$log" cmake --build build --parallel "$(build_jobs)" --target fbrdf fbrdf-viewer

# Without an argument: a gonioreflectometer measurement of garnet red paint (Cornell), where the data folder is beside
# the project; else Ward's measured rolled brass of 1992, which is a model.
data=${FBRDF_DATA_DIR:-../shared/data}
source_spec=${1:-}
if [ -z "$source_spec" ]; then
  source_spec=$data/cornell_pbrt2/garnet_red.brdf
  [ -r "$source_spec" ] || source_spec=ward-rolled-brass
elif [ -e "$origin/$source_spec" ]; then
  source_spec=$(cd "$origin" && realpath "$source_spec")
fi

fbrdf=build/bin/fbrdf viewer=build/bin/fbrdf-viewer
echo "fitting $source_spec"
"$fbrdf" fit "$source_spec" -o "$out/material.fbrdf" --report "$out/report.html"
render() { # NAME ARGS...
  local name=$1
  shift
  step "rendering $name" "$log" "$viewer" --headless --out "$out/$name" --stats "$out/${name%.*}.json" "$@"
}
render sphere.png --material "$out/material.fbrdf" --mesh sphere --full --size 640x480
render knot.png --material "$out/material.fbrdf" --mesh knot --full --size 640x480 --technique two-lookup

echo
for picture in sphere.png knot.png report.html material.fbrdf; do echo "$root/$out/$picture"; done
