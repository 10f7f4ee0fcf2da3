"$TRAMLINE" evaluate "$EXAMPLES/riverside-drive.csv" --field "$EXAMPLES/riverside.geojson" --quiet -o "$INPUT/coverage.gpkg"
"$TRAMLINE" repair "$INPUT/coverage.gpkg" --width 12 --min-area 20 --quiet -o "$INPUT/repair.gpkg"
