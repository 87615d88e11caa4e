#!/usr/bin/env bash
# Makes the pictures of the window that README.md, docs/tuning.md and docs/tuning-lab.md show: the real program on its simulated board, driven by the
# keyboard alone, on a screen of its own.
#
#   docs/pictures.sh [FOLDER]     FOLDER has the programs; build/release/bin, else build/dev/bin if not given
set -euo pipefail

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=${1:-}
[ -n "$bin" ] || { [ -x build/release/bin/rotorscope ] && bin=build/release/bin || bin=build/dev/bin; }
images=$PWD/docs/images

fail() { echo "pictures: $1" >&2; exit 1; }

for program in Xvfb openbox xdotool import; do
    command -v "$program" >/dev/null \
        || fail "$program is missing; on Debian: apt-get install --no-install-recommends xvfb openbox xdotool imagemagick"
done
[ -x "$bin/rotorscope" ] || fail "$bin/rotorscope is missing; ./dev build makes it"

work=$(mktemp -d)
started=()
trap 'kill "${started[@]}" 2>/dev/null || true; rm -rf "$work"' EXIT
mkdir -p "$work/rotorscope"

Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp 3>"$work/display" 2>/dev/null &
started+=($!)
for _ in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
DISPLAY=:$(cat "$work/display")
export DISPLAY XDG_CONFIG_HOME=$work XDG_RUNTIME_DIR=$work LC_ALL=C.UTF-8
openbox 2>/dev/null &
started+=($!)
# A window that comes while its manager does is never shown.
for _ in $(seq 100); do xdotool get_num_desktops >/dev/null 2>&1 && break; sleep 0.1; done

program=
# open_window PORT [THEME]: a new window, as at the first start, connected.
open_window() {
    local window=
    [ -z "$program" ] || { kill "$program"; wait "$program" || true; }
    echo '{"theme":"'"${2:-light}"'","firstStepsDone":true,"port":"'"$1"'"}' >"$work/rotorscope/settings.json"
    "$bin/rotorscope" --connect --language en 2>/dev/null &
    program=$!
    started+=("$program")
    for _ in $(seq 100); do
        window=$(xdotool search --onlyvisible --name Rotorscope 2>/dev/null | tail -1) && [ -n "$window" ] && break
        sleep 0.2
    done
    [ -n "$window" ] || fail "the window did not open"
    xdotool windowsize "$window" 1280 720 windowmove "$window" 0 0
    sleep 3 # the board has told what it is
}

keys() { for key in "$@"; do xdotool key "$key"; sleep 0.2; done; }

# A motor that runs, at a few turns of its field.
open_window sim dark
keys alt+m r # Arm
sleep 1
keys ctrl+Return
sleep 1
keys Tab space # the question
sleep 8
keys plus plus plus plus plus plus plus
sleep 1
import -window root +dither -colors 128 "PNG8:$images/window.png"
echo "pictures: $images/window.png"
keys Escape
sleep 2

open_window sim
keys ctrl+1 alt+l
keys Tab Tab Tab Tab Tab Tab # from Rs to the inertia
xdotool type 500
keys Tab Tab # past the slider, to the bandwidth
xdotool type 2500
keys alt+p
sleep 1
import -window root +dither -colors 128 "PNG8:$images/gain-lab.png"
echo "pictures: $images/gain-lab.png"

# Steps of the speed with three gains, for docs/tuning-lab.md.
"$bin/rotorscope-sim" mcp --motor servo24 --link "$work/board" </dev/null >/dev/null 2>&1 &
started+=($!)
open_window "$work/board"
keys ctrl+t
keys alt+m r # Arm
sleep 1
keys ctrl+shift+t Tab space # the question is answered once
sleep 8
steps() {
    keys alt+k "$@" ctrl+shift+t
    sleep 7
}
steps Prior
steps Next Next
import -window root +dither -colors 128 "PNG8:$images/step.png"
echo "pictures: $images/step.png"
keys Escape
sleep 2

# The motor itself, its response and the tour, on the same board. A question is answered by Tab and space.
keys ctrl+i alt+m r # Arm
sleep 1
keys alt+l Tab space # electrical
sleep 32
keys alt+n Tab space # mechanical
sleep 22
keys alt+u # in the motor file
sleep 1
import -window root +dither -colors 128 "PNG8:$images/identify.png"
echo "pictures: $images/identify.png"
keys ctrl+shift+f
sleep 2 # the gains are read
keys alt+p Tab space
sleep 34
keys alt+o alt+a # proposed, and written
sleep 5
keys alt+r Tab space # proved
sleep 45
import -window root +dither -colors 128 "PNG8:$images/response.png"
echo "pictures: $images/response.png"
keys ctrl+shift+g
sleep 2
keys alt+r Tab space
sleep 90
keys alt+a # written and proved
sleep 45
import -window root +dither -colors 128 "PNG8:$images/tour.png"
echo "pictures: $images/tour.png"
keys Escape
