"""The answers of check, solve, sweep and draw: shapes, columns, units, exit codes. Values are checked against a closed form."""
import cmath
import math
import os
import re
import shutil
import unittest

from harness import Case, FOUR_BAR, ROOT, Run

DEG = math.pi / 180


def four_bar(theta1, a=0.04, b=0.12, c=0.08, d=0.1, branch=1):
    """Angles of coupler and rocker to the ground, by circle intersection (the diagonal from A to C)."""
    A, C = a * cmath.exp(1j * theta1), complex(d, 0)
    f = C - A
    length = abs(f)
    if not abs(b - c) <= length <= b + c:
        return None
    cosine = (b * b + length * length - c * c) / (2 * b * length)
    coupler = cmath.phase(f) + branch * math.acos(cosine)
    B = A + b * cmath.exp(1j * coupler)
    return coupler, cmath.phase(B - C)


def turn(angle):
    """The angle between -pi and pi."""
    return math.remainder(angle, 2 * math.pi)


class Solve(Case):
    def solve(self, *words):
        return self.good("solve", self.four_bar, *words, "--format", "json").json()

    def test_the_json_shape_is_the_documented_one(self):
        answer = self.solve()
        self.assertEqual([answer["model"], answer["status"], answer["freedom"]], ["Test four-bar", "ok", 1])
        self.assertNotIn("message", answer)
        self.assertNotIn("code", answer)
        (pose,) = answer["configurations"]
        self.assertRegex(pose["label"], r"^B[+-]$|^\S+[+-]$")
        self.assertEqual(list(pose["coordinates"]), ["theta1", "theta3", "theta2"] if list(pose["coordinates"])[1] == "theta3"
                         else ["theta1", "theta2", "theta3"])
        self.assertEqual(set(pose["coordinates"]["theta1"]), {"position", "velocity", "acceleration"})
        self.assertEqual(list(pose["bodies"]), ["crank", "coupler", "rocker"])
        self.assertEqual(set(pose["bodies"]["crank"]), {"angle", "rate", "acceleration"})
        self.assertEqual(set(pose["points"]), {"ground.O", "ground.C", "crank.O", "crank.A", "coupler.A", "coupler.B",
                                               "coupler.P", "rocker.C", "rocker.B"})
        for value in pose["points"]["coupler.P"].values():
            self.assertEqual(len(value), 2)
        for absent in ("reactions", "efforts", "energy"):
            self.assertNotIn(absent, pose)

    def test_positions_agree_with_the_closed_form(self):
        for degrees in range(0, 360, 15):
            pose = self.solve("--at", "theta1=%ddeg" % degrees)["configurations"][0]
            coupler, rocker = four_bar(degrees * DEG)
            self.assertAlmostEqual(turn(pose["bodies"]["coupler"]["angle"] - coupler), 0, places=12)
            self.assertAlmostEqual(turn(pose["bodies"]["rocker"]["angle"] - rocker), 0, places=12)

    def test_rates_agree_with_differences_of_the_closed_form(self):
        h, theta, omega, alpha = 1e-4, 1.1, 0.7, -0.3
        pose = self.solve("--at", "theta1=1.1rad", "--rate", "theta1=0.7rad/s", "--accel", "theta1=-0.3 rad/s^2")["configurations"][0]
        values = [four_bar(theta + omega * t + alpha * t * t / 2)[1] for t in (-2 * h, -h, 0, h, 2 * h)]
        rate = (values[0] - 8 * values[1] + 8 * values[3] - values[4]) / (12 * h)
        accel = (-values[0] + 16 * values[1] - 30 * values[2] + 16 * values[3] - values[4]) / (12 * h * h)
        self.assertAlmostEqual(pose["bodies"]["rocker"]["rate"], rate, places=9)
        self.assertAlmostEqual(pose["bodies"]["rocker"]["acceleration"], accel, places=6)

    def test_a_bare_value_has_the_files_unit(self):
        self.assertEqual(self.solve("--at", "theta1=50")["configurations"], self.solve("--at", "theta1=50deg")["configurations"])

    def test_at_keeps_the_rate_of_the_drive_unless_it_is_given(self):
        motion = self.solve("--at", "theta1=10deg")["configurations"][0]["coordinates"]["theta1"]
        self.assertAlmostEqual(motion["velocity"], 90 * DEG, places=14)
        motion = self.solve("--at", "theta1=10deg", "--rate", "theta1=1rad/s")["configurations"][0]["coordinates"]["theta1"]
        self.assertEqual(motion["velocity"], 1)
        self.assertAlmostEqual(motion["position"], 10 * DEG, places=14)

    def test_time_evaluates_the_drives(self):
        motion = self.solve("--time", "0.5s")["configurations"][0]["coordinates"]["theta1"]
        self.assertAlmostEqual(motion["position"], 105 * DEG, places=14)

    def test_a_parameter_can_be_changed(self):
        pose = self.solve("--param", "a=30 mm", "--at", "theta1=0")["configurations"][0]
        self.assertAlmostEqual(pose["points"]["crank.A"]["position"][0], 0.03, places=15)
        self.assertEqual(Run("solve", self.four_bar, "--param", "b=1").code, 2)

    def test_two_values_for_one_name_are_refused(self):
        for option in ("--at", "--rate", "--accel"):
            run = Run("solve", self.four_bar, option, "theta1=1", option, "theta1=2")
            self.assertEqual(run.code, 2)
            self.assertIn("%s gives `theta1` twice: `1` and `2` [E0817]" % option, run.err)
            self.assertEqual(Run("solve", self.four_bar, option, "theta1=1", option, "theta1=1").code, 0)

    def test_all_gives_both_configurations_with_labels_of_their_own(self):
        answer = self.solve("--all")
        self.assertEqual(len({pose["label"] for pose in answer["configurations"]}), 2)
        self.assertTrue(answer["complete"])
        expected = sorted(turn(four_bar(60 * DEG, branch=sign)[0]) for sign in (1, -1))
        got = sorted(turn(pose["bodies"]["coupler"]["angle"]) for pose in answer["configurations"])
        for have, want in zip(got, expected):
            self.assertAlmostEqual(have, want, places=12)

    def test_a_pose_beyond_a_limit_is_exit_1_with_message_and_code(self):
        self.check_refusal("limit", "--at", "theta1=180deg")

    def test_no_assembly_is_exit_1_with_message_and_code(self):
        self.check_refusal("no-assembly", "--at", "theta1=180deg", "--assembly", "nearest")

    def test_the_code_of_a_warning_is_that_of_its_message(self):
        run = self.good("solve", os.path.join(ROOT, "examples", "three-crank-parallelogram.yaml"), "--format", "json")
        self.assertEqual((run.json()["status"], run.json()["code"]), ("redundant", "W0605"))
        self.assertIn("[W0605]", run.err)

    def check_refusal(self, status, *words):
        run = Run("solve", self.rocker, *words, "--format", "json")
        self.assertEqual(run.code, 1)
        answer = run.json()
        self.assertEqual(answer["status"], status)
        self.assertEqual(answer["configurations"], [])
        self.assertRegex(answer["code"], r"^E06\d\d$")
        self.assertGreater(len(answer["message"]), 10)
        self.assertIn(answer["code"], run.err)
        self.assertEqual(Run("explain", answer["code"]).code, 0)

    def test_masses_are_told_in_the_files_units(self):
        """check and balance tell pounds and inches where the file's units are these; JSON stays in SI."""
        path = self.write("pounds.yaml", """
units: {length: in, mass: lb}
bodies:
  ground:  {points: {O: [0, 0], C: [5.5, 0]}}
  crank:   {points: {O: [0, 0], A: [2, 0]}}
  coupler: {points: {A: [0, 0], B: [6, 0]}, mass: 0.5, center: [3, 0.4], inertia: 2}
  rocker:  {points: {B: [3, 0], C: [0, 0]}}
joints: {O: {pin: [ground, crank], angle: q}, A: {pin: [crank, coupler], angle: p}, B: {pin: [coupler, rocker]}, C: {pin: [ground, rocker], angle: r}}
drives: {q: 60 deg + 100 rpm * t}
start: {p: -30 deg, r: 100 deg}
""")
        self.assertIn("1 body with mass, 0.5 lb in all", self.good("check", path).out)
        weights = self.good("balance", path, "--format", "json").json()["counterweights"]
        text = self.good("balance", path).out
        self.assertRegex(text, r"mass x radius \[lb\*in\] +angle \[\w+\] +as mass \[lb\] +at radius \[in\]")
        for weight in weights:
            (line,) = re.findall(r"(?m)^ +%s .*$" % weight["on"], text)
            product, _, mass, radius = (float(word) for word in line.split()[2:])
            pound, inch = 0.45359237, 0.0254
            self.assertAlmostEqual(product * pound * inch / weight["product"], 1, delta=1e-5)
            self.assertAlmostEqual(mass * pound / weight["mass"], 1, delta=1e-5)
            self.assertAlmostEqual(radius * inch / weight["radius"], 1, delta=1e-5)
        self.assertEqual(len(weights), 2)

    def test_text_is_in_the_files_units(self):
        text = self.good("solve", self.four_bar, "--at", "theta1=50").out
        self.assertRegex(text, r"(?m)^  angle +position \[deg\] +velocity \[deg/s\] +acceleration \[deg/s\^2\]$")
        self.assertRegex(text, r"(?m)^  theta1 \(input\) +50 +90 +0$")
        self.assertRegex(text, r"(?m)^  crank\.A +25\.7115 +30\.6418 ")
        self.assertNotRegex(text, r"(?m) $")

    def test_csv_has_six_columns_in_si(self):
        lines = self.good("solve", self.four_bar, "--at", "theta1=50", "--format", "csv").out.splitlines()
        self.assertEqual(lines[0], "configuration,kind,name,position,velocity,acceleration")
        rows = {line.split(",")[2]: line.split(",") for line in lines[1:]}
        self.assertAlmostEqual(float(rows["theta1"][3]), 50 * DEG, places=14)
        self.assertAlmostEqual(float(rows["crank.A.x"][3]), 0.04 * math.cos(50 * DEG), places=15)
        self.assertEqual({len(row) for row in rows.values()}, {6})

    def test_of_tells_what_is_asked_for_as_the_whole_answer_has_it(self):
        whole = self.solve("--all")["configurations"]
        names = "theta1.rate,coupler.P.x,coupler.P.y.accel,rocker.rate,B.transmission,coupler.P.speed,A.angle.accel"
        asked = self.solve("--all", "--of", names)["configurations"]
        self.assertEqual(len(asked), 2)
        for pose, narrow in zip(whole, asked):
            expected = [pose["coordinates"]["theta1"]["velocity"], pose["points"]["coupler.P"]["position"][0],
                        pose["points"]["coupler.P"]["acceleration"][1], pose["bodies"]["rocker"]["rate"], pose["transmission"]["B"],
                        math.hypot(*pose["points"]["coupler.P"]["velocity"]),
                        pose["bodies"]["coupler"]["acceleration"] - pose["bodies"]["crank"]["acceleration"]]
            of = narrow.pop("of")
            self.assertEqual(list(of), names.split(","))
            for have, want in zip(of.values(), expected):
                self.assertAlmostEqual(have, want, delta=1e-13 * max(1, abs(want)))
            self.assertEqual(narrow, pose)

    def test_of_chooses_the_rows_of_the_text_and_the_columns_of_csv(self):
        words = ("--at", "theta1=50", "--of", "crank.A.x,theta1.rate")
        text = self.good("solve", self.four_bar, *words).out
        self.assertRegex(text, r"\n  column +value  unit\n  crank\.A\.x +25\.7115  mm\n  theta1\.rate +90 +deg/s\n$")
        self.assertNotIn("rocker", text)
        lines = self.good("solve", self.four_bar, *words, "--format", "csv").out.splitlines()
        self.assertEqual(lines[0], "configuration,crank.A.x,theta1.rate")
        self.assertEqual(len(lines), 2)
        self.assertAlmostEqual(float(lines[1].split(",")[1]), 0.04 * math.cos(50 * DEG), places=15)
        self.assertAlmostEqual(float(lines[1].split(",")[2]), 90 * DEG, places=14)

    def test_of_refuses_names_and_forces_that_the_machine_lacks(self):
        self.wrong(505, "solve", self.four_bar, "--of", "coupler.Q.x")
        self.wrong(819, "solve", self.four_bar, "--of", "A.force")

    def test_of_tells_nothing_of_rates_at_a_dead_point(self):
        # Driven at the rocker where crank and coupler are in line: 40 + 120 = 160 mm from O to B.
        dead = math.pi - math.acos((0.1 ** 2 + 0.08 ** 2 - 0.16 ** 2) / (2 * 0.1 * 0.08))
        text = FOUR_BAR.replace("theta1: 60 + 90 deg/s * t", "theta3: %r rad + 1 rad/s * t" % dead)
        path = self.write("dead.yaml", text.replace("theta2: -20, theta3: 90", "theta1: 30, theta2: -1"))
        run = Run("solve", path, "--of", "crank.angle,crank.rate", "--format", "json")
        self.assertEqual(run.json()["status"], "singular")
        of = run.json()["configurations"][0]["of"]
        self.assertIsNone(of["crank.rate"])
        self.assertIsNotNone(of["crank.angle"])

    def test_names_and_values_that_do_not_fit_are_refused(self):
        self.assertEqual(Run("solve", self.four_bar, "--at", "theta9=3").code, 2)
        self.assertEqual(Run("solve", self.four_bar, "--at", "theta1=3kg").code, 2)
        self.assertEqual(Run("solve", self.four_bar, "--at", "theta1=1/0").code, 2)
        run = Run("solve", self.four_bar, "--at", "theta1=3q")
        self.assertIn("--at theta1", run.err)

    def test_more_values_than_freedoms_are_refused(self):
        run = Run("solve", self.four_bar, "--at", "theta1=50", "--at", "theta3=100")
        self.assertEqual(run.code, 2, run.out)
        self.assertIn("theta3", run.err)


