"$TRAMLINE" evaluate "$EXAMPLES/riverside-drive.csv" --field "$EXAMPLES/riverside.geojson" --quiet -o "$INPUT/coverage.gpkg"
