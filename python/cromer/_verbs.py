"""The verbs."""

from __future__ import annotations

import contextlib
import inspect
import os
import warnings
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, TypeVar, Union, overload

import numpy as np

from ._arguments import arrays_of, request_of, unit_of_observed
from ._core import Answer, InputError, Progress, call
from ._networks import Network, NetworkFit, NetworkRun, NetworkRuns, arrays_of_channels, request_of_network
from ._options import (ARGUMENTS, CompareOptions, FitOptions, MethodsOptions, ModesOptions, ReadOptions,
                       SimulateOptions, SpectrumOptions, SweepOptions)
from ._results import Comparison, Fits, FitWarning, LawFit, Methods, Modes, Recognition, Recording, Run, Runs, Spectrum, Sweep, told

if TYPE_CHECKING:
    from typing_extensions import Unpack

File = Union[str, "os.PathLike[str]", Recording]
Verb = TypeVar("Verb", bound=Callable[..., Any])
#: an argument, and the one of a fitted law that it stands for
_IN_PLACE_OF = {"natural_frequency": "stiffness", "damping_ratio": "damping", "quality_factor": "damping", "accuracy": "step"}
#: what many verbs take beside their options: the type, and what it is
_COMMON = {
    "language": ("str, optional", 'Of the sentences: "en" (if not given) or "de".'),
    "strict": ("bool", "Raise NoSuccess where the computation does not succeed, rather than warn."),
    "progress": ("bool or callable, optional",
                 "True shows a bar where tqdm is installed; a callable gets the share done, 0 to 1, and ends the\n"
                 "    work by returning False."),
}


def _documented(verb: Verb) -> Verb:
    """Adds to the verb's docstring what many verbs take, and its options from the table that the program has; the
    options to its signature as well."""
    table = ARGUMENTS[verb.__name__.replace("fit_all", "fit")]
    signature = inspect.signature(verb)
    common = {name: each for name, each in _COMMON.items() if name in signature.parameters}
    lines = [f"{name} : {kind}\n    {text}" for name, (kind, text) in {**common, **table}.items()]
    begin, _, end = (inspect.cleandoc(verb.__doc__ or "") + "\n").partition("{options}")
    verb.__doc__ = begin + "\n".join(lines) + end
    own = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD]
    options = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in table
               if name not in signature.parameters]
    verb.__signature__ = signature.replace(parameters=own + options)  # type: ignore[attr-defined]
    return verb


@contextlib.contextmanager
def _shown(progress: Union[None, bool, Progress], what: str) -> Iterator[Optional[Progress]]:
    """A function of the share done, for True a bar of tqdm where that is installed; the bar is full when all went well."""
    if progress is None or isinstance(progress, bool):
        bar: Any = None
        if progress:
            with contextlib.suppress(ImportError):
                from tqdm.auto import tqdm
                bar = tqdm(total=100, desc=what, unit="%", leave=False)
        if bar is None:
            yield None
            return
        with contextlib.closing(bar) as shown:
            yield lambda done: shown.update(round(100 * done) - shown.n)
            shown.update(shown.total - shown.n)
        return
    if not callable(progress):
        raise InputError(f"progress must be True or a function of the share done, not {progress!r}", "progress", "must_be_value")
    yield progress


def _names(method: Any) -> Any:
    """One method's name or none, or a list of names."""
    if isinstance(method, np.ndarray):
        method = method.tolist()
    if isinstance(method, (list, tuple)) and not method:
        raise InputError("method is an empty list: name a method, or leave it out", "method", "must_be_value")
    return method


def _of_file(source: Any) -> Optional[Dict[str, Any]]:
    """What a request says of a file or a recording; None of anything else."""
    if isinstance(source, Recording):
        return {"file": source.file, **source.options}
    return {"file": os.fsdecode(source)} if isinstance(source, (str, os.PathLike)) else None


