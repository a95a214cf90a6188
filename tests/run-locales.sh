#!/usr/bin/env bash
# Runs tests of build-tests in locales that trip programs up: de_DE, whose decimal sign is a comma, and tr_TR, whose capital
# i has a dot. The locales are compiled into build-tests, so that none has to be installed, and a preloaded library makes each
# program a host that has set its locale. This is not part of CI. Usage: tests/run-locales.sh [ARGUMENT OF CTEST...]; with
# -R . the whole suite runs, without an argument the tests of readers, writers, numbers and the tool. Of the whole
# suite those fail that draw by OGRE or read plain nodes of OSG's text files: their shaders and numbers have the comma that
# std::locale::global has. In tr_TR those fail as well that configure a project: CMake does not know its own commands there.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"
cd "$root"
host="$root/build-tests/tests/libfbrdf_host_locale.so"
[ -f "$host" ] || { echo "fbrdf: found no $host, run tests/run.sh first" >&2; exit 1; }
arguments=("$@")
[ $# -gt 0 ] || arguments=(-R '^(Locale|Number|Text|Fields|AngleText|MeasurementText|Csv|Alta|Astm|Klems|Zemax|Speos|Pab|Write|MaterialFile|Manifest|ShaderSource|InfoCommand|ConvertCommand|EvalCommand|CompareCommand)')
export LOCPATH="$root/build-tests/locales"
mkdir -p "$LOCPATH"
failed=()
for locale in de_DE tr_TR; do
  [ -d "$LOCPATH/$locale.UTF-8" ] || localedef -i "$locale" -f UTF-8 "$LOCPATH/$locale.UTF-8"
  export LC_ALL=$locale.UTF-8 LANG=$locale.UTF-8
  # Python asks for the characters of its locale, not for its numbers: the comma comes from the library alone.
  point=$(LD_PRELOAD=$host python3 -c 'import locale; print(locale.localeconv()["decimal_point"])')
  [ "$point" = , ] || { echo "fbrdf: found the decimal sign '$point' in $locale, expected ','" >&2; exit 1; }
  LD_PRELOAD=$host ctest --test-dir build-tests --parallel "$(nproc)" --output-on-failure "${arguments[@]}" || failed+=("$locale")
done
[ ${#failed[@]} -eq 0 ] || { echo "fbrdf: tests failed in: ${failed[*]}" >&2; exit 1; }
