"""What the verbs give back."""

from __future__ import annotations

import difflib
import html
import json
import shlex
import warnings
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Protocol, Sequence, Tuple, TypeVar, Union, overload

import numpy as np

from ._arguments import arrays_of
from ._core import NO_SUCCESS, Answer, InputError, Numbers, _numbers
from ._estimate import Estimate, with_error


class CromerWarning(UserWarning):
    """What there is to know about a result. `code` is the same in every language, `values` is what the text holds."""

    def __init__(self, text: str, code: str = "", values: Optional[Mapping[str, Any]] = None) -> None:
        super().__init__(text)
        self.code, self.values = code, dict(values or {})


class FitWarning(CromerWarning):
    """A computation that did not succeed: what exists was given back."""


class NoSuccess(RuntimeError):
    """With strict=True, in place of FitWarning. `result` is what exists."""

    def __init__(self, text: str, result: Any = None) -> None:
        super().__init__(text)
        self.result = result


@dataclass(frozen=True)
class Notice:
    """One thing to know about a result; `severity` is "wrong_if_ignored", "worth_knowing" or "detail"."""

    code: str
    severity: str
    text: str
    values: Dict[str, Any]


def _number(value: Any) -> float:
    return float("nan") if value is None else float(value)


def _estimate(name: str, each: Mapping[str, Any]) -> Estimate:
    low, high = each.get("confidence_95") or (None, None)
    return Estimate(name, _number(each["value"]), _number(each["standard_error"]), (_number(low), _number(high)),
                    each.get("unit", ""))


class Result:
    """What all results have."""

    def __init__(self, answer: Answer, document: Optional[Dict[str, Any]] = None) -> None:
        self._answer = answer
        self._document: Dict[str, Any] = json.loads(answer.text) if document is None else document

    @property
    def notices(self) -> List[Notice]:
        """What there is to know about the result."""
        return [Notice(each["code"], each["severity"], each["text"], each["values"])
                for each in self._document.get("notices", [])]

    def to_dict(self) -> Dict[str, Any]:
        """The document of the program's --json, without what the arrays hold (docs/results.md)."""
        return json.loads(json.dumps(self._document))  # type: ignore[no-any-return]

    def to_json(self) -> str:
        """What `to_dict` gives, as JSON."""
        return json.dumps(self._document, indent=2, ensure_ascii=False)

    def to_csv(self) -> str:
        """The table that the program writes; InputError of methods, which have none."""
        return self._answer.written_as("csv")

    def to_svg(self) -> str:
        """The figure that the program draws; InputError of methods and recordings, which have none."""
        return self._answer.written_as("svg")

    def __str__(self) -> str:
        return self._answer.written_as("text").rstrip("\n")


def told(result: Result, answer: Answer, strict: bool, message: str = "") -> None:
    """Warns of what there is to know; raises NoSuccess if the result has to succeed and did not."""
    for notice in result.notices:
        if notice.severity != "detail":
            warnings.warn(CromerWarning(notice.text, notice.code, notice.values), stacklevel=3)
    if answer.status == NO_SUCCESS:
        text = message or "the computation did not succeed: see its status"
        if strict:
            raise NoSuccess(text, result)
        warnings.warn(FitWarning(text, getattr(result, "status", "")), stacklevel=3)


def _unknown(name: object, known: Sequence[str], what: str) -> str:
    near = difflib.get_close_matches(str(name), known, 1)
    return f"{name!r}: {what} has {', '.join(known) or 'none'}" + (f"; did you mean {near[0]!r}?" if near else "")


def _frame(columns: Mapping[str, Any], index: Optional[str] = None) -> Any:
    import pandas
    frame = pandas.DataFrame({name: np.array(values) for name, values in columns.items()})
    return frame.set_index(index) if index else frame


