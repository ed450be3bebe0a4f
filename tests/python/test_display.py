"""What notebooks show: drawings, formulas, tables; and the tables of the command."""
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
import yoke
from conftest import command, example


def test_a_pose_prints_the_tables_of_the_command():
    for name in ("slider-crank", "quick-return", "toggle", "four-bar", "double-pendulum", "excavator", "jansen"):
        told = command("solve", example(name)).stdout
        for table in yoke.load(example(name)).solve().table().split("\n\n"):
            assert table in told, name


def test_tables_take_units(crank):
    lines = crank.solve(theta="90 deg").table("cm", "rad").splitlines()
    assert lines[0].split()[1:3] == ["position", "[rad]"] and "theta (input)" in lines[1] and "1.5708" in lines[1]
    assert any("[cm/s^2]" in line for line in lines)
    with pytest.raises(yoke.RequestError):
        crank.solve().table("kg")


def test_drawings_are_svg(crank):
    assert crank.animation()._repr_svg_() == crank.animation()
    for svg in (crank._repr_svg_(), crank.solve(theta=1.0).svg(width=300, labels=False), crank.animation()):
        assert ElementTree.fromstring(svg).tag.endswith("svg")


def test_rows_and_poses_are_html(crank):
    t = crank.sweep(theta=(0, 360, "deg"), steps=100, of=["s", "s.rate"])
    html = t._repr_html_()
    assert ElementTree.fromstring(html).tag == "table" and html.count("<tr>") == 21 and "[mm]" in html
    assert "theta [deg]" in t.text() and t.text().count("\n") == 101
    assert "<table>" in crank.solve()._repr_html_()


def test_formulas_are_latex():
    page = yoke.load(example("double-pendulum")).derive("lagrange")
    assert page._repr_latex_().startswith("$$") and page._repr_latex_().count("$$") == 2 * len(page.formulas())
    # long formulas are broken over lines in the document
    assert sum(formula in page.latex() for formula in page.formulas()) > len(page.formulas()) / 2
    assert page.text() == str(page) and page.json()["sections"][0]["name"] == "lagrange"
    assert page.mathml().startswith("<!DOCTYPE html>") and "double" in page.c()


def test_equations_are_those_of_the_command():
    for format_, ask in (("text", "text"), ("latex", "latex"), ("c", "c"), ("mathml", "mathml")):
        told = command("derive", example("quick-return"), "--what", "loops,jacobian", "--format", format_).stdout
        assert getattr(yoke.load(example("quick-return")).derive("loops,jacobian"), ask)() == told


def test_code_is_that_of_the_command(tmp_path):
    path = yoke.load(example("quick-return")).code(tmp_path / "q.c")
    assert path.read_text() == command("code", example("quick-return")).stdout


def test_a_report_tells_what_the_command_tells(crank, crank_file, tmp_path):
    command("report", crank_file, "-o", tmp_path / "c.html")
    assert crank.report() == (tmp_path / "c.html").read_text()


def test_a_verdict_shows_where_it_is_false():
    v = yoke.load(example("quick-return")).check("d3 = l1")
    assert v.verdict == "false" and not v and v.left != v.right and set(v.pose) and "false" in repr(v)
    assert yoke.load(example("quick-return")).check("l1*cos(theta1) = d3*cos(theta2)")


def test_pandas_is_asked_only_where_it_is_used(crank):
    t = crank.sweep(theta=(0, 1), steps=3, of=["s"])
    try:
        import pandas
    except ImportError:
        with pytest.raises(ImportError):
            t.to_pandas()
    else:
        assert isinstance(t.to_pandas("theta"), pandas.DataFrame)


def test_tables_are_arrays(crank):
    t = crank.sweep(theta=(0, 1), steps=10, of=["s"])
    assert type(t["s"]) is np.ndarray and type(t[2:4]) is yoke.Table and t[3]["s"] == t["s"][3]
    assert t[t["theta"] > 0.5].columns == t.columns and np.array_equal(np.sort(t, order="s"), t[np.argsort(t["s"])])
    assert t.copy().status == "ok" and t[:0].text()
