#!/usr/bin/env bash
# Builds everything as each preset below describes, warnings as errors, and runs every test of each. CI runs gcc's Debug
# alone (tests/run.sh); this takes several times as long. Each preset has a build folder of its own and is incremental.
# Usage: tests/run-builds.sh [gcc-release] [clang-debug] [clang-release] [asan]    without arguments: all four
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
presets=("$@")
[ $# -gt 0 ] || presets=(gcc-release clang-debug clang-release asan)

failed=()
for preset in "${presets[@]}"; do
  mkdir -p "build-$preset"
  log=build-$preset/run.log
  : >"$log"
  bash cmake/install-packages.sh builds "$log" || { echo "fbrdf: set-up failed; the log is $root/$log" >&2; exit 1; }
  step "$preset: configuring" "$log" cmake --preset "$preset" -DFBRDF_WARNINGS_AS_ERRORS=ON
  step "$preset: building" "$log" cmake --build "build-$preset" --parallel "$(build_jobs)"
  ctest --preset "$preset" --parallel "$(nproc)" || failed+=("$preset")
done
[ ${#failed[@]} -eq 0 ] || { echo "fbrdf: tests failed in: ${failed[*]}" >&2; exit 1; }
echo "fbrdf: every test passed in: ${presets[*]}"
