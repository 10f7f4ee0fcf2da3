"$TRAMLINE" evaluate "$EXAMPLES/riverside-drive.csv" --quiet -o "$INPUT/coverage.gpkg"
