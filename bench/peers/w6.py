"""W6 in SciPy: the chain of w6.cpp, over whole arrays, with errors below 1e-6. Prints row, who, seconds."""
import numpy
from scipy.integrate import solve_ivp

from stopwatch import median

MASSES, STIFFNESS = 1000, 8
rate = STIFFNESS / (0.5 + 0.001 * (numpy.arange(MASSES) % 7))
padded = numpy.zeros(MASSES + 2)


def law(t, y):
    padded[1:-1] = y[:MASSES]
    return numpy.concatenate([y[MASSES:], rate * (padded[:-2] - 2 * padded[1:-1] + padded[2:])])


start = numpy.zeros(2 * MASSES)
start[MASSES // 2] = 1
times = numpy.arange(101) * 0.1
for name in ("RK45", "DOP853"):
    run = lambda: solve_ivp(law, (0, 10), start, method=name, t_eval=times, rtol=7e-8, atol=7e-9)
    print("chain of 1000, 10 s, errors below 1e-6", "SciPy " + name, median(run, 5), sep="\t")
