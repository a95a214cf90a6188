#!/usr/bin/env bash
# Runs tests of build-tests in locales that trip programs up: de_DE, whose decimal sign is a comma, and tr_TR, whose capital
# i has a dot. The locales are compiled into build-tests, so that none has to be installed. This is not part of CI. Usage:
# tests/run-locales.sh [ARGUMENT OF CTEST...]; without an argument the tests of readers, writers, numbers and the tool run.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
[ -f build-tests/CTestTestfile.cmake ] || { echo "fbrdf: found no build-tests, run tests/run.sh first" >&2; exit 1; }
arguments=("$@")
[ $# -gt 0 ] || arguments=(-R '^(Locale|Number|Text|Fields|AngleText|MeasurementText|Csv|Alta|Astm|Klems|Zemax|Speos|Write|MaterialFile|Manifest|ShaderSource|InfoCommand|ConvertCommand|EvalCommand|CompareCommand)')
export LOCPATH="$root/build-tests/locales"
mkdir -p "$LOCPATH"
for locale in de_DE tr_TR; do
  [ -d "$LOCPATH/$locale.UTF-8" ] || localedef -i "$locale" -f UTF-8 "$LOCPATH/$locale.UTF-8"
  LC_ALL=$locale.UTF-8 LANG=$locale.UTF-8 ctest --test-dir build-tests --parallel "$(nproc)" --output-on-failure \
    "${arguments[@]}"
done
