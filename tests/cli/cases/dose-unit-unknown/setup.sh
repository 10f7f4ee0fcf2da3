printf "x_m,y_m,time_s,width_m,applied_rate\n0,0,0,6,200\n0,5,1,6,210\n0,10,2,6,190\n" > "$INPUT/drive.csv"