def _motion(verb: str, t: Any, y: Any, force: Any = None) -> Tuple[Dict[str, Any], Dict[str, Any]]:
    """The request and the arrays that a recorded motion is."""
    request = _of_file(t)
    if request is not None:
        for name, values, cure in (("y", y, "column"), ("force", force, "force_column")):
            if values is not None:
                raise InputError(f"a file has its own columns: name one with {cure}=", name, "file_and_arrays")
        return request, {}
    if hasattr(t, "columns"):  # a DataFrame
        raise InputError(f"a table does not say which of its columns is the time: {verb}(table[TIME], table[POSITION]), "
                         f"in SI units; it has {', '.join(map(str, t.columns))}", "t", "no_numbers")
    if y is None and hasattr(t, "index") and hasattr(t, "to_numpy"):  # a Series of pandas: its index is the time
        return {}, {"t": t.index, "y": t, "force": force}
    if y is None:
        raise InputError(f"y is missing: {verb}(t, y), or {verb} of a file, a path or a recording", "y", "array_is_missing")
    return {}, {"t": t, "y": y, "force": force}


def _channels(verb: str, t: Any, channels: Any, unit: str) -> Tuple[Dict[str, Any], Dict[str, Any]]:
    """The request and the arrays that a recording of several channels is."""
    if channels is None:
        return _motion(verb, t, None)
    if _of_file(t) is not None:
        raise InputError("a file has its own columns: leave the arrays out", "channels", "file_and_arrays")
    return {}, arrays_of_channels(t, channels, unit)


@overload
def fit(t: Any, y: Any = None, *, network: None = ..., force: Any = None, observed: Optional[str] = None, language: Optional[str] = None,
        strict: bool = False, progress: Union[None, bool, Progress] = None, **options: "Unpack[FitOptions]") -> LawFit: ...
@overload
def fit(t: Any, y: Any = None, *, network: Network, force: Any = None, observed: Optional[str] = None, language: Optional[str] = None,
        strict: bool = False, progress: Union[None, bool, Progress] = None, **options: "Unpack[FitOptions]") -> NetworkFit: ...
@_documented
def fit(t: Any, y: Any = None, *, network: Optional[Network] = None, force: Any = None, observed: Optional[str] = None,
        language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
        **options: "Unpack[FitOptions]") -> Union[LawFit, NetworkFit]:
    """The law of motion of a free or a driven oscillation, with uncertainties, from its recording; or the links of a
    network of masses.

    No start values are needed. The whole waveform is fitted by Levenberg-Marquardt; intervals allow for correlated
    residuals (docs/identify.md).

    Parameters
    ----------
    t : array of shape (n,), str, path, Series or Recording
        Times [s], strictly increasing; or a file; or what `read` gave; or a pandas Series whose index is the time.
    y : array of shape (n,)
        The motion [SI unit of `observed`]; NaN is a missing value. At least one and a half periods. With a network a list
        of arrays, an array of two dimensions or a DataFrame: the positions [m] or angles [rad] of all masses, in its order.
    network : str, path or mapping, optional
        The file of a network of masses, or what it holds, {"mass": [{"name": "left", "mass": 2}, ...], "link": [{"to":
        "left", "stiffness": "?"}, ...]}: the values "?" are found (docs/networks.md). Of the options those of the file,
        run, from_ and to go with it.
    force : array of shape (n,), optional
        Recorded force [N] that drives the motion.
    observed : str, optional
        "position" (if not given), "angle", "velocity", "angular_velocity" or "acceleration".
    {options}

    Returns
    -------
    LawFit; NetworkFit with a network

    Raises
    ------
    InputError
        An argument that cannot be used, or a file of several runs: name one with run=, or take `fit_all`.
    """
    if network is not None:
        return _fit_network(network, t, y, {**options, "force": force, "observed": observed}, language, strict, progress)
    found, answer = _fits(t, y, force, observed, language, progress, options)
    if len(found) != 1:
        raise InputError(f"the recording has {len(found)} runs: name one with run=, or take fit_all", "run",
                         "several_runs", {"runs": len(found)})
    first = found[0]
    told(first, answer, strict, f"{first.status}: {first.message}" if first.message else first.status)
    return first


def _fit_network(network: Network, t: Any, channels: Any, options: Mapping[str, Any], language: Optional[str], strict: bool,
                 progress: Union[None, bool, Progress]) -> NetworkFit:
    request, arrays = _channels("fit", t, channels, "")
    request.update(request_of({**options, "language": language}, "fit"), network=request_of_network(network))
    with _shown(progress, "fit") as shown:
        answer = call("fit", request, arrays, shown)
    found = NetworkFit(answer)
    told(found, answer, strict, f"{found.status}: {found.message}")
    return found


