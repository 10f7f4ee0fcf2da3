"$TRAMLINE" evaluate "$EXAMPLES/riverside-drive.csv" --field "$EXAMPLES/riverside.geojson" -o "$INPUT/coverage.gpkg" --quiet