class Sweep(Case):
    def test_n_steps_give_n_plus_1_rows(self):
        for steps in (1, 7, 36):
            head, rows = self.good("sweep", self.four_bar, "--over", "theta1=0:360deg", "--steps", str(steps), "--format", "csv").csv()
            self.assertEqual(len(rows), steps + 1)
            self.assertEqual(head[0], "theta1")
            self.assertAlmostEqual(rows[-1][0], 2 * math.pi, places=14)

    def test_columns_are_named_and_ordered_as_asked(self):
        wanted = ["theta3", "theta3.rate", "theta3.accel", "coupler.angle", "coupler.P.x", "coupler.P.speed"]
        head, rows = self.good("sweep", self.four_bar, "--over", "theta1=0:90deg", "--steps", "9", "--of", ",".join(wanted), "--format", "csv").csv()
        self.assertEqual(head, ["theta1"] + wanted)
        for row in rows:
            coupler, rocker = four_bar(row[0])
            self.assertAlmostEqual(turn(row[1] - rocker), 0, places=12)
            self.assertAlmostEqual(turn(row[4] - coupler), 0, places=12)
            P = 0.04 * cmath.exp(1j * row[0]) + (0.06 + 0.05j) * cmath.exp(1j * coupler)
            self.assertAlmostEqual(row[5], P.real, places=13)

    def test_without_of_all_other_coordinates_come(self):
        head, _ = self.good("sweep", self.four_bar, "--over", "theta1=0:90deg", "--format", "csv").csv()
        self.assertEqual(head[0], "theta1")
        self.assertEqual(set(head[1:]), {"theta2", "theta3"})

    def test_angles_come_out_continuous(self):
        _, rows = self.good("sweep", self.four_bar, "--over", "theta1=0:720deg", "--steps", "144", "--of", "theta2,theta3", "--format", "csv").csv()
        for before, after in zip(rows, rows[1:]):
            self.assertLess(max(abs(y - x) for x, y in zip(before, after)), 0.5)

    def test_a_unit_at_the_end_holds_for_both_ends(self):
        for text in ("10:20deg", "10deg:20deg", "10:20", "10 deg:20 deg"):
            _, rows = self.good("sweep", self.four_bar, "--over", "theta1=" + text, "--steps", "1", "--format", "csv").csv()
            self.assertAlmostEqual(rows[0][0], 10 * DEG, places=14)
            self.assertAlmostEqual(rows[1][0], 20 * DEG, places=14)
        _, rows = self.good("sweep", self.four_bar, "--over", "theta1=-1/2:1/4rad", "--steps", "1", "--format", "csv").csv()
        self.assertEqual([rows[0][0], rows[1][0]], [-0.5, 0.25])

    def test_ends_may_be_expressions(self):
        _, rows = self.good("sweep", self.four_bar, "--over", "theta1=0:2*pi", "--steps", "1", "--format", "csv").csv()
        self.assertAlmostEqual(rows[1][0], 2 * math.pi, places=13)

    def test_time_can_be_swept(self):
        head, rows = self.good("sweep", self.four_bar, "--over", "t=0:2s", "--steps", "4", "--of", "theta1,theta1.rate", "--format", "csv").csv()
        self.assertEqual(head[0], "t")
        for row in rows:
            self.assertAlmostEqual(row[1], (60 + 90 * row[0]) * DEG, places=13)
            self.assertAlmostEqual(row[2], 90 * DEG, places=14)

    def test_an_event_tells_every_column_as_a_pose_there_has_it(self):
        names = "theta3,coupler.P.x,coupler.P.speed,B.transmission"
        answer = self.good("sweep", self.four_bar, "--over", "theta1=0:720deg", "--steps", "5", "--of", names, "--format", "json").json()
        self.assertGreaterEqual(len(answer["events"]), 8)
        for event in answer["events"]:
            self.assertEqual(list(event["values"]), names.split(","))
            self.assertEqual(event["values"][event["column"]], event["value"])
            coupler, rocker = four_bar(event["at"])
            self.assertAlmostEqual(turn(event["values"]["theta3"] - rocker), 0, places=12)
            P = 0.04 * cmath.exp(1j * event["at"]) + (0.06 + 0.05j) * cmath.exp(1j * coupler)
            self.assertAlmostEqual(event["values"]["coupler.P.x"], P.real, places=13)
            h = 1e-5
            before, after = (0.04 * cmath.exp(1j * (event["at"] + d)) + (0.06 + 0.05j) * cmath.exp(1j * four_bar(event["at"] + d)[0]) for d in (-h, h))
            self.assertAlmostEqual(event["values"]["coupler.P.speed"], abs(after - before) / (2 * h) * 90 * DEG, places=8)

    def test_text_puts_the_columns_beside_the_events_where_there_are_several(self):
        words = ("sweep", self.four_bar, "--over", "theta1=0:360deg", "--steps", "4", "--of")
        self.assertRegex(self.good(*words, "theta3,coupler.P.x").out, r"(?m)^  event +theta1 \[deg\] +theta3 \[deg\]  coupler\.P\.x \[mm\]$")
        self.assertRegex(self.good(*words, "theta3").out, r"(?m)^  event +theta1 \[deg\]$")

    def test_at_a_limit_the_columns_are_those_of_the_last_pose(self):
        run = Run("sweep", self.rocker, "--over", "theta1=20:200deg", "--steps", "3", "--of", "theta3,coupler.angle,theta3.rate", "--format", "json")
        (event,) = [event for event in run.json()["events"] if event["kind"] == "limit"]
        coupler, rocker = four_bar(event["at"] - 1e-12, 0.09, 0.06, 0.04)
        self.assertAlmostEqual(turn(event["values"]["theta3"] - rocker), 0, places=3)
        self.assertAlmostEqual(math.sin(event["values"]["coupler.angle"] - event["values"]["theta3"]), 0, places=3)  # in line
        self.assertIn("theta3 [deg]", Run("sweep", self.rocker, "--over", "theta1=20:200deg", "--steps", "3", "--of", "theta3").out.split("event")[1])

    def test_at_a_limit_the_rows_so_far_come_with_exit_1(self):
        run = Run("sweep", self.rocker, "--over", "theta1=20:200deg", "--steps", "180", "--format", "json")
        self.assertEqual(run.code, 1)
        answer = run.json()
        # Stretched: coupler and rocker in line, 60 + 40 = 100 = the diagonal from A to C.
        limit = math.acos((0.09 ** 2 + 0.1 ** 2 - 0.1 ** 2) / (2 * 0.09 * 0.1))
        self.assertEqual(answer["status"], "limit")
        self.assertAlmostEqual(answer["rows"][-1][0], math.floor(limit / DEG) * DEG, places=9)
        events = [event for event in answer["events"] if event["kind"] == "limit"]
        self.assertEqual(len(events), 1)
        self.assertAlmostEqual(events[0]["at"], limit, delta=1e-8)
        self.assertTrue(answer["ranges"])
        self.assertTrue(any(abs(end - limit) < 1e-8 for _, end in answer["ranges"]))
        self.assertEqual(answer["ranges_of"], "theta1")
        self.assertRegex(answer["code"], r"^E06\d\d$")
        self.assertIn("closes for theta1", run.err)

    def test_at_a_limit_csv_keeps_to_rows(self):
        run = Run("sweep", self.rocker, "--over", "theta1=20:200deg", "--steps", "180", "--format", "csv")
        self.assertEqual(run.code, 1)
        head, rows = run.csv()
        self.assertEqual({len(row) for row in rows}, {len(head)})
        self.assertIn("limit", run.err)

    def test_text_tells_limit_and_ranges_too(self):
        run = Run("sweep", self.rocker, "--over", "theta1=20:200deg")
        self.assertEqual(run.code, 1)
        self.assertIn("limit", run.out)
        self.assertIn("closes for theta1 from", run.out)

    def test_extremes_are_found(self):
        answer = self.good("sweep", self.four_bar, "--over", "theta1=0:360deg", "--of", "theta3", "--format", "json").json()
        kinds = sorted(event["kind"] for event in answer["events"])
        self.assertEqual(kinds, ["maximum", "minimum"])
        # Crank and coupler in line: the diagonal from O to B is b - a, b + a.
        for event in answer["events"]:
            self.assertEqual(event["column"], "theta3")
            reach = 0.16 if event["kind"] == "minimum" else 0.08
            cosine = (0.1 ** 2 + 0.08 ** 2 - reach ** 2) / (2 * 0.1 * 0.08)
            self.assertAlmostEqual(math.cos(math.pi - event["value"]), cosine, places=9)

    def test_a_turn_gives_stroke_and_time_ratio(self):
        answer = self.good("sweep", self.four_bar, "--over", "theta1=0:360deg", "--of", "theta3", "--format", "json").json()
        (stroke,) = answer["strokes"]
        at = sorted(event["at"] for event in answer["events"])
        span = at[1] - at[0]
        slow = max(span, 2 * math.pi - span)
        self.assertAlmostEqual(stroke["ratio"], slow / (2 * math.pi - slow), places=6)
        for over, strokes in (("0:720deg", 1), ("360deg:-720deg", 1), ("0:540deg", 0), ("0:180deg", 0)):
            more = self.good("sweep", self.four_bar, "--over", "theta1=" + over, "--of", "theta3", "--format", "json").json()["strokes"]
            self.assertEqual(len(more), strokes, over)
            for key in ("low", "high", "ratio"):
                self.assertTrue(all(abs(each[key] - stroke[key]) < 1e-6 for each in more))

    def test_turns_that_differ_have_no_stroke(self):
        """A slider on a wheel that turns half as fast as the crank rises in one turn and falls in the next."""
        machine = self.write("halved.yaml", """\
bodies:
  ground: {points: {O: [0, 0], W: [3, 0]}}
  crank: {points: {O: [0, 0]}}
  wheel: {points: {W: [0, 0], P: [0.5, 0.1]}}
joints:
  O: {pin: [ground, crank], angle: theta}
  W: {pin: [ground, wheel], angle: psi}
gears: {g: {mesh: [crank, wheel], teeth: [20, 40]}}
""")
        for over in ("0:360deg", "0:720deg", "0:1440deg"):
            answer = self.good("sweep", machine, "--over", "theta=" + over, "--of", "wheel.P.x", "--format", "json").json()
            self.assertEqual(answer["strokes"], [])

    def test_bad_requests_are_refused(self):
        self.wrong(818, "sweep", self.four_bar)
        for text in ("theta1", "theta1=0", "=0:1", "theta1=:1", "theta1=0:", "theta1=0:1:2"):
            self.wrong(812, "sweep", self.four_bar, "--over", text)
        for steps in ("0", "-1", "x", "1.5", "99999999999999999999"):
            self.wrong(806, "sweep", self.four_bar, "--over", "theta1=0:1", "--steps", steps)
        self.wrong(706, "sweep", self.four_bar, "--over", "theta1=0:1", "--plot", self.path("plot.gif"))
        self.assertEqual(Run("sweep", self.four_bar, "--over", "theta9=0:1").code, 2)
        run = Run("sweep", self.four_bar, "--over", "theta1=0:1", "--of", "theta3,thata2,nothing")
        self.assertEqual(run.code, 2)
        for word in ("thata2", "nothing"):
            self.assertIn(word, run.err)

    @unittest.skipUnless(shutil.which("gnuplot"), "needs gnuplot")
    def test_plots_come_in_three_kinds(self):
        for ending, start in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG")):
            self.good("sweep", self.four_bar, "--over", "theta1=0:360deg", "--of", "theta3,theta3.rate", "--plot", self.path("plot." + ending))
            self.assertTrue(self.read("plot." + ending).startswith(start))

    def test_without_gnuplot_the_table_still_comes(self):
        run = Run("sweep", self.four_bar, "--over", "theta1=0:360deg", "--plot", self.path("plot.svg"), env={"PATH": self.folder})
        self.assertEqual(run.code, 2)
        self.assertIn("[E0710]", run.err)
        self.assertIn("theta1 [deg]", run.out)


