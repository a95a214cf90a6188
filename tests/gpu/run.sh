#!/usr/bin/env bash
# Runs the programs of a packed folder (tests/run-gpu.sh) on the machine that it was copied to, and prints the driver and a
# line for each: passed, failed, skipped, and where a driver ended the program. What follows a test that crashed runs in
# another process. Usage: run.sh [--device N] [--filter GTEST_FILTER] [--programs "NAME NAME"] [--no-bench]
# Exit code: 0 where nothing failed. Logs are beside this script.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/tree"
filter='*' programs="$(cat "$here/programs")" bench=1
while [ $# -gt 0 ]; do
  case $1 in
    --device) export FBRDF_EGL_DEVICE=$2; shift 2 ;;
    --filter) filter=$2; shift 2 ;;
    --programs) programs=$2; shift 2 ;;
    --no-bench) bench=0; shift ;;
    *) echo "run.sh: found '$1', expected --device, --filter, --programs or --no-bench" >&2; exit 2 ;;
  esac
done
export LD_LIBRARY_PATH="$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export FBRDF_BENCH=$here/fbrdf-bench FBRDF_VIEWER=$here/fbrdf-viewer FBRDF_C_LIBRARY=$here/lib/libfbrdf.so
export FBRDF_OSG_LIBRARIES=$here/lib

echo "devices of EGL:"
"$here/fbrdf-viewer" list-devices | sed 's/^/  /'
echo "drawn with: $("$here/fbrdf-bench" --lights 1 --size 8x8 --mesh triangle --only ggx 2>&1 | head -1)"

# Tests of a program that the filter takes, one a line: "Suite.Test".
tests_of() {
  "$here/$1" --gtest_list_tests --gtest_filter="$filter" 2>/dev/null |
    awk '/^[^ ]/ { suite = $1; next } { print suite $1 }'
}

failed_in_all=0
printf '%-22s %7s %7s %8s\n' program passed failed skipped
for program in $programs; do
  log=$here/$program.log
  : >"$log"
  tests_of "$program" >"$here/todo"
  crashes=""
  while [ -s "$here/todo" ]; do
    "$here/$program" --gtest_filter="$(paste -sd: "$here/todo")" >"$here/part.log" 2>&1
    code=$?
    cat "$here/part.log" >>"$log"
    sed -n 's/^\[ RUN      \] //p' "$here/part.log" >"$here/begun"
    # A test program ends with 0 or 1; anything else, and a run that began nothing, is the driver's or the machine's doing.
    if [ "$code" -gt 1 ] || [ ! -s "$here/begun" ]; then
      last=$(tail -n 1 "$here/begun")
      crashes="$crashes  ended with $code in ${last:-its start: $(tail -n 1 "$here/part.log")}"
      [ -s "$here/begun" ] || break
    fi
    grep -vxF -f "$here/begun" "$here/todo" >"$here/rest"
    mv "$here/rest" "$here/todo"
  done
  passed=$(grep -c '^\[       OK \]' "$log")
  failed=$(grep -c '^\[  FAILED  \] .*ms)$' "$log")
  skipped=$(grep -c '^\[  SKIPPED \] .*ms)$' "$log")
  printf '%-22s %7d %7d %8d%s\n' "$program" "$passed" "$failed" "$skipped" "$crashes"
  sed -n 's/^\[  FAILED  \] \(.*\) ([0-9]* ms)$/    failed: \1/p' "$log"
  if [ "$failed" -gt 0 ] || [ -n "$crashes" ]; then failed_in_all=1; fi
done
rm -f "$here/todo" "$here/rest" "$here/begun" "$here/part.log"

if [ "$bench" = 1 ]; then
  echo
  "$here/fbrdf-bench" --accuracy --lights 1,64 >"$here/accuracy.log" 2>&1
  code=$?
  over=$(awk '$NF + 0 > 1 && NF > 8' "$here/accuracy.log" | wc -l)
  echo "accuracy: $(grep -c 'GLSL\|ES ' "$here/accuracy.log") pictures, $over above their bound (accuracy.log), exit code $code"
  [ "$code" = 0 ] || failed_in_all=1
  "$here/fbrdf-bench" --lights 1,64 --size 1920x1080 --clock gpu 2>&1 | tee "$here/bench.log"
fi
exit $failed_in_all
