#!/bin/sh
# check_dissector.sh TSHARK SCRIPT CLI: the dissector takes a whole recording apart, without an error. Bytes that are no
# packet may only stand at the very beginning: a recording begins in the middle of what the line does.
tshark=$1 script=$2 cli=$3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
"$cli" --port sim capture --hf I_A,I_B --seconds 0.3 --record "$folder/r.pcapng" --link >/dev/null || exit 1
"$tshark" -X "lua_script:$script" -r "$folder/r.pcapng" -V >"$folder/text" 2>"$folder/errors" || { cat "$folder/errors"; exit 1; }
if grep -E 'Lua Error|Malformed|CRC-4 right: False' "$folder/text" "$folder/errors"; then exit 1; fi
"$tshark" -X "lua_script:$script" -r "$folder/r.pcapng" -Y aspep 2>/dev/null | sed 1,2d >"$folder/frames"
if grep noise "$folder/frames" || [ ! -s "$folder/frames" ]; then exit 1; fi
for what in 'ASPEP ASYNC' 'ASPEP REQUEST' 'ASPEP RESPONSE' 'Kind: samples' 'Kind: event' 'Kind: end'; do
    grep -qF "$what" "$folder/text" || { echo "not dissected: $what"; exit 1; }
done
