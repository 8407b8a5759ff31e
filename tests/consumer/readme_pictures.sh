#!/bin/sh
# The README's pictures are, byte by byte, what the commands below them draw.
#   readme_pictures.sh PROGRAM PICTURES SCRATCH
set -e
program=$1 pictures=$2
mkdir -p "$3"
cd "$3"
"$program" generate airfoil --nodes 3000 -o w --quiet
"$program" coarsen w --profile quality -o levels --format svg --quiet
for level in 0 1 2; do
  cmp "levels/level_$level.svg" "$pictures/level_$level.svg"
done
