#!/usr/bin/env bash
# parameters.sh PROGRAM MODEL: every kind of parameter is set, shown and bounded as its type says, and the model reads it there.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 model=$2
cat >all.txt <<'EOF'
spring[0].stiffness = 4      # one member of an array of structs
spring[0].rest = 0.5 0.25
spring[1].stiffness = 9
spring[1].rest[1] = -1
steps = -2
loaded = 1
code = 65535
selected = 2
sign = -128
big = -4503599627370496
table[1] = 1 2 3
p.q = 2                      # the mass, though coordinates are q as well
x = 1
yd = 2
EOF
run 0 "$program" info "$model" --start all.txt
for line in 'spring\[0\].stiffness +double   = 4$' 'spring\[0\].rest\[2\] +float    = 0.5 0.25$' 'spring\[1\].rest\[2\] +float    = 0 -1$' 'steps +integer  = -2$' \
  'loaded +bool     = 1$' 'code +unsigned = 65535$' 'selected +integer  = 2   of offset$' 'sign +integer  = -128$' 'big +integer  = -4503599627370496$|big +integer  = -4.5' \
  'table\[0\]\[3\] +double   = 0 \(all\)$' 'table\[1\]\[3\] +double   = 1 2 3$' 'q +double   = 2$' 'label +cannot be set   for people$'; do
  says scratch/out.txt "^  $line"
done
says scratch/out.txt '^Coordinates: 2: x, y; velocities: xd, yd$'

# 2 x'' = -4 (x - 0.5) + 3 (-2) = -8 at x = 1; 2 y'' = -9 (y + 1) = -9 at y = 0.
run 0 "$program" linearise "$model" --start all.txt
says scratch/out.txt '^  x += 1 +xd += 0 +acceleration -4$'
says scratch/out.txt '^  y += 0 +yd += 2 +acceleration -4.5$'

refused() { # refused NAME=VALUE TEXT
  run 2 "$program" run "$model" --start all.txt --set "$1"
  says scratch/err.txt "^eom: --set .*: .*$2"
}
refused loaded=2 'must be 0 or 1'
refused code=-1 'too small for the type'
refused code=65536 'too large for the type'
refused sign=128 'too large for the type'
refused sign=-129 'too small for the type'
refused big=9223372036854775808 'too large for the type'
refused steps=0.5 'must be a whole number'
refused 'spring[0].rest[0]=1e39' 'too large for a float'
refused label=1 'cannot be set by a text'
refused 'table[2]=1' "unknown name 'table"
refused zd=1 "unknown name 'zd'"
refused selected=3 'it may be 2 at most: with more the model would leave its arrays'


# The names that the source gives velocities, and those of coordinates with _dot behind them, mean the same.
run 0 "$program" run "$model" --start all.txt --set x_dot=3 --t-end 1e-9 --keep xd --column 'v=xd*10+yd' --csv v.csv
says v.csv '^t,x,y,xd,yd,energy,energy_change,v$'
[ "$(sed -n 2p v.csv | rev | cut -d, -f 1 | rev)" = 32 ] || fail "xd*10+yd is not 32: $(sed -n 2p v.csv)"

# Formulas: what stands before what, functions, names.
run 0 "$program" run "$model" --start all.txt --t-end 1e-9 --column 'a=2^3^2-2*3/4-(1-2)-3' --column 'b=-2^2' --column 'c=atan2(1,-1)/pi' \
  --column 'd=table[1][2]+spring[0].rest[1]*q[0]+x' --column 'e=hypot(3,4)*1e-1+max(steps,-3)' --csv c.csv
[ "$(sed -n 2p c.csv | rev | cut -d, -f 1-5 | rev)" = 508.5,-4,0.75,4.25,-1.5 ] || fail "the formulas give $(sed -n 2p c.csv)"

# What was not given is named, whole elements of an array of structs by the first and the last one.
given="--set p.q=2 --set steps=1 --set loaded=1 --set code=1 --set sign=1 --set big=1 --set table[0]=1"
run 0 "$program" run "$model" $given --t-end 1e-9
says scratch/out.txt '^Parameters that were not given, and are zero: spring\[0\] to spring\[1\], '
run 0 "$program" run "$model" $given --set 'spring[0].stiffness=1' --t-end 1e-9
says scratch/out.txt '^Parameters that were not given, and are zero: spring\[0\]\.rest, spring\[1\], '

# A file as some editors write it, with a mark of UTF-8 before the first line.
printf '\xEF\xBB\xBFx = 0.5\r\np.q = 2\r\n' >marked.txt
run 0 "$program" info "$model" --start marked.txt
says scratch/out.txt '^  q +double   = 2$'
