# Draws the firmware's CSV: make run >run.csv && gnuplot -e "csv='run.csv'; svg='run.svg'; poles=1" plot.gp
if (!exists("poles")) poles = 1
set terminal svg size 900,800 background "white"
set output svg
set datafile separator ","
set datafile commentschars "#"
set multiplot layout 3,1
set xlabel "t, s"
set grid
set key outside right
set lmargin 10
set rmargin 16
set autoscale xfix
set ylabel "angle from upright, rad"
plot for [i=1:poles] csv using (column("ms")/1000):(column(sprintf("y%d", i))) with lines lw 2 title sprintf("pole %d", i), \
  for [i=1:poles] csv using (column("ms")/1000):(column(sprintf("estimate%d", i))) with lines dt 2 title sprintf("estimate %d", i)
set ylabel "cart, m"
plot csv using (column("ms")/1000):"y0" with lines lw 2 title "cart", csv using (column("ms")/1000):"estimate0" with lines dt 2 title "estimate"
set ylabel "push, N"
plot csv using (column("ms")/1000):"push" with steps title "push"
unset multiplot