@_documented
def fit_all(t: File, *, language: Optional[str] = None, strict: bool = False,
            progress: Union[None, bool, Progress] = None, **options: "Unpack[FitOptions]") -> Fits:
    """The laws of all runs of a recording, as `fit` finds one.

    Parameters
    ----------
    t : str, path or Recording
        A file, or what `read` gave.
    {options}

    Returns
    -------
    Fits
    """
    found, answer = _fits(t, None, None, None, language, progress, options)
    told(found, answer, strict, "not every run could be fitted: see the status of each")
    return found


def _fits(t: Any, y: Any, force: Any, observed: Optional[str], language: Optional[str],
          progress: Union[None, bool, Progress], options: Mapping[str, Any]) -> Tuple[Fits, Answer]:
    request, arrays = _motion("fit", t, y, force)
    request.update(request_of({**options, "observed": observed, "language": language}, "fit"))
    with _shown(progress, "fit") as shown:
        answer = call("fit", request, arrays_of(arrays, observed), shown)
    return Fits(answer), answer


@overload
def simulate(law: Optional[LawFit] = None, *, method: Optional[str] = ..., force: Any = None, acceleration: Any = None, spacing: Optional[float] = None,
             language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
             **options: "Unpack[SimulateOptions]") -> Run: ...
@overload
def simulate(law: None = None, *, network: Network, method: Optional[str] = ..., force: Any = None, acceleration: Any = None, spacing: Optional[float] = None,
             language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
             **options: "Unpack[SimulateOptions]") -> NetworkRun: ...
@overload
def simulate(law: None = None, *, network: Network, method: Union[List[str], Tuple[str, ...]], force: Any = None, acceleration: Any = None, spacing: Optional[float] = None,
             language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
             **options: "Unpack[SimulateOptions]") -> NetworkRuns: ...
@overload
def simulate(law: Optional[LawFit] = None, *, method: Union[List[str], Tuple[str, ...]], force: Any = None, acceleration: Any = None, spacing: Optional[float] = None,
             language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
             **options: "Unpack[SimulateOptions]") -> Runs: ...
@_documented
def simulate(law: Optional[LawFit] = None, *, network: Optional[Network] = None, method: Union[None, str, List[str], Tuple[str, ...]] = None,
             force: Any = None, acceleration: Any = None, spacing: Optional[float] = None, language: Optional[str] = None, strict: bool = False,
             progress: Union[None, bool, Progress] = None, **options: "Unpack[SimulateOptions]") -> Union[Run, Runs, NetworkRun, NetworkRuns]:
    """The motion of an oscillator, or of a network of masses, by one method or several.

    Parameters
    ----------
    law : LawFit, optional
        A fitted law, from its first used sample on; an option that is given replaces the law's own.
    network : str, path or mapping, optional
        The file of a network of masses, or what it holds, {"mass": [{"name": "left", "mass": 2}, ...], "link": [{"to":
        "left", "stiffness": 8}, ...]} (docs/networks.md). The options of the integration go with it.
    method : str or list of str
        euler-cromer if not given, rk4 of a fitted law; `methods()` lists them. "exact" is the closed form of a linear law.
    force : array of shape (n,), optional
        Recorded force [N] that drives it, with `spacing`.
    acceleration : array of shape (n,), optional
        Recorded acceleration [m/s²] of the ground, with `spacing`; the motion is then relative to the ground.
    spacing : float, optional
        Time between their samples [s].
    {options}

    Returns
    -------
    Run of one method, Runs of a list of methods; of a network NetworkRun, and NetworkRuns of a list
    """
    if law is not None and not isinstance(law, LawFit):
        raise InputError(f"law must be a fit, what cromer.fit(...) gives, not {type(law).__name__}; the terms of a law have "
                         "arguments of their own: stiffness=9, damping=0.2", "law", "must_be_value")
    method = _names(method)
    own = law.simulation() if law is not None else {}
    for name in (each for each, value in options.items() if value is not None):
        own.pop(_IN_PLACE_OF.get(name, name), None)
    given: Dict[str, Any] = {**own, **options, "spacing": spacing, "language": language}
    if method is not None:
        given["method"] = method
    request = request_of(given, "simulate")
    if network is not None:
        request["network"] = request_of_network(network)
    arrays = arrays_of({"force": force, "acceleration": acceleration})
    with _shown(progress, "simulate") as shown:
        answer = call("simulate", request, arrays, shown)
    if network is not None:
        networks = NetworkRuns(answer)
        told(networks, answer, strict, _unfinished(networks))
        return networks if isinstance(method, (list, tuple)) else networks[0]
    runs = Runs(answer)
    told(runs, answer, strict, _unfinished(runs))
    return runs if isinstance(method, (list, tuple)) else runs[0]


