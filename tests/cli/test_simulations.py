"""Motion in time, as `simulate` gives it: against an independent integration, published references, closed forms."""
import math
import os
import subprocess
import sys
import unittest

from forces import Machine, documents, example, published
from harness import ROOT

CASES = published()
ANDREWS = ("beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon")


class Oracle(Machine):
    """Every motion of examples/expected/dynamics."""

    def test_every_motion_agrees_with_the_oracle(self):
        count = 0
        for document in documents():
            for simulation in document.get("simulations", []):
                with self.subTest(file=document["file"]):
                    rows, of = simulation["rows"], simulation["of"]
                    table = self.simulate(example(document["file"][:-5]), simulation["to"], simulation["to"] / (len(rows) - 1), of,
                                          tol=simulation["tol"])
                    for row in rows:
                        got = table.at(row[0])
                        for name, want in zip(of, row[1:]):
                            self.near(got[name], want, simulation["tolerance"], "%s at t = %g" % (name, row[0]))
                    count += 1
        self.assertGreaterEqual(count, 13)


class Andrews(Machine):
    def test_reference_state(self):
        case = CASES["AND-1"]
        want = {row[0]: float(row[1]) for row in case["check"]["quad_t_0_03"]["rows"]}
        of = [name + suffix for suffix in ("", ".rate", ".accel") for name in ANDREWS]
        of += [joint + ".force." + axis for joint in ("E2", "E4", "E6") for axis in "xy"] + ["energy"]
        table = self.simulate(example("andrews"), 0.03, 0.03, of, tol=1e-12)
        got = table.at(0.03)
        for name in ANDREWS:
            self.near(got[name], want[name], 1e-10, name)
            self.near(got[name + ".rate"], want[name + "'"], 1e-9, name + "'")
            self.near(got[name + ".accel"], want[name + "''"], 1e-8, name + "''")
        # Their loops all close at K2, our pins at K3: what K2 gives to K3 is the sum of the three.
        for k, axis in ((1, "x"), (2, "y")):
            self.near(got["E2.force." + axis], sum(want["lambda%d" % (k + m)] for m in (0, 2, 4)), 1e-8, "E2")
            self.near(got["E4.force." + axis], -want["lambda%d" % (k + 2)], 1e-8, "E4")
            self.near(got["E6.force." + axis], -want["lambda%d" % (k + 4)], 1e-8, "E6")
        work = 0.033 * (got["beta"] - table.at(0)["beta"])
        self.near(got["energy"] - table.at(0)["energy"], work, 1e-11, "energy")
        self.near(table.at(0)["energy"], float(case["check"]["E0_J"]), 1e-12, "energy at the start")

    def test_published_reference_is_met_to_its_digits(self):
        want = {row[0]: float(row[1]) for row in CASES["AND-1"]["published"]["reference_t_0_03"]["rows"]}
        got = self.simulate(example("andrews"), 0.03, 0.03, ANDREWS, tol=1e-11).at(0.03)
        for name in ANDREWS:
            self.near(got[name], want[name], 1e-9, name)


