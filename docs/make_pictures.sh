#!/usr/bin/env bash
# Makes the pictures of README.md and docs/method.md from analytic models, with the programs in build/bin, which
# sample_app/demo.sh builds. Usage: docs/make_pictures.sh [BIN_DIRECTORY]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=${1:-build/bin}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

picture() { # NAME SOURCE FORM MESH LIGHTS EXPOSURE
  "$bin/fbrdf" fit "$2" -o "$work/$1.fbrdf" --form "$3" --quiet
  "$bin/fbrdf-viewer" --headless --material "$work/$1.fbrdf" --mesh "$4" --light-count "$5" --exposure "$6" \
    --technique two-lookup --size 480x480 --out "docs/images/$1.png"
}
picture gold ggx:alpha_x=0.12,alpha_y=0.4,f0=1.0/0.77/0.34 pqpr knot 12 0.9
picture red-plastic ggx:alpha=0.12,f0=0.04,kd=0.55/0.05/0.04 io+hdio sphere 12 1.0
picture blue-satin poulin-fournier:kd=0.08/0.12/0.4,ks=0.35 io+pqpr knot 12 1.0

# The maps of docs/method.md, and the standard spheres of function, fit and difference.
"$bin/fbrdf" fit ggx:alpha_x=0.12,alpha_y=0.4,f0=1.0/0.77/0.34 -o "$work/method.fbrdf" --form pqp --resolution 64 --quiet \
  --report "$work/method.html"
python3 docs/report_pictures.py "$work/method.html" docs/images/method
