"""Yoke in Python: planar machines - linkages, gears and cams - from a file or from calls.

    import yoke
    m = yoke.load("crank.yaml", r="60 mm")
    m.solve(theta="30 deg").coordinates["s"].position
    m.sweep(theta=(0, 360, "deg"), steps=360, of=["s", "s.rate"])

All answers are in SI and radians.
"""
from __future__ import annotations

from ._answers import Effort, Energy, Motion, PointMotion, Reaction
from ._batch import Columns
from ._configurations import Configurations
from ._designs import Distribution, normal, tolerance, triangular, uniform
from ._equations import Equations, Verdict, sections
from ._machine import Machine, load, parse
from ._many import Simulations
from ._map import Branch, Circuit, Map, MapEvent, Way
from ._regions import Bound, Region, Regions
from ._native import ffi as _ffi
from ._native import lib as _lib
from ._pose import Pose, Svg
from ._problems import (
    ClosedError, Error, ModelError, PoseError, Problem, RequestError, UnknownName, YokeWarning, explain,
)
from ._simulation import Simulation, Summary
from ._study import Sensitivities
from ._synthesis import Candidate, Dyad, Synthesis, TaskError, synthesize
from ._table import Column, Event, Table
from .environment import Environment

__version__: str = _ffi.string(_lib.yk_version()).decode()
if __version__ != _ffi.string(_lib.YOKE_VERSION_STRING).decode():
    raise ImportError(f"yoke was built for libyoke {_ffi.string(_lib.YOKE_VERSION_STRING).decode()}, "
                      f"and {__version__} is installed: build it again")

__all__ = [
    "Bound", "Branch", "Candidate", "Circuit", "ClosedError", "Column", "Columns", "Configurations", "Distribution", "Dyad",
    "Effort", "Energy", "Environment", "Equations", "Error", "Event", "Machine", "Map", "MapEvent", "ModelError",
    "Motion", "PointMotion", "Pose", "PoseError", "Problem", "Reaction", "Region", "Regions", "RequestError", "Sensitivities",
    "Simulation", "Simulations", "Summary", "Svg", "Synthesis", "Table", "TaskError", "UnknownName", "Verdict",
    "Way", "YokeWarning", "explain", "load", "normal", "parse", "sections", "synthesize", "tolerance", "triangular",
    "uniform",
]
