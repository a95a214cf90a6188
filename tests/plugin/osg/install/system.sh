#!/usr/bin/env bash
# An install into PREFIX, where OSG looks by itself, needs no variable: OSG's own programs read a material and a scene.
# The files lie over PREFIX in a mount namespace, which nobody else sees; PREFIX itself stays as it is.
# Usage: system.sh CMAKE BUILD WORK PREFIX. Ends with 77 where the machine allows no such namespace.
set -euo pipefail
cmake=$1 build=$2 work=$3 prefix=$4
unset OSG_LIBRARY_PATH LD_LIBRARY_PATH

# An osgconv that knows nothing of us leaves the material out.
reads() { osgconv "$1" "$2" >>log 2>&1 && [ -s "$2" ]; }

if [ "${5:-}" != inside ]; then
  rm -rf "$work"
  mkdir -p "$work/layers"
  cd "$work"
  DESTDIR=$work/stage "$cmake" --install "$build" --prefix "$prefix" >/dev/null
  "$build/bin/fbrdf" fit lambert:albedo=0.5 -o grey.fbrdf --form io --quiet
  if reads grey.fbrdf without.osgt; then echo "osgconv reads a material before it is installed"; exit 1; fi
  if ! unshare -rm true 2>/dev/null; then echo "skipped: needs a mount namespace (unshare -rm)"; exit 77; fi
  exec unshare -rm "$BASH" "$0" "$@" inside
fi

cd "$work"
# The upper layer must not be an overlay itself, as the file systems of containers are.
mount -t tmpfs layers layers
mkdir layers/upper layers/work
cp -a "stage$prefix/." layers/upper
if ! mount -t overlay overlay -o "lowerdir=$prefix,upperdir=layers/upper,workdir=layers/work" "$prefix" 2>/dev/null; then
  echo "skipped: needs overlayfs in a mount namespace"
  exit 77
fi
fail() { echo "$1"; cat log; exit 1; }
reads grey.fbrdf ball.osgt || fail "found no material in $prefix, expected one read by osgconv"
grep -q osgFbrdf::FactorizedBrdf ball.osgt || fail "found no effect in the scene"
reads ball.osgt ball.osgb && reads ball.osgb again.osgt || fail "found no serializers in $prefix"
grep -q 'MaterialFile "grey.fbrdf"' again.osgt || fail "found no material in the scene that was read again"
