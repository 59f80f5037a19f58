"""The snippets of docs/python.md run, in their order, in one room."""

import re
import warnings

import cromer
import pytest
from conftest import ROOT

pytest.importorskip("matplotlib").use("Agg")


def test_each_snippet_runs(monkeypatch):
    monkeypatch.chdir(ROOT)
    snippets = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "python.md").read_text(), re.S)
    assert len(snippets) >= 3
    room = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cromer.CromerWarning)
        for snippet in snippets:
            exec(snippet, room)
    assert room["fit"].succeeded


def test_every_verb_has_its_section_of_arguments():
    for verb in ("read", "fit", "fit_all", "simulate", "compare", "methods", "spectrum", "sweep"):
        said = getattr(cromer, verb).__doc__
        assert "Parameters\n----------" in said and "{options}" not in said, verb
