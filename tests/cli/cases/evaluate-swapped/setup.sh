awk -F, 'NR == 1 { print } NR > 1 { print $1 "," $3 "," $2 }' "$COMMON/drive.csv" >drive.csv
