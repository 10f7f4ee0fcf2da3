#!/usr/bin/env bash
# drive.csv: four sides of a square of 20 m, to the east first, a fix a metre and a second; its headings are
# anticlockwise from east. In the current folder.
set -euo pipefail
awk 'BEGIN {
  print "time,x,y,heading,width"
  print "2026-05-06T08:00:00Z,0,0,0,4"
  for (i = 1; i <= 80; ++i) {
    side = int((i - 1) / 20); along = (i - 1) % 20 + 1
    x = side == 0 ? along : side == 1 ? 20 : side == 2 ? 20 - along : 0
    y = side == 0 ? 0 : side == 1 ? along : side == 2 ? 20 : 20 - along
    printf "2026-05-06T08:%02d:%02dZ,%d,%d,%d,4\n", int(i / 60), i % 60, x, y, 90 * side
  }
}' >drive.csv
