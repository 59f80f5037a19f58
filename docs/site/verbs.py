"""The docstrings of Python's verbs as `help` shows them: with the options of the program's tables."""

import inspect

import cromer
import griffe


class Verbs(griffe.Extension):
    def on_function(self, *, func, **_):
        if func.docstring and "{options}" in func.docstring.value:
            func.docstring.value = inspect.cleandoc(getattr(cromer, func.name).__doc__)