class Pendulums(Machine):
    def test_iftomm_a1(self):
        of = ["rod.P.x", "rod.P.y", "rod.P.x.rate", "rod.P.y.rate"]
        rows = CASES["IFT-A1"]["check"]["rows"]["rows"]
        short = self.simulate(example("pendulum"), 20.0, 0.01, of, tol=1e-13)
        for row in rows[:-1]:
            for name, want in zip(of, row[1:]):
                self.near(short.at(float(row[0]))[name], float(want), 1e-10, "%s at %s" % (name, row[0]))
        self.assertLess(short.energy_error(), 1e-11)
        self.assertEqual(rows[-1][0], "2000")
        long = self.simulate(example("pendulum"), 2000.0, 500.0, of, tol=1e-13)
        for name, want in zip(of, rows[-1][1:]):
            self.near(long.at(2000.0)[name], float(want), 1e-7, name + " at 2000")

    def test_exactly_two_seconds(self):
        table = self.simulate(example("two-second-pendulum"), 30.0, 2.0, ["rod.P.x", "rod.P.y", "rod.P.x.rate", "rod.P.y.rate"], tol=1e-13)
        for row in table.rows:
            for got, want in zip(row[1:], (1, 0, 0, 0)):
                self.near(got, want, 1e-10, "at %g s" % row[0])

    def test_adams_compound_pendulum(self):
        case = CASES["CHR-REV1"]
        of = ["bob.C.x", "bob.C.y", "bob.C.x.rate", "bob.C.y.rate", "theta", "theta.rate", "theta.accel", "O.force.x", "O.force.y"]
        table = self.simulate(example("compound-pendulum"), 5.0, 1.0, of)
        end, want = table.at(5.0), case["published"]["end"]
        self.compare_adams(end, want)
        own = case["check"]["mine_end"]
        for name, value in (("bob.C.x", own["x"]), ("bob.C.y", own["z"]), ("theta", -own["theta"]), ("theta.rate", -own["w"]),
                            ("theta.accel", -own["alpha"])):
            self.near(end[name], value, 1e-10, name)
        self.near(table.at(1.0)["theta"], -case["check"]["mine_t1"]["theta"], 1e-10, "theta at 1 s")
        self.near(table.at(1.0)["bob.C.x"], case["published"]["t=1 s"]["x"], 5e-6, "x at 1 s")

    def compare_adams(self, end, want):
        """Theirs is the x-z plane seen from the other side: x and z are ours, the angle is minus ours; their force is on the ground."""
        for name, value in (("bob.C.x", want["pos"][0]), ("bob.C.y", want["pos"][2]), ("bob.C.x.rate", want["vel"][0]),
                            ("bob.C.y.rate", want["vel"][2]), ("theta.rate", -want["w"])):
            self.assertLessEqual(abs(end[name] - value), 1.2e-5, name)
        for name, value in (("theta.accel", -want["alpha"]), ("O.force.x", -want["Rforce"][0]), ("O.force.y", -want["Rforce"][2])):
            self.assertLessEqual(abs(end[name] - value), 1e-3, name)

    def test_adams_torsion_spring(self):
        case = CASES["CHR-RS1"]
        of = ["bob.C.x", "bob.C.y", "bob.C.x.rate", "bob.C.y.rate", "theta", "theta.rate", "theta.accel", "O.force.x", "O.force.y"]
        table = self.simulate(example("torsion-spring"), 5.0, 1.0, of)
        self.compare_adams(table.at(5.0), case["published"]["end"])
        own = case["check"]["mine_end"]
        for name, value in (("theta", -own["theta"]), ("theta.rate", -own["w"]), ("theta.accel", -own["alpha"])):
            self.near(table.at(5.0)[name], value, 1e-10, name)
        self.near(table.at(1.0)["theta.rate"], -case["check"]["mine_t1"]["w"], 1e-10, "rate at 1 s")

    def test_modelica_pendulum(self):
        case = CASES["MSL-PEND"]
        table = self.simulate(example("damped-pendulum"), 5.0, 1.0, ["phi", "phi.rate"])
        for column, tolerance in (("published", 1e-4), ("check", 1e-10)):
            for t, phi, rate in case[column]["rows"]["rows"]:
                self.near(table.at(t)["phi"], phi, tolerance, "phi at %g" % t)
                self.near(table.at(t)["phi.rate"], rate, tolerance, "rate at %g" % t)

    def test_modelica_double_pendulum(self):
        case = CASES["MSL-DPEND"]
        of = ["phi1", "phi1.rate", "phi2", "phi2.rate"]
        table = self.simulate(example("double-pendulum-boxes"), 3.0, 0.6, of, tol=1e-13)
        for column, tolerance in (("published", 2e-4), ("check", 1e-9)):
            for row in case[column]["rows"]["rows"]:
                for name, want in zip(of, row[1:]):
                    self.near(table.at(row[0])[name], want, tolerance, "%s at %g" % (name, row[0]))


