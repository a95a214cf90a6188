#!/usr/bin/env bash
# Builds the planner and the C ABI with the thread sanitizer into build-tsan and runs their tests, which have two contexts
# on two threads and load the library twice. This is not part of CI. Usage: tests/run-threads.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
mkdir -p build-tsan
log=build-tsan/run.log
: >"$log"

bash cmake/install-packages.sh tests "$log" || { echo "fbrdf: set-up failed; the log is $root/$log" >&2; exit 1; }
step "configuring" "$log" cmake -S . -B build-tsan -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DFBRDF_TESTS=ON \
  -DFBRDF_SANITIZE=thread
step "building with the thread sanitizer" "$log" cmake --build build-tsan --target plan_test capi_test \
  --parallel "$(build_jobs)"
export TSAN_OPTIONS="suppressions=$root/tests/tsan.supp"
step "the planner" "$log" build-tsan/bin/plan_test
step "the C ABI, two threads" "$log" build-tsan/bin/capi_test --gtest_filter='*CApi*'
