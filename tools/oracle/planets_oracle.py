#!/usr/bin/env python3
"""Expected answers for planets that share a load: `planets_oracle.py FOLDER` writes examples/expected/dynamics/planetary-gear.json.

Knows nothing of the library. Every planet is written out with forces of its own: Newton's and Euler's equations of three planets, the sun and
the arm, each planet with the same two tooth forces in its own directions. 40 digits.
"""
import json
import os
import sys

from mpmath import cos, fabs, mp, mpf, pi, sin, tan

mp.dps = 40
Zs, Zp, Zr, N = 20, 16, 52, 3
MODULE, G, LEAN = mpf(2) / 1000, mpf("9.81"), tan(20 * pi / 180)
R, RP, RS = MODULE * (Zs + Zp) / 2, MODULE * Zp / 2, MODULE * Zs / 2
M, J, LOAD = mpf("0.15"), mpf("20e-6"), mpf(25)
SUN, ARM = (mpf("0.4"), mpf("90e-6")), (mpf("0.6"), mpf("500e-6"))


def pose(theta, rate, accel):
    """The answers where the sun has this motion; the ring stands still, so that the arm turns by Zs / (Zs + Zr) of it."""
    ratio = mpf(Zs) / (Zs + Zr)
    phi, w, a = ratio * theta, ratio * rate, ratio * accel
    roll = 1 - mpf(Zr) / Zp  # the planet's turn for one of the arm, with the ring at rest
    spin, turn = roll * w, roll * a
    # Tangential tooth forces on each planet, inner and outer: J turn = RP (outer - inner), and of the arm, on which the planets'
    # weights have no moment together: ARM a = -LOAD - R (N M R a - N (inner + outer)).
    difference = J * turn / RP
    total = (ARM[1] * a + LOAD + N * M * R * R * a) / (N * R)
    inner, outer = (total - difference) / 2, (total + difference) / 2
    torque = SUN[1] * accel + N * RS * inner
    bearing = [mpf(0), ARM[0] * G]
    kinetic = (SUN[1] * rate**2 + ARM[1] * w**2) / 2
    potential = mpf(0)
    for k in range(N):
        at = phi + 2 * pi * k / N
        radial, across = (cos(at), sin(at)), (-sin(at), cos(at))
        by_sun = [inner * across[i] + fabs(inner) * LEAN * radial[i] for i in (0, 1)]
        by_ring = [outer * across[i] - fabs(outer) * LEAN * radial[i] for i in (0, 1)]
        moved = [M * R * (a * across[i] - w * w * radial[i]) for i in (0, 1)]
        pin = [moved[i] + (M * G if i else 0) - by_sun[i] - by_ring[i] for i in (0, 1)]
        bearing = [bearing[i] + pin[i] for i in (0, 1)]
        kinetic += (M * (R * w)**2 + J * spin**2) / 2
        potential += M * G * R * sin(at)
        if k == 0:
            first = {"P.force.x": pin[0], "P.force.y": pin[1], "inner.force.x": by_sun[0], "inner.force.y": by_sun[1],
                     "outer.force.x": -by_ring[0], "outer.force.y": -by_ring[1]}
    values = {"theta": theta, "phi": phi, "phi.accel": a, "planet.angle.accel": turn, "S.force.x": 0, "S.force.y": SUN[0] * G,
              "C.force.x": bearing[0], "C.force.y": bearing[1], "R.force.x": 0, "R.force.y": 0,
              "R.moment": N * (RP + R) * outer, "theta.effort": torque, "phi.effort": -LOAD, "kinetic": kinetic, "potential": potential}
    values.update(first)
    return {"at": {"theta": float(theta)}, "rate": {"theta": float(rate)}, "accel": {"theta": float(accel)},
            "expect": {name: float(value) for name, value in values.items()}, "tolerance": 1e-12}


def main():
    poses = [pose(mpf(t), mpf(w), mpf(a)) for t, w, a in (("0", "0", "0"), ("0.3", "150", "80"), ("2.5", "-90", "400"), ("-1", "10", "-9000"))]
    document = {"file": "planetary-gear.yaml", "source": "three planets written out, 40 digits", "angles": ["theta", "phi", "planet.angle"],
                "poses": poses}
    with open(os.path.join(sys.argv[1], "planetary-gear.json"), "w", encoding="utf-8") as file:
        json.dump(document, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
