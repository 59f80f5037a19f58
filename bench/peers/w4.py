"""W4 in SciPy and lmfit: the same samples, five parameters, covariance. w4.py SHORT.csv LONG.csv; prints row, who, seconds."""
import sys

import lmfit
import numpy
import pandas
from scipy.optimize import curve_fit

from stopwatch import median


def swing(t, frequency, decay_rate, equilibrium, cosine, sine):
    return equilibrium + numpy.exp(-decay_rate * t) * (cosine * numpy.cos(frequency * t) + sine * numpy.sin(frequency * t))


def first_guess(t):
    """As near as our own start values: within a tenth of a cycle at the end."""
    decay_rate = 3 / t[-1]
    return [6 * (1 + 0.05 / (t[-1] * 6)), 1.1 * decay_rate, 0.2, 0.047, -0.014]


def fit_lmfit(t, y):
    model = lmfit.Model(swing)
    names = ["frequency", "decay_rate", "equilibrium", "cosine", "sine"]
    return model.fit(y, model.make_params(**dict(zip(names, first_guess(t)))), t=t)


short = pandas.read_csv(sys.argv[1]).to_numpy()
t, y = short[:, 0].copy(), short[:, 1].copy()
row = "fit of 12000 samples, start values given"
print(row, "SciPy curve_fit", median(lambda: curve_fit(swing, t, y, p0=first_guess(t)), 21), sep="\t")
print(row, "lmfit", median(lambda: fit_lmfit(t, y), 21), sep="\t")


def from_file():
    rows = pandas.read_csv(sys.argv[2]).to_numpy()
    t, y = rows[:, 0].copy(), rows[:, 1].copy()
    return curve_fit(swing, t, y, p0=first_guess(t))


print("5 million samples, file to law", "pandas + curve_fit, start given", median(from_file, 1), sep="\t")
