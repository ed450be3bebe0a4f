"""The gallery of machines with forces once more, by hand: what the model files say, in the oracle's words.

case(machine, simulations=[...], poses=[...], **more): `simulations` are dicts with times, step (first guess, s), of, tol (asked of
the command), tolerance (of the comparison); `poses` are dicts with hold: {coordinate: (value, rate, acceleration)} or nothing for
the start.
"""
from mpmath import mp, mpf

from dynamics_oracle import Force, Loaded, Mass, Spring, Torsion, exact, pin, rod, slide, slot

CASES = []
O = (0, 0)
PI = mp.pi


def case(machine, simulations=(), poses=(), tolerance=1e-10):
    CASES.append({"machine": machine, "simulations": list(simulations), "poses": list(poses), "tolerance": tolerance})


def times(end, rows, start="0"):
    return [exact(start) + exact(end) * k / rows for k in range(rows + 1)]


def held(value, rate=0, accel=0):
    value, rate, accel = exact(value), exact(rate), exact(accel)
    return value, rate, accel


def number(t, value):
    """A constant in the kind of numbers of t."""
    return t * 0 + (mpf(value) if isinstance(t, mpf) else float(value))


def functions(t):
    import math
    return mp if isinstance(t, mpf) else math


# --- pendulums ----------------------------------------------------------------------------------------------------------------

case(Loaded("pendulum", "IFT-A1: check columns; here the same by another way", {"O": pin("ground", O, "rod", O, "theta")},
            {"rod": Mass(1, (1, 0), 0)}, {"theta": PI, "theta.rate": 0}, points={"rod.P": ("rod", (1, 0))},
            gravity=(0, "-9.81")),
     simulations=[dict(times=times(10, 20), step=0.1, of=["theta", "theta.rate", "rod.P.x", "O.force.x", "O.force.y", "energy"])],
     poses=[{}])

case(Loaded("compound-pendulum", "CHR-REV1", {"O": pin("ground", O, "bob", O, "theta")}, {"bob": Mass(1, (2, 0), "0.1")},
            {"theta": 0, "theta.rate": 0}, points={"bob.C": ("bob", (2, 0))}, gravity=(0, "-9.80665")),
     simulations=[dict(times=times(5, 10), step=0.1, of=["theta", "theta.rate", "theta.accel", "bob.C.x", "bob.C.y", "O.force.x",
                                                        "O.force.y", "kinetic", "potential"])], poses=[{}])

case(Loaded("torsion-spring", "CHR-RS1", {"O": pin("ground", O, "bob", O, "theta")}, {"bob": Mass(1, (2, 0), "0.1")},
            {"theta": 0, "theta.rate": 0}, points={"bob.C": ("bob", (2, 0))}, gravity=(0, "-9.80665"),
            springs=[Torsion("theta", 200, 0, 10)]),
     simulations=[dict(times=times(5, 10), step=0.02, of=["theta", "theta.rate", "theta.accel", "O.force.x", "O.force.y", "energy"])],
     poses=[{}])

case(Loaded("damped-pendulum", "MSL-PEND", {"O": pin("ground", O, "box", O, "phi")}, {"box": Mass(1, ("0.5", 0), "0.001")},
            {"phi": 0, "phi.rate": 0}, gravity=(0, "-9.80665"), springs=[Torsion("phi", 0, 0, "0.1")]),
     simulations=[dict(times=times(5, 5), step=0.05, of=["phi", "phi.rate", "phi.accel", "O.force.x", "O.force.y", "energy"])],
     poses=[{}])

BOX = "13.86"
case(Loaded("double-pendulum-boxes", "MSL-DPEND",
            {"O": pin("ground", O, "box1", O, "phi1"), "A": pin("box1", ("0.5", 0), "box2", O, "phi2")},
            {b: Mass(BOX, ("0.25", 0), "0.292908") for b in ("box1", "box2")},
            {"phi1": 0, "phi2": 0, "phi1.rate": 0, "phi2.rate": 0}, points={"box2.tip": ("box2", ("0.5", 0))},
            gravity=(0, "-9.80665"), springs=[Torsion("phi1", 0, 0, "0.1")]),
     simulations=[dict(times=times(3, 5), step=0.03, of=["phi1", "phi1.rate", "phi2", "phi2.rate", "box2.tip.x", "A.force.x", "O.force.y"],
                       tol=1e-12, tolerance=1e-8)], poses=[{}])

