"""Figures by matplotlib, in the look of the program's: the exact solution is a wide grey line under everything, a
method has its family's hue, measured is ink."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    from ._results import LawFit, Run, Spectrum, Sweep

INK, SOFT, AXIS, GRID, LAW = "#171C24", "#4A5361", "#7B8594", "#E4E8ED", "#AA4488"
#: colour, dashes, width of each method's line
LINES: Dict[str, Tuple[str, Any, float]] = {
    "exact": ("#8A93A0", "-", 4.5), "forward-euler": ("#D55E00", "-", 1.3), "euler-cromer": ("#0072B2", "-", 1.3),
    "implicit-euler": ("#009E73", "-", 1.3), "verlet": ("#2E8FBF", "-", 1.3), "yoshida4": ("#2E8FBF", (0, (8, 3)), 1.3),
    "rk4": ("#A06A00", "-", 1.3), "heun": ("#A06A00", (0, (3, 3)), 1.3),
    "dormand-prince": ("#A06A00", (0, (8, 3, 2, 3)), 1.3), "implicit-midpoint": ("#009E73", (0, (8, 3)), 1.3),
    "newmark": ("#009E73", (0, (3, 3)), 1.3), "generalized-alpha": ("#009E73", (0, (8, 3, 2, 3)), 1.3),
    "gauss-legendre4": ("#009E73", (0, (2, 2)), 1.3)}
LOGARITHMIC_FROM = 30  # a grid that spans more than this is drawn on a logarithmic axis


def _styled(ax: Any, across: str, up: str) -> Any:
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        ax.spines[side].set_color(AXIS)
    ax.tick_params(colors=AXIS, labelcolor=SOFT)
    ax.grid(True, color=GRID, linewidth=0.7)
    ax.set_axisbelow(True)
    ax.set_xlabel(across, color=SOFT)
    ax.set_ylabel(up, color=SOFT)
    return ax


def _axes(ax: Any, size: Tuple[float, float] = (7.6, 4.4)) -> Any:
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt
    return plt.subplots(figsize=size, layout="constrained")[1]


def _name(ax: Any, own: bool) -> None:
    """The curves' names, each in its colour: in the right margin of a figure of our own, else inside the axes."""
    lines, labels = ax.get_legend_handles_labels()
    place: Dict[str, Any] = {"loc": "center left", "bbox_to_anchor": (1.01, 0.5)} if own else {"loc": "best"}
    legend = ax.legend(lines, labels, frameon=False, handlelength=1.2, **place)
    for text, line in zip(legend.get_texts(), lines):
        colour = line.get_color()
        text.set_color(colour if colour != LINES["exact"][0] else "#5B6573")
        text.set_fontweight("bold")


def fit(law: "LawFit", ax: Any = None) -> Any:
    quantity = law.to_dict().get("recording", {}).get("observed", "position").replace("_", " ")
    level = law.parameters["equilibrium"] if "equilibrium" in law.parameters else None
    unit = f" ({level.unit})" if level and level.unit not in ("", "1") else ""
    below = None
    if ax is None:
        import matplotlib.pyplot as plt
        figure, (ax, below) = plt.subplots(2, 1, figsize=(7.6, 5.4), sharex=True, layout="constrained",
                                           gridspec_kw={"height_ratios": [3, 1]})
    ax.plot(law.t, law.measured, ".", color=INK, markersize=2.6, label="measured")
    if law.residuals.size:
        ax.plot(law.t, law.measured - law.residuals, color=LAW, linewidth=1.3, label=law.law)
    _styled(ax, "" if below is not None else "time t (s)", quantity + unit)
    _name(ax, below is not None)
    if below is not None:
        below.plot(law.t, law.residuals, ".", color=INK, markersize=2)
        _styled(below, "time t (s)", "residual" + unit)
        return np.array([ax, below])
    return ax


def runs(each_run: Sequence["Run"], of: str, ax: Any = None) -> Any:
    axes = {"position": ("t", "x", "time t (s)", "position x (m)"), "velocity": ("t", "v", "time t (s)", "velocity v (m/s)"),
            "energy": ("t", "energy", "time t (s)", "energy E (J)"), "phase": ("x", "v", "position x (m)", "velocity v (m/s)")}
    if of not in axes:
        raise ValueError(f"of={of!r}: it is one of {', '.join(axes)}")
    across, up, across_name, up_name = axes[of]
    own = ax is None
    ax = _axes(ax, (4.8, 4.4) if of == "phase" else (7.6, 4.4))
    for run in sorted(each_run, key=lambda each: each.method != "exact"):  # the road lies under the others
        colour, dashes, width = LINES.get(run.method, (SOFT, "-", 1.3))
        ax.plot(getattr(run, across), getattr(run, up), color=colour, linestyle=dashes, linewidth=width, label=run.label)
    _styled(ax, across_name, up_name)
    _name(ax, own)
    return ax


def _logarithmic(ax: Any, values: Any) -> None:
    positive = np.asarray(values)
    if positive.size and positive.min() > 0 and positive.max() > LOGARITHMIC_FROM * positive.min():
        ax.set_xscale("log")


def spectrum(found: "Spectrum", of: str, ax: Any = None) -> Any:
    names = {"psa": "pseudo-acceleration PSA (m/s²)", "psv": "pseudo-velocity PSV (m/s)", "sd": "displacement SD (m)"}
    if of not in names:
        raise ValueError(f"of={of!r}: it is one of {', '.join(names)}")
    own = ax is None
    ax = _axes(ax)
    hues = ["#00304D", "#005A8C", "#0072B2", "#2E86BE", "#5596C2"]
    rows = np.atleast_2d(getattr(found, of))
    for i, (ratio, row) in enumerate(zip(found.damping_ratio, rows)):
        colour = hues[min(i, len(hues) - 1)] if len(rows) > 1 else hues[2]
        ax.plot(found.period, row, color=colour, linewidth=1.5, label=f"ζ = {ratio:g}")
    _logarithmic(ax, found.period)
    _styled(ax, "period T (s)", names[of])
    _name(ax, own)
    return ax


def sweep(found: "Sweep", of: str, ax: Any = None) -> Any:
    first = next(iter(found.columns))
    ax = _axes(ax)
    ax.plot(found[first], found[of], color=LINES["euler-cromer"][0], linewidth=1.5)
    _logarithmic(ax, found[first])

    def title(name: str) -> str:
        return name.replace("_", " ") + (f" ({found.units[name]})" if found.units[name] else "")

    return _styled(ax, title(first), title(of))