def _table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table as notebooks show it."""
    cells = "".join(f"<th style='text-align:left'>{html.escape(each)}</th>" for each in head)
    body = "".join("<tr>" + "".join(f"<td style='text-align:left'>{html.escape(each)}</td>" for each in row) + "</tr>"
                   for row in rows)
    return f"<p><b>{html.escape(title)}</b></p><table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table>"


@dataclass(frozen=True)
class Trajectory:
    """States against time: t [s], x [m] and v [m/s], or [rad] and [rad/s] of an angle; arrays of equal length."""

    t: Numbers
    x: Numbers
    v: Numbers

    def to_pandas(self) -> Any:
        """The states: t as the index, x and v."""
        return _frame({"t": self.t, "x": self.x, "v": self.v}, "t")


@dataclass(frozen=True)
class Residual:
    """What a fit leaves: rms [unit of the record], p of the normality test, autocorrelation from sample to sample,
    and whether it is compatible with white noise."""

    rms: float
    normality: float
    autocorrelation: float
    white: bool


class _Motion(Result):
    """A result with the states of one run."""

    @property
    def _run_number(self) -> int:
        raise NotImplementedError

    def _array(self, name: str) -> Numbers:
        return self._answer.arrays.get(f"{self._run_number}.{name}", np.empty(0))

    @property
    def t(self) -> Numbers:
        """Times [s]."""
        return self._array("t")

    @property
    def x(self) -> Numbers:
        """Displacement from the equilibrium [m], of an angle [rad]."""
        return self._array("x")

    @property
    def v(self) -> Numbers:
        """Velocity [m/s], of an angle [rad/s]."""
        return self._array("v")


#: what has a name of its own among the quantities
_ALSO = {"spring_constant": "stiffness", "viscous_decay_rate": "decay_rate"}
#: a quantity, the parameter that it follows from, and the arguments of fit that it needs
_FROM = {"stiffness": ("angular_frequency", "mass="), "damping": ("decay_rate", "mass="), "drag_constant": ("drag", "mass="),
         "friction_force": ("friction", "mass="), "cubic_stiffness": ("cubic", "mass="),
         "drag_coefficient": ("drag", "disc_diameter= and mass=")}
#: a result and the argument of fit that it needs
_ASKED_BY = {"reynolds": "disc_diameter=", "keulegan_carpenter": "disc_diameter=", "decay_segments": "segment=",
             "decay_rate_mean": "segment=", "decay_rate_mean_standard_error": "segment=", "stiffness_budget": "mass=",
             "monte_carlo": "monte_carlo=", "plan": "goal=", "textbook": "textbook=True", "held_out": "hold_out="}


class LawFit(_Motion):
    """The law of one recorded motion.

    `fit["decay_rate"]` is an Estimate, as is each of `headline`, `parameters` and `derived` (names to Estimates, SI);
    `keys()` has the names. `headline` is what is looked for first, as far as it is known: frequency, stiffness,
    decay_rate_start and decay_rate_end (by all terms of the law, at the first and the last sample), reynolds_max. `fitted` and `covariance` are names and a square array in their order.

    Per used sample: `t` [s], `measured`, `residuals` (measured less fitted), `x` (displacement of the law from the
    equilibrium) and `v`.

    Further: `law` ("viscous+drag"), `status` ("converged" where it succeeded), `succeeded`, `message` (why it did
    not), `run` (number in the file), `residual` (a Residual), `notices`. These are as docs/results.md describes them,
    and None or empty where they were not asked for: `recording`, `iterations`, `between_samples`, `simulate` (a command
    line), `candidates`, `modes`, `held_out`, `decay_segments`, `decay_rate_mean`, `decay_rate_mean_standard_error`,
    `decay_by_amplitude`, `reynolds`, `keulegan_carpenter`, `stiffness_budget`, `monte_carlo`, `plan`, `textbook` and
    `warnings`.
    """

    recording: Mapping[str, Any] = {}
    iterations: int = 0
    between_samples: Optional[str] = None
    simulate: Optional[str] = None
    candidates: Sequence[Dict[str, Any]] = ()
    modes: Sequence[Dict[str, Any]] = ()
    held_out: Optional[Dict[str, Any]] = None
    decay_segments: Sequence[Dict[str, Any]] = ()
    decay_rate_mean: Optional[float] = None
    decay_rate_mean_standard_error: Optional[float] = None
    decay_by_amplitude: Sequence[Dict[str, Any]] = ()
    reynolds: Optional[Dict[str, Any]] = None
    keulegan_carpenter: Optional[Dict[str, Any]] = None
    stiffness_budget: Sequence[Dict[str, Any]] = ()
    monte_carlo: Optional[Dict[str, Any]] = None
    plan: Optional[Dict[str, Any]] = None
    textbook: Optional[Dict[str, Any]] = None
    warnings: Sequence[str] = ()

    def __init__(self, answer: Answer, document: Optional[Dict[str, Any]] = None) -> None:
        super().__init__(answer, document)
        has = self._document.get
        for name in LawFit.__annotations__:
            if has(name) is not None:
                setattr(self, name, has(name))
        self.run: int = self.recording.get("run", 1)
        self.law: str = has("law", "") or ""
        self.status: str = has("status", "")
        self.message: str = has("message", "") or ""
        self.headline = {name: _estimate(name, each) for name, each in (has("headline") or {}).items()}
        self.parameters = {name: _estimate(name, each) for name, each in (has("parameters") or {}).items()}
        self.derived = {name: _estimate(name, each) for name, each in (has("derived") or {}).items()}
        covariance = has("covariance") or {}
        self.fitted: List[str] = list(covariance.get("parameters", []))
        self.covariance: Numbers = np.array(
            [[_number(each) for each in row] for row in covariance.get("matrix", [])], dtype=np.float64)
        self.covariance.flags.writeable = False
        left = has("residual") or {}
        self.residual = Residual(_number(left.get("rms")), _number(left.get("normality")),
                                 _number(left.get("autocorrelation")), bool(left.get("white", False)))

    @property
    def _run_number(self) -> int:
        return self.run

    @property
    def measured(self) -> Numbers:
        """The record [SI unit of its quantity]."""
        return self._array("measured")

    @property
    def residuals(self) -> Numbers:
        """Measured less fitted [SI unit of the recorded quantity]."""
        return self._array("residual")

    @property
    def succeeded(self) -> bool:
        """Whether the fit converged."""
        return self.status == "converged"

    def keys(self) -> List[str]:
        """The names of all parameters, derived quantities and what else stands in the headline."""
        return [*dict.fromkeys([*self.parameters, *self.derived, *self.headline])]

    def __getitem__(self, name: str) -> Estimate:
        for known in (self.parameters, self.derived, self.headline):
            if name in known:
                return known[name]
        if not self.parameters:
            raise KeyError(f"{name!r}: this fit has no values: {self.message or self.status}")
        raise KeyError(self._why_not(name))

    def _why_not(self, name: str) -> str:
        known = _ALSO.get(name, name)
        if known in self:
            return f"{name!r}: its name is {known!r}"
        source, needed = _FROM.get(known, ("", ""))
        if source in self:
            return f"{name!r}: " + ("" if known == name else f"its name is {known!r}; ") + f"give {needed} to fit"
        if known in LawFit.__annotations__:
            absent = known in _ASKED_BY and not getattr(self, known)
            return f"{name!r}: it is the attribute .{known}" + (f"; give {_ASKED_BY[known]} to fit" if absent else "")
        return _unknown(name, self.keys(), "this fit")

    if not TYPE_CHECKING:
        def __getattr__(self, name: str) -> Any:
            """Only of what does not exist: says what to write instead."""
            known = _ALSO.get(name, name)
            if name.startswith("_"):
                raise AttributeError(name)
            if known in self:
                raise AttributeError(f"{name} is a quantity: fit[{known!r}]")
            if known in _FROM:
                raise AttributeError(self._why_not(name))
            near = difflib.get_close_matches(name, [each for each in dir(self) if not each.startswith("_")], 1)
            raise AttributeError(f"a fit has no {name}" + (f"; did you mean {near[0]}?" if near else ""))

    def __contains__(self, name: object) -> bool:
        return name in self.keys()

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def at(self, t: Any) -> Trajectory:
        """The law's motion at times t [s], strictly increasing from the first used sample's on.

        InputError of a motion that a recorded force drives: it is known at the samples only.
        """
        if getattr(getattr(t, "dtype", None), "kind", "") == "M":
            raise InputError("t must be seconds after the first time of the record, which the fit has as 0: give "
                             "(times - first).total_seconds()", "t", "no_numbers")
        motion = self._answer.motion_at(self.run, _numbers("t", arrays_of({"t": t})["t"]))
        return Trajectory(motion["t"], motion["x"], motion["v"])

    def simulation(self) -> Dict[str, Any]:
        """The arguments with which `simulate` runs this law from the first used sample on. Where no mass was given to the
        fit, the body has 1 kg: motion and frequencies are the same, energies and forces are those of 1 kg."""
        command = self._document.get("simulate")
        if not command:
            raise InputError("this law cannot be simulated by itself", "fit", "fit_without_law")
        given: Dict[str, Any] = {}
        name = ""
        for word in shlex.split(command.partition(" --over ")[0])[2:]:
            if word.startswith("--"):
                name = word[2:].replace("-", "_")
                given[name] = True  # a flag, if no value follows
            else:
                given[name] = word if _no_number(word) else float(word)
        return given

    def to_uncertainties(self) -> Dict[str, Any]:
        """The fitted parameters as numbers of the package `uncertainties`, with their correlations."""
        from uncertainties import correlated_values
        if not self.fitted:
            return {}
        values = [self.parameters[name].value for name in self.fitted]
        return dict(zip(self.fitted, correlated_values(values, self.covariance, tags=self.fitted)))

    def to_pandas(self) -> Any:
        """The samples: t as the index, measured, x, v and residual."""
        return _frame({"t": self.t, "measured": self.measured, "x": self.x, "v": self.v, "residual": self.residuals}, "t")

    def plot(self, ax: Any = None) -> Any:
        """Record, law and residual; draws into `ax` the record and the law alone. Returns the axes."""
        from . import _plot
        return _plot.fit(self, ax)

    def _shown(self) -> List[Estimate]:
        """All quantities, in the program's words, with what is asked first at the head."""
        rest = {**self.parameters, **self.derived}
        return [*self.headline.values(),
                *(each if name != "decay_rate" else replace(each, name="viscous decay rate")
                  for name, each in rest.items() if name not in self.headline)]

    def __repr__(self) -> str:
        said = f", residual (rms) {self.residual.rms:.3g}{self._unit}" if self.succeeded else f": {self.message}"
        head = f"LawFit: {self.law or 'no law'}, {self.status}{said}"
        return "\n".join([head, *(f"  {each.name.replace('_', ' ')} = {each}" for each in self._shown())])

    @property
    def _unit(self) -> str:
        """Of the record, as it stands after a number."""
        level = self.parameters.get("equilibrium")
        return f" {level.unit}" if level and level.unit not in ("", "1") else ""

    def _repr_html_(self) -> str:
        rows = [[each.name.replace("_", " "), with_error(each.value, each.standard_error),
                 f"{each.confidence_95[0]:.7g} to {each.confidence_95[1]:.7g}", each.unit] for each in self._shown()]
        title = f"Law: {self.law} ({self.status}), residual (rms) {self.residual.rms:.3g}{self._unit}"
        return _table(title if self.succeeded else f"{self.status}: {self.message}",
                      ["", "value ± standard error", "95 % interval", "unit"], rows)


