printf -- "-6,1\n0,-1\n6,1\n" > "$INPUT/boom.csv"
