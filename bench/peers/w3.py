"""W3 in SciPy, and in eqsig, pyrotd and endaq where they are installed: one response spectrum of 1000 periods. w3.py RECORDING.csv; prints row, who, seconds."""
import sys

import numpy
from scipy.linalg import expm
from scipy.signal import lfilter

from stopwatch import median


rows = numpy.loadtxt(sys.argv[1], delimiter=",", skiprows=1)
step, acceleration = rows[1, 0] - rows[0, 0], rows[:, 1].copy()
periods = numpy.logspace(-1, 1, 1000)


def biquad(period, damping_ratio):
    """The exact recurrence for straight lines between samples, as one filter of second order."""
    w = 2 * numpy.pi / period
    system = numpy.zeros((4, 4))
    system[0, 1] = system[2, 3] = system[1, 2] = 1
    system[1, :2] = -w * w, -2 * damping_ratio * w
    e = expm(system * step)
    a, to = e[:2, :2], e[:2, 3] / step
    start = e[:2, 2] - to
    numerator = [to[0], start[0] - a[1, 1] * to[0] + a[0, 1] * to[1], a[0, 1] * start[1] - a[1, 1] * start[0]]
    return numerator, [1, -numpy.trace(a), numpy.linalg.det(a)]


# The coefficients are found beforehand: the filter alone is timed.
filters = [biquad(period, 0.05) for period in periods]


def by_lfilter():
    return [numpy.abs(lfilter(b, a, acceleration)).max() for b, a in filters]


row = "1000 periods, 4000 samples, peaks at the samples"
seconds = median(by_lfilter, 5)
print(row, "SciPy lfilter", seconds, sep="\t")
print("a sample of an oscillator, avx512", "SciPy lfilter", seconds / (len(periods) * len(acceleration)), sep="\t")
try:
    from eqsig import sdof

    print(row, "eqsig", median(lambda: sdof.pseudo_response_spectra(acceleration, step, periods, 0.05), 3), sep="\t")
except ImportError:
    print("eqsig is not installed: skipped", file=sys.stderr)
try:
    import pyrotd

    print(row, "pyrotd", median(lambda: pyrotd.calc_spec_accels(step, acceleration, 1 / periods, 0.05), 1), sep="\t")
except ImportError:
    print("pyrotd is not installed: skipped", file=sys.stderr)
try:
    import pandas
    from endaq.calc.shock import shock_spectrum

    frame = pandas.DataFrame({"a": acceleration}, index=pandas.Index(step * numpy.arange(len(acceleration)), name="time"))
    print(row, "endaq", median(lambda: shock_spectrum(frame, 1 / periods, damp=0.05, mode="srs"), 1), sep="\t")
except ImportError:
    print("endaq is not installed: skipped", file=sys.stderr)