def _no_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return True
    return False


class Fits(Result, Sequence[LawFit]):
    """The fits of several runs, in their order."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self._fits = [LawFit(answer, each) for each in self._document.get("fits", [self._document])]

    @overload
    def __getitem__(self, index: int) -> LawFit: ...
    @overload
    def __getitem__(self, index: slice) -> List[LawFit]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[LawFit, List[LawFit]]:
        return self._fits[index]

    def __len__(self) -> int:
        return len(self._fits)

    def __repr__(self) -> str:
        return "\n".join(repr(each) for each in self._fits)


class Run(_Motion):
    """One simulated run: `t` [s], `x` [m], `v` [m/s], `energy` [J] and, with a simulated sensor, `sensor`; `method`,
    `label` (tells it from other runs), `step` [s], `status` ("reached_end" where it succeeded), `in_words` (what the
    method makes of the law) and `energy_balance` [J]. `to_dict()` has the rest."""

    def __init__(self, answer: Answer, number: int, document: Dict[str, Any], notices: List[Dict[str, Any]]) -> None:
        super().__init__(answer, document)
        self._place = number
        self._document = {**document, "notices": notices}
        self.method: str = document["method"]
        self.label: str = document["label"]
        self.status: str = "interrupted" if document.get("interrupted") else document["status"]
        self.step = _number(document.get("step"))
        self.in_words: str = document.get("in_words") or ""
        self.energy_balance: Dict[str, float] = document.get("energy_balance") or {}

    @property
    def _run_number(self) -> int:
        return self._place

    @property
    def energy(self) -> Numbers:
        """Kinetic and potential energy [J]."""
        return self._array("energy")

    @property
    def sensor(self) -> Numbers:
        """What the simulated sensor reads [m], of an angle [rad]; empty without one."""
        return self._array("sensor")

    def to_pandas(self) -> Any:
        """The states: t as the index, x, v and energy."""
        return _frame({"t": self.t, "x": self.x, "v": self.v, "energy": self.energy}, "t")

    def to_csv(self) -> str:
        """Its states; of all runs of one call Runs.to_csv has them."""
        head, _, rows = self._answer.written_as("csv").partition("\n")
        return head + "\n" + "".join(row for row in rows.splitlines(True) if row.startswith(f"{self._run_number},"))

    def __str__(self) -> str:
        return repr(self)

    def plot(self, of: str = "position", ax: Any = None) -> Any:
        """`of`: "position", "velocity", "energy" or "phase" (v against x). Returns the axes."""
        from . import _plot
        return _plot.runs([self], of, ax)

    def __repr__(self) -> str:
        return f"Run: {self.label}, {self.status}, {self.t.size} states\n  {self.in_words}".rstrip()


class _Named(Protocol):
    method: str

    @property
    def label(self) -> str: ...

    def to_pandas(self) -> Any: ...


One = TypeVar("One", bound=_Named)


class Several(Result, Sequence[One]):
    """Several runs: by number, or by the name of the method."""

    def __init__(self, answer: Answer, each: List[One]) -> None:
        super().__init__(answer)
        self._each = each

    def keys(self) -> List[str]:
        """Their names."""
        return [each.label for each in self._each]

    @overload
    def __getitem__(self, index: Union[int, str]) -> One: ...
    @overload
    def __getitem__(self, index: slice) -> List[One]: ...
    def __getitem__(self, index: Union[int, str, slice]) -> Union[One, List[One]]:
        if isinstance(index, str):
            for each in self._each:
                if index in (each.label, each.method):
                    return each
            raise KeyError(_unknown(index, self.keys(), "this"))
        return self._each[index]

    def __len__(self) -> int:
        return len(self._each)

    def __repr__(self) -> str:
        return "\n".join(repr(each) for each in self._each)

    def to_pandas(self) -> Any:
        """All states, one below the other, with the run's label."""
        import pandas
        return pandas.concat([each.to_pandas().assign(run=each.label) for each in self._each])


