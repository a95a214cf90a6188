# demo.sh and the scripts of tests/ source this file. Its functions print each step, and the log of a step that fails.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# step NAME LOGFILE COMMAND...: runs the command into the log; on failure shows the log's end and its path.
step() {
  local name=$1 log=$2
  shift 2
  local start=$SECONDS
  printf '%-44s' "$name"
  if "$@" >>"$log" 2>&1; then
    printf 'ok (%d s)\n' $((SECONDS - start))
  else
    local status=$?
    printf 'FAILED\n'
    tail -n 25 "$log" >&2
    echo "fbrdf: $name failed; the whole log is $log" >&2
    exit $status
  fi
}

# Prints how many compilers to run: one a core, but no more than fit into memory (a translation unit takes up to 1 GiB).
build_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo 2>/dev/null || echo 2)
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}
