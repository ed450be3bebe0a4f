"""Synthesis: candidates are the command's, each loads, and a picture and a pickle hold them."""
import pickle
from pathlib import Path

import numpy as np
import pytest
import yoke
from conftest import ROOT, answer

TASKS = ROOT / "examples" / "tasks"


@pytest.mark.parametrize("name", ["five-positions", "power-function", "quick-rocker", "two-positions"])
def test_it_is_the_commands(name):
    told, found = answer("synthesize", TASKS / f"{name}.yaml"), yoke.synthesize(TASKS / f"{name}.yaml")
    assert (found.task, found.kind, found.seed) == (told["task"], told["synthesis"], told["seed"])
    assert (found.complete, found.left_out) == (told["complete"], told["left_out"])
    assert found.solutions == ((told["solutions"]["complex"], told["solutions"]["real"]) if "solutions" in told else None)
    assert len(found) == len(told["candidates"]) > 0 and len(found.dyads) == len(told["dyads"])
    for mine, one in zip(found, told["candidates"]):
        assert (mine.model, mine.mechanism, mine.type) == (one["model"], one["mechanism"], one["type"])
        assert (mine.error, mine.worst, mine.parameters) == (one["error"], one["worst"], one["parameters"])
    for mine, one in zip(found.dyads, told["dyads"]):
        assert (mine.kind, list(mine.fixed), list(mine.moving)) == (one["kind"], one["fixed"], one["moving"])


def test_a_candidate_goes_through_its_positions():
    found = yoke.synthesize(TASKS / "five-positions.yaml")
    assert found.solutions == (4, 4) and sum(found.left_out.values()) == len(found.defects) == 3
    for one in found:
        m = one.machine()
        assert m.freedom == 1 and one.defect is None
        table = m.sweep(**{m.inputs[0]: (0, 360, "deg")}, steps=20) if "crank" in one.type else None
        assert table is None or len(table) > 1
        assert one.curve.ndim == 2 and one.curve.shape[1] == 2 and np.all(np.isfinite(one.curve))
    assert {one.defect for one in found.defects} == {"branch"}


def test_an_offset_belongs_to_a_slider():
    """A crank r and a rod l carry a slider whose line is e off the pivot between sqrt((l - r)^2 - e^2) and sqrt((l + r)^2 - e^2)."""
    told = answer("synthesize", TASKS / "quick-slider.yaml")["candidates"]
    for one, same in zip(yoke.synthesize(TASKS / "quick-slider.yaml"), told, strict=True):
        _, r, l, _ = one.lengths
        assert one.offset == same["lengths"]["offset"] > 0
        assert abs(np.sqrt((l + r) ** 2 - one.offset ** 2) - np.sqrt((l - r) ** 2 - one.offset ** 2) - 0.1) < 1e-12
    assert {one.offset for one in yoke.synthesize(TASKS / "quick-rocker.yaml")} == {None}


def test_a_task_as_text_and_its_seed():
    text = Path(TASKS / "four-positions.yaml").read_text()
    first, again, other = yoke.synthesize(text), yoke.synthesize(text), yoke.synthesize(text, seed=2, best=3)
    assert [one.model for one in first] == [one.model for one in again]
    assert len(other) <= 3 and other.seed == 2
    assert [one.model for one in other] != [one.model for one in first][:3]
    kept = pickle.loads(pickle.dumps(first))
    assert [one.model for one in kept] == [one.model for one in first] and kept.left_out == first.left_out
    assert first._repr_svg_().startswith("<svg") and "machines" in repr(first)


def test_a_wrong_task_is_told_with_its_place():
    with pytest.raises(yoke.TaskError) as told:
        yoke.synthesize("name: wrong\nsynthesis: nothing\n")
    assert told.value.problems[0].line == 2 and told.value.problems[0].code == "E0840"
    with pytest.raises(yoke.RequestError):
        yoke.synthesize(TASKS / "two-positions.yaml", seed=0)
    with pytest.raises(yoke.TaskError):
        yoke.synthesize("/nowhere/task.yaml")


def test_progress_is_told_and_can_end_it():
    parts = []

    def stop(part):
        parts.append(part)
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        yoke.synthesize(TASKS / "arc-at-angles.yaml", progress=stop)
    assert parts
