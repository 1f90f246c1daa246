#!/usr/bin/env bash
# watch.sh PROGRAM MODELS PYTHON: the moving picture of a pendulum shows rods of their length in every frame, and moves as the motion does.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 models=$2 python=$3
cat >three.txt <<'EOF'
n = 3
g = 9.81
mass = 1
length = 1 0.5 0.25
q = 75 deg, 0, -1
line = 0, 0; k<n: x + length[k]*sin(q[k]), y - length[k]*cos(q[k])
EOF
run 0 "$program" watch "$models/pendulum.so" --start three.txt --t-end 2 --rate 20
says scratch/out.txt '^41 frames in pendulum.svg: open it in a browser'
run 0 "$program" run "$models/pendulum.so" --start three.txt --t-end 2 --every 0.05 --csv rows.csv
"$python" - <<'EOF' || fail "the picture is not that of the motion"
import csv, math
import xml.etree.ElementTree as tree

svg = "{http://www.w3.org/2000/svg}"
picture = tree.parse("pendulum.svg").getroot() # well formed
line = next(e for e in picture.iter(svg + "polyline") if e.get("class") == "line")
frames = [[tuple(map(float, p.split(","))) for p in f.split()] for f in line.find(svg + "animate").get("values").split(";")]
assert line.find(svg + "animate").get("dur") == "2.000s"
rows = [[float(x) for x in row] for row in list(csv.reader(open("rows.csv")))[1:]]
assert len(frames) == len(rows) == 41
scale = math.dist(*frames[0][:2]) # pixels per metre, by the first rod
for frame, row in zip(frames, rows):
    for k, length in enumerate([1, 0.5, 0.25]):
        (x0, y0), (x1, y1) = frame[k : k + 2]
        assert abs(x1 - x0 - scale * length * math.sin(row[1 + k])) < 0.3 and abs(y1 - y0 - scale * length * math.cos(row[1 + k])) < 0.3
width, height = float(picture.get("width")), float(picture.get("height"))
assert all(0 < x < width and 0 < y < height for frame in frames for x, y in frame)
EOF
run 0 "$program" watch "$models/pendulum.so" --start three.txt --t-end 2 --rate 20 --svg again.svg --gif p.gif
cmp pendulum.svg again.svg || fail "the same picture has other bytes"
"$python" - <<'EOF' || fail "p.gif is no GIF of 41 frames"
data = open("p.gif", "rb").read()
assert data[:6] == b"GIF89a" and data.count(b"\x21\xf9\x04") == 41 # graphic control extensions
EOF
run 0 "$program" watch "$models/kepler.so" --q 1,0 --qd 0,1 --t-end 1 --svg k.svg
says scratch/err.txt 'no line says what to draw .*: q\[1\] over q\[0\] is drawn'

# A line that ends on the way.
run 1 "$program" watch "$models/kepler.so" --q 1,0 --qd 0,1 --t-end 3 --line '0,0; q[0],q[1]' --line '0,0; log(1-t),0' --svg none.svg
says scratch/err.txt '^eom: point 2 of line 2 \(both counted from 1\) is not a number at t = 1'
[ -e none.svg ] && fail "a picture that has no end"
exit 0
