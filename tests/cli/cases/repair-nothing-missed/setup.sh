# A square of 10 m, and one pass of 12 m over it.
cat > "$INPUT/field.geojson" <<'END'
{"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]}
END
printf 'time,x,y\n0,-5,5\n1,0,5\n2,5,5\n3,10,5\n4,15,5\n' > "$INPUT/log.csv"
"$TRAMLINE" evaluate "$INPUT/log.csv" --log-crs none --field "$INPUT/field.geojson" --crs none --width 12 --quiet -o "$INPUT/coverage.gpkg"