case(Loaded("double-pendulum", "issue's example; Lagrange's equations, any textbook",
            {"O": pin("ground", O, "link1", O, "theta1"), "A": pin("link1", (0, "-0.5"), "link2", O, "theta2")},
            {"link1": Mass("0.5", (0, "-0.35"), "0.025"), "link2": Mass("0.4", (0, "-0.3"), "0.02")},
            {"theta1": PI / 3, "theta2": PI / 4, "theta1.rate": "0.1", "theta2.rate": "-0.2"},
            points={"link2.tip": ("link2", (0, "-0.5"))}, gravity=(0, "-9.81"),
            efforts={"theta1": lambda t, v: number(t, "0.5"), "theta2": lambda t, v: number(t, "-0.2")}),
     simulations=[dict(times=times(3, 6), step=0.03, of=["theta1", "theta1.rate", "theta2", "theta2.rate", "A.force.x", "O.force.y", "energy"],
                       tol=1e-12, tolerance=1e-8)],
     poses=[{}, {"hold": {"theta1": held("0.3", "1.5", "-4"), "theta2": held("-1.2", "-2", "7")}},
            {"hold": {"theta1": held("0.3", "1.5", "-4")}, "state": {"theta2": "0.8", "theta2.rate": "-1"}}])

LINKS = range(1, 6)
case(Loaded("chain", "five rods of 0.2 m and 0.1 kg",
            {"P%d" % i: pin("link%d" % (i - 1) if i > 1 else "ground", ("0.2", 0) if i > 1 else O, "link%d" % i, O, "q%d" % i) for i in LINKS},
            {"link%d" % i: rod("0.1", "0.2") for i in LINKS},
            dict([("q%d" % i, 0) for i in LINKS] + [("q%d.rate" % i, 0) for i in LINKS]), gravity=(0, "-9.81"),
            points={"link5.P6": ("link5", ("0.2", 0))}),
     simulations=[dict(times=times(1, 10), step=0.02, of=["q1", "q2", "q3", "q4", "q5", "q5.rate", "link5.P6.x", "P1.force.y", "energy"],
                       tol=1e-12, tolerance=1e-8)], poses=[{}])

case(Loaded("cart-pendulum", "cart and pole", {"R": slide("ground", O, "cart", O, 0, 0, "x"), "O": pin("cart", O, "pole", O, "theta")},
            {"cart": Mass(2), "pole": Mass("0.5", (0, "-0.3"), exact("0.5") * exact("0.36") / 12)},
            {"x": 0, "theta": PI / 6, "x.rate": 0, "theta.rate": 0}, points={"pole.P": ("pole", (0, "-0.6"))}, gravity=(0, "-9.81"),
            efforts={"x": lambda t, v: 4 * functions(t).cos(3 * t)}, springs=[Torsion("x", 0, 0, "0.3")]),
     simulations=[dict(times=times(5, 10), step=0.05, of=["x", "x.rate", "theta", "theta.rate", "O.force.x", "O.force.y", "R.force.y",
                                                         "R.moment", "x.effort", "energy"], tol=1e-12, tolerance=1e-9)],
     poses=[{}, {"hold": {"x": held("0.1", "0.4", "-2")}, "state": {"theta": "2", "theta.rate": "3"}}])

# --- loops ----------------------------------------------------------------------------------------------------------------------

AND = dict(pair.split("=") for pair in (
    "d=0.028 da=0.0115 e=0.02 ea=0.01421 rr=0.007 ra=0.00092 ss=0.035 sa=0.01874 sb=0.01043 sc=0.018 sd=0.02 ta=0.02308 tb=0.00916 "
    "u=0.04 ua=0.01228 ub=0.00449 zf=0.02 zt=0.04 fa=0.01421").split())
AND = {key: exact(value) for key, value in AND.items()}
AND_A, AND_B, AND_C = ("-0.06934", "-0.00227"), ("-0.03635", "0.03273"), ("0.014", "0.072")


def less(a, b):
    return AND[a] - AND[b]


