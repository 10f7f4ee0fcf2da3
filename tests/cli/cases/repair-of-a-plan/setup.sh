"$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width 12 --strategy sweep --quiet -o "$INPUT/plan.gpkg"