class Runs(Several[Run]):
    """Several runs of the same law: by number, or by the name of the method."""

    def __init__(self, answer: Answer) -> None:
        document = json.loads(answer.text)
        said = document.get("notices", [])
        super().__init__(answer, [Run(answer, i + 1, each, said) for i, each in enumerate(document["runs"])])

    def plot(self, of: str = "position", ax: Any = None) -> Any:
        """All runs in one picture, as Run.plot draws one."""
        from . import _plot
        return _plot.runs(self._each, of, ax)


def _phase(t: Numbers, x: Numbers) -> Numbers:
    """Half a turn from each crossing of zero to the next."""
    i = np.flatnonzero(np.signbit(x[1:]) != np.signbit(x[:-1]))
    if not i.size:
        return np.full(t.size, np.nan)
    crossings = t[i] - x[i] * (t[i + 1] - t[i]) / (x[i + 1] - x[i])
    return np.asarray(np.interp(t, crossings, np.pi * np.arange(i.size), left=np.nan, right=np.nan))


class Curve:
    """One curve of a comparison: per sample `t` [s], `x` [m], `v` [m/s], `residual` and `phase_error`; `label`,
    `law` and `method` (exact: none); `numbers` are those of docs/results.md (`rms`, `r_squared`, `phase_drift`, `law_rms`,
    `method_phase`, ...), each an attribute too. For energies simulate the fit: cromer.simulate(comparison.fit, ...)."""

    def __init__(self, comparison: "Comparison", prefix: str, document: Dict[str, Any]) -> None:
        self._of = comparison
        arrays = comparison._answer.arrays
        self.t, self.x, self.v = (arrays.get(prefix + name, np.empty(0)) for name in ("t", "x", "v"))
        self.label: str = document["label"]
        self.law: str = document["law"]
        self.method: str = document["method"]
        self.numbers = {name: value for name, value in document.items() if isinstance(value, (int, float))}

    @property
    def residual(self) -> Numbers:
        """Measured less simulated displacement [m], of an angle [rad]."""
        fit, n = self._of.fit, self.t.size  # fewer than the record has if the simulation ended early
        return np.asarray(fit.residuals[:n] + fit.x[:n] - self.x)

    @property
    def phase_error(self) -> Numbers:
        """Phase [rad] by which the curve is ahead of the fitted law's own motion, from where both cross the equilibrium;
        NaN before the first crossing and after the last."""
        ahead = _phase(self.t, self.x) - _phase(self.t, self._of.fit.x[:self.t.size])
        known = ahead[np.isfinite(ahead)]
        return ahead - np.pi * np.round(known[0] / np.pi) if known.size else ahead

    def to_pandas(self) -> Any:
        """The samples: t as the index, x, v, residual and phase_error."""
        return _frame({"t": self.t, "x": self.x, "v": self.v, "residual": self.residual, "phase_error": self.phase_error}, "t")

    def __repr__(self) -> str:
        return f"Curve: {self.label}, rms {self.numbers.get('rms', float('nan')):.3g}"

    def __getattr__(self, name: str) -> float:
        numbers: Dict[str, float] = self.__dict__.get("numbers", {})
        if name in numbers:
            return numbers[name]
        raise AttributeError(name)


