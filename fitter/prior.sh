#!/usr/bin/env bash
# prior.sh - learns anew what fits to few samples lean on, and where few samples are best taken: the files of fit/data.
# The materials are the networks of Sztrajman et al. 2021 for the isotropic materials of MERL; of each the prior has no
# more than a share in its mean and 32 modes.
# Usage: fitter/prior.sh [path of fbrdf] [folder of data]    Build again afterwards: the files are compiled in.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
fbrdf=${1:-$root/build/bin/fbrdf}
data=${2:-${FBRDF_DATA_DIR:-$root/../shared/data}}/nbrdf
mapfile -t names < <(awk '$1 == "merl" { print $2 }' "$data/materials.txt")
"$fbrdf" learn-prior "${names[@]/#/$data/nbrdf_weights.f32#}" -o "$root/fitter/fit/data/hdio.prior" \
  --plan "$root/fitter/fit/data/plan_hemisphere.csv" --plan-in-plane "$root/fitter/fit/data/plan_in_plane.csv"
