"""All configurations: names, order and proof are the command's, and a name takes its configuration."""
import pickle

import pytest
import yoke
from conftest import answer, example


@pytest.mark.parametrize("name", ["double-butterfly", "four-bar-at-rest", "stephenson-awkward", "geared-five-bar"])
def test_they_are_the_commands(name):
    told, found = answer("solve", example(name), "--all"), yoke.load(example(name)).configurations()
    assert [pose.label for pose in found] == [one["label"] for one in told["configurations"]]
    assert [pose.is_start for pose in found] == [one["is_start"] for one in told["configurations"]]
    assert (found.complete, found.reason) == (told["complete"], told["reason"])
    assert found.because == told["because"]
    for pose, one in zip(found, told["configurations"]):
        for coordinate, motion in one["coordinates"].items():
            assert pose.coordinates[coordinate].position == motion["position"]


def test_a_name_takes_its_configuration_and_stays_with_it():
    m = yoke.load(example("double-butterfly"))
    names = [pose.label for pose in m.configurations()]
    assert len(set(names)) == len(names) == 8 and "DW+.3" in names
    for name in names:
        here, moved = m.solve(assembly=name), m.solve(assembly=name, **{"lambda": 1e-3})
        assert here.label == moved.label == name
        assert abs(here.coordinates["omega"].position - moved.coordinates["omega"].position) < 0.1
    assert m.solve().label == answer("solve", example("double-butterfly"))["configurations"][0]["label"]


def test_the_list_is_pickled_with_its_proof():
    found = yoke.load(example("double-butterfly")).configurations()
    again = pickle.loads(pickle.dumps(found))
    assert again.complete and again.reason == "counted" and again.because == found.because
    assert [pose.label for pose in again] == [pose.label for pose in found]
