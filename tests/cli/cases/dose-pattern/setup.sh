printf "offset,rate\n-9,0\n-3,1\n3,1\n9,0\n" > "$INPUT/boom.csv"
