#!/usr/bin/env bash
# make.sh CROMER: makes both sample recordings again beside this script.
set -euo pipefail
cromer=$(realpath "${1:?usage: data/make.sh path/to/cromer}")
cd "$(dirname "${BASH_SOURCE[0]}")"

sensor=(--method rk4 --step "1 ms" --every 10 --sensor-noise "0.3 mm" --sensor-resolution "0.1 mm" --sensor-offset "0.2 m")

"$cromer" simulate --mass "200.8 g" --stiffness "16.6 N/m" --damping "0.002 kg/s" --position "3 cm" --until "20 s" \
  "${sensor[@]}" --seed 1 --quiet -o recording1.csv
"$cromer" simulate --mass "217.6 g" --stiffness "17.04 N/m" --damping "0.000789 kg/s" --drag "0.02043 kg/m" --position "0.036 m" \
  --until "120 s" "${sensor[@]}" --seed 24 --quiet -o recording2.csv
