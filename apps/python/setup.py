"""The package by CMake: its compiled part in the release build of the checkout, of which nothing is
compiled again that is there. GRAZE_BUILD names another folder than build/."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("GRAZE_BUILD", ROOT / "build")).resolve()
SCRATCH = BUILD / "pip"  # instead of folders among the sources
SCRATCH.mkdir(parents=True, exist_ok=True)


class BuildByCMake(build_ext):
    def run(self) -> None:
        configure = ["cmake", "-S", str(ROOT), "-B", str(BUILD), "-DGRAZE_PYTHON=ON"]
        # That of a virtual environment is a link to the one that the compiled part is made for.
        configure.append(f"-DGRAZE_PYTHON_INTERPRETER={getattr(sys, '_base_executable', sys.executable)}")
        if not (BUILD / "CMakeCache.txt").exists():
            configure += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        subprocess.run(configure, check=True)
        targets = ["graze_python", "graze_python_package", "graze_python_stub"]
        subprocess.run(["cmake", "--build", str(BUILD), "--target", *targets], check=True)
        shutil.copytree(BUILD / "python/graze", pathlib.Path(self.build_lib) / "graze", dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("__pycache__"))


setup(
    version=re.search(r"project\(graze VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1),
    packages=[],
    ext_modules=[Extension("graze._core", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={
        "build": {"build_base": str(SCRATCH)},
        "egg_info": {"egg_base": str(SCRATCH)},
        "bdist_wheel": {"dist_dir": str(SCRATCH)},
    },
)