case(Loaded("andrews", "AND-1", {
    "O": pin("ground", O, "K1", O, "beta"), "F": pin("K1", (AND["rr"], 0), "K2", O, "Theta"), "B": pin("ground", AND_B, "K3", O, "gamma"),
    "A5": pin("ground", AND_A, "K5", O, "delta"), "G": pin("K5", (AND["zt"], 0), "K4", O, "Phi"),
    "A7": pin("ground", AND_A, "K7", O, "epsilon"), "H": pin("K7", (0, -AND["u"]), "K6", O, "Omega"),
    "E2": pin("K2", (-AND["d"], 0), "K3", (0, -AND["ss"])), "E4": pin("K4", (0, -AND["e"]), "K3", (0, -AND["ss"])),
    "E6": pin("K6", (AND["zf"], 0), "K3", (0, -AND["ss"]))},
    {"K1": Mass("0.04325", (AND["ra"], 0), "2.194e-6"), "K2": Mass("0.00365", (-AND["da"], 0), "4.41e-7"),
     "K3": Mass("0.02373", (AND["sb"], -AND["sa"]), "5.255e-6"), "K4": Mass("0.00706", (0, less("ea", "e")), "5.667e-7"),
     "K5": Mass("0.0705", (AND["ta"], AND["tb"]), "1.169e-5"), "K6": Mass("0.00706", (less("zf", "fa"), 0), "5.667e-7"),
     "K7": Mass("0.05498", (AND["ub"], -AND["ua"]), "1.912e-5")},
    {"beta": "-0.0617138900142764496358948458001", "Theta": 0, "gamma": "0.455279819163070380255912382449",
     "Phi": "0.222668390165885884674473185609", "delta": "0.487364979543842550225598953530",
     "Omega": "-0.222668390165885884674473185609", "epsilon": "1.23054744454982119249735015568", "beta.rate": 0},
    efforts={"beta": lambda t, v: number(t, "0.033")},
    springs=[Spring("ground", AND_C, "K3", (AND["sd"], -AND["sc"]), 4530, "0.07785")]),
     simulations=[dict(times=times("0.03", 6), step=3e-4, of=["beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon", "O.force.x",
                                                             "B.force.y", "energy"], tol=1e-12, tolerance=1e-9)], poses=[{}])

SLIDER = ("0.5", 1)
case(Loaded("spring-slider-crank", "SUN-SLCR",
            {"O": pin("ground", O, "crank", O, "q"), "B": slot("ground", O, "rod", (1, 0), 0, "p", "x"), "A": pin("crank", ("0.5", 0), "rod", O)},
            {"crank": Mass(0, O, 1), "rod": Mass(1, (1, 0), 2)}, {"q": PI / 2, "q.rate": 0, "x": "0.866", "p": -PI / 6},
            springs=[Spring("crank", ("0.25", 0), "rod", ("0.5", 0), 1, 1, 1)],
            forces=[Force("rod", (2, 0), lambda t, v: (number(t, 1), number(t, 0)))]),
     simulations=[dict(times=times(10, 8), step=0.2, of=["q", "q.rate", "x", "p", "A.force.x", "A.force.y", "B.force.y", "energy"],
                       tol=1e-12, tolerance=1e-9)], poses=[{}])

case(Loaded("rocking-four-bar", "oscillating four-bar with a spring, a damper and viscous bearings",
            {"O2": pin("ground", O, "left", O, "theta2"), "A": pin("left", ("0.2", 0), "coupler", O, "theta3"),
             "O4": pin("ground", ("0.3", 0), "right", O, "theta4"), "B": pin("coupler", ("0.22", 0), "right", ("0.18", 0))},
            {"left": rod("0.5", "0.2"), "coupler": Mass(2, ("0.11", "0.02"), "0.012"), "right": rod("0.4", "0.18")},
            {"theta2": PI / 2, "theta3": -PI / 2, "theta4": exact("5/9") * PI, "theta2.rate": 0}, gravity=(0, "-9.81"),
            springs=[Spring("ground", ("0.15", "0.4"), "coupler", ("0.11", "0.06"), 300, "0.15", "0.5"), Torsion("theta2", 0, 0, "0.02"),
                     Torsion("theta3", 0, 0, "0.02"), Torsion("theta4", 0, 0, "0.01")]),
     simulations=[dict(times=times(2, 8), step=0.03, of=["theta2", "theta2.rate", "theta3", "theta4", "B.force.x", "O4.force.y", "energy"],
                       tol=1e-12, tolerance=1e-8)],
     poses=[{}, {"hold": {"theta2": held("1.8", "-6", "11")}}])

