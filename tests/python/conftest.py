"""Shared by the tests of the Python package: a machine, the examples, and the command beside it."""
from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest
import yoke

ROOT = Path(os.environ["YOKE_ROOT"])
COMMAND = os.environ["YOKE_COMMAND"]

CRANK = """\
parameters: {r: 50 mm, l: 180 mm}
gravity: [0, -9.81 m/s^2]
bodies:
  ground: {points: {O: [0, 0]}}
  crank:  {points: {O: [0, 0], A: [r, 0]}, mass: 0.4 kg, rod: [O, A]}
  rod:    {points: {A: [0, 0], B: [l, 0]}, mass: 0.6 kg, rod: [A, B]}
  piston: {points: {B: [0, 0]}, mass: 0.5 kg}
joints:
  O: {pin: [ground, crank], angle: theta}
  A: {pin: [crank, rod], angle: phi}
  B: {pin: [rod, piston]}
  S: {slide: [ground, piston], along: x, distance: s}
start: {theta: 60 deg, phi: -75 deg, s: 200 mm, theta.rate: 3 rad/s}
units: {length: mm, angle: deg}
"""


def command(*words: object) -> "subprocess.CompletedProcess[str]":
    """Runs the command."""
    return subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True)


def answer(*words: object):
    """Returns what the command answers as JSON."""
    return json.loads(command(*words, "--format", "json").stdout)


@pytest.fixture
def crank_file(tmp_path: Path) -> Path:
    path = tmp_path / "crank.yaml"
    path.write_text(CRANK)
    return path


@pytest.fixture
def crank(crank_file: Path) -> yoke.Machine:
    return yoke.load(crank_file)


def example(name: str) -> Path:
    return ROOT / "examples" / f"{name}.yaml"


def examples() -> "list[Path]":
    return sorted((ROOT / "examples").glob("*.yaml"))