class Comparison(Result):
    """A recorded motion beside its simulations: `curves` (one constant decay rate and the law, without a method's error, then
    the law by each method), one of them by the name of its method (`comparison["rk4"]`), `status` (of the fit), `message` (what
    went wrong), `explanation` (in words) and `fit`."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        if "comparisons" in self._document:
            raise InputError("the recording has several runs: name one with run=", "run", "several_runs")
        self._fit: Optional[LawFit] = None
        run = self._document["recording"]["run"]
        self.status: str = self._document["status"]
        self.message: str = self._document.get("message") or ""
        self.explanation: str = self._document.get("explanation") or ""
        self.curves = [Curve(self, f"{run}.{i + 1}.", each) for i, each in enumerate(self._document.get("curves") or [])]

    def __getitem__(self, method: str) -> Curve:
        """The law by this method; "exact" is the law itself."""
        for each in reversed(self.curves):
            if each.method == method:
                return each
        raise KeyError(_unknown(method, [each.method for each in self.curves[1:]], "this"))

    @property
    def fit(self) -> LawFit:
        """The fit of the record, as `fit` finds it; made when it is first asked for."""
        if self._fit is None:
            self._fit = LawFit(self._answer.by("fit", without=["method", "step"]))
        return self._fit

    def to_pandas(self) -> Any:
        """A row of numbers for each curve, by label; a Curve has its samples."""
        import pandas
        rows = [{"simulated": each.label, "method": each.method, **each.numbers} for each in self.curves]
        return pandas.DataFrame(rows).set_index("simulated") if rows else pandas.DataFrame()

    def plot(self, of: str = "position", ax: Any = None) -> Any:
        """`of`: "position" (with the measured one), "residual" or "phase_error" of each curve against time. Returns
        the axes."""
        from . import _plot
        return _plot.compared(self, of, ax)

    def _repr_html_(self) -> str:
        names = ["rms", "r_squared", "amplitude_ratio_end", "phase_drift"]
        rows = [[each.method, each.label, *(f"{each.numbers[name]:.4g}" if name in each.numbers else "" for name in names)]
                for each in self.curves]
        said = f"<p>{html.escape(self.explanation or self.message)}</p>"
        return _table("Comparison", ["method", "simulated", *(name.replace("_", " ") for name in names)], rows) + said

    def __repr__(self) -> str:
        return f"Comparison: {self.status}, {len(self.curves)} curves\n  {self.explanation or self.message}"


class Methods(Result, Sequence[Dict[str, Any]]):
    """The methods of integration, each with what it is and, with a step, what it simulates in place of the law
    ("effective", "stable", "stability_limit", "in_words"): by number or by name."""

    @overload
    def __getitem__(self, index: Union[int, str]) -> Dict[str, Any]: ...
    @overload
    def __getitem__(self, index: slice) -> List[Dict[str, Any]]: ...
    def __getitem__(self, index: Union[int, str, slice]) -> Union[Dict[str, Any], List[Dict[str, Any]]]:
        rows: List[Dict[str, Any]] = self._document["methods"]
        if isinstance(index, str):
            for each in rows:
                if each["name"] == index:
                    return each
            raise KeyError(_unknown(index, self.names, "the table"))
        return rows[index]

    def __len__(self) -> int:
        return len(self._document["methods"])

    @property
    def names(self) -> List[str]:
        """The names of the methods."""
        return [each["name"] for each in self._document["methods"]]

    def to_pandas(self) -> Any:
        """A row for each method."""
        import pandas
        return pandas.json_normalize(self._document["methods"]).set_index("name")

    def __repr__(self) -> str:
        return f"Methods: {', '.join(self.names)}"


class Mode:
    """A mode: `frequency` [Hz] and `damping_ratio` with their errors (0 of a network, which is known), the complex
    `shape` of shape (names,), its largest 1, `shape_standard_error` of its parts (empty of a network),
    `participation` (effective modal mass over the whole, None of a recording), `methods`, what each really simulates
    ("method", "step", "frequency", "damping_ratio", "stable", "in_words"), and `of_network`, the network's mode that
    matches it, of a recording beside a network ("mode", "frequency", "damping_ratio", "mac"; None without one)."""

    def __init__(self, document: Dict[str, Any]) -> None:
        self.frequency = _estimate("frequency", document["frequency"])
        self.damping_ratio = _estimate("damping_ratio", document["damping_ratio"])
        self.shape = np.array([complex(re, im) for re, im in document["shape"]])
        self.shape_standard_error = np.array([complex(re, im) for re, im in document["shape_standard_error"]])
        self.participation: Optional[float] = document["participation"]
        self.of_network: Optional[Dict[str, Any]] = document["of_network"]
        self.methods: List[Dict[str, Any]] = document["methods"]

    def __repr__(self) -> str:
        return f"Mode: {self.frequency.value:.6g} Hz, damping ratio {self.damping_ratio.value:.6g}"


class Modes(Result, Sequence[Mode]):
    """The modes of a network or in a recording, by rising frequency; `names` of the masses or channels are those of
    the components of shapes."""

    @overload
    def __getitem__(self, index: int) -> Mode: ...
    @overload
    def __getitem__(self, index: slice) -> List[Mode]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Mode, List[Mode]]:
        rows = self._document["modes"]
        return Mode(rows[index]) if not isinstance(index, slice) else [Mode(each) for each in rows[index]]

    def __len__(self) -> int:
        return len(self._document["modes"])

    @property
    def names(self) -> List[str]:
        """The names of the masses or channels."""
        return list(self._document["names"])

    @property
    def frequency(self) -> Numbers:
        """Of each mode [Hz]."""
        return np.array([each.frequency.value for each in self])

    @property
    def damping_ratio(self) -> Numbers:
        """Of each mode [1]."""
        return np.array([each.damping_ratio.value for each in self])

    def to_pandas(self) -> Any:
        """A row for each mode, without shapes."""
        import pandas
        return pandas.DataFrame({"frequency": self.frequency, "damping_ratio": self.damping_ratio,
                                 "participation": [each.participation for each in self]})

    def __repr__(self) -> str:
        return f"Modes: {', '.join(f'{each:.4g}' for each in self.frequency)} Hz"


class Recognition(Result, Sequence[Dict[str, Any]]):
    """Which method made a run: the nearest first ("method", "same_map", "step", "distance", "decay_rate_added",
    "frequency_shift"). `verdict` is "made", "the_law" (no error of a method shows), "other_law" or "none"."""

    @overload
    def __getitem__(self, index: int) -> Dict[str, Any]: ...
    @overload
    def __getitem__(self, index: slice) -> List[Dict[str, Any]]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Dict[str, Any], List[Dict[str, Any]]]:
        found: List[Dict[str, Any]] = self._document["recognised"]
        return found[index]

    def __len__(self) -> int:
        return len(self._document["recognised"])

    @property
    def verdict(self) -> str:
        """What there is to say of the first."""
        return str(self._document["verdict"])

    def to_pandas(self) -> Any:
        """A row for each method and step."""
        import pandas
        return pandas.DataFrame(self._document["recognised"])

    def __repr__(self) -> str:
        return f"Recognition: {self.in_words}"

    @property
    def in_words(self) -> str:
        """The verdict as a sentence."""
        return str(self._document["in_words"])


#: the curves of a shock spectrum
SHOCK = ("maximax", "primary", "residual", "positive", "negative")


class Spectrum(Result):
    """Response spectrum: `period` [s], `sd` [m], `psv` [m/s] and `psa` [m/s²] of the first component, and of two
    components `rotd50` and `rotd100` [m]. Of a shock (shock=True) `maximax`, `primary`, `residual`, `positive` and
    `negative` [m/s²] instead. Of shape (periods,), with several damping ratios (ratios, periods); what was not asked
    for is empty. `damping_ratio` and `loss_factor` [1] have a number for each spectrum, NaN where it has none. With
    in_g=True table, figure and document are in g; the arrays stay in m/s²."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self.maximax, self.primary, self.residual, self.positive, self.negative = map(self._of, SHOCK)
        found = max(self.sd.shape[-1], self.maximax.shape[-1])
        self.period = answer.arrays.get("period", np.empty(0))[:found]  # fewer where it was interrupted
        self.status = "interrupted" if answer.status == NO_SUCCESS else "done"
        spectra = self._document["spectra"]
        self.damping_ratio: Numbers = np.array([_number(each.get("damping_ratio")) for each in spectra])
        self.loss_factor: Numbers = np.array([_number(each.get("loss_factor")) for each in spectra])

    def _of(self, name: str) -> Numbers:
        rows = [values for key, values in self._answer.listed if key.rpartition(".")[2] == name]
        unit = 9.80665 if self._document["units"].get("acceleration") == "g" else 1  # the document follows in_g
        rows = rows or [unit * np.array(each[name]) for each in self._document["spectra"] if name in each]
        return rows[0] if len(rows) == 1 else np.array(rows)

    @property
    def sd(self) -> Numbers:
        """Spectral displacement [m]."""
        return self._of("displacement")

    @property
    def psv(self) -> Numbers:
        """Pseudo-velocity [m/s]."""
        return self._of("pseudo_velocity")

    @property
    def psa(self) -> Numbers:
        """Pseudo-acceleration [m/s²]."""
        return self._of("pseudo_acceleration")

    @property
    def ground_velocity(self) -> Numbers:
        """Of the ground (the first component), from rest at the first sample, one for each sample [m/s]."""
        return self._answer.arrays.get("ground_velocity", np.empty(0))

    @property
    def ground_displacement(self) -> Numbers:
        """Of the ground, likewise [m]."""
        return self._answer.arrays.get("ground_displacement", np.empty(0))

    @property
    def components(self) -> List[Dict[str, Any]]:
        """What there is to say of each component itself: `peak_velocity`, `cumulative_absolute_velocity`, `duration_5_75`
        and the other entries of the document (docs/results.md)."""
        return self.to_dict()["components"]  # type: ignore[no-any-return]

    @property
    def rotd50(self) -> Numbers:
        """Of two components, the median over all directions [m]."""
        return self._of("rotd50")

    @property
    def rotd100(self) -> Numbers:
        """Of two components, the largest over all directions [m]."""
        return self._of("rotd100")

    def to_pandas(self) -> Any:
        """The first damping ratio's SD, PSV and PSA against the period; of a shock what it has instead."""
        curves = {"SD": self.sd, "PSV": self.psv, "PSA": self.psa, **{name: self._of(name) for name in SHOCK}}
        first = {name: np.atleast_2d(each)[0] for name, each in curves.items() if each.size}
        return _frame({"period": self.period, **first}, "period")

    def plot(self, of: Optional[str] = None, ax: Any = None) -> Any:
        """`of`: "psa" (if not given), "psv" or "sd" against the period; of a shock "maximax" (if not given), "primary",
        "residual", "positive" or "negative". Returns the axes."""
        from . import _plot
        return _plot.spectrum(self, of, ax)

    def _damping(self) -> List[str]:
        """Of each spectrum, as the curves are named."""
        return [f"ζ = {ratio:g}" if np.isfinite(ratio) else f"η = {loss:g}"
                for ratio, loss in zip(self.damping_ratio, self.loss_factor)]

    def __repr__(self) -> str:
        return f"Spectrum: {self.period.size} periods, {', '.join(self._damping())}"