class Loops(Machine):
    def test_car_axis(self):
        want = {row[0]: float(row[1]) for row in CASES["IVP-CAR"]["published"]["reference_t3"]["rows"]}
        points = {"xl": "left.P.x", "yl": "left.P.y", "xr": "right.Q.x", "yr": "right.Q.y"}
        of = list(points.values()) + [c + ".rate" for c in points.values()] + ["S.force.x", "S.force.y", "P.force.x", "P.force.y"]
        end = self.simulate(example("car-axis"), 3.0, 3.0, of).at(3.0)
        for name, channel in points.items():
            self.near(end[channel], want[name], 1e-10, name)
            self.near(end[channel + ".rate"], want[name + "'"], 1e-10, name + "'")
        yb = 0.1 * math.sin(30)
        xb = math.sqrt(1 - yb * yb)
        for axis, arm in (("x", xb), ("y", yb)):
            self.near(end["S.force." + axis], want["lam1"] * arm, 1e-11, "first multiplier")
        for axis, ends in (("x", ("xl", "xr")), ("y", ("yl", "yr"))):
            self.near(end["P.force." + axis], -2 * want["lam2"] * (want[ends[0]] - want[ends[1]]), 1e-11, "second multiplier")

    def test_sundials_slider_crank(self):
        case = CASES["SUN-SLCR"]
        table = self.simulate(example("spring-slider-crank"), 10.0, 1.25, ["q", "x", "p"])
        for t, *values in case["check"]["rows"]["rows"]:
            for name, want in zip("qxp", values):
                self.near(table.at(t)[name], float(want), 1e-10, "%s at %g" % (name, t))
        for t, *values in case["published"]["rows_41"]["rows"]:
            for name, want in zip("qxp", values):
                self.assertLessEqual(abs(table.at(t)[name] - want), 6e-5, "%s at %g" % (name, t))

    def test_time_integral_of_kinetic_energy(self):
        """SUNDIALS' quadrature G, here by Simpson's rule over the rows."""
        rows = self.simulate(example("spring-slider-crank"), 10.0, 0.01, ["kinetic"]).rows
        weights = [1] + [4, 2] * (len(rows) // 2 - 1) + [4, 1]
        self.assertEqual(len(weights), len(rows))
        total = sum(w * row[1] for w, row in zip(weights, rows)) * 0.01 / 3
        self.near(total, float(CASES["SUN-SLCR"]["check"]["G"]), 1e-9, "G")

    def bars(self, case, file, to, tolerance, tol):
        of = ["link0.B0.x", "link0.B0.y", "link0.B0.x.rate", "link0.B0.y.rate", "theta0.rate", "energy"]
        table = self.simulate(file, to, 0.5, of, tol=tol)
        for row in CASES[case]["check"]["rows"]["rows"]:
            if float(row[0]) <= to:
                got = table.at(float(row[0]))
                for name, want in zip(of[:4], row[1:5]):
                    self.near(got[name], float(want), tolerance, "%s at %s" % (name, row[0]))
                self.near(abs(got["theta0.rate"]), float(row[5]), tolerance, "rate at %s" % row[0])
        self.assertLess(table.energy_error(), 1e-9)
        self.assertLess(table.residual(), 1e-12)

    def test_two_four_bars_pass_their_singular_positions(self):
        self.bars("IFT-A2-N2", example("n-four-bar"), 20.0, 1e-8, 1e-12)

    def made(self, kind, count):
        done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make-model"), kind, str(count)], capture_output=True,
                              encoding="utf-8", check=True)
        return self.write("%s-%d.yaml" % (kind, count), done.stdout)

    def test_forty_four_bars_pass_their_singular_positions(self):
        self.bars("IFT-A2-N40", self.made("n-four-bar", 40), 10.0, 1e-6, 1e-11)

    def test_made_models_are_the_stored_ones(self):
        of = ["link0.B0.x", "theta0.rate", "energy"]
        stored, made = (self.simulate(file, 1.0, 0.25, of).rows for file in (example("n-four-bar"), self.made("n-four-bar", 2)))
        for a, b in zip(stored, made):
            for x, y in zip(a, b):
                self.near(x, y, 1e-9)

    def test_long_chain_keeps_its_energy(self):
        table = self.simulate(self.made("chain", 1000), 0.02, 0.01, ["q1", "q1.accel", "energy"], tol=1e-9)
        self.assertLess(table.energy_error(), 1e-9)
        # At rest and level, each link's angular acceleration is -(2 - sqrt 3) times that of the one before; so the first has:
        self.near(table.at(0)["q1.accel"], -(3 - math.sqrt(3)) * 9.81, 1e-10, "first link")


