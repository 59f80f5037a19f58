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

# The floors of networks/frame.toml in gusts, five minutes of their accelerations: Euler-Cromer in steps of 1 ms.
awk 'function gust() { state = (state * 16807) % 2147483647; return state / 2147483647 }
BEGIN {
  print "# synthetic: made by data/make.sh"
  print "Time (s),Acceleration 1 (m/s^2),Acceleration 2 (m/s^2),Acceleration 3 (m/s^2)"
  state = 19; h = 0.001
  split("2000 2000 1500", m, " "); split("2.4e6 1.8e6 1.2e6", k, " "); split("3000 3000 1000", c, " ")
  for (n = 0; n < 340000; ++n) {
    if (n % 10 == 0) for (i = 1; i <= 3; ++i) push[i] = 400 * (gust() + gust() + gust() + gust() - 2)
    for (i = 1; i <= 3; ++i) link[i] = k[i] * (x[i] - x[i - 1]) + c[i] * (v[i] - v[i - 1])
    for (i = 1; i <= 3; ++i) { a[i] = (push[i] - link[i] + (i < 3 ? link[i + 1] : 0)) / m[i] }
    for (i = 1; i <= 3; ++i) { v[i] += h * a[i]; x[i] += h * v[i] }
    if (n >= 40000 && n % 50 == 0) printf "%.2f,%.4f,%.4f,%.4f\n", (n - 40000) * h, a[1], a[2], a[3]
  }
}' > networks/floors_in_wind.csv
