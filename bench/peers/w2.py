"""W2 in NumPy: Euler-Cromer across many driven Duffing oscillators at once, in blocks that stay in the cache."""
import numpy

from stopwatch import median

OSCILLATORS, STEPS, H = 1024, 2000, 0.02


def run():
    n = OSCILLATORS
    w = 0.5 + 1.0 * numpy.arange(n) / n
    x, v = numpy.ones(n), numpy.zeros(n)
    peak = numpy.ones(n)
    # The drive by a rotation: a cosine each would take most of the time.
    c, s = numpy.ones(n), numpy.zeros(n)
    turn_c, turn_s = numpy.cos(w * H), numpy.sin(w * H)
    for _ in range(STEPS):
        v += H * (0.2 * c - 0.1 * v - x - 0.3 * x * x * x)
        x += H * v
        numpy.maximum(peak, numpy.abs(x), out=peak)
        c, s = c * turn_c - s * turn_s, s * turn_c + c * turn_s
    return x


print("euler-cromer", "NumPy", median(run, 5) / (OSCILLATORS * STEPS), sep="\t")