class Contacts(Machine):
    """Closed forms, piece by piece."""

    def test_block_bounces(self):
        g, e, fall = 9.81, 0.8, math.sqrt(2 / 9.81)
        table = self.simulate(example("bouncing-block"), 3.0, 0.05, ["h", "h.rate"], tol=1e-10)
        for t, height, rate in table.rows:
            hit, speed, flight = fall, e * g * fall, 2 * e * fall
            if t < hit:
                want, fast = 1 - g * t * t / 2, -g * t
            else:
                while t >= hit + flight:
                    hit, speed, flight = hit + flight, e * speed, e * flight
                want, fast = speed * (t - hit) - g * (t - hit) ** 2 / 2, speed - g * (t - hit)
            self.assertLessEqual(abs(height - want), 1e-8, "at %g" % t)
            self.assertLessEqual(abs(rate - fast), 1e-7, "rate at %g" % t)

    def test_block_on_a_rough_floor_comes_to_rest(self):
        half, drop = math.pi / 10, 0.06
        table = self.simulate(example("rough-block"), 1.5, 0.05, ["x", "x.rate", "floor.force.y"], tol=1e-10)
        for t, x, rate, normal in table.rows:
            k = min(int(t / half), 3)
            start = (-1) ** k * (0.2 - k * drop)
            middle = math.copysign(drop / 2, start)
            phase = 10 * (t - k * half)
            want, fast = (start, 0) if k == 3 else (middle + (start - middle) * math.cos(phase), -10 * (start - middle) * math.sin(phase))
            self.assertLessEqual(abs(x - want), 1e-8, "at %g" % t)
            self.assertLessEqual(abs(rate - fast), 1e-7, "rate at %g" % t)
            self.near(normal, 10, 1e-10, "normal force")

    def test_block_slips_and_sticks_on_a_shaking_table(self):
        table = self.simulate(example("shaking-table"), 1.2, 0.01, ["x", "x.rate"], tol=1e-10)
        for (t, x, rate), (want, fast) in zip(table.rows, shaken([row[0] for row in table.rows])):
            self.assertLessEqual(abs(x - want), 1e-8, "at %g" % t)
            self.assertLessEqual(abs(rate - fast), 1e-7, "rate at %g" % t)


def shaken(times, A=0.05, w=10.0, limit=3.0):
    """Block on a table x = A sin wt with friction up to `limit` (acceleration): (relative place, rate) at rising times, by bisection."""
    def root(f, a, b):
        for _ in range(200):
            m = (a + b) / 2
            a, b = (m, b) if (f(m) > 0) == (f(a) > 0) else (a, m)
        return b

    since, sign, place = None, 0, 0.0  # of the slip that goes on: its start, direction of the block against the table

    def moved(t):
        at = place + A * w * math.cos(w * since) * (t - since) - sign * limit * (t - since) ** 2 / 2
        return at - A * (math.sin(w * t) - math.sin(w * since))

    def speed(t):
        return A * w * math.cos(w * since) - sign * limit * (t - since) - A * w * math.cos(w * t)

    answers, now, step = [], 0.0, 1e-4
    for t in times:
        while now < t:
            after = min(now + step, t)
            if since is None and abs(A * w * w * math.sin(w * after)) > limit:
                since = root(lambda s: abs(A * w * w * math.sin(w * s)) - limit, now, after)
                sign = 1 if math.sin(w * after) > 0 else -1
            elif since is not None and now > since and sign * speed(after) < 0:
                end = root(lambda s: sign * speed(s), now, after)
                place, since = moved(end), None
                if abs(A * w * w * math.sin(w * end)) > limit:  # cannot hold: slips the other way at once
                    since, sign = end, -sign
            now = after
        answers.append((place, 0.0) if since is None else (moved(t), speed(t)))
    return answers


class Reports(Machine):
    def test_last_line_tells_the_cost_and_the_errors(self):
        table = self.simulate(example("pendulum"), 1.0, 0.5, ["theta", "energy"], tol=1e-10)
        for word in ("steps", "evaluations", "energy error", "residual"):
            self.assertIn(word, table.summary)
        self.assertLess(table.energy_error(), 1e-9)

    def test_a_closer_tolerance_is_closer(self):
        want = float(CASES["IFT-A1"]["check"]["rows"]["rows"][5][1])
        errors = [abs(self.simulate(example("pendulum"), 10.0, 10.0, ["rod.P.x"], tol=tol).at(10.0)["rod.P.x"] - want)
                  for tol in (1e-5, 1e-8, 1e-11)]
        self.assertGreater(errors[0], errors[1])
        self.assertGreater(errors[1], errors[2])


if __name__ == "__main__":
    unittest.main()
