#!/usr/bin/env bash
# orbit.sh PROGRAM: the orbit satisfies Kepler's equation, t = E - e sin E with r = 1 - e cos E, for both kinetic energies.
. "$(dirname "$0")/expect.sh"
# The phase error, s, of the fifth-order integrator with the default step over one period; a wrong equation of motion gives 1e-2 and more.
tolerance=1e-7
for e in 0 0.3 0.9; do
  for kinetic in full reduced; do
    run 0 "$1" --kinetic $kinetic --states 1 --eccentricity $e --periods 1 --csv orbit.csv
    [ "$(head -1 orbit.csv)" = t,r,u1,u2,u3,phi,energy_error,momentum_error ] || fail "header: $(head -1 orbit.csv)"
    awk -F, -v e=$e -v tolerance=$tolerance 'NR > 1 {
      x = $2 * $3; y = $2 * sqrt($4 * $4 + $5 * $5) * ($4 < 0 ? -1 : 1)  # in the plane of the orbit
      E = atan2(y / sqrt(1 - e * e), x + e); if (E < 0) E += 8 * atan2(1, 1)
      d = E - e * sin(E) - $1
      while (d > 3) d -= 8 * atan2(1, 1)
      while (d < -3) d += 8 * atan2(1, 1)
      if (d < 0) d = -d
      if (d > worst) worst = d
      if (!(d <= tolerance)) bad = 1
    } END { printf "e=%s: %d rows, largest phase error %.1e s\n", e, NR - 1, worst; exit bad || NR < 100 }' orbit.csv ||
      fail "$kinetic, e=$e"
  done
done
