#!/usr/bin/env bash
# Makes the pictures of the documentation anew, and fails where one looks different from the one that is there. Usage:
#   check_pictures.sh PICTURE_FLIP BIN_DIRECTORY    PICTURE_FLIP: the program beside this file
#   check_pictures.sh --self-test PICTURE_FLIP      that a picture in another's place is seen, and a folder without any
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
limit=0.01
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
refused() {
  if "$@"; then
    echo "check_pictures.sh: found no fault in: $*" >&2
    exit 1
  fi
}
if [ "$1" = --self-test ]; then
  refused "$2" "$work" "$root/docs/images" $limit
  cp "$root/docs/images/gold.png" "$work/gold.png"
  "$2" "$work" "$root/docs/images" $limit
  cp "$root/docs/images/red-plastic.png" "$work/gold.png"
  refused "$2" "$work" "$root/docs/images" $limit
else
  "$root/docs/make_pictures.sh" "$2" "$work"
  "$1" "$work" "$root/docs/images" $limit
fi
