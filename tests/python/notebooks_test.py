"""The notebooks of docs/notebooks run from their first cell to the last, wherever they are, and hold what
they show then."""

import json

import pytest
from notebook_run import BUILD, NOTEBOOKS, run


def words(cell):
    """What a cell shows but for pictures."""
    shown = []
    for output in cell.get("outputs", []):
        data = output.get("data", {})
        if "image/png" not in data:
            shown.append((output["output_type"], output.get("text"), data))
    return shown


@pytest.mark.parametrize("file", NOTEBOOKS, ids=[file.stem for file in NOTEBOOKS])
def test_a_notebook_shows_what_it_holds(file, monkeypatch, tmp_path):
    pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    monkeypatch.setenv("PYTHONPATH", str(BUILD / "python"))
    notebook, stored = run(file, tmp_path), nbformat.read(file, as_version=4)
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("text/html" in output.get("data", {}) for output in shown)
    for cell, before in zip(notebook.cells, stored.cells):
        assert words(cell) == words(before), cell.source
        for one in (cell, before):
            pictures = sum("image/png" in output.get("data", {}) for output in one.get("outputs", []))
            assert pictures == cell.source.count(".plot("), cell.source


def test_there_are_three_with_their_output():
    assert len(NOTEBOOKS) == 3
    for file in NOTEBOOKS:
        code = [cell for cell in json.loads(file.read_text())["cells"] if cell["cell_type"] == "code"]
        assert [cell["execution_count"] for cell in code] == list(range(1, len(code) + 1))
        assert file.stat().st_size < 600_000
