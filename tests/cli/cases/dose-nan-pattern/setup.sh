printf -- "-6,1\n0,nan\n6,1\n" > "$INPUT/boom.csv"
