"""Runs the notebooks of docs/notebooks; as a program it stores them with what they show:
python3 tests/python/notebook_run.py"""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("GRAZE_BUILD", ROOT / "build"))
NOTEBOOKS = sorted((ROOT / "docs/notebooks").glob("*.ipynb"))


def run(file, folder):
    """The notebook as it is after a run from its first cell to the last, in that folder."""
    import nbclient
    import nbformat

    notebook = nbformat.read(file, as_version=4)
    client = nbclient.NotebookClient(
        notebook, timeout=300, kernel_name="python3", record_timing=False,
        resources={"metadata": {"path": str(folder)}},
    )
    client.execute()
    return notebook


if __name__ == "__main__":
    import nbformat

    os.environ["PYTHONPATH"] = str(BUILD / "python")
    for file in NOTEBOOKS:
        notebook = run(file, ROOT)
        notebook.metadata["language_info"] = {"name": "python"}
        file.write_text(nbformat.writes(notebook) + "\n")
        sys.stdout.write(f"{file.name}: {len(notebook.cells)} cells\n")