case(Loaded("five-bar-motors", "two torque-speed lines",
            {"L": pin("ground", ("-0.06", 0), "left", O, "theta1"), "R": pin("ground", ("0.06", 0), "right", O, "theta2"),
             "A": pin("left", ("0.2", 0), "reachL", O, "phi1"), "B": pin("right", ("0.2", 0), "reachR", O, "phi2"),
             "P": pin("reachL", ("0.26", 0), "reachR", ("0.26", 0))},
            {"left": rod("0.8", "0.2"), "right": rod("0.8", "0.2"), "reachL": rod("0.5", "0.26"), "reachR": Mass("0.5", ("0.16", 0), "0.004")},
            {"theta1": 2 * PI / 3, "theta2": PI / 3, "theta1.rate": 0, "theta2.rate": 0, "phi1": -7 * PI / 18, "phi2": 7 * PI / 18},
            gravity=(0, "-9.81"),
            efforts={"theta1": lambda t, v: 5 - number(t, "0.4") * v["theta1.rate"],
                     "theta2": lambda t, v: number(t, "2.5") - number(t, "0.4") * v["theta2.rate"]}),
     simulations=[dict(times=times("0.2", 4), step=0.01, of=["theta1", "theta1.rate", "theta2", "theta2.rate", "theta1.effort", "P.force.x",
                                                            "P.force.y", "energy"], tol=1e-12, tolerance=1e-9)],
     poses=[{}, {"hold": {"theta1": held("2", "1", "3"), "theta2": held("1", "-2", "5")}},
            {"hold": {"theta1": held("2", "1", "3")}, "state": {"theta2": "1", "theta2.rate": "-2"}}])

TOGGLE = {"l1": "0.1", "l2": "0.22", "l3": "0.2", "l4": "0.25"}
case(Loaded("toggle", "toggle linkage with masses, the format's example",
            {"O1": pin("ground", O, "link1", O, "theta1"), "A": pin("link1", ("0.1", 0), "link2", O, "theta2"),
             "O2": pin("ground", ("0.25", "-0.12"), "link3", O, "theta3"), "J34": pin("link3", ("0.2", 0), "link4", O, "theta4"),
             "J23": pin("link2", ("0.22", 0), "link3", ("0.2", 0)), "B": pin("link4", ("0.25", 0), "slider", O),
             "R": slide("ground", ("0.25", "-0.12"), "slider", O, 0, 0, "d5")},
            {"link1": rod("0.4", "0.1"), "link2": rod("0.9", "0.22"), "link3": rod("0.8", "0.2"), "link4": rod(1, "0.25"), "slider": Mass("2.5")},
            {"theta1": 7 * PI / 18, "theta2": -PI / 3, "theta3": 2 * PI / 3, "theta4": -5 * PI / 6, "d5": "0.1", "theta1.rate": 3},
            gravity=(0, "-9.81"), efforts={"theta1": lambda t, v: number(t, 2)}),
     simulations=[dict(times=times("0.3", 3), step=0.01, of=["theta1", "theta1.rate", "theta3", "d5", "R.force.y", "J23.force.x", "energy"],
                       tol=1e-12, tolerance=1e-8)],
     poses=[{}, {"hold": {"theta1": held("1.4", "3", "0")}}, {"hold": {"theta1": held("1.0", "-5", "40")}}])

# --- tables, dry friction -------------------------------------------------------------------------------------------------------


def table(points, period=None):
    """Straight lines between points; periodic, or its end values outside."""
    points = [(exact(x), exact(y)) for x, y in points]
    if period is not None:
        points.append((points[0][0] + period, points[0][1]))

    def value(x):
        kind = mpf if isinstance(x, mpf) else float
        if period is not None:
            x = x % kind(period)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            if kind(x0) <= x <= kind(x1):
                return kind(y0) + (kind(y1) - kind(y0)) * (x - kind(x0)) / (kind(x1) - kind(x0))
        return kind(points[0][1] if x < points[0][0] else points[-1][1])
    return value


GAS = table([(exact(x) * PI / 180, y) for x, y in (
    (0, -9000), (15, -16000), (30, -12000), (60, -5200), (90, -2800), (130, -1500), (180, -300), (200, -60), (360, -40), (380, 60),
    (540, 50), (600, -250), (650, -900), (690, -3200))], 4 * PI)
