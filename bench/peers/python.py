"""The Python package beside the C interface under it, SciPy's curve_fit and lmfit: one process, in turn, processor time.

python.py LIBRARY SHAKING.csv; prints row, who, seconds.
"""
import json
import os
import pathlib
import subprocess
import sys
import time
import warnings

import numpy
import pandas
from stopwatch import medians

PACKAGE = str(pathlib.Path(__file__).resolve().parents[2] / "python")
os.environ["CROMER_LIBRARY"] = os.path.abspath(sys.argv[1])
sys.path.insert(0, PACKAGE)
import cromer  # noqa: E402
from cromer import _core  # noqa: E402


def row(name, works, rounds):
    for who, seconds in zip(works, medians(list(works.values()), rounds, time.process_time)):
        print(name, who, seconds, sep="\t")


def interface(verb, request, **arrays):
    """The same call of the C interface, without anything of Python's."""
    text = json.dumps(request).encode()
    given = (_core._Array * len(arrays))(*[_core._Array(name.encode(), _core._pointer(each), each.size)
                                           for name, each in arrays.items()])
    return lambda: _core._Handle(_core._library.cromer_call(verb.encode(), text, given, len(arrays), _core._Told(), None))


def swing(t, amplitude, decay_rate, frequency, phase, equilibrium):
    return amplitude * numpy.exp(-decay_rate * t) * numpy.cos(frequency * t + phase) + equilibrium


TRUTH = [0.05, 0.025, 6.0, 0.3, 0.2]
NEAR = [0.045, 0.03, 6.005, 0.35, 0.19]
t = numpy.arange(12000) * 0.01
y = swing(t, *TRUTH) + 3e-4 * numpy.random.default_rng(1).standard_normal(t.size)


def fits():
    import lmfit
    from scipy.optimize import curve_fit

    model = lmfit.Model(swing)
    near = dict(zip(["amplitude", "decay_rate", "frequency", "phase", "equilibrium"], NEAR))
    peers = {"SciPy curve_fit, start given": lambda: curve_fit(swing, t, y, p0=NEAR),
             "lmfit, start given": lambda: model.fit(y, model.make_params(**near), t=t)}
    for law, rounds in (("viscous", 41), ("auto", 5)):
        row(f"Python: fit of 12000 samples, law {law}",
            {"cromer": lambda: cromer.fit(t, y, law=law), "C interface": interface("fit", {"law": law}, t=t, y=y),
             **peers}, rounds)


def spectra(file):
    rows = pandas.read_csv(file).to_numpy()
    spacing, acceleration = rows[1, 0] - rows[0, 0], rows[:, 1].copy()
    periods = numpy.logspace(-1, 1, 1000)
    row("Python: 1000 periods, 4000 samples",
        {"cromer": lambda: cromer.spectrum(acceleration, spacing, periods=periods),
         "C interface": interface("spectrum", {"spacing": spacing}, acceleration=acceleration, periods=periods)}, 11)


def imports():
    def seconds(modules):
        code = f"import time; import {modules}; print(time.process_time())"
        return float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True,
                                    cwd=PACKAGE).stdout)
    for who, modules in (("cromer", "cromer"), ("NumPy alone", "numpy"), ("Python alone", "sys")):
        print("Python: import cromer", who, sorted(seconds(modules) for _ in range(7))[3], sep="\t")


with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    fits()
    spectra(sys.argv[2])
imports()
