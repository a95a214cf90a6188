#!/usr/bin/env bash
# Films the window while a slider is dragged, for README.md: docs/images/live-fit.gif. Needs Xvfb, xdotool and imagemagick, and the
# programs in build/bin, which sample_app/demo.sh builds. Usage: docs/make_film.sh [BIN_DIRECTORY]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export bin=${1:-build/bin} film=docs/images/live-fit.gif
work=$(mktemp -d)
export work
trap 'rm -rf "$work"' EXIT
xvfb-run -a -s "-noreset -screen 0 920x520x24" env -u WAYLAND_DISPLAY bash -c '
  set -eu
  "$bin/fbrdf-viewer" --size 920x520 --material ggx:alpha_x=0.12,alpha_y=0.12,f0=0.95/0.64/0.54 --form pqpr --samples 4 & viewer=$!
  trap "kill $viewer 2>/dev/null || true" EXIT
  # Until the window shows something, and then until its picture is whole.
  while [ "$(import -window root png:- | convert - -scale 1x1! -format "%[fx:mean>0.02]" info:)" != 1 ]; do sleep 0.5; done
  xdotool mousemove 860 20 key space key w  # no turntable, no handles of lights
  sleep 5
  frame=0
  shot() { import -window root "$work/frame-$(printf %03d $frame).png"; frame=$((frame + 1)); }
  row=206 left=37  # the slider of alpha_y, at 0.12
  shot
  xdotool mousemove $left $row; sleep 1; xdotool mousedown 1; sleep 1
  for ((x = 0; x <= 48; x += 2)); do xdotool mousemove $((left + x)) $row; sleep 0.35; shot; done
  xdotool mouseup 1 mousemove 860 20; sleep 4
  for ((i = 0; i < 6; ++i)); do shot; done
  xdotool key q; wait $viewer || true'
convert -delay 12 -loop 0 "$work"/frame-*.png -dither FloydSteinberg -colors 220 -layers optimize "$film"
echo "$film: $(stat -c %s "$film") bytes"
