#!/usr/bin/env bash
# Runs what uploads (a library, a mesh, their buffers) under valgrind, with the gl_test of a build folder that has
# no sanitizer. Not part of CI. Usage: tests/run-valgrind.sh [BUILD-FOLDER]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
exec valgrind -q --error-exitcode=9 --leak-check=no --suppressions="$root/tests/valgrind.supp" \
  "${1:-$root/build}/bin/gl_test" --gtest_filter='*Library.NothingIsLeftBehind/egl'
