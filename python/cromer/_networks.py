"""Networks of masses, and channels that were recorded together: what they may be, and what simulate and fit give back."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np

from ._arguments import in_unit, plain
from ._core import Answer, InputError, Numbers
from ._estimate import Estimate
from ._results import Notice, Result, Several, Trajectory, _estimate, _frame, _number, _unknown

#: A network's file, or what it holds: {"mass": [{"name": "left", "mass": 2}, ...], "link": [{"to": "left", "stiffness": 8}, ...]}
Network = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def request_of_network(network: Network) -> Any:
    """The network as a request has it."""
    if isinstance(network, (str, os.PathLike)):
        return os.fsdecode(network)
    if not isinstance(network, Mapping):
        raise InputError('network must be the path of a file, or a mapping like it: {"mass": [...], "link": [...]}, not '
                         f"{type(network).__name__}", "network", "network_is_object")
    return {key: [{name: plain(name, value) for name, value in dict(each).items() if value is not None} for each in tables]
            for key, tables in network.items()}


def arrays_of_channels(t: Any, channels: Any, unit: str) -> Dict[str, Any]:
    """The arrays of a call: t and each channel, by its name or number. `unit` is that of quantities of pint."""
    if hasattr(channels, "columns"):  # a DataFrame
        channels = {str(name): channels[name] for name in channels.columns}
    if not isinstance(channels, Mapping):
        if isinstance(channels, np.ndarray) and channels.ndim == 2 and channels.shape[1] != np.size(t) == channels.shape[0]:
            channels = channels.T  # a row for each time
        channels = {f"channel {i + 1}": each for i, each in enumerate(channels)}
    if "t" in channels:
        raise InputError('no channel can be called "t": that is the time', "channels", "array_given_twice")
    return {"t": in_unit("t", t, "s"), **{name: in_unit(name, each, unit) for name, each in channels.items()}}


class NetworkRun(Result):
    """The run of a network of masses: `names`, `t` [s], and for each mass a row of `x` and of `v`; `energy` [J] of all masses
    and links. One mass by its name: run["left"].x. Further `method`, `step` [s] and `status` ("reached_end" where it
    succeeded); `to_dict()` has the rest."""

    def __init__(self, answer: Answer, number: int = 1, document: Optional[Dict[str, Any]] = None) -> None:
        super().__init__(answer, document)
        self._of_run = f"{number}."
        self.method: str = self._document["method"]
        self.status: str = self._document["status"].replace("stopped_by_event", "interrupted")  # networks have no events
        self.step = _number(self._document.get("step"))

    @property
    def label(self) -> str:
        """What tells it from other runs: its method."""
        return self.method

    @property
    def names(self) -> List[str]:
        """Of the masses."""
        return [each["name"] for each in self._document["masses"]]

    @property
    def t(self) -> Numbers:
        """Times [s]."""
        return self._answer.arrays[self._of_run + "t"]

    @property
    def x(self) -> Numbers:
        """Positions [m], of angles [rad], of shape (masses, times)."""
        return _rows(self._answer, self.names, "x", self._of_run)

    @property
    def v(self) -> Numbers:
        """Velocities [m/s], of angles [rad/s], of shape (masses, times)."""
        return _rows(self._answer, self.names, "v", self._of_run)

    @property
    def energy(self) -> Numbers:
        """Kinetic and potential energy of all masses and links [J]."""
        return self._answer.arrays[self._of_run + "energy"]

    def __getitem__(self, name: str) -> Trajectory:
        if name not in self.names:
            raise KeyError(_unknown(name, self.names, "this network"))
        arrays = self._answer.arrays
        return Trajectory(self.t, arrays[f"{self._of_run}{name}.x"], arrays[f"{self._of_run}{name}.v"])

    def to_pandas(self) -> Any:
        """The states: t as the index, x and v of each mass, energy."""
        columns = {f"{name} {of}": self._answer.arrays[f"{self._of_run}{name}.{of}"] for name in self.names for of in ("x", "v")}
        return _frame({"t": self.t, **columns, "energy": self.energy}, "t")

    def plot(self, of: str = "position", ax: Any = None) -> Any:
        """`of`: "position", "velocity" or "energy". Returns the axes."""
        from . import _plot
        return _plot.network(self, of, ax)

    def __repr__(self) -> str:
        return f"NetworkRun: {', '.join(self.names)} by {self.method}, {self.status}, {self.t.size} states"


class NetworkRuns(Several[NetworkRun]):
    """Several runs of the same network: by number, or by the name of the method."""

    def __init__(self, answer: Answer) -> None:
        document = json.loads(answer.text)
        each = document.get("runs", [document])
        super().__init__(answer, [NetworkRun(answer, i + 1, run) for i, run in enumerate(each)])

    @property
    def notices(self) -> List[Notice]:
        """What there is to know about each run."""
        return [notice for run in self for notice in run.notices]

    def plot(self, of: str = "position", mass: Optional[str] = None, ax: Any = None) -> Any:
        """One mass (the first, or that of this name) by all methods; `of` as of NetworkRun.plot. Returns the axes."""
        from . import _plot
        return _plot.network_runs(list(self), of, mass, ax)


@dataclass(frozen=True)
class FittedLink:
    """What was found of a link: `parameters` by their names; `start` and `end` are masses or "ground"."""

    start: str
    end: str
    parameters: Dict[str, Estimate]


class NetworkFit(Result):
    """The links of a recorded network: `links` (a `FittedLink` each), one of them as fit["left", "right"]; of each
    mass, by its name, `masses` ("position" [m, or rad of an angle] and "velocity" [m/s, rad/s] at the first sample,
    "equilibrium" [m, rad], what its column reads at rest, "rms" [m, rad] of the residuals, "r_squared"). `status` is
    "converged" where it succeeded, `message` says why it did not. Per sample `t` [s], and for each mass a row of
    `measured` and of `residuals`."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self.status: str = self._document["status"]
        self.message: str = self._document.get("message") or ""
        self.links = [FittedLink(each["from"], each["to"],
                                 {name: _estimate(name, value) for name, value in each["parameters"].items()})
                      for each in self._document["links"]]
        self.masses: Dict[str, Dict[str, Any]] = {
            each["name"]: {name: _estimate(name, value) if isinstance(value, dict) else value for name, value in each.items()}
            for each in self._document["masses"]}

    @property
    def succeeded(self) -> bool:
        """Whether the fit converged."""
        return self.status == "converged"

    @property
    def t(self) -> Numbers:
        """Times used [s]."""
        return self._answer.arrays["1.t"]

    @property
    def measured(self) -> Numbers:
        """The record [m], of angles [rad], of shape (masses, times)."""
        return _rows(self._answer, list(self.masses), "measured")

    @property
    def residuals(self) -> Numbers:
        """Measured less fitted [m], of angles [rad], of shape (masses, times)."""
        return _rows(self._answer, list(self.masses), "residual")

    def __getitem__(self, ends: Tuple[str, str]) -> FittedLink:
        for link in self.links:
            if ends in ((link.start, link.end), (link.end, link.start)):
                return link
        raise KeyError(_unknown(ends, [f"{link.start}–{link.end}" for link in self.links], "this network"))

    def __repr__(self) -> str:
        lines = [f"NetworkFit: {self.status}" + (f": {self.message}" if self.message else "")]
        lines += [f"  {link.start}–{link.end}: {name} = {value}" for link in self.links for name, value in link.parameters.items()]
        return "\n".join(lines)


def _rows(answer: Answer, names: List[str], of: str, of_run: str = "1.") -> Numbers:
    rows = np.array([answer.arrays[f"{of_run}{name}.{of}"] for name in names])
    rows.flags.writeable = False
    return rows
