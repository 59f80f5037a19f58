"""W1 in SciPy: DOP853 to odeint's accuracy at 8000 points, and numpy.savetxt for the rows. Prints row, who, seconds."""
import io

import numpy
from scipy.integrate import solve_ivp

from stopwatch import median


def law(t, y):
    return [y[1], numpy.cos(3 * t) - 9 * y[0] - 0.2 * y[1]]


times = numpy.arange(8001) * 0.01
run = lambda: solve_ivp(law, (0, 80), [0.0, 0.0], method="DOP853", t_eval=times, rtol=1e-9, atol=1e-12)
y = run().y
rows = numpy.column_stack([times, y[0], y[1]])
print("linear, rk4", "SciPy DOP853", median(run), sep="\t")
print("writing 8000 rows x 3", "numpy.savetxt", median(lambda: numpy.savetxt(io.StringIO(), rows, delimiter=",", fmt="%.17g")), sep="\t")
