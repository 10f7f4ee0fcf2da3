"$TRAMLINE" plan "$COMMON/two-fields.geojson" --all --width 6 -o "$OUT/plan.gpkg" --quiet
rm "$OUT/plan-mill.gpkg"
