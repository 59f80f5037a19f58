"""The door: a verb, a request and arrays in; a document and arrays out (cromer/c.h)."""

from __future__ import annotations

import ctypes
import json
import os
import pathlib
import queue
import sys
import threading
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray  # since NumPy 1.20; Debian 11 has 1.19

    Numbers = NDArray[np.float64]
else:
    Numbers = np.ndarray
Progress = Callable[[float], Any]

DONE, NO_SUCCESS, BAD_INPUT = 0, 1, 2
_HERE = pathlib.Path(__file__).parent
_NAMES = {"win32": "cromer.dll", "darwin": "libcromer.dylib"}


class InputError(ValueError):
    """An argument that cannot be used: the message says which, what is wrong, and what to do.

    `argument` is its name or None, `code` is the same in every language, `values` is what the message is made of.
    """

    def __init__(self, message: str, argument: Optional[str] = None, code: str = "",
                 values: Optional[Mapping[str, Any]] = None) -> None:
        super().__init__(message)
        self.argument, self.code, self.values = argument, code, dict(values or {})

    def __reduce__(self) -> Any:
        return InputError, (self.args[0], self.argument, self.code, self.values)


class _Array(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("values", ctypes.POINTER(ctypes.c_double)), ("length", ctypes.c_size_t)]


_Told = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, ctypes.c_void_p)


def _load() -> ctypes.CDLL:
    """The library beside this file, or the one that CROMER_LIBRARY names."""
    path = os.environ.get("CROMER_LIBRARY") or str(_HERE / _NAMES.get(sys.platform, "libcromer.so"))
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"Cromer's library cannot be loaded: {error}. Install the wheel of this platform, or name "
                          "a built library in the environment variable CROMER_LIBRARY.") from error
    handle, array = ctypes.c_void_p, ctypes.POINTER(_Array)
    for name, gives, *takes in (
            ("call", handle, ctypes.c_char_p, ctypes.c_char_p, array, ctypes.c_size_t, _Told, ctypes.c_void_p),
            ("written_as", handle, handle, ctypes.c_char_p),
            ("motion_at", handle, handle, ctypes.c_int, ctypes.POINTER(ctypes.c_double), ctypes.c_size_t),
            ("document", ctypes.c_char_p, handle), ("status", ctypes.c_int, handle),
            ("arrays", array, handle, ctypes.POINTER(ctypes.c_size_t)), ("free", None, handle),
            ("version", ctypes.c_char_p)):
        function = getattr(library, "cromer_" + name)
        function.restype, function.argtypes = gives, takes
    return library


_library = _load()
version: str = _library.cromer_version().decode()


class _Handle:
    """A result of the library; it lives as long as any of its arrays."""

    def __init__(self, address: Optional[int]) -> None:
        if not address:
            raise MemoryError
        self.address = address
        self._free = _library.cromer_free  # the module may be gone first when Python ends

    def __del__(self) -> None:
        if hasattr(self, "address"):
            self._free(self.address)


class Answer:
    """What a call found. `arrays` are read-only views of the library's memory."""

    def __init__(self, handle: _Handle) -> None:
        self._handle: Optional[_Handle] = handle
        self._again: Optional[_Again] = None
        self.text: str = _library.cromer_document(handle.address).decode()
        self.status: int = _library.cromer_status(handle.address)
        if self.status == BAD_INPUT:
            refusal = json.loads(self.text)
            raise InputError(refusal["message"], refusal["argument"], refusal["code"], refusal["values"])
        count = ctypes.c_size_t()
        held = _library.cromer_arrays(handle.address, ctypes.byref(count))
        #: in the order of the library; two runs may have columns of one title
        self.listed: List[Tuple[str, Numbers]] = [(held[i].name.decode(), _view(held[i], handle))
                                                  for i in range(count.value)]
        self.arrays: Dict[str, Numbers] = dict(self.listed)

    @property
    def handle(self) -> _Handle:
        """The library's result; of an answer that was unpickled, the same call made again."""
        if self._handle is None:
            assert self._again is not None
            self._handle = self._again()
        return self._handle

    def written_as(self, form: str) -> str:
        return Answer(_Handle(_library.cromer_written_as(self.handle.address, form.encode()))).text

    def motion_at(self, run: int, t: Numbers) -> Dict[str, Numbers]:
        address = _library.cromer_motion_at(self.handle.address, run, _pointer(t), t.size)
        return Answer(_Handle(address)).arrays

    def by(self, verb: str, without: Sequence[str]) -> Answer:
        """What another verb makes of the same call, less some options."""
        assert self._again is not None
        request = {name: value for name, value in json.loads(self._again.request).items() if name not in without}
        return call(verb, request, self._again.arrays)

    def __getstate__(self) -> Dict[str, Any]:
        state = dict(self.__dict__, _handle=None)
        state["listed"] = [(name, np.array(values)) for name, values in self.listed]
        state["arrays"] = dict(state["listed"])
        return state


