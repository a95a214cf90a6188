#!/usr/bin/env bash
# auto.sh - prints how the error of `auto` compares with that of the best named form on the same
# measured data: median |ln g/f| on samples held out. Exits 1 where it is more than 2 % above.
# Usage: fitter/auto.sh [path of fbrdf] [folder of the data]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
fbrdf=${1:-$root/build/bin/fbrdf} data=${2:-$root/../shared/data}
csv=$(mktemp)
trap 'rm -f "$csv"' EXIT
rm "$csv"
"$fbrdf" bench-fit --peers none --forms auto,pqp,pqpr,hdio,hdg,hdp,hdpio,qdio,qdg --csv "$csv" \
  "$data"/cornell_pbrt2/{garnet_red,krylon_blue,mystique}.brdf "$data/nist_ptfe/PTFE.data.csv@0.532" \
  > /dev/null
sed 's/"[^"]*"//g' "$csv" | awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  { m = $column["material"]; name = $column["name"]; error = $column["log_median"]
    if (error == "") next
    if (name == "auto") auto[m] = error
    else if (!(m in best) || error < best[m]) { best[m] = error; form[m] = name } }
  END { for (m in auto) {
      printf "%-14s auto %.5f, best named form %.5f (%s): %.2f of it\n", m, auto[m], best[m], form[m], auto[m] / best[m]
      if (auto[m] > 1.02 * best[m]) failed = 1 }
    exit failed }'
