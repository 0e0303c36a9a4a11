"""Pages of the site from those of the project: python3 pages.py ROOT FOLDER.

Copies docs, the pages beside it and the files that they link, with links as they are there; makes
thumbnails of the gallery, pages of the notebooks with what they show, and one of the public headers
of each room.
"""
import re
import shutil
import sys
from pathlib import Path

import nbconvert

LINK = re.compile(r"(\]\()(?!\w+://|#)([^)#\s]+)(#[^)]*)?\)")
# README.md by another name: beside index.md there can be none.
BESIDE = {"README.md": "graze.md", "CHANGELOG.md": "CHANGELOG.md", "CONTRIBUTING.md": "CONTRIBUTING.md"}


def titled(text, page):
    """Links that are named by a file are named by its title."""

    def name(match):
        title = re.search(r"^# (.*)$", (page.parent / match[1]).read_text(), flags=re.M)[1]
        return f"[{title}]({match[1]}{match[2] or ''})"

    return re.sub(r"\[[\w./]+\.md\]\(([\w./]+\.md)(#[^)]*)?\)", name, text)


def linked(text, page, root, folder):
    """The text of a page of the project with the links of the site; files that are linked are copied."""

    def link(match):
        target = (page.parent / match[2]).resolve()
        relative = target.relative_to(root)
        if relative.parts[0] == "docs":
            relative = Path(*relative.parts[1:])
            if relative.suffix == ".ipynb":
                relative = relative.with_suffix(".md")
        elif target.is_dir():
            return f"](#){{ title='{relative}' }}"
        elif str(relative) in BESIDE:
            relative = Path(BESIDE[str(relative)])
        else:
            (folder / relative).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(target, folder / relative)
        depth = len(page.relative_to(root).parts) - (2 if page.relative_to(root).parts[0] == "docs" else 1)
        return f"]({'../' * depth}{relative.as_posix()}{match[3] or ''})"

    return LINK.sub(link, text)


def thumbnails(text):
    """The gallery: each picture small, with its command behind it."""
    looks, first = text.index("## What looks how"), text.index("## A motion")
    boxes = []
    for part in re.split(r"\n(?=## )", text[first:]):
        title, rest = part.split("\n", 1)
        commands = re.findall(r"^    (build/graze .*)$", rest, flags=re.M)
        rest = re.sub(r"^    build/graze .*\n?", "", rest, flags=re.M).strip()
        hidden = "".join(f"\n\n<details markdown><summary>Command</summary>\n\n```\n{line}\n```\n\n</details>" for line in commands)
        boxes.append(f"<div markdown>\n\n{title}\n\n{rest}{hidden}\n\n</div>")
    grid = '<div class="thumbnails" markdown>\n\n' + "\n\n".join(boxes) + "\n\n</div>\n\n"
    return text[:looks] + grid + text[looks:first]


def write(folder, name, text):
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text)


def notebooks(root, folder):
    for notebook in sorted((root / "docs/notebooks").glob("*.ipynb")):
        text, resources = nbconvert.MarkdownExporter().from_filename(str(notebook))
        for name, content in resources["outputs"].items():
            text = text.replace(f"({name})", f"({notebook.stem}_{name})")
            (folder / "notebooks").mkdir(exist_ok=True)
            (folder / "notebooks" / f"{notebook.stem}_{name}").write_bytes(content)
        write(folder, f"notebooks/{notebook.stem}.md", text)


def headers(root, folder):
    """The public headers of each room: what stands above them as text, and what they declare."""
    rooms = {}
    for header in sorted((root / "lib/graze").rglob("*.hpp")):
        if "detail" not in header.parts:
            rooms.setdefault(header.relative_to(root / "lib/graze").parts[0], []).append(header)
    names = ["# C++ interface\n\nThe public headers, room by room; [library.md](../library.md) says which holds what.\n"]
    for room, list_of_room in rooms.items():
        names.append(f"- [{room}]({room}.md): {len(list_of_room)} headers")
        parts = [f"# {room}\n"]
        for header in list_of_room:
            text = header.read_text()
            above, _, below = text.partition("#pragma once")
            words = " ".join(line.removeprefix("//").strip() or "\n\n" for line in above.strip().split("\n"))
            words = words.replace("<", "&lt;")
            declared = re.sub(r"^#include .*\n+", "", below.strip(), flags=re.M)
            path = header.relative_to(root / "lib")
            parts.append(f"## {path.relative_to(f'graze/{room}')}\n\n`#include \"{path}\"`\n\n{words}\n\n"
                         f"```cpp\n{declared}\n```\n")
        write(folder, f"api/{room}.md", "\n".join(parts))
    write(folder, "api/index.md", "\n".join(names) + "\n")


def main(root, folder):
    shutil.copytree(root / "docs", folder, ignore=shutil.ignore_patterns("site*", "*.sh", "*.ipynb", "*.gp*"))
    pages = [page for page in (root / "docs").rglob("*.md")] + [root / name for name in BESIDE]
    for page in pages:
        text = linked(titled(page.read_text(), page), page, root, folder)
        if page.name == "gallery.md":
            text = thumbnails(text)
        name = page.relative_to(root / "docs") if "docs" in page.relative_to(root).parts else BESIDE[page.name]
        write(folder, name, text)
    notebooks(root, folder)
    headers(root, folder)
    shutil.copytree("/usr/share/javascript/katex", folder / "katex", ignore=shutil.ignore_patterns("*.mjs", "katex.js", "katex.css"))
    for name in ("site.css", "site.js"):
        shutil.copy(root / "docs/site" / name, folder)


main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]))
