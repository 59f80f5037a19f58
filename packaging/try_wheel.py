"""What the wheel must do where only NumPy is: a law in three lines, the same as the program's, to the last bit."""

import json
import subprocess
import sys
import time

begin = time.perf_counter()
import cromer  # noqa: E402

seconds = time.perf_counter() - begin
recording = cromer.read("data/recording2.csv")
fit = cromer.fit(recording, mass="217.6 ± 0.3 g", disc_diameter="12 cm")
print(f"try: imported in {1000 * seconds:.0f} ms; {fit.law}: {fit['frequency']}", file=sys.stderr)

program = [sys.executable, "-m", "cromer", "fit", "data/recording2.csv", "--mass", "217.6 ± 0.3 g",
           "--disc-diameter", "12 cm", "--json"]
theirs = json.loads(subprocess.run(program, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout)
for name, one in theirs["parameters"].items():
    assert (fit[name].value, fit[name].standard_error) == (one["value"], one["standard_error"]), name
