"""Builds the wheel; all but the extension module and the version is in pyproject.toml."""
import os
import re
import sys
from pathlib import Path

from setuptools import setup
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "native"))
from build_native import INCLUDE  # noqa: E402


class StableWheel(bdist_wheel):
    """Names the wheel for every Python from 3.9, since the module uses only the stable interface."""

    def get_tag(self):
        _, _, platform = super().get_tag()
        return "cp39", "abi3", platform


version = re.search(r'YOKE_VERSION_STRING "(.*)"', (INCLUDE / "yoke" / "version.h").read_text())
os.chdir(HERE)
setup(version=version[1], cffi_modules=["native/build_native.py:ffibuilder"], cmdclass={"bdist_wheel": StableWheel})