Jobs = queue.SimpleQueue[Callable[[], None]]


class _Worker:
    """A thread that works for the main one, which stays free to hear Ctrl-C. One for all calls: starting a thread
    costs as much as a small fit, and the library keeps tables in each."""

    def __init__(self) -> None:
        self._jobs: Jobs = queue.SimpleQueue()
        self._process = -1  # that the thread lives in: a fork leaves it behind

    def start(self, work: Callable[[], None]) -> threading.Event:
        """Begins the work, which must not raise; the event is set when it has ended."""
        if self._process != os.getpid():
            self._jobs, self._process = queue.SimpleQueue(), os.getpid()
            threading.Thread(target=_work_on, args=(self._jobs,), name="cromer", daemon=True).start()
        ended = threading.Event()

        def job() -> None:
            work()
            ended.set()

        self._jobs.put(job)
        return ended


def _work_on(jobs: Jobs) -> None:
    while True:
        jobs.get()()


_worker = _Worker()


class _Again:
    """A call that can be made once more."""

    def __init__(self, verb: str, request: str, arrays: Dict[str, Numbers]) -> None:
        self.verb, self.request, self.arrays = verb, request, arrays

    def __call__(self) -> _Handle:
        return _called(self.verb, self.request, self.arrays, None)


def call(verb: str, request: Mapping[str, Any], arrays: Mapping[str, Any],
         progress: Optional[Progress] = None) -> Answer:
    """Makes one call; raises InputError for what cannot be used, KeyboardInterrupt after Ctrl-C."""
    text = json.dumps(request)
    kept = {name: _numbers(name, values) for name, values in arrays.items() if values is not None}
    answer = Answer(_called(verb, text, kept, progress))
    answer._again = _Again(verb, text, kept)
    return answer


def _called(verb: str, request: str, arrays: Dict[str, Numbers], progress: Optional[Progress]) -> _Handle:
    given = (_Array * len(arrays))(*[_Array(name.encode(), _pointer(values), values.size)
                                     for name, values in arrays.items()])
    stopped = threading.Event()
    raised: list[BaseException] = []

    def told(done: float, _: Any) -> int:
        try:
            going_on = None if progress is None else progress(done)
            if isinstance(going_on, (bool, np.bool_)) and not going_on:
                stopped.set()
        except BaseException as error:  # it ends the work and is raised again where the call was made
            raised.append(error)
            stopped.set()
        return 0 if stopped.is_set() else 1

    callback = _Told(told)
    found: list[Any] = []

    def work() -> None:
        found.append(_library.cromer_call(verb.encode(), request.encode(), given, len(arrays), callback, None))

    if threading.current_thread() is not threading.main_thread():
        work()
    else:
        ended = _worker.start(work)
        try:
            while not ended.wait(0.1):  # a wait without a limit is deaf on Windows
                pass
        except BaseException:
            stopped.set()
            ended.wait()
            _library.cromer_free(found[0] if found else None)
            raise
    handle = _Handle(found[0])
    if raised:
        raise raised[0]
    return handle


def _numbers(name: str, values: Any) -> Numbers:
    """One-dimensional doubles: a masked or missing value is NaN, times of the calendar are seconds from the first."""
    try:
        if getattr(getattr(values, "dtype", None), "tz", None) is not None:  # times of pandas with a time zone
            values = getattr(values, "dt", values).tz_convert(None)
        if hasattr(values, "filled"):  # a masked array
            values = values.astype(np.float64).filled(np.nan)
        elif hasattr(values, "isna") and values.ndim == 1 and values.dtype.kind in "fiu":  # pandas, with its own NA
            values = values.to_numpy(dtype=np.float64, na_value=np.nan)
        given = np.asarray(values)
        if given.dtype.kind in "mM":
            if name != "t":
                raise InputError(f"{name} must be numbers, not times", name, "no_numbers")
            since = given - given[:1] if given.dtype.kind == "M" else given
            given = since / np.timedelta64(1, "s")
        elif given.dtype.kind == "c":
            raise InputError(f"{name} must be real numbers, not complex ones", name, "no_numbers")
        numbers = np.ascontiguousarray(given, dtype=np.float64)
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{name} must be a sequence of numbers: {error}", name, "no_numbers") from None
    if numbers.ndim != 1:
        raise InputError(f"{name} must have one dimension, not {numbers.ndim}", name, "not_one_dimension")
    return numbers


def _pointer(values: Numbers) -> Any:
    return values.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def _view(array: _Array, handle: _Handle) -> Numbers:
    if array.length == 0:
        return np.empty(0)
    memory = (ctypes.c_double * array.length).from_address(ctypes.addressof(array.values.contents))
    memory.owner = handle
    view = np.frombuffer(memory, dtype=np.float64)
    view.flags.writeable = False
    return view
