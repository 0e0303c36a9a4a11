"""The notebooks of docs/notebooks run from their first cell to the last, and keep no output."""

import json

import pytest
from conftest import BUILD, ROOT

NOTEBOOKS = sorted((ROOT / "docs/notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("file", NOTEBOOKS, ids=[file.stem for file in NOTEBOOKS])
def test_a_notebook_runs(file, monkeypatch):
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    monkeypatch.setenv("PYTHONPATH", str(BUILD / "python"))
    notebook = nbformat.read(file, as_version=4)
    nbclient.NotebookClient(
        notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(file.parent)}}
    ).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("text/html" in output.get("data", {}) for output in shown)
    for cell in notebook.cells:
        pictures = sum("image/png" in output.get("data", {}) for output in cell.get("outputs", []))
        assert pictures == cell.source.count(".plot("), cell.source


def test_there_are_three_without_output():
    assert len(NOTEBOOKS) == 3
    for file in NOTEBOOKS:
        for cell in json.loads(file.read_text())["cells"]:
            assert not cell.get("outputs") and cell.get("execution_count") is None