def _unfinished(runs: "Union[Runs, NetworkRuns]") -> str:
    """Names the runs that did not reach their end, with what ended each."""
    return ", ".join(f"{each.label}: {each.status}" for each in runs if each.status != "reached_end")


@_documented
def compare(t: Any, y: Any = None, *, method: Union[None, str, List[str], Tuple[str, ...]] = None, observed: Optional[str] = None,
            language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
            **options: "Unpack[CompareOptions]") -> Comparison:
    """A recorded motion beside its law, one constant decay rate, and the law simulated by each method.

    Parameters
    ----------
    t, y, observed
        As of `fit`.
    method : str or list of str
        Each simulates the law (euler-cromer if none is given); `methods()` lists them.
    {options}

    Returns
    -------
    Comparison
    """
    request, arrays = _motion("compare", t, y)
    method = _names(method)
    given: Dict[str, Any] = {**options, "observed": observed, "language": language}
    if method is not None:
        given["method"] = method
    request.update(request_of(given, "compare"))
    with _shown(progress, "compare") as shown:
        answer = call("compare", request, arrays_of(arrays, observed), shown)
    found = Comparison(answer)
    told(found, answer, strict, found.message or found.status)
    return found


@overload
def methods(*, recognise: None = None, language: Optional[str] = None, strict: bool = False,
            **options: "Unpack[MethodsOptions]") -> Methods: ...
@overload
def methods(*, recognise: "Union[str, os.PathLike[str]]", language: Optional[str] = None, strict: bool = False,
            **options: "Unpack[MethodsOptions]") -> Recognition: ...
@_documented
def methods(*, recognise: "Union[None, str, os.PathLike[str]]" = None, language: Optional[str] = None, strict: bool = False,
            **options: "Unpack[MethodsOptions]") -> Union[Methods, Recognition]:
    """The methods of integration; with a step, what each simulates in place of your law. Or which of them made a run.

    Parameters
    ----------
    recognise : str or path, optional
        File of any simulator with time, position and velocity: which method made it, with which step, under the law
        given; a linear law is fitted where none is.
    {options}

    Returns
    -------
    Methods; with `recognise` Recognition
    """
    answer = call("methods", request_of({**options, "recognise": recognise, "language": language}, "methods"), {})
    made = Methods(answer) if recognise is None else Recognition(answer)
    told(made, answer, strict, made.to_dict().get("message", ""))
    return made


@_documented
def modes(t: Any, channels: Any = None, *, network: Optional[Network] = None, observed: Optional[str] = None,
          language: Optional[str] = None, strict: bool = False, **options: "Unpack[ModesOptions]") -> Modes:
    """The modes of a network of masses, or in a recording of several channels: natural frequencies, damping ratios,
    shapes; and what methods make of them.

    Parameters
    ----------
    t : array of shape (n,), str, path, Recording or mapping
        Times [s], strictly increasing, of the channels; or the file of a recording, or what `read` gave; or a network: its
        TOML file, or what that holds, {"mass": [...], "link": [...]} (docs/networks.md).
    channels : list of arrays of shape (n,), array of shape (channels, n), mapping or DataFrame
        What was recorded together [SI unit of `observed`]; NaN is a missing value. A mapping names the channels.
    network : str, path or mapping, optional
        Of a recording: the network whose masses are the channels, in its order, likewise; `of_network` of each mode
        is then the one that matches it.
    observed : str, optional
        "position" (if not given), "angle", "velocity", "angular_velocity" or "acceleration", of channels.
    {options}

    Returns
    -------
    Modes
    """
    arrays: Dict[str, Any] = {}
    if isinstance(t, Mapping):
        if network is not None:
            raise ValueError("network: it is set beside a recording, and `t` is a network")
        request: Dict[str, Any] = {"network": request_of_network(t)}
    else:
        request, arrays = _channels("modes", t, channels, unit_of_observed(observed))
    request.update(request_of({**options, "observed": observed, "language": language}, "modes"))
    if network is not None:
        request["network"] = request_of_network(network)
    answer = call("modes", request, arrays)
    made = Modes(answer)
    told(made, answer, strict, made.to_dict().get("message", ""))
    return made


