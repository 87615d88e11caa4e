#!/usr/bin/env bash
# Makes the pictures of docs/simulator.md: runs every motor of the simulator through a start, a ramp, a load step, a fault
# and a restart, with nothing but rotorscope-cli and the simulator's control words, and plots what was recorded.
#
#   docs/gallery.sh [FOLDER]     FOLDER has the programs; build/release/bin, else build/dev/bin if not given
#
# GALLERY_ONLY=pm24,start-up: only these. GALLERY_KEEP=FOLDER: keeps the CSV files there.
set -euo pipefail

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
bin=${1:-}
[ -n "$bin" ] || { [ -x build/release/bin/rotorscope-sim ] && bin=build/release/bin || bin=build/dev/bin; }
images=$PWD/docs/images
only=${GALLERY_ONLY:-}
work=${GALLERY_KEEP:-$(mktemp -d)}
mkdir -p "$work"

fail() { echo "gallery: $1" >&2; exit 1; }

command -v gnuplot >/dev/null || fail "gnuplot is missing; on Debian: apt-get install --no-install-recommends gnuplot-nox"
for program in rotorscope-sim rotorscope-cli; do
    [ -x "$bin/$program" ] || fail "$bin/$program is missing; ./dev build makes it"
done

simulator=
stop_simulator() {
    [ -n "$simulator" ] || return 0
    exec 3>&-
    wait "$simulator" || true
    simulator=
}
trap 'stop_simulator; [ -n "${GALLERY_KEEP:-}" ] || rm -rf "$work"' EXIT

# start_simulator OPTION...: a new board; control words go to descriptor 3.
start_simulator() {
    stop_simulator
    rm -f "$work/words" "$work/ready"
    mkfifo "$work/words" "$work/ready"
    "$bin/rotorscope-sim" mcp --control --link "$work/board" "$@" <"$work/words" >"$work/ready" &
    simulator=$!
    exec 3>"$work/words"
    read -r _ <"$work/ready"
}

# cli ARGUMENT...: a busy machine may lose an answer, so once more if need be.
cli() { "$bin/rotorscope-cli" --port "$work/board" "$@" || "$bin/rotorscope-cli" --port "$work/board" "$@"; }

# record FILE SECONDS SIGNALS OPTION... [-- SECONDS WORD]...: records, and gives the board control words on the way, each
# so many seconds after the one before. Says what the program said; a fault is no failure here, for some are wanted.
record() {
    local file=$work/$1.csv seconds=$2 signals=$3 options=() said status=0
    shift 3
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        options+=("$1")
        shift
    done
    rm -f "$file" "$work/progress"
    mkfifo "$work/progress"
    QT_LOGGING_RULES=cli.progress.info=true "$bin/rotorscope-cli" --port "$work/board" capture --hf "$signals" --hf-rate "${rate:-7}" --seconds "$seconds" \
        "${options[@]}" -o "$file" 2>"$work/progress" >"$work/said" &
    local capture=$! line
    exec 4<"$work/progress"
    while read -r line <&4; do
        case $line in
        *recording*) break ;;
        *) echo "  $line" ;;
        esac
    done
    while [ $# -ge 3 ]; do
        sleep "$2"
        echo "$3" >&3
        shift 3
    done
    while read -r line <&4; do
        case $line in *cli.progress*) ;; *) echo "  $line" ;; esac
    done
    exec 4<&-
    wait "$capture" || status=$?
    sed 's/^/  /' "$work/said"
    [ -s "$file" ] || fail "nothing was recorded (status $status)"
}

wanted() { [ -z "$only" ] || [[ ",$only," == *",$1,"* ]]; }

# plot NAME: gnuplot's commands from standard input, into docs/images/sim-NAME.png of less than 60 kB.
plot() {
    local image=$images/sim-$1.png
    {
        cat <<'END'
set datafile separator ","
set terminal pngcairo size 880,360 font "sans,9" background "#ffffff"
set grid lc rgb "#dddddd"
set border lc rgb "#666666"
set key top left samplen 1 spacing 0.9 font ",8"
set style line 1 lc rgb "#0060a8" lw 1.2
set style line 2 lc rgb "#d04000" lw 1.0
set style line 3 lc rgb "#208040" lw 1.0
set tmargin 1.6
set bmargin 2.0
END
        echo "set output '$image'"
        cat
    } >"$work/$1.gp"
    gnuplot "$work/$1.gp"
    local size
    size=$(stat -c %s "$image")
    echo "  $image: $size bytes"
    [ "$size" -lt 60000 ] || fail "$image is larger than 60 kB"
}

# ---- the motors ----------------------------------------------------------------------------------------------------