SPEED = 100 * PI


def engine_speed(t):
    speed = SPEED if isinstance(t, mpf) else float(SPEED)
    return speed * t, speed, 0


case(Loaded("gas-engine", "four-stroke engine with a table of gas forces",
            {"O": pin("ground", O, "crank", O, "theta"), "A": pin("crank", ("0.04", 0), "rod", O, "psi"), "B": pin("rod", ("0.14", 0), "piston", O),
             "R": slide("ground", O, "piston", O, 0, 0, "x")},
            {"crank": Mass(3, ("0.006", 0), "0.12"), "rod": Mass("0.8", (exact("0.14") / 3, 0), "0.0025"), "piston": Mass("0.6")},
            {"theta": 0, "psi": 0, "x": "0.18"}, drives={"theta": engine_speed}, efforts={"x": lambda t, v: GAS(v["theta"])}),
     poses=[{}] + [{"hold": {"theta": (exact(degrees) * PI / 180, SPEED, mpf(0))}} for degrees in (10, 45, 180, 400, 670, 700)])

WORK = table([("-0.35", 40000), ("-0.346", 40000), ("-0.33", 10000), ("-0.32", 0), ("-0.25", 0)])
case(Loaded("crank-press", "press with flywheel, motor line, table of resistance, dry friction in the guide",
            {"O": pin("ground", O, "crank", O, "theta"), "A": pin("crank", ("0.05", 0), "rod", O, "psi"), "B": pin("rod", ("0.3", 0), "ram", O),
             "R": slide("ground", O, "ram", O, PI / 2, 0, "h")},
            {"crank": Mass(60, ("0.005", 0), 30), "rod": Mass(15, ("0.11", 0), "0.15"), "ram": Mass(40)},
            {"theta": 2 * PI / 3, "theta.rate": 10, "psi": -7 * PI / 6, "h": "-0.25"}, gravity=(0, "-9.81"),
            efforts={"theta": lambda t, v: 60 * (1 - v["theta.rate"] / 12), "h": lambda t, v: WORK(v["h"])},
            springs=[Torsion("theta", 0, 0, "0.5")], coulomb={"R": "0.12"}),
     simulations=[dict(times=times("0.25", 5), step=0.01, of=["theta", "theta.rate", "h", "R.force.x", "B.force.y", "h.effort", "theta.effort"],
                       tol=1e-11, tolerance=1e-7, effort_tolerance=1e-11)],
     poses=[{}, {"hold": {"theta": held("4.5", "8", "-3")}}])

case(Loaded("steam-engine", "REC-KG 15.7",
            {"O": pin("ground", O, "crank", O, "theta"), "A": pin("crank", ("0.3", 0), "rod", O, "psi"), "B": pin("rod", ("1.2", 0), "piston", O),
             "R": slide("ground", O, "piston", O, 0, 0, "x")}, {"piston": Mass(250)},
            {"theta": PI / 3, "psi": -exact("0.4") * PI, "x": "1.3"}, points={"piston.B": ("piston", O)},
            forces=[Force("piston", O, lambda t, v: (-350000 * functions(t).pi / 16, number(t, 0)))],
            drives={"theta": lambda t: (number(t, 0) + (PI if isinstance(t, mpf) else float(PI)) * (1 / number(t, 3) + 25 * t / 3),
                                        (PI if isinstance(t, mpf) else float(PI)) * 25 / 3, 0)}),
     poses=[{}])

