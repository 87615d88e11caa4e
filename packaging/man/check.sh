#!/bin/sh
# check.sh MANUAL PROGRAM: the manual is flawless roff, and it has every option that the program's --help lists.
manual=$1 program=$2
flaws=$(man --warnings -l -Tutf8 -Z "$manual" 2>&1 >/dev/null)
[ -z "$flaws" ] || { echo "$flaws"; exit 1; }
options=$("$program" --help | grep -oE '^ *(-[a-zA-Z], )?--[a-z][a-z0-9-]*' | grep -oE -e '--[a-z][a-z0-9-]*' | sort -u)
[ -n "$options" ] || { echo "$program --help lists no options"; exit 1; }
missing=0
for option in $options; do
    tr -d '\\' <"$manual" | grep -qwF -e "$option" || { echo "not in the manual: $option"; missing=1; }
done
exit $missing
