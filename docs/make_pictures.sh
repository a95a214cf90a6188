#!/usr/bin/env bash
# Makes the pictures of README.md and docs/method.md from analytic models, with the programs in build/bin, which
# sample_app/demo.sh builds. Usage: docs/make_pictures.sh [BIN_DIRECTORY [FOLDER]]    FOLDER: docs/images unless told
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=${1:-build/bin}
images=${2:-docs/images}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

material() { # NAME SOURCE FORM
  "$bin/fbrdf" fit "$2" -o "$work/$1.fbrdf" --form "$3" --environment-lobes 3 --quiet
}
picture() { # NAME MESH: the full scene, as in the window
  "$bin/fbrdf-viewer" --headless --full --material "$work/$1.fbrdf" --mesh "$2" --technique two-lookup --size 480x480 \
    --out "$images/$1.png"
}
material gold ggx:alpha_x=0.12,alpha_y=0.4,f0=1.0/0.77/0.34 pqpr
material red-plastic ggx:alpha=0.12,f0=0.04,kd=0.55/0.05/0.04 io+hdio
material blue-satin poulin-fournier:kd=0.08/0.12/0.4,ks=0.35 io+pqpr
picture gold knot
picture red-plastic sphere
picture blue-satin knot

# The gallery of README.md: materials that have a name, from models of their papers and, for Ward's, from his measurements.
gallery=()
shown() { # NAME SOURCE FORM
  material "$@"
  gallery+=("$work/$1.fbrdf")
}
shown "gold leaf" ggx:alpha=0.22,f0=1.0/0.77/0.34 hdio
shown "brushed copper" ggx:alpha_x=0.1,alpha_y=0.35,f0=0.95/0.64/0.54 pqpr
shown "rolled brass" ward:alpha_x=0.05,alpha_y=0.16,rho_d=0.1/0.07/0.03,rho_s=0.33/0.26/0.12 io+pqpr
shown "brushed aluminium" ward-brushed-aluminium io+pqpr
shown chrome ggx:alpha=0.06,f0=0.55/0.55/0.56 hdio
shown "car paint" disney:baseColor=0.5/0.01/0.01,clearcoat=1,roughness=0.45 io+hdio
shown "ivory plastic" ward:alpha=0.13,rho_d=0.6/0.55/0.42,rho_s=0.043 io+hdio
shown "ceramic tile" ward-white-ceramic-tile io+hdio
shown terracotta oren-nayar:albedo=0.55/0.22/0.12,sigma=0.6 hdio
shown "varnished plywood" ward:alpha_x=0.04,alpha_y=0.11,rho_d=0.45/0.28/0.13,rho_s=0.025 io+pqpr
shown "green velvet" disney:baseColor=0.03/0.2/0.08,roughness=0.9,sheen=1,sheenTint=1 hdio
shown "blue silk" ward:alpha_x=0.18,alpha_y=0.4,rho_d=0.04/0.07/0.25,rho_s=0.16/0.2/0.3 io+pqpr
"$bin/fbrdf-viewer" sheet "${gallery[@]}" --under studio --size 240x240 -o "$images/gallery.png"

# sample_app/README.md: what is made of one source, and how far that is from it.
"$bin/fbrdf-viewer" compare poulin-fournier:kd=0.08/0.12/0.4,ks=0.35 --form io+pqpr --side reference --side drawn --side pqp-2001 \
  --side ggx --mesh knot --samples 128 --size 256x256 -o "$images/compare.png"

# The maps of docs/method.md, and the standard spheres of function, fit and difference.
"$bin/fbrdf" fit ggx:alpha_x=0.12,alpha_y=0.4,f0=1.0/0.77/0.34 -o "$work/method.fbrdf" --form pqp --resolution 64 --quiet \
  --report "$work/method.html"
python3 docs/report_pictures.py "$work/method.html" "$images/method"
