#!/bin/sh
# page_commands.sh PAGE WORK PROGRAM BUILD
# Follows a page of the documentation as its reader would, in a folder with two domains, domain.poly
# and part.off: blocks that begin with a comment that holds the name of a file become that file, then
# the lines of the sh blocks are run in order, and each must succeed. Left out is what builds the
# project, which is built, and Python where numpy is not installed.
set -eu
page=$1 work=$2 program=$3 build=$4
rm -rf "$work"
mkdir -p "$work/build"
cd "$work"
ln -s "$build" build/release
printf '4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n' > domain.poly
printf 'OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n' > part.off
printf '4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n' >> part.off
PATH=$(dirname "$program"):/usr/bin:$PATH  # where Debian's Python has numpy

awk '
  /^```/ && inside { inside = 0; file = ""; next }
  /^```/ { inside = 1; first = 1; language = substr($0, 4); next }
  inside && language == "sh" { print > "commands"; next }
  inside && first { first = 0; if ($1 ~ /^(\/\/|\/\*|#)$/ && $2 ~ /^[a-z_]+\.[a-z]+$/) file = $2 }
  inside && file != "" { print > file }
' "$page"

count=0
while IFS= read -r line; do
  case $line in
    '' | 'cmake --workflow'*) continue ;;
    *python3*) python3 -c 'import numpy' 2> output || continue ;;
  esac
  count=$((count + 1))
  if ! sh -c "$line" > output 2>&1; then
    echo "$page: this command fails: $line" >&2
    cat output >&2
    exit 1
  fi
done < commands
[ "$count" -gt 0 ] || { echo "$page: no commands" >&2; exit 1; }