CENTER3 = (exact("-1.38") / 3, exact("5.35") / 3)
MIDDLE = (exact("17.04") / 3, exact("0.09"))
case(Loaded("watt-with-masses", "PMKS-W1",
            {"A": pin("ground", ("-3.74", "-2.41"), "AB", ("-3.74", "-2.41"), "alpha"), "B": pin("AB", ("-2.72", "0.91"), "BCD", ("-2.72", "0.91"), "beta"),
             "G": pin("ground", ("7.32", "-3.51"), "CFG", ("7.32", "-3.51"), "gamma"), "C": pin("BCD", ("1.58", "0.43"), "CFG", ("1.58", "0.43")),
             "D": pin("BCD", ("-0.24", "4.01"), "DE", ("-0.24", "4.01"), "delta"), "E": pin("DE", ("5.08", "5.31"), "EF", ("5.08", "5.31"), "epsilon"),
             "F": pin("EF", ("8.14", "3.35"), "CFG", ("8.14", "3.35"))},
            {"AB": Mass(5, ("-3.23", "-0.75"), "0.1"), "BCD": Mass(10, CENTER3, "0.2"), "DE": Mass(5, ("2.42", "4.66"), "0.1"),
             "EF": Mass(10, ("6.61", "4.33"), "0.2"), "CFG": Mass(5, MIDDLE, "0.1")},
            {"alpha": 0, "beta": 0, "gamma": 0, "delta": 0, "epsilon": 0}, gravity=(0, "-9.81"),
            forces=[Force("CFG", MIDDLE, lambda t, v: (number(t, 50), number(t, 25)))],
            drives={"alpha": lambda t: (t * (PI if isinstance(t, mpf) else float(PI)) / 3, (PI if isinstance(t, mpf) else float(PI)) / 3, 0)}),
     poses=[{}, {"hold": {"alpha": (mpf("0.08"), PI / 3, mpf(2))}}])

DEG = PI / 180
case(Loaded("four-bar-at-rest", "GOL-4BS",
            {"O2": pin("ground", O, "crank", O, "theta2"), "A": pin("crank", (1, 0), "coupler", O, "theta3"),
             "O4": pin("ground", (4, 0), "rocker", O, "theta4"), "B": pin("coupler", (3, 0), "rocker", (2, 0))},
            {"crank": Mass(2, ("0.5", 0), "0.01"), "coupler": Mass(3, ("1.5", 0), "0.05"), "rocker": Mass(2, (1, 0), "0.02")},
            {"theta2": 30 * DEG, "theta3": 0, "theta4": 105 * DEG}, gravity=(0, "-9.81"),
            drives={"theta2": lambda t: (30 * DEG, mpf(0), mpf(0)) if isinstance(t, mpf) else (float(30 * DEG), 0.0, 0.0)}),
     poses=[{}, {"hold": {"theta2": (60 * DEG, mpf(0), mpf(0))}}, {"hold": {"theta2": (60 * DEG, mpf(2), mpf(-3))}}])

case(Loaded("standing-frame", "SYM-4BR",
            {"P1": pin("ground", O, "left", O, "q1"), "P2": pin("left", (1, 0), "top", O, "q2"), "P3": pin("top", (2, 0), "right", O, "q3"),
             "P4": pin("right", (1, 0), "ground", (2, 0))}, {"left": rod(5, 1), "top": rod(10, 2), "right": rod(5, 1)},
            {"q1": PI / 2, "q2": -PI / 2, "q3": -PI / 2, "q1.rate": 0}, gravity=(0, "-9.81")), poses=[{}])


def road(t):
    f = functions(t)
    r, w = number(t, "0.1"), number(t, 10)
    y, y1, y2 = r * f.sin(w * t), r * w * f.cos(w * t), -r * w * w * f.sin(w * t)
    x = f.sqrt(1 - y * y)
    return f.asin(y), y1 / x, y2 / x + y * y1 * y1 / x ** 3


LOAD = exact("0.0005")
case(Loaded("car-axis", "IVP-CAR",
            {"O": pin("ground", O, "axle", O, "alpha"), "S": slide("axle", O, "left", O, PI / 2, 0, "h"), "P": pin("left", O, "right", O, "beta")},
            {"left": Mass(LOAD), "right": Mass(LOAD, (1, 0))}, {"h": "0.5", "beta": 0, "h.rate": 0, "beta.rate": -1}, gravity=(0, -1),
            points={"left.P": ("left", O), "right.Q": ("right", (1, 0))}, drives={"alpha": road},
            springs=[Spring("ground", O, "left", O, 1, "0.5"), Spring("axle", (1, 0), "right", (1, 0), 1, "0.5")]),
     simulations=[dict(times=times(3, 6), step=0.02, of=["left.P.x", "left.P.y", "right.Q.x", "right.Q.y", "left.P.x.rate", "left.P.y.rate",
                                                        "right.Q.x.rate", "right.Q.y.rate", "S.force.x", "P.force.x", "P.force.y", "alpha.effort"],
                       tol=1e-12, tolerance=1e-9)], poses=[{}])
