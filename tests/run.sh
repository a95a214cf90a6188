#!/usr/bin/env bash
# Installs what is missing, builds everything into build-debug (with assertions) and runs every test. ctest prints the
# last line.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
mkdir -p build-debug
log=build-debug/run.log
: >"$log"

bash cmake/install-packages.sh tests "$log" || { echo "fbrdf: set-up failed; the log is $root/$log" >&2; exit 1; }
werror=OFF
[ "${CI:-}" != true ] || werror=ON
step "configuring" "$log" cmake --preset debug -DFBRDF_WARNINGS_AS_ERRORS=$werror
step "building" "$log" cmake --build build-debug --parallel "$(build_jobs)"
exec ctest --test-dir build-debug --parallel "$(nproc)" --output-on-failure
