#!/usr/bin/env python3
"""Expected answers for the cams of the gallery: `cam_oracle.py FOLDER` writes examples/expected/cams/*.json.

Knows nothing of the library: laws are written out as formulas, curves are differentiated numerically with 60 digits, the roller's place
comes from triangles, the surface from the pitch curve's normal, a flat face's surface from its lines' intersections in the limit.
"""
import json
import os
import sys

from mpmath import acos, atan2, cos, diff, exp, findroot, j as i, mp, mpf, pi, sin, sqrt

mp.dps = 60
DEG = pi / 180


def cycloidal(u):
    return u - sin(2 * pi * u) / (2 * pi)


def poly345(u):
    return u**3 * (10 - 15 * u + 6 * u * u)


def modified_sine(u):
    """scca 1/4, 0, 3/4: Norton's closed form."""
    k = 1 / (4 + pi)
    if u < mpf(1) / 8:
        return k * (pi * u - sin(4 * pi * u) / 4)
    if u <= mpf(7) / 8:
        return k * (2 + pi * u - mpf(9) / 4 * sin(pi / 3 + 4 * pi * u / 3))
    return k * (4 + pi * u - sin(4 * pi * u) / 4)


def single_polynomial(u):
    return 64 * u**3 * (1 - u)**3


def program(parts):
    """parts: (from, to, function of u in [0, 1]), angles in degrees; 0 elsewhere."""
    def lift(x):
        for begin, end, function in parts:
            if begin * DEG <= x < end * DEG:
                return function((x - begin * DEG) / ((end - begin) * DEG))
        return mpf(0)
    return lift


def up_down(h, rise, top, fall, rise_law, fall_law):
    return program([(0, rise, lambda u: h * rise_law(u)), (rise, top, lambda u: h),
                    (top, fall, lambda u: h * (1 - fall_law(u)))])


def roller_row(center, roller, direction, x):
    """The row at cam angle x: center(x) in the carrier, direction(x) in which a growing lift leads."""
    def curve(t):
        return exp(-i * t) * center(t)
    c, d1, d2 = curve(x), diff(curve, x), diff(curve, x, 2)
    normal = i * d1 / abs(d1)
    curvature = -(d1.conjugate() * d2).imag / abs(d1)**3
    surface = c - roller * normal
    push = exp(i * x) * normal
    angle = atan2((direction(x).conjugate() * push).imag, (direction(x).conjugate() * push).real)
    row = {"pressure_angle": angle, "x": surface.real, "y": surface.imag, "pitch.x": c.real, "pitch.y": c.imag}
    if abs(curvature * c) > mpf(10)**-20:  # not on a straight flank
        row.update({"pitch_radius": 1 / curvature, "surface_radius": 1 / curvature - roller})
    return row


def flat_row(distance, x):
    """The face y = distance(x) of the carrier; two near faces meet in the contact, in the limit."""
    h, slope, bend = distance(x), diff(distance, x), diff(distance, x, 2)
    contact = exp(-i * x) * (slope + i * h)
    return {"pressure_angle": mpf(0), "surface_radius": h + bend, "x": contact.real, "y": contact.imag, "reach": slope}


def slide(lift, base, roller, offset=mpf(0)):
    start = sqrt((base + roller)**2 - offset**2)
    return lambda x: roller_row(lambda t: offset + i * (start + lift(t)), roller, lambda t: i, x)


def swing(lift, base, roller, pivot, arm):
    distance = base + roller

    def off(psi):
        return abs(pivot + arm * exp(i * psi)) - distance
    gamma = atan2(pivot.imag, pivot.real)
    start = findroot(off, (gamma + pi, gamma + 2 * pi), solver="anderson")
    return lambda x: roller_row(lambda t: pivot + arm * exp(i * (start + lift(t))), roller,
                                lambda t: i * exp(i * (start + lift(t))), x)


def between_two_discs(base, nose, apart, axis, roller):
    """A roller above the hull of two discs, which is the union of the discs between them; the nearest one is found from its slope."""
    k = (base - nose) / apart
    slope = k / sqrt(1 - k * k)

    def gap(at):
        u, v = (at * exp(-i * axis)).real, abs((at * exp(-i * axis)).imag)
        share = min(max((u - v * slope) / apart, mpf(0)), mpf(1))
        return abs(u - share * apart + i * v) - (base + share * (nose - base))

    def lift(x):
        return findroot(lambda y: gap(i * y * exp(-i * x)) - roller, (base + roller, base + roller + apart), solver="anderson") - base - roller
    return lift


def document(name, cam, lift, row, angles):
    rows = []
    for degrees in angles:
        x = degrees * DEG
        entry = {"angle": x, "s": lift(x), "v": diff(lift, x), "a": diff(lift, x, 2), "j": diff(lift, x, 3)}
        entry.update(row(x))
        rows.append({key: float(value) for key, value in entry.items()})
    return {"file": name + ".yaml", "cam": cam, "tolerance": 1e-11, "rows": rows}


def documents():
    mm = mpf(1) / 1000
    cep = program([(0, 240, lambda u: mpf(20) / 100 * single_polynomial(u))])
    yield "cep-cam", "valve", cep, slide(cep, 60 * mm, 10 * mm)
    valve = program([(0, 120, lambda u: 9 * mm * single_polynomial(u))])
    yield "valve-cam", "intake", valve, slide(valve, 17 * mm, 8 * mm)
    inch = mpf(254) / 10 * mm
    disc = up_down(inch, 90, 180, 270, cycloidal, cycloidal)
    yield "flat-faced-cam", "disc", disc, lambda x: flat_row(lambda t: mpf(1893) / 1000 * inch + disc(t), x)
    fourier = lambda x: 12 * mm * (3 - 4 * cos(x) + cos(2 * x)) / 8
    yield "formula-cam", "heart", fourier, slide(fourier, 30 * mm, 6 * mm, 4 * mm)
    tangent = between_two_discs(20 * mm, 6 * mm, 26 * mm, pi / 2 - acos(mpf(14) / 26), 15 * mm)
    yield "arc-cam", "inlet", tangent, slide(tangent, 20 * mm, 15 * mm)
    rocker = up_down(20 * DEG, 120, 160, 280, modified_sine, poly345)
    yield "swing-cam", "rocker-cam", rocker, swing(rocker, 45 * mm, 10 * mm, -90 * mm + i * 40 * mm, sqrt(mpf(90)**2 + 15**2) * mm)


def main():
    folder = sys.argv[1]
    angles = [7, 20, 35, 50, 65, 80, 100, 110, 130, 150, 170, 195, 200, 220, 235, 250, 265, 285, 300, 350]
    for name, cam, lift, row in documents():
        with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as file:
            json.dump(document(name, cam, lift, row, angles), file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