class Check(Case):
    def test_the_text_tells_all_to_a_student(self):
        text = self.good("check", self.four_bar).out
        for words in ("4 bodies (the ground and 3 that move), 4 joints, 1 loop", "Gruebler: 3 x 3 moving bodies - 8 constraints = 1",
                      "by the rank of the loop equations: 1", "1 driven: the motion is determined", "Order of solution", "crank-rocker"):
            self.assertIn(words, text)
        self.assertRegex(text, r"(?m)^  B +pin +coupler +rocker$")
        self.assertRegex(text, r"(?m)^  theta1 +an angle +O +driven$")
        loop = re.search(r"(?m)^  1: (.*), closed at (\w+)$", text)
        self.assertEqual(set(loop.group(1).split(" - ")), {"ground", "crank", "coupler", "rocker"})

    def test_the_json_tells_the_same(self):
        answer = self.good("check", self.four_bar, "--format", "json").json()
        self.assertEqual(answer["status"], "ok")
        self.assertEqual(answer["degrees"], {"gruebler": 1, "rank": 1, "redundant": 0, "driven": 1})
        self.assertEqual(answer["bodies"], ["ground", "crank", "coupler", "rocker"])
        self.assertEqual(answer["joints"][3], {"name": "B", "kind": "pin", "bodies": ["coupler", "rocker"]})
        self.assertEqual(len(answer["loops"]), 1)
        (block,) = answer["blocks"]
        self.assertEqual([block["class"], block["unknowns"], block["equations"]], [2, 2, 2])
        self.assertEqual(answer["redundant"], [])
        self.assertIn("crank-rocker", answer["four_bars"][0]["class"])
        self.assertEqual(sorted(round(length, 12) for length in answer["four_bars"][0]["lengths"]), [0.04, 0.08, 0.1, 0.12])

    def test_the_class_follows_the_lengths(self):
        # Frame 100, coupler 60, rocker 40 mm: with 90 the rocker, being shortest, turns; with 70 nothing does (40 + 100 > 60 + 70).
        for a, name in (("90 mm", "rocker-crank"), ("70 mm", "triple-rocker")):
            four_bars = self.good("check", self.rocker, "--param", "a=" + a, "--format", "json").json()["four_bars"]
            self.assertIn(name, four_bars[0]["class"].replace(" ", "-"))

    def test_what_cannot_be_put_together_is_told_with_exit_1(self):
        run = Run("check", self.four_bar, "--param", "a=400 mm")
        self.assertEqual(run.code, 1)
        self.assertIn("Gruebler", run.out)
        self.assertIn("cannot be assembled", run.out)

    def test_a_repeated_constraint_is_named(self):
        model = FOUR_BAR.replace("B: [120, 0], P: [60, 50]}", "B: [100, 0], D: [50, 0]}").replace("rocker:  {points: {C: [0, 0], B: [80, 0]}}",
            "rocker:  {points: {C: [0, 0], B: [40, 0]}}\n  third:   {points: {E: [0, 0], D: [40, 0]}}").replace(
            "C: [100, 0]}}", "C: [100, 0], E: [50, 0]}}").replace("  B: {pin: [coupler, rocker]}",
            "  B: {pin: [coupler, rocker]}\n  E: {pin: [ground, third]}\n  D: {pin: [coupler, third]}").replace(
            "theta2: -20, theta3: 90", "theta2: -60, theta3: 60")
        run = self.good("check", self.write("third.yaml", model), "--format", "json")
        answer = run.json()
        self.assertEqual(answer["status"], "redundant")
        self.assertEqual(answer["degrees"], {"gruebler": 0, "rank": 1, "redundant": 1, "driven": 1})
        self.assertTrue(answer["redundant"])


