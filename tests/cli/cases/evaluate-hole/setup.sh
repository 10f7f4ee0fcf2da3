awk 'NR < 1000 || NR > 1030' "$EXAMPLES/riverside-drive.csv" > "$INPUT/drive.csv"