class Sweep(Result):
    """What was swept and what was found, one value for each point: `amplitude` [m], `phase` [rad], ... as
    attributes and by name; `columns` has them all, `units` their units, `swept` the names of what was swept, `statuses` how each point ended, and
    `status` is "done" or "interrupted"."""

    def __init__(self, answer: Answer) -> None:
        super().__init__(answer)
        self.columns: Dict[str, Numbers] = {}
        self.units: Dict[str, str] = {}
        for title, values in answer.arrays.items():
            name, _, unit = title.partition(" (")
            self.columns[name] = values
            self.units[name] = unit[:-1]
        self.statuses: List[str] = self._document.get("statuses", [])
        self.swept: List[str] = [each["column"].partition(" (")[0] for each in self._document["swept"]]
        self.status = "interrupted" if "not_reached" in self.statuses else "done"

    def __getitem__(self, name: str) -> Numbers:
        if name in self.columns:
            return self.columns[name]
        raise KeyError(_unknown(name, list(self.columns), "this sweep"))

    def __getattr__(self, name: str) -> Numbers:
        if "columns" not in self.__dict__:  # not yet: it is being unpickled
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def to_pandas(self) -> Any:
        """A row for each point: what was swept, and what was found."""
        return _frame(self.columns)

    def plot(self, of: Optional[str] = None, ax: Any = None) -> Any:
        """`of` (the first of what was found, if not given) against the last swept option, with a line for each value of
        the others. Returns the axes."""
        from . import _plot
        return _plot.sweep(self, of, ax)

    def __repr__(self) -> str:
        return f"Sweep: {', '.join(self.columns)}; {len(self.statuses)} points"


