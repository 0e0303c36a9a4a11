"""Command lines of the program as calls of the package."""

import os
import pathlib
import shlex

import graze

ROOT = pathlib.Path(__file__).resolve().parents[2]


def battery():
    """(name, words) of tests/results/commands.txt."""
    rows = []
    for line in (ROOT / "tests/results/commands.txt").read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        name, command = (cell.strip() for cell in line.split("|"))
        words = [
            word.replace("S/", "data/scenes/", 1) if word.startswith("S/")
            else word.replace("M/", "data/measurements/", 1) if word.startswith("M/")
            else word
            for word in shlex.split(command)
        ]
        if words[0] == "simulate":  # what a picture shows is chosen after the run
            for option in ("--show", "--shapes-at"):
                if option in words:
                    at = words.index(option)
                    del words[at : at + 2]
        rows.append((name, words))
    return rows


def options_of(command):
    """What the program says of the options of a command, by their names with dashes."""
    return {option["name"].replace("_", "-"): option for option in graze._core.options(command)}


def call(words):
    """Calls the function that the words are a command line of."""
    command, files, keywords = words[0], [], {}
    known = options_of(command)
    rest = list(words[1:])
    while rest:
        word = rest.pop(0)
        if not word.startswith("--"):
            files.append(word)
            continue
        name, _, value = word[2:].partition("=")
        if known[name]["kind"] == "flag":
            keywords[keyword(name)] = True
            continue
        value = value or rest.pop(0)
        if known[name]["repeated"]:
            before = keywords.get(keyword(name), [])
            keywords[keyword(name)] = (before if isinstance(before, list) else [before]) + [value]
        else:
            keywords[keyword(name)] = value
    return function_of(command, keywords)(*files, **keywords)


def keyword(option):
    name = option.replace("-", "_")
    return name + "_" if name == "from" else name


def function_of(command, keywords):
    if command == "continue":
        return graze.loci if "locus" in keywords else graze.continue_
    return getattr(graze, command)


def is_slow(words):
    return os.environ.get("GRAZE_LONG") is None and words[0] in (
        "continue", "diagram", "map", "compare", "cost",
    )
