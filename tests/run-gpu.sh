#!/usr/bin/env bash
# Packs the tests that draw, the benchmark and the libraries that they need into one folder, and runs them: here, or on
# another Linux machine that has a GPU and ssh. This is not part of CI.
# Usage: tests/run-gpu.sh [--host USER@HOST] [--folder FOLDER] [--build BUILD] [-- ARGUMENTS OF gpu/run.sh]
#   --folder  where the pack is made; default build-tests/gpu. It may be copied anywhere: FOLDER/run.sh runs it.
#   --build   the build whose programs are packed; default build-tests
#   --host    copies the pack to fbrdf-gpu in the home folder there, and runs it there
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
host="" build=build-tests folder=""
while [ $# -gt 0 ]; do
  case $1 in
    --host) host=$2; shift 2 ;;
    --folder) folder=$2; shift 2 ;;
    --build) build=$2; shift 2 ;;
    --) shift; break ;;
    *) echo "run-gpu.sh: found '$1', expected --host, --folder, --build or --" >&2; exit 2 ;;
  esac
done
folder=${folder:-$build/gpu}

tests=(gl_test capi_test bench_test techniques_test osg_effect_test osg_views_test)
present=()
for name in "${tests[@]}"; do [ -x "$build/bin/$name" ] && present+=("$name"); done
[ ${#present[@]} -gt 0 ] || { echo "run-gpu.sh: found no test programs in $build/bin, expected a build: tests/run.sh" >&2; exit 1; }

rm -rf "$folder"
mkdir -p "$folder/tree"
libraries=("$build/runtime/capi/libfbrdf.so")
while IFS= read -r plugin; do libraries+=("$plugin"); done < <(find "$build/lib" -path '*osgPlugins*' -name '*.so')
python3 tests/gpu/pack.py "$folder" "${present[@]/#/$build/bin/}" "$build/bin/fbrdf-bench" "$build/bin/fbrdf-viewer" \
  "${libraries[@]}"
# OSG looks for its plugins in a folder of its version.
for plugin in "${libraries[@]:1}"; do
  plugins=$(basename "$(dirname "$plugin")")
  mkdir -p "$folder/lib/$plugins"
  mv "$folder/lib/$(basename "$plugin")" "$folder/lib/$plugins/"
done
# OSMesa is opened by name.
osmesa=$(ldconfig -p | sed -n 's/.*libOSMesa\.so\.8.* => //p' | head -n 1)
[ -z "$osmesa" ] || echo "run-gpu.sh: tests on OSMesa run where $(basename "$osmesa") is installed, and are skipped elsewhere"
printf '%s\n' "${present[@]}" >"$folder/programs"
cp tests/gpu/run.sh "$folder/run.sh"
echo "packed $(du -sh "$folder" | cut -f1) in $folder"

if [ -z "$host" ]; then
  exec bash "$folder/run.sh" "$@"
fi
tar -C "$folder" -czf - . | ssh "$host" 'rm -rf fbrdf-gpu && mkdir fbrdf-gpu && tar -C fbrdf-gpu -xzf -'
exec ssh "$host" "bash fbrdf-gpu/run.sh $(printf '%q ' "$@")"
