#!/usr/bin/env bash
# The Debian package: what is in it, and what it depends on.
# Usage: package.sh CPACK BUILD WORK OSG_VERSION [FILE]..., which other plugins add
set -euo pipefail
cpack=$1 build=$2 work=$3 version=$4
shift 4
rm -rf "$work"
mkdir -p "$work"
"$cpack" -G DEB --config "$build/CPackConfig.cmake" -B "$work" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
package=$(echo "$work"/fbrdf_*.deb)
dpkg-deb --contents "$package" >"$work/contents"
for file in bin/fbrdf bin/fbrdf-viewer fbrdf/fbrdf_pictures_oiio.so "osgPlugins-$version/osgdb_fbrdf.so" "osgPlugins-$version/osgdb_serializers_osgfbrdf.so" \
  'libosgFbrdf.so -> ' 'libosgFbrdf.so.[0-9.]* -> ' 'libosgFbrdf.so.[0-9.]*$' include/osgFbrdf/FactorizedBrdf.h \
  include/fbrdf/brdf/Material.h cmake/fbrdf/fbrdfConfig.cmake share/doc/fbrdf/copyright "$@"; do
  grep -q "/$file" "$work/contents" || { echo "found no $file"; cat "$work/contents"; exit 1; }
done
depends=$(dpkg-deb --field "$package" Depends)
for dependency in libopenscenegraph libopenexr libopenimageio libc6; do
  [[ $depends == *$dependency* ]] || { echo "found no $dependency in: $depends"; exit 1; }
done
# Libraries are made known to the loader by ldconfig.
dpkg-deb --ctrl-tarfile "$package" | tar -xO ./triggers | grep -q ldconfig || { echo "found no ldconfig"; exit 1; }