@_documented
def spectrum(acceleration: Any, spacing: Optional[float] = None, *, second: Any = None, periods: Any = None,
             language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
             **options: "Unpack[SpectrumOptions]") -> Spectrum:
    """The response spectrum of a ground motion.

    Parameters
    ----------
    acceleration : array of shape (n,), str, path or Recording
        Acceleration of the ground [m/s²]; or a file.
    spacing : float
        Time between the samples of an array [s].
    second : array of shape (n,), optional
        The other horizontal component, for RotD50 and RotD100.
    periods : array of shape (periods,) or str, optional
        Natural periods [s], increasing; as text a grid, "0.05:5:200:log".
    {options}

    Returns
    -------
    Spectrum
    """
    arrays: Dict[str, Any] = {"second": second}
    given: Dict[str, Any] = {**options, "language": language}
    of_file = _of_file(acceleration)
    if of_file is None:
        given.update(spacing=spacing)
        arrays.update(acceleration=acceleration)
    elif spacing is not None:
        raise InputError("a file has its own times: leave spacing out, or give rate= where it has none", "spacing",
                         "file_and_arrays")
    else:
        given.update(of_file)
    if isinstance(periods, str):
        given.update(periods=periods)
    elif periods is not None:
        arrays.update(periods=periods)
    with _shown(progress, "spectrum") as shown:
        answer = call("spectrum", request_of(given, "spectrum"), arrays_of(arrays), shown)
    made = Spectrum(answer)
    told(made, answer, strict, "interrupted")
    return made


def _is_grid(value: Any) -> bool:
    """Whether it is an array of plain numbers; texts and numbers with units go into the request."""
    if hasattr(value, "to_base_units") or isinstance(value, (list, tuple)) and any(hasattr(each, "to_base_units") for each in value):
        return False
    return np.ndim(value) == 1 and np.asarray(value).dtype.kind in "iuf"


@_documented
def sweep(*, language: Optional[str] = None, strict: bool = False, progress: Union[None, bool, Progress] = None,
          **options: "Unpack[SweepOptions]") -> Sweep:
    """Amplitude and phase of the steady motion, or what `measure` asks for, over grids of options.

    An array is a grid, and so is a text ("1:5:400", "0.1:10:50:log", "2,5,10 Hz"); several grids give every
    combination. A linear law is answered in closed form, any other by steps (docs/sweep.md).

    Parameters
    ----------
    {options}

    Returns
    -------
    Sweep
    """
    given: Dict[str, Any] = dict(options)
    grids = {name: value for name, value in given.items() if _is_grid(value)}
    rest = {name: value for name, value in given.items() if name not in grids}
    with _shown(progress, "sweep") as shown:
        answer = call("sweep", request_of({**rest, "language": language}, "sweep"), grids, shown)
    made = Sweep(answer)
    unsettled = made.to_dict().get("not_settled", 0)
    told(made, answer, strict, "interrupted" if made.status == "interrupted" else "not every point succeeded: see statuses")
    if unsettled:
        text = f"{unsettled} of {len(made.statuses)} points have no steady motion: see statuses"
        warnings.warn(FitWarning(text, "not_settled", {"points": unsettled}), stacklevel=2)
    return made


@_documented
def read(file: Union[str, "os.PathLike[str]"], *, language: Optional[str] = None,
         **options: "Unpack[ReadOptions]") -> Recording:
    """A recording as it comes out of a logger.

    Parameters
    ----------
    file : str or path
        Its format is found by what is in it.
    {options}

    Returns
    -------
    Recording
    """
    given = request_of(options, "read")
    if not isinstance(file, (str, bytes, os.PathLike)):
        raise InputError(f"file must be a path, not {type(file).__name__}", "file", "must_be_value")
    path = os.fsdecode(file)
    answer = call("read", {"file": path, **given, **request_of({"language": language}, "read")}, {})
    made = Recording(answer, path, given)
    told(made, answer, False)
    return made
