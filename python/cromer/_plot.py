"""Figures by matplotlib, in the look of the program's: the exact solution is a wide grey line under everything, a
method has its family's hue, measured is ink."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple, TypeVar

import numpy as np

from ._core import InputError

if TYPE_CHECKING:
    from ._core import Numbers
    from ._networks import NetworkRun
    from ._results import Comparison, LawFit, Run, Spectrum, Sweep

INK, SOFT, AXIS, GRID, LAW, BAND = "#171C24", "#4A5361", "#7B8594", "#E4E8ED", "#AA4488", "#C9CCD1"
#: colour, dashes, width of each method's line
LINES: Dict[str, Tuple[str, Any, float]] = {
    "exact": ("#8A93A0", "-", 4.5), "forward-euler": ("#D55E00", "-", 1.3), "euler-cromer": ("#0072B2", "-", 1.3),
    "implicit-euler": ("#009E73", "-", 1.3), "verlet": ("#2E8FBF", (0, (11, 4)), 1.3), "yoshida4": ("#2E8FBF", (0, (8, 3)), 1.3),
    "rk4": ("#A06A00", (0, (11, 4)), 1.3), "heun": ("#A06A00", (0, (3, 3)), 1.3),
    "dormand-prince": ("#A06A00", (0, (8, 3, 2, 3)), 1.3), "implicit-midpoint": ("#009E73", (0, (8, 3)), 1.3),
    "newmark": ("#009E73", (0, (3, 3)), 1.3), "generalized-alpha": ("#009E73", (0, (8, 3, 2, 3)), 1.3),
    "gauss-legendre4": ("#009E73", (0, (2, 2)), 1.3)}
#: of lines of one family
SHADES = ["#00304D", "#005A8C", "#0072B2", "#2E86BE", "#5596C2"]
MANY_LINES = 12  # more than these have no names
DASHES = (0, (6, 4))  # of one constant decay rate
LOGARITHMIC_FROM = 30  # a grid that spans more than this is drawn on a logarithmic axis
MANY_SWINGS = 30  # more than these are drawn as their envelope
SMOOTH = 40  # points in a period
FEW_SWINGS = 5  # are drawn beside it


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
    """The curves' names, each in its colour: in the right margin of a figure of our own, else above the axes."""
    lines, labels = ax.get_legend_handles_labels()
    place: Dict[str, Any] = {"loc": "center left", "bbox_to_anchor": (1.01, 0.5)} if own else \
        {"loc": "lower left", "bbox_to_anchor": (0, 1), "borderaxespad": 0, "ncol": 3}
    legend = ax.legend(lines, labels, frameon=False, handlelength=1.2, **place)
    for text, line in zip(legend.get_texts(), lines):
        colour = line.get_color() if hasattr(line, "get_color") else INK
        text.set_color(colour if colour != LINES["exact"][0] else "#5B6573")
        text.set_fontweight("bold")


def _envelope(t: "Numbers", y: "Numbers", swings: float) -> "Tuple[Numbers, Numbers, Numbers]":
    """Times, least and largest values, of pieces of one and a half swings or more; NaN between them in a gap of that length."""
    piece = float(np.ptp(t)) * max(1.5 / swings, 1 / 240)
    gaps = np.flatnonzero(np.diff(t) > piece) + 1
    found = []
    for u, z in zip(np.split(t, gaps), np.split(y, gaps)):
        starts = np.unique(np.linspace(0, u.size, int(max(2.0, float(np.ptp(u)) / piece)), endpoint=False).astype(int))
        middle = (u[starts] + u[np.append(starts[1:], u.size) - 1]) / 2
        middle[0], middle[-1] = u[0], u[-1]
        found += [[middle, np.minimum.reduceat(z, starts), np.maximum.reduceat(z, starts)], [[np.nan]] * 3]
    times, low, high = (np.concatenate(each) for each in zip(*found[:-1]))
    return times, low, high


def _measured(ax: Any, t: "Numbers", y: "Numbers", swings: float) -> None:
    if swings > MANY_SWINGS:
        ax.fill_between(*_envelope(t, y, swings), color=BAND, linewidth=0, label="measured")
    else:
        ax.plot(t, y, ".", color=INK, markersize=1.8, label="measured")


def _curve(ax: Any, t: "Numbers", y: "Numbers", swings: float, **look: Any) -> None:
    if swings > MANY_SWINGS and t.size:
        t, low, high = _envelope(t, y, swings)
        ax.plot(t, low, **{**look, "label": "_"})
        ax.plot(t, high, **look)
    else:
        ax.plot(t, y, **look)


