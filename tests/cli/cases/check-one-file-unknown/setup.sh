"$TRAMLINE" plan "$EXAMPLES/two-farms.gpkg" --layer parcels --all --width 6 -o "$INPUT/plans.gpkg" --one-file --quiet
