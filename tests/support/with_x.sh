#!/usr/bin/env bash
# Runs a command in an X server of its own, which chooses a display that nobody has: of two xvfb-run that begin at once
# one fails. Usage: with_x.sh COMMAND...
set -euo pipefail
folder=$(mktemp -d)
trap 'kill "$server" 2>/dev/null || true; rm -rf "$folder"' EXIT
mkfifo "$folder/display"
Xvfb -displayfd 1 -screen 0 1280x1024x24 -nolisten tcp -noreset >"$folder/display" 2>/dev/null &
server=$!
read -r display <"$folder/display"
DISPLAY=:$display "$@"