def _looks(methods: Sequence[str]) -> List[Dict[str, Any]]:
    """Of curves drawn in this order: what lies below is wider, so that curves that coincide are all seen.
    One alone is solid."""
    looks = []
    for i, method in enumerate(methods):
        colour, dashes, width = LINES.get(method, (SOFT, "-", 1.3))
        below = 0 if method == "exact" else min(1.8, 4 / len(methods)) * len(set(methods[i:]) - {method})
        looks.append({"color": colour, "linestyle": dashes if len(methods) > 1 else "-", "linewidth": width + below})
    return looks


def _swings(law: "LawFit") -> float:
    return float(law["frequency"].value * (law.t[-1] - law.t[0])) if "frequency" in law and law.t.size else 0


def _law(law: "LawFit") -> "Tuple[Numbers, Numbers]":
    """The law as it is drawn: at the samples, and where these are few in a period, between them as well."""
    observed = (law.recording.get("observed") or "position").replace(" ", "_")
    states = {"position": "x", "angle": "x", "velocity": "v", "angular_velocity": "v"}
    points = int(SMOOTH * _swings(law))
    if not law.residuals.size or law.t.size > points or observed not in states or law.simulate is None:
        return law.t[:law.residuals.size], law.measured[:law.residuals.size] - law.residuals
    t = np.unique(np.append(np.linspace(law.t[0], law.t[-1], points), law.t))
    level = law["equilibrium"].value if "equilibrium" in law else 0
    return t, getattr(law.at(t), states[observed]) + level


def fit(law: "LawFit", ax: Any = None) -> Any:
    quantity = (law.recording.get("observed") or law.recording.get("column") or "position").replace("_", " ")
    unit = f" ({law._unit.strip()})" if law._unit else ""
    swings = _swings(law)
    end = law.t[0] + FEW_SWINGS * np.ptp(law.t) / swings if swings > MANY_SWINGS else None
    own = ax is None
    axes = [ax]
    if own:
        import matplotlib.pyplot as plt
        heights = [3, 1] if end is None else [3, 2, 1]
        axes = list(plt.subplots(len(heights), 1, figsize=(7.6, 1.8 * len(heights) + 1.8), layout="constrained",
                                 gridspec_kw={"height_ratios": heights})[1])
    look = {"color": LAW, "linewidth": 1.3, "label": law.law}
    t, fitted = _law(law)
    for i, each in enumerate(axes[:-1] if own else axes):
        until = end if i == 1 and end is not None else np.inf
        # axes that were given may be zoomed into, so they have every swing
        dense = swings if own and i == 0 else 0
        if fitted.size:
            _curve(each, t[t <= until], fitted[t <= until], dense, zorder=2.5 if dense else 1.5, **look)
        _measured(each, law.t[law.t <= until], law.measured[law.t <= until], dense)
        _styled(each, "", quantity + unit)
        _name(each, own)
    if own:
        axes[-1].plot(law.t, law.residuals, ".", color=INK, markersize=1.5)
        _styled(axes[-1], "", "residual" + unit)
        axes[-1].sharex(axes[0])
    axes[-1].set_xlabel("time t (s)", color=SOFT)
    return np.array(axes) if own else ax


T = TypeVar("T")


def _chosen(of: str, among: Dict[str, T]) -> T:
    if of not in among:
        raise InputError(f"of must be one of {', '.join(among)}, not {of!r}", "of", "word_not_known", {"word": of})
    return among[of]


def runs(each_run: Sequence["Run"], of: str, ax: Any = None) -> Any:
    axes = {"position": ("t", "x", "time t (s)", "position x (m)"), "velocity": ("t", "v", "time t (s)", "velocity v (m/s)"),
            "energy": ("t", "energy", "time t (s)", "energy E (J)"), "phase": ("x", "v", "position x (m)", "velocity v (m/s)")}
    across, up, across_name, up_name = _chosen(of, axes)
    own = ax is None
    ax = _axes(ax, (4.8, 4.4) if of == "phase" else (7.6, 4.4))
    drawn = sorted(each_run, key=lambda each: each.method != "exact")  # the road lies under the others
    for run, look in zip(drawn, _looks([each.method for each in drawn])):
        ax.plot(getattr(run, across), getattr(run, up), label=run.label, **look)
    _styled(ax, across_name, up_name)
    _name(ax, own)
    return ax


OF_NETWORKS = {"position": ("x", "position x (m or rad)"), "velocity": ("v", "velocity v (m/s or rad/s)"),
               "energy": ("energy", "energy E (J)")}


