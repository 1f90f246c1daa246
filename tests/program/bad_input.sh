#!/usr/bin/env bash
# bad_input.sh PROGRAM MODELS OLD OLDER SCRIPT TABLE: what makes no sense is refused by messages that say where and why, as tests/examples/bad_input.sh
# (SCRIPT) says. MODELS: a folder with pendulum.so; OLD, OLDER: shared objects of other versions.
set -eu
eom=$1 models=$2 old=$3 older=$4 script=$5 table=$6
double="$models/pendulum.so --set n=2 --set g=9.81 --set mass=1 --set length=1"
cases=$(mktemp -d)
trap 'rm -rf "$cases"' EXIT
# The script makes its folder itself; files that a case reads are made by the first one.
export models old older double
cat >"$cases/eom" <<'EOF'
#!/usr/bin/env bash
printf 'g = 9.81 # m/s^2\n\ngravitas = 1\n' >scratch/typo.txt
printf '# two lengths\nlength\n' >scratch/line.txt
printf 'q[1] = 7 5\n' >scratch/value.txt
[ -e scratch/endless.txt ] || head -c 17000000 /dev/zero | tr "\0" 1 >scratch/endless.txt
head -c 9000 "$models"/pendulum.so >scratch/cut.so
exec "$eom" "$@"
EOF
chmod +x "$cases/eom"
export eom
bash "$script" "$cases/eom" "$table"