# motor NAME SPEED_SIGNAL LOAD_NM: the whole sequence on one motor.
motor() {
    local name=$1 speed=$2 load=$3 signals=$2,I_Q_REF,I_Q_MEAS column
    wanted "$name" || return 0
    echo "$name"
    start_simulator --motor "$name"
    record "$name-start" 2.5 "$signals" --start --from-start --ramp 500,1500 --keep-running
    record "$name-ramp" 5 "$signals" --ramp 3000,2000 --from-start --keep-running -- 3 "load $load" -- 1.2 "load 0"
    record "$name-fault" 1.5 "$signals" -- 0.4 "fault 40" -- 0.4 "nofault"
    cli ack | sed 's/^/  /'
    record "$name-restart" 2.5 "$signals" --start --from-start --ramp 3000,1000
    {
        echo "set multiplot layout 2,4"
        for column in start ramp fault restart; do
            echo "set xtics $([ $column = ramp ] && echo 1 || echo 0.5)"
            echo "set title '$column' offset 0,-0.7"
            echo "set ylabel '$([ $column = start ] && echo "speed [rpm]")'"
            echo "plot '$work/$name-$column.csv' using 1:2 skip 1 with lines ls 1 notitle"
        done
        echo "unset title"
        for column in start ramp fault restart; do
            echo "set xtics $([ $column = ramp ] && echo 1 || echo 0.5)"
            echo "set ylabel '$([ $column = start ] && echo "q current [A]")'"
            echo "plot '$work/$name-$column.csv' using 1:4 skip 1 every 6 with lines ls 2 title 'measured'," \
                "'' using 1:3 skip 1 every 6 with lines ls 3 title 'reference'"
            echo "unset key"
        done
        echo "unset multiplot"
    } | plot "$name"
}

motor pm24 STOPLL_ROT_SPEED 0.08
motor prop12 STOPLL_ROT_SPEED 0.02
motor servo24 ENCODER_SPEED 0.12
motor blower36 HALL_SPEED 0.15
motor ipm48 STOPLL_ROT_SPEED 0.5

# ---- what goes wrong -----------------------------------------------------------------------------------------------

# stages RPM,DIGITS,MS...: the bytes of REVUP_DATA.
stages() {
    local stage rpm digits ms
    for stage in "$@"; do
        IFS=, read -r rpm digits ms <<<"$stage"
        printf '%02x%02x%02x%02x%02x%02x%02x%02x' $((rpm & 255)) $((rpm >> 8 & 255)) $((rpm >> 16 & 255)) \
            $((rpm >> 24 & 255)) $((digits & 255)) $((digits >> 8 & 255)) $((ms & 255)) $((ms >> 8 & 255))
    done
}

# A rev-up whose field runs away from the rotor: 4000 rpm in 60 ms.
if wanted start-up; then
    echo "start-up"
    start_simulator --motor pm24
    rate=3 record start-up-right 1.5 STOPLL_ROT_SPEED,I_Q_MEAS,STOPLL_BEMF_ALPHA,STOPLL_BEMF_BETA \
        --start --from-start --ramp 1500,300
    cli set REVUP_DATA="$(stages 0,1361,50 4000,1361,60 4000,1361,200 4000,1361,0 4000,1361,0)" | sed 's/^/  /'
    rate=3 record start-up-wrong 1.5 STOPLL_ROT_SPEED,I_Q_MEAS,STOPLL_BEMF_ALPHA,STOPLL_BEMF_BETA --start --from-start
    cli get STATUS FAULTS_FLAGS | sed 's/^/  /'
    {
        echo "set multiplot layout 2,2"
        for column in right wrong; do
            echo "set title 'rev-up: $column' offset 0,-0.7"
            echo "set ylabel '$([ $column = right ] && echo "observed speed [rpm]")'"
            echo "plot [0:0.8] '$work/start-up-$column.csv' using 1:2 skip 1 with lines ls 1 notitle"
        done
        echo "unset title"
        for column in right wrong; do
            echo "set ylabel '$([ $column = right ] && echo "back-EMF [V]")'"
            echo "plot [0:0.8] '$work/start-up-$column.csv' using 1:(sqrt(\$4**2+\$5**2)) skip 1 with lines ls 2 notitle"
        done
        echo "unset multiplot"
    } | plot start-up
fi

# Braking hard: what the motor returns raises the bus until the firmware gives up.
if wanted brake; then
    echo "brake"
    start_simulator --motor ipm48
    record brake-run 1 STOPLL_ROT_SPEED,I_Q_MEAS --start --ramp 3000,1500 --keep-running
    record brake 1 STOPLL_ROT_SPEED,I_Q_REF,I_Q_MEAS --ramp 600,100 --from-start
    cli get STATUS FAULTS_FLAGS BUS_VOLTAGE | sed 's/^/  /'
    {
        echo "set multiplot layout 1,2"
        echo "set ylabel 'speed [rpm]'"
        echo "plot '$work/brake.csv' using 1:2 skip 1 with lines ls 1 notitle"
        echo "set ylabel 'q current [A]'"
        echo "plot '$work/brake.csv' using 1:4 skip 1 with lines ls 2 title 'measured'," \
            "'' using 1:3 skip 1 with lines ls 3 title 'reference'"
        echo "unset multiplot"
    } | plot brake
fi

# The currents themselves, at every control period.
if wanted currents; then
    echo "currents"
    start_simulator --motor pm24 --load 0.05
    rate=0 record currents 0.2 I_A,I_B,I_Q_MEAS,I_D_MEAS --start --ramp 3000,1000
    {
        echo "set ylabel 'current [A]'"
        echo "set xlabel 'time [s]'"
        echo "plot [0:0.015] '$work/currents.csv' using 1:2 skip 1 with lines ls 1 title 'phase A'," \
            "'' using 1:3 skip 1 with lines ls 2 title 'phase B', '' using 1:4 skip 1 with lines ls 3 title 'q'," \
            "'' using 1:5 skip 1 with lines lc rgb '#707070' title 'd'"
    } | plot currents
fi

stop_simulator
echo "gallery: done"
