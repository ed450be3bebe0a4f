"""Maps: circuits, events and ways are the command's."""
import math
import pickle

import numpy as np
import pytest
import yoke
from conftest import answer, example


@pytest.mark.parametrize("name, over", [("non-grashof", "theta4"), ("four-bar", "theta4"), ("four-bar", None), ("jansen", None)])
def test_it_is_the_commands(name, over):
    told = answer("map", example(name), *(["--over", over] if over else []))
    found = yoke.load(example(name)).map(over)
    assert (found.coordinate, list(found.domain)) == (told["coordinate"], told["domain"])
    assert (found.complete, found.because) == (told["complete"], told["reason"])
    assert len(found.circuits) == len(told["circuits"]) > 0
    for mine, one in zip(found.circuits, told["circuits"]):
        assert mine.contains_start == one["contains_start"]
        assert [list(r) for r in mine.ranges] == one["ranges"]
        assert [(b.start, b.end, b.closed) for b in mine.branches] == [(p["from"], p["to"], p["closed"]) for p in one["parts"]]
        assert [(e.kind, e.at, e.of, e.branch + 1, e.coordinates) for e in mine.events] == [
            (e["kind"], e["at"], e["of"], e["branch"], e["coordinates"]) for e in one["events"]]
        assert {n: (t.full, list(t.range)) for n, t in mine.joints.items()} == {
            n: (t["full"], t["range"]) for n, t in one["joints"].items()}


def test_rows_of_branches_close_the_loop():
    m = yoke.load(example("non-grashof"))
    names, points = m.coordinates, list(m.points)
    for circuit in m.map("theta4").circuits:
        for branch in circuit.branches:
            assert branch.coordinates.shape == (len(branch.points), len(names)) and len(branch.points) > 10
            theta4 = branch.coordinates[:, names.index("theta4")]
            assert np.all(np.diff(theta4) > 0) and theta4[0] == pytest.approx(branch.start)
            where = {name: branch.points[:, points.index(name)] for name in points}
            pairs = [(a, b) for a in points for b in points if a < b and a.split(".")[0] == b.split(".")[0]]
            for a, b in pairs:  # bodies are rigid
                apart = np.hypot(*(where[a] - where[b]).T)
                assert np.ptp(apart) < 1e-9


def test_the_way_is_the_commands():
    m = yoke.load(example("non-grashof"))
    mapped = m.map("theta4")
    there = mapped.reach({"theta4": "110 deg"}, pose={"theta4": "200 deg", "theta2": m.map("theta4").circuits[0].branches[0]
                                                        .coordinates[5, m.coordinates.index("theta2")]})
    assert not there and there.reason  # no configuration has both
    told = answer("map", example("non-grashof"), "--over", "theta4", "--reach", "theta4=120deg")
    way = mapped.reach({"theta4": "120 deg"})
    assert told["reachable"] and way
    assert [list(pose.values()) for pose in way] == told["way"] and list(way[0]) == told["coordinates"]
    never = mapped.reach({"theta4": "90 deg"})
    assert not never and never.proved and "closes" in never.reason


def test_a_picture_and_a_pickle():
    mapped = yoke.load(example("four-bar")).map("theta4")
    svg = mapped.svg(trace=["coupler.P"])
    assert svg.startswith("<svg") and mapped._repr_svg_().startswith("<svg")
    again = pickle.loads(pickle.dumps(mapped))
    assert again.circuits[0].ranges == mapped.circuits[0].ranges and "theta4" in repr(again)


def test_what_cannot_be_mapped_is_refused():
    with pytest.raises(yoke.PoseError) as told:
        yoke.load(example("five-bar")).map()
    assert told.value.problems[0].code == "E0850" and "hold all inputs but one" in told.value.problems[0].hint
    assert yoke.load(example("five-bar")).map("theta1", at={"theta2": math.radians(50)}).complete
    m = yoke.load(example("four-bar"))
    with pytest.raises(yoke.UnknownName):
        m.map("nothing")
    with pytest.raises(yoke.RequestError):
        m.map("theta4", at={"theta4": 1.0})
    with pytest.raises(yoke.RequestError):
        m.map("theta4").reach({"theta2": 1.0})
    with pytest.raises(yoke.UnknownName):
        m.map("theta4").svg(trace=["coupler.nothing"])


# --- two freedoms

def test_regions_are_the_commands():
    told = answer("map", example("five-bar"), "--tol", "0.01")
    for over in None, "theta1,theta2", ["theta1", "theta2"]:
        found = yoke.load(example("five-bar")).regions(over, tolerance=0.01)
        assert (list(found.coordinates), [list(d) for d in found.domain]) == (told["coordinates"], told["domain"])
        assert (found.complete, found.because, list(found.tolerance)) == (told["complete"], told["reason"], told["tolerance"])
        assert found.proved == told["proved"] and len(found) == len(told["regions"]) > 0
        for mine, one in zip(found.regions, told["regions"]):
            assert (mine.configurations, mine.contains_start, mine.area) == (one["configurations"], one["contains_start"], one["area"])
            assert [b._asdict() for b in mine.bounds] == one["bounds"]
            assert [o.tolist() for o in mine.outlines] == [one["polygon"], *one.get("holes", [])]


def test_regions_count_configurations():
    m = yoke.load(example("five-bar"))
    found = m.regions()
    rng, checked = np.random.default_rng(5), 0
    for first, second in rng.uniform(-3, 3, (20, 2)):
        count, proved = found.at(first, second)
        if proved:
            checked += 1
            try:
                assert len(m.configurations(theta1=first, theta2=second)) == count
            except yoke.PoseError:
                assert count == 0
    assert checked > 10
    assert "<svg" in found._repr_svg_() and "five-bar" in repr(found).lower()
    again = pickle.loads(pickle.dumps(found))
    assert again.because == found.because and np.array_equal(again.regions[0].outlines[0], found.regions[0].outlines[0])


def test_what_has_no_regions_is_refused():
    five, four = yoke.load(example("five-bar")), yoke.load(example("four-bar"))
    for ask in (lambda: five.regions("theta1"), lambda: five.regions("theta1,theta2", at={"theta1": 1.0}),
                lambda: five.regions(tolerance=1.0), lambda: five.regions().at(100.0, 0.0), lambda: five.regions(["theta1", "theta1"])):
        with pytest.raises(yoke.RequestError):
            ask()
    with pytest.raises(yoke.UnknownName):
        five.regions("theta1,nothing")
    with pytest.raises(yoke.PoseError, match="two freedoms"):
        four.regions()
    with pytest.raises(yoke.PoseError, match="two freedoms"):
        five.regions(theta1=1.0)
