"""The examples of docs/python.md run, one after the other as a reader would type them, and print what
the page shows."""

import contextlib
import io
import pathlib
import re

import matplotlib.pyplot as pyplot

ROOT = pathlib.Path(__file__).resolve().parents[2]


def blocks():
    """(code, what it prints or None) of the page."""
    page = (ROOT / "docs/python.md").read_text()
    pattern = r"```python\n(.*?)```(?:\s*```text\n(.*?)```)?"
    return re.findall(pattern, page, re.S)


def test_the_examples_print_what_the_page_shows(tmp_path, monkeypatch):
    monkeypatch.setattr(pyplot.Figure, "savefig", lambda *_, **__: None)
    names = {}
    shown = 0
    for code, expected in blocks():
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, "docs/python.md", "exec"), names)
        if expected:
            shown += 1
            assert printed.getvalue() == expected, code
        pyplot.close("all")
    assert shown >= 5


def test_the_page_names_every_function():
    import graze

    page = (ROOT / "docs/python.md").read_text()
    for name in graze.__all__:
        if name[0] != "_":
            assert f"`{name}" in page or f"graze.{name}" in page, name
