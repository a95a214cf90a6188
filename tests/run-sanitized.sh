#!/usr/bin/env bash
# Builds everything with the address and undefined-behaviour sanitizers into build-asan and runs every test under them.
# This is not part of CI, because it takes several times as long as tests/run.sh.
# Usage: tests/run-sanitized.sh [CTEST-ARGUMENTS]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
mkdir -p build-asan
log=build-asan/run.log
: >"$log"

bash cmake/install-packages.sh tests "$log" || { echo "fbrdf: set-up failed; the log is $root/$log" >&2; exit 1; }
step "configuring" "$log" cmake --preset asan
step "building with sanitizers" "$log" cmake --build build-asan --parallel "$(build_jobs)"
exec ctest --preset asan --parallel "$(nproc)" "$@"
