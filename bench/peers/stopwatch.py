"""The median of a few rounds."""
import statistics
import time


def median(work, rounds=7):
    return medians([work], rounds)[0]


def medians(works, rounds, clock=time.perf_counter):
    """Of several pieces of work in turn, so that a machine that drifts drifts for all of them."""
    times = [[] for _ in works]
    for _ in range(rounds):
        for work, taken in zip(works, times):
            start = clock()
            work()
            taken.append(clock() - start)
    return [statistics.median(taken) for taken in times]
