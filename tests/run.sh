#!/usr/bin/env bash
# Installs what is missing, builds everything into build-tests (with assertions) and runs every test. ctest prints the
# last line.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
mkdir -p build-tests
log=build-tests/run.log
: >"$log"

bash cmake/install-packages.sh tests "$log" || { echo "fbrdf: set-up failed; the log is $root/$log" >&2; exit 1; }
werror=OFF
[ "${CI:-}" != true ] || werror=ON
step "configuring" "$log" cmake --preset tests -DFBRDF_WARNINGS_AS_ERRORS=$werror
step "building" "$log" cmake --build build-tests --parallel "$(build_jobs)"
exec ctest --test-dir build-tests --parallel "$(nproc)" --output-on-failure
