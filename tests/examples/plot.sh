#!/usr/bin/env bash
# plot.sh PROGRAM: SVG and PNG figures, the same bytes in every run; a clear message where gnuplot is missing or the disk is full.
. "$(dirname "$0")/expect.sh"
program=$1
short="--t-end 4 --step 0.01"
run 0 "$program" $short --plot a.svg
head -c 200 a.svg | grep -q '<svg' || head -c 600 a.svg | grep -q '<svg' || fail "a.svg is no SVG file"
tail -c 20 a.svg | grep -q '</svg>' || fail "a.svg has no end"
for i in 1 2 3 4; do grep -q "gnuplot_plot_$i\"" a.svg || fail "curve $i is missing"; done
run 0 "$program" $short --plot b.svg
cmp a.svg b.svg || fail "two figures of the same run differ"
run 0 "$program" $short --plot a.png
[ "$(head -c 8 a.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || fail "a.png is no PNG file"
[ "$(wc -c <a.png)" -gt 10000 ] || fail "a.png is empty"

run 0 "$program" $short --figures out
[ "$(ls out | tr '\n' ' ')" = "N2.csv fig3.svg fig4.svg fig5.svg " ] || fail "the folder holds $(ls out)"
for f in out/*.svg; do tail -c 20 $f | grep -q '</svg>' || fail "$f has no end"; done
rm -r out a.svg b.svg a.png

mkdir scratch/empty
PATH=$PWD/scratch/empty run 1 "$program" $short --plot c.svg
says scratch/err.txt 'plots need gnuplot.*apt-get install gnuplot'
run 1 "$program" $short --plot missing/c.svg
says scratch/err.txt "cannot write 'missing/c.svg'"
full_device full.svg
run 1 "$program" $short --plot full.svg
says scratch/err.txt "cannot write 'full.svg': No space left on device"
leaves full.svg
