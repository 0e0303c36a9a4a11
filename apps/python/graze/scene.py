"""Scenes: what is simulated."""

from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Union

from . import _core
from .errors import OptionError, SceneError

Settings = Union[None, str, Sequence[str], Mapping[str, Any]]


class Scene:
    """A structure, its stops, its forcing. Made by `Scene.load`, `Scene.parse` or
    `Scene.from_dict`; it is never changed, `changed` makes another one."""

    def __init__(self, named: "_core.NamedScene") -> None:
        self._named = named

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"], set: Settings = None) -> "Scene":
        """Reads a scene file (TOML). `set` replaces or adds keys: {"stop.gap": 2e-3}, or
        "stop.gap=2e-3", or a list of such. Raises SceneError and FileError."""
        return cls(_of_scene(_core.load_scene, os.fspath(path), settings_of(set)))

    @classmethod
    def parse(cls, text: str, name: str = "scene", set: Settings = None) -> "Scene":
        """The same for TOML text. `name` stands for the file in messages; files that the scene
        names are looked for beside it."""
        return cls(_of_scene(_core.parse_scene, text, name, settings_of(set)))

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any], name: str = "scene", set: Settings = None) -> "Scene":
        """The same for nested dicts and lists as tomllib.load() gives them."""
        return cls.parse(toml_text(tables), name, set)

    def changed(self, set: Settings) -> "Scene":
        """The scene with keys replaced or added by their names: scene.changed({"stop.gap": 2e-3})."""
        return Scene(_of_scene(self._named.changed, settings_of(set)))

    def __getitem__(self, name: str) -> float:
        """The value of a parameter by its name, in its own unit: scene["forcing.frequency"]."""
        value = self._named.value(name)
        if value is None:
            raise KeyError(name)
        return value

    @property
    def parameters(self) -> Dict[str, float]:
        """All continuous parameters by their names, each in its own unit."""
        return self._named.parameters()

    def unit(self, name: str) -> str:
        """"rad/s", "m", .. of a parameter; "" of a pure number."""
        return self._named.unit(name)

    @property
    def title(self) -> str:
        return self._named.title

    @property
    def name(self) -> str:
        """The file, or what stands for it."""
        return self._named.name

    @property
    def modes(self) -> int:
        """Number of modes of the structure."""
        return self._named.modes

    @property
    def is_forced(self) -> bool:
        return self._named.is_forced

    @property
    def stops(self) -> int:
        """Number of stops."""
        return self._named.stops

    def to_toml(self) -> str:
        """The scene in force as TOML that reads back to the same values."""
        return self._named.text

    def __repr__(self) -> str:
        return f"<graze.Scene {self.name!r}: {self.title or 'without title'}>"

    def _repr_html_(self) -> str:
        from .table import html_rows

        rows = [(name, value, self.unit(name)) for name, value in self.parameters.items()]
        return html_rows(self.title or self.name, ("parameter", "value", "unit"), rows)


SceneLike = Union[Scene, str, "os.PathLike[str]", Mapping[str, Any]]


def scene_from(scene: SceneLike, set: Settings = None) -> Scene:
    """A scene, a file of one, or a dict of one, with keys replaced."""
    if isinstance(scene, Scene):
        return scene.changed(set) if set else scene
    if isinstance(scene, (str, os.PathLike)):
        return Scene.load(scene, set)
    if isinstance(scene, Mapping):
        return Scene.from_dict(scene, set=set)
    raise TypeError(f"a scene is a graze.Scene, a file or a dict, not {type(scene).__name__}")


def _of_scene(read: Callable[..., "_core.NamedScene"], *given: Any) -> "_core.NamedScene":
    """What is read; whatever is wrong then is wrong with the scene."""
    try:
        return read(*given)
    except OptionError as error:
        raise SceneError(str(error)) from None


def settings_of(set: Settings) -> List[str]:
    """As the program's --set takes them."""
    if set is None:
        return []
    if isinstance(set, str):
        return [set]
    if isinstance(set, Mapping):
        return [f"{name}={toml_value(value)}" for name, value in set.items()]
    settings = list(set)
    if not all(isinstance(setting, str) for setting in settings):
        raise TypeError('set is a dict {"stop.gap": 2e-3}, or "stop.gap=2e-3", or a list of such')
    return settings


def toml_value(value: Any) -> str:
    """A value as TOML writes it on one line."""
    if hasattr(value, "tolist"):  # NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        inside = ", ".join(f"{_key(key)} = {toml_value(entry)}" for key, entry in value.items())
        return "{" + inside + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_value(entry) for entry in value) + "]"
    raise SceneError(f"a scene holds numbers, words, lists and tables, not {type(value).__name__}")


def toml_text(tables: Mapping[str, Any]) -> str:
    """Nested dicts as TOML."""
    plain = {name: value for name, value in tables.items() if not _is_tables(value)}
    lines = [f"{_key(name)} = {toml_value(value)}" for name, value in plain.items()]
    for name, value in tables.items():
        if isinstance(value, Mapping):
            lines += _table(f"[{_key(name)}]", value)
        elif name not in plain:
            for entry in value:
                lines += _table(f"[[{_key(name)}]]", entry)
    return "\n".join(lines) + "\n"


def _is_tables(value: Any) -> bool:
    is_list = isinstance(value, (list, tuple)) and len(value) > 0
    return isinstance(value, Mapping) or (is_list and all(isinstance(v, Mapping) for v in value))


def _table(heading: str, table: Mapping[str, Any]) -> List[str]:
    return [heading] + [f"{_key(key)} = {toml_value(value)}" for key, value in table.items()]


def _key(name: Any) -> str:
    return json.dumps(str(name), ensure_ascii=False)
