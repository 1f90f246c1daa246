# Draws the firmware's CSV: make run >run.csv && gnuplot -e "csv='run.csv'; svg='run.svg'" plot.gp
set terminal svg size 900,700
set output svg
set datafile separator ","
set multiplot layout 3,1
set xlabel "t, s"
set grid
set ylabel "angle of the pole, rad"
plot csv using (column("ms")/1000):"y1" with lines title "true", csv using (column("ms")/1000):"estimate1" with lines title "estimate"
set ylabel "cart, m"
plot csv using (column("ms")/1000):"y0" with lines title "true", csv using (column("ms")/1000):"estimate0" with lines title "estimate"
set ylabel "push, N"
plot csv using (column("ms")/1000):"push" with lines notitle
unset multiplot
