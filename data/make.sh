#!/usr/bin/env bash
# make.sh CROMER: makes the sample recordings again beside this script.
set -euo pipefail
cromer=$(realpath "${1:?usage: data/make.sh path/to/cromer}")
cd "$(dirname "${BASH_SOURCE[0]}")"

sensor=(--method rk4 --step "1 ms" --every 10 --sensor-noise "0.3 mm" --sensor-resolution "0.1 mm" --sensor-offset "0.2 m")

"$cromer" simulate --mass "200.8 g" --stiffness "16.6 N/m" --damping "0.002 kg/s" --position "3 cm" --until "20 s" \
  "${sensor[@]}" --seed 1 --quiet --provenance -o recording1.csv
"$cromer" simulate --mass "217.6 g" --stiffness "17.04 N/m" --damping "0.000789 kg/s" --drag "0.02043 kg/m" --position "0.036 m" \
  --until "120 s" "${sensor[@]}" --seed 24 --quiet --provenance -o recording2.csv

# Ground that shakes in two directions: fifty waves from 0.3 to 15 Hz, strongest at 2.5 Hz, under an envelope that rises for 3 s and then dies down.
awk 'BEGIN {
  print "# synthetic: made by data/make.sh"
  print "time (s),east (m/s^2),north (m/s^2)"
  pi = atan2(0, -1)
  for (i = 0; i < 2000; ++i) {
    t = i / 100
    envelope = t / 3 * exp(1 - t / 3)
    east = north = 0
    for (n = 1; n <= 50; ++n) {
      f = 0.3 * exp(log(50) * (n - 0.7 * sin(7 * n)) / 50)
      size = 0.35 / (1 + log(f / 2.5)^2)
      east += size * cos(2 * pi * f * t + 2.1 * n * n)
      north += 0.7 * size * cos(2 * pi * f * t + 3.3 * n * n + 1)
    }
    printf "%.2f,%.4f,%.4f\n", t, envelope * east, envelope * north
  }
}' > ground/shaking.csv

# A drop on a table: half a sine of 50 g and 6 ms, and a little ringing of the table.
awk 'BEGIN {
  print "# synthetic: made by data/make.sh"
  print "time (s),acceleration (g)"
  pi = atan2(0, -1)
  for (i = 0; i <= 600; ++i) {
    t = i / 20000
    a = t < 0.006 ? 50 * sin(pi * t / 0.006) : 0
    printf "%.5f,%.4f\n", t, a + (t > 0.001 ? 3 * exp(-(t - 0.001) / 0.004) * sin(2 * pi * 900 * (t - 0.001)) : 0)
  }
}' > ground/drop.csv