def network_runs(runs: "List[NetworkRun]", of: str, mass: Optional[str], ax: Any = None) -> Any:
    up, name = _chosen(of, OF_NETWORKS)
    own = ax is None
    ax = _axes(ax)
    mass = runs[0].names[0] if mass is None else mass
    for run, look in zip(runs, _looks([each.method for each in runs])):
        ax.plot(run.t, run.energy if up == "energy" else getattr(run[mass], up), label=run.label, **look)
    _styled(ax, "time t (s)", name if up == "energy" else f"{mass}: {name}")
    _name(ax, own)
    return ax


def network(run: "NetworkRun", of: str, ax: Any = None) -> Any:
    up, name = _chosen(of, OF_NETWORKS)
    own = ax is None
    ax = _axes(ax)
    rows = np.atleast_2d(getattr(run, up))
    for i, row in enumerate(rows):
        label = "all masses" if up == "energy" else run.names[i]
        ax.plot(run.t, row, color=SHADES[min(i, len(SHADES) - 1)], linewidth=1.3,
                label=label if len(rows) <= MANY_LINES else "_")
    _styled(ax, "time t (s)", name)
    if len(rows) <= MANY_LINES:
        _name(ax, own)
    return ax


def compared(found: "Comparison", of: str, ax: Any = None) -> Any:
    names = {"position": "displacement x", "residual": "measured less simulated", "phase_error": "phase error (rad)"}
    name = _chosen(of, names)
    own = ax is None
    ax = _axes(ax)
    law = found.fit
    swings = _swings(law) if own and of != "phase_error" else 0
    if of == "position":
        _measured(ax, law.t, law.residuals + law.x, swings)
    for curve, look in zip(found.curves, _looks([each.method for each in found.curves])):
        if curve.label != curve.law:  # one constant decay rate
            look["linestyle"] = DASHES
        _curve(ax, curve.t, curve.x if of == "position" else getattr(curve, of), swings,
               label=curve.label.replace(" by ", "\nby "), **look)
    _styled(ax, "time t (s)", name + ("" if of == "phase_error" else f" ({law._unit.strip()})" if law._unit else ""))
    _name(ax, own)
    return ax


def _logarithmic(ax: Any, values: Any) -> None:
    positive = np.asarray(values)
    if positive.size and positive.min() > 0 and positive.max() > LOGARITHMIC_FROM * positive.min():
        ax.set_xscale("log")


def spectrum(found: "Spectrum", of: Optional[str], ax: Any = None) -> Any:
    from ._results import SHOCK
    names = {"psa": "pseudo-acceleration PSA (m/s²)", "psv": "pseudo-velocity PSV (m/s)", "sd": "displacement SD (m)",
             **{each: f"acceleration, {each} (m/s²)" for each in SHOCK}}
    names = {each: name for each, name in names.items() if getattr(found, each).size}
    of = of or next(iter(names), "")
    name = _chosen(of, names)
    own = ax is None
    ax = _axes(ax)
    rows = np.atleast_2d(getattr(found, of))
    for i, (label, row) in enumerate(zip(found._damping(), rows)):
        colour = SHADES[min(i, len(SHADES) - 1)] if len(rows) > 1 else SHADES[2]
        ax.plot(found.period, row, color=colour, linewidth=1.5, label=label)
    _logarithmic(ax, found.period)
    _styled(ax, "period T (s)", name)
    _name(ax, own)
    return ax


def sweep(found: "Sweep", of: Optional[str], ax: Any = None) -> Any:
    of = of or next(name for name in found.columns if name not in found.swept)
    grids = [name for name in found.swept if name != "direction" and np.unique(found[name]).size > 1] or found.swept
    across = grids[-1]
    others = [name for name in found.swept if name != across]
    of_line = np.column_stack([np.zeros(len(found.statuses)), *(found[name] for name in others)])
    own = ax is None
    ax = _axes(ax)

    def title(name: str) -> str:
        return name.replace("_", " ") + (f" ({found.units[name]})" if found.units[name] else "")

    def value(name: str, each: float) -> str:
        return ("up" if each > 0 else "down") if name == "direction" else f"{name.replace('_', ' ')} = {each:g} {found.units[name]}"

    lines, place = np.unique(of_line, axis=0, return_inverse=True)
    lines, place = lines[::-1], len(lines) - 1 - place.ravel()  # upwards before downwards
    for i, each in enumerate(lines):
        names = [value(name, number) for name, number in zip(others, each[1:])]
        points = np.flatnonzero(place == i)
        points = points[np.argsort(found[across][points], kind="stable")]
        ax.plot(found[across][points], found[of][points], color=SHADES[i % len(SHADES)] if len(lines) > 1 else SHADES[2],
                linewidth=1.5, label=", ".join(names).strip())
    _logarithmic(ax, found[across])
    _styled(ax, title(across), title(of))
    if 1 < len(lines) <= MANY_LINES:
        _name(ax, own)
    return ax
