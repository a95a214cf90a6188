#!/usr/bin/env bash
# Runs the test that uploads a library, a mesh and their buffers under valgrind, with the gl_test of a build folder that
# has no sanitizer. This is not part of CI. Usage: tests/run-valgrind.sh [BUILD-FOLDER]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
exec valgrind -q --error-exitcode=9 --leak-check=no --suppressions="$root/tests/valgrind.supp" \
  "${1:-$root/build}/bin/gl_test" --gtest_filter='*Library.NothingIsLeftBehind/egl'
