#!/usr/bin/env bash
# Installs what is missing of the Debian packages that fbrdf builds (or is tested) with. Does nothing, and asks for no
# rights, where all are there. Usage: install-packages.sh build|tests|builds LOGFILE
set -euo pipefail
usage='usage: install-packages.sh build|tests|builds LOGFILE'
purpose=${1:?$usage}
log=${2:?$usage}

packages=(
  g++ cmake ninja-build pkg-config ccache python3 python3-glad help2man
  libeigen3-dev libcli11-dev libfmt-dev nlohmann-json3-dev libpugixml-dev libpng-dev libopenexr-dev
  libglm-dev libglfw3-dev libimgui-dev libembree-dev libegl-dev libegl1 libgl1-mesa-dri libosmesa6-dev
)
if [ "$purpose" != build ]; then
  packages+=(libgtest-dev libopenimageio-dev libceres-dev libopenmpi-dev openmpi-bin glslang-tools clang-format xvfb xauth libx11-dev imagemagick libopenscenegraph-dev openscenegraph libvtk9-dev libogre-1.12-dev xdotool dpkg-dev file doxygen graphviz groff-base)
fi
[ "$purpose" != builds ] || packages+=(clang)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null || true)
  [[ $status == ii* ]] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

sudo=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "fbrdf: set-up: found neither root nor sudo, expected one to install: ${missing[*]}" >&2; exit 1; }
  sudo=(sudo)
fi
echo "installing ${#missing[@]} Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${sudo[@]}" apt-get update -qq >>"$log" 2>&1
"${sudo[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >>"$log" 2>&1
