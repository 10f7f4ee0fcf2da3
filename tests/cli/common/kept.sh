#!/usr/bin/env bash
# Makes a file in the current folder, or takes the one that the same program has made of the same inputs before: many
# cases begin with the same plan. Usage: kept.sh FILE PROGRAM [ARGUMENT...]
set -euo pipefail
file="$1"
shift
same_again() {
  printf '%s\n' "$file" "$@"
  for word in "$@"; do
    if [ -f "$word" ]; then cat "$word"; fi
  done
}
known="$KEPT/$(same_again "$@" | sha256sum | cut -c1-32)"
if [ -e "$known" ]; then
  cp "$known" "$file"
  exit
fi
"$@"
mkdir -p "$KEPT"
find "$KEPT" -type f -mmin +600 -delete # of earlier builds
cp "$file" "$known.$$"
mv "$known.$$" "$known" # at once: other cases run beside this one
