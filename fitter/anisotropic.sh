#!/usr/bin/env bash
# anisotropic.sh - prints how well anisotropic models are fitted: the picture error of the standard
# sphere and the bytes of each, and the average and the least of all errors. No pass takes more than
# two look-ups: gg+pqpr straight into the target; pqp+pqpr with an accumulation surface for each term.
# The second is for cylinders, whose diffuse part is not a product of two angles.
# Usage: fitter/anisotropic.sh [path of fbrdf] [further options of fbrdf batch]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
fbrdf=${1:-$root/build/bin/fbrdf}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
{
  for name in ward-rolled-brass ward-brushed-aluminium ward-varnished-plywood; do
    printf '%s\t%s\n' "$name" "$name"
  done
  for alpha in 0.05:0.2 0.1:0.4; do
    lobe="ggx:alpha_x=${alpha%:*},alpha_y=${alpha#*:}"
    printf 'metal-%s\t%s,f0=0.9,kd=0\n' "${alpha/:/-}" "$lobe"
    printf 'plastic-%s\t%s,f0=0.04,kd=0.3\n' "${alpha/:/-}" "$lobe"
  done
  printf 'ashikhmin-shirley\tashikhmin-shirley:nu=10,nv=100,ks=0.5\n'
} > "$folder/lobes"
printf 'poulin-fournier\tpoulin-fournier:kd=0.3,ks=0.3\n' > "$folder/cylinders"
"$fbrdf" batch "$folder/lobes" -o "$folder/1" --form gg+pqpr --resolution 64 "${@:2}" --quiet
"$fbrdf" batch "$folder/cylinders" -o "$folder/2" --form pqp+pqpr --resolution 48 \
  --metric cuberoot --lookups 3 "${@:2}" --quiet
# Sources in quotes have commas of their own.
sed 's/"[^"]*"//g' "$folder"/[12]/results.csv | awk -F, '
  $1 == "name" { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  { p = $column["psnr_linear"]; sum += p; if (++count == 1 || p < least) least = p
    printf "%-24s %6d bytes %7.2f dB\n", $column["name"], $column["bytes"], p }
  END { printf "average %.2f dB, least %.2f dB\n", sum / count, least }'