class Recording(Result):
    """A file that was read: `columns` (titles), `units`, `runs`; a column by its title ("Position (m)"), by its name
    without unit, or by its quantity ("position"). Values are as the file has them."""

    def __init__(self, answer: Answer, file: str, options: Mapping[str, Any]) -> None:
        super().__init__(answer)
        self.file = file
        self.options = dict(options)
        self._about: List[Dict[str, Any]] = self._document.get("columns") or []
        self.columns: List[str] = [each["name"] for each in self._about]
        self.units: Dict[str, str] = {each["name"]: each["unit"] for each in self._about}
        self.runs: List[int] = sorted({each["run"] for each in self._about})

    def __getitem__(self, key: Union[str, Tuple[str, int]]) -> Numbers:
        """recording["position"], of the first run that has it; recording["position", 2] of run 2."""
        name, run = key if isinstance(key, tuple) and len(key) == 2 else (key, None)
        for spelled in range(3):
            for about, (_, values) in zip(self._about, self._answer.listed):
                names: List[str] = [about["name"], about["name"].partition(" (")[0], about["quantity"]]
                if names[spelled].lower() == str(name).lower() and run in (None, about["run"]):
                    return values
        raise KeyError(_unknown(key, self.columns, f"this recording, of runs {self.runs},"))

    def to_pandas(self) -> Any:
        """Its columns; where they differ in length, the shorter ones end with NaN."""
        import pandas
        return pandas.concat([pandas.Series(np.array(values), name=name) for name, values in self._answer.listed], axis=1)

    def __repr__(self) -> str:
        return f"Recording of {self.file}: {', '.join(self.columns)}"
