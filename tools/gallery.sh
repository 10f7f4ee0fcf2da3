#!/usr/bin/env bash
# Plans a fixed choice of real fields and draws them on one contact sheet, for people to look at.
# The pictures stay outside the repository: the fields belong to their registers.
# Usage: gallery.sh [BUILD_DIR]     (TRAMLINE_DATA says where the real fields are)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# First the hard ones by name, then holes, concave and narrow shapes from many registers.
ids=(
  cz/45 bg/9 de-bb/13 sk/83 isopy-big/0 cz/12 br-lem/23 sk/32 us-csb/16
  at-block/57 be-vlg/82 bg/28 ch/3835047-p0 de-sh/62 dk-marker/28 ec-ro/9 fi/98
  fr-rpg/19 iso-MultiFields/PFD4 nl-brp/68 nz-irrig/87 pt/24 si/84 us-csb/55
)
machine=(--width 6 --radius 6)

build=${1:-build/release}
fields=${TRAMLINE_DATA:?say where the real fields are}/fields/fields.geojson
out=${TMPDIR:-/tmp}/tramline-gallery
if [[ ! -r $fields ]]; then
  echo "gallery.sh: $fields is not there; set TRAMLINE_DATA to the folder with fields/fields.geojson" >&2
  exit 2
fi

rm -rf "$out"
mkdir -p "$out"
pictures=()
refused=()
for id in "${ids[@]}"; do
  name=${id//\//_}
  if "$build/apps/tramline/tramline" plan "$fields" --where "id = '$id'" "${machine[@]}" --quiet \
    -o "$out/$name.gpkg" --picture "$out/$name.png" >"$out/$name.txt"; then
    pictures+=("$out/$name.png")
  else
    refused+=("$id")
  fi
done

if ((${#pictures[@]} > 0)); then
  "$build/apps/gallery/tramline_gallery" "$out/contact-sheet.png" "${pictures[@]}"
  echo "${#pictures[@]} of ${#ids[@]} fields planned; look at $out/contact-sheet.png"
fi
if ((${#refused[@]} > 0)); then
  echo "gallery.sh: not planned: ${refused[*]}" >&2
  exit 1
fi
