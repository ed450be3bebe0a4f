#!/bin/sh
# Compares what `door` prints for every example with golden.txt: tests/wasm/door.sh DOOR [--update]
set -u
folder=$(dirname "$0")
found=$("$1" "$folder"/../../examples/*.yaml) || exit 1
if [ "${2-}" = --update ]; then
    printf '%s\n' "$found" >"$folder/golden.txt"
else
    printf '%s\n' "$found" | diff "$folder/golden.txt" -
fi
