#!/usr/bin/env bash
# Saves what osgviewer shows in a window of 640 x 480 under Xvfb. OSG_LIBRARY_PATH names the folder of the plugins.
# Usage: screenshot.sh PICTURE.png ARGUMENT_OF_OSGVIEWER... (paths are absolute). Needs xdotool and imagemagick.
set -euo pipefail
picture=$(realpath "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# osgviewer answers to the key c, by a picture (JPEG) of its own, once it draws.
xvfb-run -a -s "-noreset -screen 0 640x480x24" bash -c '
  set -eu
  picture=$1 work=$2
  shift 2
  cd "$work"
  osgviewer --window 0 0 640 480 "$@" & viewer=$!
  trap "kill $viewer 2>/dev/null || true" EXIT
  for ((i = 0; i < 300; ++i)); do
    if [ -e "$work/screen_shot_0_1.jpg" ]; then break; fi
    kill -0 $viewer
    xdotool mousemove 320 20 key c
    sleep 0.2
  done
  import -window root -strip "$picture"
  xdotool key Escape
  wait $viewer' _ "$picture" "$work" "$@"
