#!/usr/bin/env bash
# Runs clang-tidy with the repository's .clang-tidy over all sources (or those given) and fails on any finding. This is not
# part of CI, because it takes about 10 s of processor time a file. It needs clang-tidy (Debian: clang-tidy), and
# configures build/ where that was not done.
# Usage: tests/tidy.sh [FILE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ -r build/compile_commands.json ] || cmake --preset release >/dev/null
[ $# -gt 0 ] || mapfile -t files < <(git ls-files 'runtime/*.cpp' 'fitter/*.cpp' 'sample_app/*.cpp' 'plugin/*.cpp' 'tests/*.cpp')
[ $# -eq 0 ] || files=("$@")
printf '%s\n' "${files[@]}" |
  xargs -P "$(nproc)" -n 4 clang-tidy -p build --quiet --warnings-as-errors='*' 2> >(grep -v 'warnings generated\|warnings treated' >&2)
