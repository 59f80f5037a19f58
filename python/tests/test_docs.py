"""The Python snippets of the documentation run: those of a page in their order, in one room."""

import re
import shlex
import warnings

import cromer
import pytest
from conftest import ROOT

pytest.importorskip("matplotlib").use("Agg")


def blocks(page):
    return re.findall(r"```(\w+)\n(.*?)```", page.read_text(), re.S)


def writes_hdf5(block):
    """The commands of a shell block whose files the page goes on to open."""
    lines = re.sub(r"\s+#.*", "", block.replace("\\\n", " ")).splitlines()
    return [shlex.split(line)[1:] for line in lines if line.startswith("cromer ") and ".h5" in line]


PAGES = [page for page in sorted((ROOT / "docs").rglob("*.md")) if any(kind == "python" for kind, _ in blocks(page))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_each_snippet_runs(page, monkeypatch, tmp_path, program):
    (tmp_path / "data").symlink_to(ROOT / "data")
    monkeypatch.chdir(tmp_path)
    room = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cromer.CromerWarning)
        for kind, block in blocks(page):
            if kind == "sh":
                for command in writes_hdf5(block):
                    program(*command)
            elif kind == "python":
                exec(block, room)
    if page.stem == "python":
        assert room["fit"].succeeded


def test_every_verb_has_its_section_of_arguments():
    for verb in ("read", "fit", "fit_all", "simulate", "compare", "methods", "spectrum", "sweep"):
        said = getattr(cromer, verb).__doc__
        assert "Parameters\n----------" in said and "{options}" not in said, verb
        section = said.split("----------\n")[1].split("\n\n")[0].splitlines()
        margins = {len(line) - len(line.lstrip()) for line in section}
        assert margins == {0, 4}, verb
