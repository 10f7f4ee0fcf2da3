#!/usr/bin/env bash
# Zips the plugin for QGIS, in the form that its plugin manager installs. Usage: qgis_plugin.sh ZIP
# The same sources give the same bytes.
set -euo pipefail

zip_file=$(realpath -m "${1:?Usage: qgis_plugin.sh ZIP}")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir -p "$(dirname "$zip_file")" "$work/tramline_processing"
cp -r qgis/tramline_processing LICENSE "$work"
mv "$work/LICENSE" "$work/tramline_processing/"
version=$(sed -n 's/^project(tramline VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
sed -i "s/@VERSION@/$version/" "$work/tramline_processing/metadata.txt"
find "$work" -name __pycache__ -prune -exec rm -rf {} +
find "$work" -exec touch -d '2020-01-01 00:00:00 UTC' {} +
rm -f "$zip_file"
(cd "$work" && find tramline_processing -type f | LC_ALL=C sort | TZ=UTC zip -q -X "$zip_file" -@)
echo "The plugin: $zip_file (in QGIS: Plugins > Manage and Install Plugins > Install from ZIP)"