class Draw(Case):
    def test_svg_comes_on_standard_output_and_is_the_same_every_time(self):
        first = self.good("draw", self.four_bar)
        self.assertTrue(first.out.startswith("<svg "))
        self.assertTrue(first.out.endswith("</svg>\n"))
        self.assertEqual(self.good("draw", self.four_bar).out, first.out)

    def test_a_stroboscope_has_n_faint_poses(self):
        for over, poses in (("theta1=0:360deg", 12), ("theta1=0:90deg", 4)):
            svg = self.good("draw", self.four_bar, "--over", over, "--poses", str(poses)).out
            self.assertEqual(svg.count("<g opacity="), poses)

    def test_a_path_is_traced_with_and_without_a_range(self):
        for words in ([], ["--over", "theta1=0:90deg"], ["--over", "t=0:1s"]):
            svg = self.good("draw", self.four_bar, "--trace", "coupler.P", *words).out
            self.assertEqual(svg.count("<polyline"), 1)

    def test_an_unknown_point_is_refused(self):
        self.wrong(815, "draw", self.four_bar, "--trace", "coupler.Q")

    def test_poses_need_a_range(self):
        self.wrong(818, "draw", self.four_bar, "--poses", "3")

    def test_the_ending_says_the_kind(self):
        self.wrong(706, "draw", self.four_bar, "-o", self.path("picture.bmp"))
        self.good("draw", self.four_bar, "-o", self.path("picture.svg"))
        self.assertTrue(self.read("picture.svg").startswith(b"<svg "))

    @unittest.skipUnless(shutil.which("rsvg-convert"), "needs rsvg-convert")
    def test_pdf_and_png_come_from_the_same_svg(self):
        for ending, start in (("pdf", b"%PDF"), ("png", b"\x89PNG")):
            self.good("draw", self.four_bar, "-o", self.path("picture." + ending))
            self.assertTrue(self.read("picture." + ending).startswith(start))

    def test_without_rsvg_convert_the_message_says_what_to_do(self):
        run = self.wrong(710, "draw", self.four_bar, "-o", self.path("picture.pdf"), env={"PATH": self.folder})
        self.assertIn(".svg", run.err)

    def test_a_pose_that_does_not_close_is_not_drawn(self):
        run = Run("draw", self.rocker, "--at", "theta1=180deg")
        self.assertEqual([run.code, run.out], [1, ""])


if __name__ == "__main__":
    unittest.main()
