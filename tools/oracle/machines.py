"""The gallery once more, by hand and by other means: bodies, joints and dimensions as the oracle takes them.

Nothing here is read from the model files, so that a mistake in a file or in its reader shows as a difference. Lengths in m, angles in
rad; deg(...) converts. `case` collects what is asked of a machine: poses, sweeps, figures that somebody published.
"""
import math

from mpmath import mp, mpf

from oracle import Machine, deg, exact, pin, slide, slot, weld

CASES = []


def case(machine, poses, sweeps=(), all_poses=(0,), tolerance=1e-12, params=None):
    """poses: dicts of at, rate, accel (inputs by name; doubles), published, params, time. all_poses: those listed with every assembly."""
    CASES.append(dict(machine=machine, poses=list(poses), sweeps=list(sweeps), all_poses=all_poses, tolerance=tolerance, params=params))


def rad(degrees):
    """The double nearest to an angle in degrees: what the command line is given."""
    return float(deg(degrees))


def rpm(value):
    return float(exact(value) * 2 * mp.pi / 60)


def turn(name, begin, of, steps=24, **more):
    return dict(over=name, **{"from": rad(begin), "to": rad(begin + 360)}, steps=steps, of=of, **more)


O = (0, 0)


def four_bar(name, source, names, d, a, b, c, start, coupler_point=None, bodies=("crank", "coupler", "rocker")):
    """names: coordinates at O2, A and O4. Frame d, crank a, coupler b, rocker c."""
    t2, t3, t4 = names
    crank, coupler, rocker = bodies
    points = {crank + ".A": (crank, (a, 0)), rocker + ".B": (rocker, (c, 0))}
    if coupler_point:
        points[coupler + ".P"] = (coupler, coupler_point)
    return Machine(name, source, [
        pin("ground", O, crank, O, t2), pin(crank, (a, 0), coupler, O, t3),
        pin("ground", (d, 0), rocker, O, t4), pin(coupler, (b, 0), rocker, (c, 0)),
    ], points, start, [t2])


# ---------------------------------------------------------------------------------------------------- the files of the format

def quick_return(a1=1, a2=1):
    return Machine("quick-return", "figures to the digits printed; range of the crank in closed form", [
        pin("ground", (0, a1), "crank", O, "theta1"), pin("ground", O, "lever", O, "theta2"),
        slide("lever", O, "block", O, distance="d3"), pin("crank", ("3/4", 0), "block", O),
        pin("lever", ("7/4", 0), "coupler", O, "theta4"), pin("coupler", ("2/3", 0), "ram", O),
        slide("ground", (0, exact(a1) + exact(a2)), "ram", O, distance="d5"),
    ], {"crank.A": ("crank", ("3/4", 0)), "lever.B": ("lever", ("7/4", 0)), "ram.C": ("ram", O)},
        {"theta2": deg(60), "d3": "1.5", "theta4": deg(-20), "d5": "1.2"}, ["theta1"])


def quick_return_ranges():
    """The coupler closes while the lever's end is within l4 of the ram's line: sin(theta2) >= (a1 + a2 - l4)/l2."""
    k2 = (mpf(16) / 21) ** 2
    a, b, c = mpf(9) / 16, mpf(3) / 2 * (1 - k2), 1 - mpf(25) / 16 * k2
    root = mp.sqrt(b * b - 4 * a * c)
    high, low = mp.asin((-b + root) / (2 * a)), mp.asin((-b - root) / (2 * a))
    return [[float(-mp.pi - low), float(low)], [float(high), float(mp.pi - high)]]


case(quick_return(), [
    dict(at={"theta1": rad(30)}, rate={"theta1": -0.5}, accel={"theta1": 0.0}, published={
        "theta2": (math.radians(64.715), 1e-5), "d3": (1.521, 5e-4), "theta4": (math.radians(-25.923), 1e-5), "d5": (1.267, 5e-4),
        "theta2.rate": (-0.2027, 5e-5), "d3.rate": (-0.2136, 5e-5), "theta4.rate": (0.4943, 5e-5), "d5.rate": (0.1990, 5e-5)}),
    dict(at={"theta1": rad(75)}, rate={"theta1": 2.0}, accel={"theta1": -3.0}),
    dict(time=1.0, at={"theta1": float(deg(30) - mpf(1) / 2)}, rate={"theta1": -0.5}, accel={"theta1": 0.0}),
], [
    dict(over="theta1", **{"from": rad(30), "to": rad(180)}, steps=15, of=["theta2", "d3", "theta4", "d5", "ram.C.x"]),
    dict(over="theta1", **{"from": rad(30), "to": rad(-60)}, steps=90, of=["theta2"], limit=quick_return_ranges()[1][0],
         ranges=quick_return_ranges()),
])
case(quick_return("9/10", "11/10"), [dict(at={"theta1": rad(40)}, rate={"theta1": 1.0}, accel={"theta1": 0.5})],
     params={"a1": "900 mm", "a2": "1.1"})

case(Machine("toggle", "dimensions of the model file; closed by an independent solver", [
    pin("ground", O, "link1", O, "theta1"), pin("link1", ("0.1", 0), "link2", O, "theta2"),
    pin("ground", ("0.25", "-0.12"), "link3", O, "theta3"), pin("link3", ("0.2", 0), "link4", O, "theta4"),
    pin("link2", ("0.22", 0), "link3", ("0.2", 0)), pin("link4", ("0.25", 0), "slider", O),
    slide("ground", ("0.25", "-0.12"), "slider", O, distance="d5"),
], {"link1.A": ("link1", ("0.1", 0)), "link3.J": ("link3", ("0.2", 0)), "slider.B": ("slider", O)},
    {"theta1": deg(70), "theta2": deg(-60), "theta3": deg(120), "theta4": deg(-150), "d5": "0.1"}, ["theta1"]), [
    dict(at={"theta1": rad(70)}, rate={"theta1": 3.0}, accel={"theta1": 0.0}),
    dict(at={"theta1": rad(100)}, rate={"theta1": 3.0}, accel={"theta1": -40.0}),
])

case(Machine("double-pendulum", "closed form: sums of angles", [
    pin("ground", O, "link1", O, "theta1"), pin("link1", (0, "-0.5"), "link2", O, "theta2"),
], {"link1.A": ("link1", (0, "-0.5")), "link2.tip": ("link2", (0, "-0.5"))}, {"theta1": mp.pi / 3, "theta2": mp.pi / 4},
    ["theta1", "theta2"]), [
    dict(at={"theta1": rad(60), "theta2": rad(45)}, rate={"theta1": 0.1, "theta2": -0.2}, accel={"theta1": 0.0, "theta2": 0.0}),
    dict(at={"theta1": rad(-100), "theta2": rad(170)}, rate={"theta1": 3.0, "theta2": -7.0}, accel={"theta1": 20.0, "theta2": 11.0}),
])

# ---------------------------------------------------------------------------------------------------- four-bars

NORTON = four_bar("four-bar", "NOR-4.1 (Norton, example 4-1)", ("theta2", "gamma", "theta4"), "0.1", "0.04", "0.12", "0.08",
                  {"gamma": deg(-20), "theta4": deg(57)}, ("0.06", "0.03"))
case(NORTON, [
    dict(at={"theta2": rad(40)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}, published={
        "coupler.angle": (math.radians(20.29788278819648), 1e-12), "rocker.angle": (math.radians(57.3248800703608), 1e-12)}),
    dict(at={"theta2": rad(100)}, rate={"theta2": 10.0}, accel={"theta2": -4.0}),
    dict(at={"theta2": rad(60)}, rate={"theta2": 10.0}, accel={"theta2": 0.0}),
], [turn("theta2", 40, ["gamma", "theta4", "coupler.P.x", "coupler.P.y"])])

case(four_bar("drag-link", "Grashof double crank; closed by an independent solver", ("theta2", "theta3", "theta4"), 1, 2, "1.8", "2.4",
              {"theta3": deg(-80), "theta4": deg(60)}, bodies=("input", "coupler", "output")), [
    dict(at={"theta2": rad(90)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}),
    dict(at={"theta2": rad(50)}, rate={"theta2": 1.0}, accel={"theta2": 1.0}),
], [turn("theta2", 90, ["theta3", "theta4", "output.B.x"])])

# coupler and rocker stretched: (b + c)^2 = a^2 + d^2 - 2 a d cos(theta2)
LIMIT = float(mp.acos(exact("-0.44")))
case(four_bar("non-grashof", "closed form: acos(-0.44)", ("theta2", "theta3", "theta4"), 10, 5, 6, 7,
              {"theta3": deg(-30), "theta4": deg(110)}), [
    dict(at={"theta2": rad(60)}, rate={"theta2": rpm(30)}, accel={"theta2": 0.0}),
    dict(at={"theta2": rad(110)}, rate={"theta2": 0.1}, accel={"theta2": 0.0}, tolerance=1e-11),
], [dict(over="theta2", **{"from": rad(60), "to": rad(180)}, steps=12, of=["theta4"], limit=LIMIT, ranges=[[-LIMIT, LIMIT]]),
    dict(over="theta2", **{"from": rad(60), "to": rad(-180)}, steps=24, of=["theta4"], limit=-LIMIT)])

case(four_bar("parallelogram", "closed form: rocker angle = crank angle", ("theta2", "theta3", "theta4"), 4, 2, 4, 2,
              {"theta3": deg(-60), "theta4": deg(60)}, (2, 1)), [
    dict(at={"theta2": rad(60)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}, published={"theta4": (rad(60), 1e-14)}),
    dict(at={"theta2": rad(110)}, rate={"theta2": 2.0}, accel={"theta2": 5.0}),
], [turn("theta2", 60, ["theta4", "coupler.angle"], closed_form="parallel", change_points=[rad(180), rad(360)])])

case(four_bar("kite", "closed form: the output is the mirror of O2 in the diagonal", ("theta2", "theta3", "theta4"), 2, 1, 1, 2,
              {"theta3": deg(-35), "theta4": deg(125)}), [
    dict(at={"theta2": rad(80)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}),
    dict(at={"theta2": rad(140)}, rate={"theta2": 1.0}, accel={"theta2": 0.0}),
], [dict(over="theta2", **{"from": rad(80), "to": rad(170)}, steps=9, of=["theta3", "theta4"])])

case(four_bar("change-point-four-bar", "GOL-4BK (linkage_sim, fourbar_kinematics.json)", ("theta2", "theta3", "theta4"), 4, 1, 3, 2,
              {"theta3": 0, "theta4": deg(105)}, ("1.5", "0.5")), [
    dict(at={"theta2": math.pi / 6}, rate={"theta2": 1.0}, accel={"theta2": 0.0}, published={
        "coupler.angle": (0.4993004389513942, 1e-9), "coupler.angle.rate": (-0.33119712826775427, 1e-9),
        "coupler.angle.accel": (0.11944138127824894, 1e-8), "rocker.angle": (1.8235909102424988, 1e-9),
        "rocker.angle.rate": (0.012526641065686628, 1e-9), "rocker.angle.accel": (0.6850601240625163, 1e-8),
        "coupler.P.x": (1.9434962562379798, 1e-9), "coupler.P.y": (1.6571761154262732, 1e-9),
        "coupler.P.x.rate": (-0.11674659367078366, 1e-9), "coupler.P.y.rate": (0.5091701516596169, 1e-9),
        "coupler.P.x.accel": (-1.1224295521041576, 1e-8), "coupler.P.y.accel": (-0.49823782067096833, 1e-8)}),
    dict(at={"theta2": rad(100)}, rate={"theta2": 1.0}, accel={"theta2": 0.0}),
], [dict(over="theta2", **{"from": rad(30), "to": rad(170)}, steps=28, of=["theta4", "coupler.P.x", "coupler.P.y"])])

# ---------------------------------------------------------------------------------------------------- straight lines


def hoeken(l1, l2, l3):
    return four_bar("hoeken", "SL-HOEK (Norton, table 3-1), SL-CHEB", ("theta", "gamma", "beta"), l1, l2, l3, l3,
                    {"gamma": deg(-120), "beta": deg(120)}, (2 * exact(l3), 0))


# dbeta, L1, L3, dCx, dCy in percent of dCx: the recomputed values of SL-HOEK, check
HOEKEN_ROWS = [
    (20, "2.975", "3.9625", 0.6013096244219946, 1.0605354581019959e-05), (40, "2.95", "3.925", 1.1929980016425579, 4.353841534986262e-05),
    (60, "2.9", "3.85", 1.7629413074286147, 0.0002654698690505069), (80, "2.825", "3.7375", 2.2991334703088406, 0.001168994434745169),
    (100, "2.725", "3.5875", 2.7897702160368842, 0.003670642907067542), (120, "2.625", "3.4375", 3.2379620468651367, 0.010310120818806688),
    (140, "2.5", "3.25", 3.6225601639039726, 0.023090522017384523), (160, "2.35", "3.025", 3.9331384101497697, 0.0474399565061041),
    (180, "2.2", "2.8", 4.180843462125141, 0.09630782421524409)]


def straight(dbeta, x_span, y_percent):
    return dict(over="theta", **{"from": rad(180 - mpf(dbeta) / 2), "to": rad(180 + mpf(dbeta) / 2)}, steps=400,
                of=["coupler.P.x", "coupler.P.y"], only_ends=True,
                straight=dict(x="coupler.P.x", y="coupler.P.y", x_span=x_span, y_percent=y_percent, tolerance=2e-4))


for dbeta, l1, l3, dcx, dcy in HOEKEN_ROWS:
    if dbeta == 140:
        case(hoeken(l1, 1, l3), [
            dict(at={"theta": math.pi}, rate={"theta": 1.0}, accel={"theta": 0.0},
                 published={"coupler.P.x.rate": (-1.565, 5e-4)}),
            dict(at={"theta": rad(250)}, rate={"theta": 1.0}, accel={"theta": 0.0}),
        ], [straight(dbeta, dcx, dcy), turn("theta", 180, ["gamma", "beta", "coupler.P.x", "coupler.P.y"])])
    else:
        case(hoeken(l1, 1, l3), [dict(at={"theta": math.pi}, rate={"theta": 1.0}, accel={"theta": 0.0})],
             [straight(dbeta, dcx, dcy)], all_poses=(), params={"l1": l1, "l3": l3})
case(hoeken(2, 1, "2.5"), [dict(at={"theta": math.pi}, rate={"theta": 1.0}, accel={"theta": 0.0})],
     [dict(over="theta", **{"from": rad(90), "to": rad(270)}, steps=720, of=["coupler.P.x", "coupler.P.y"], only_ends=True,
           extremes={"coupler.P.x": [0.0, 4.0], "coupler.P.y": [4.0, 4.009753733085981]}, extreme_tolerance=2e-6)],
     all_poses=(), params={"l1": "2", "l3": "2.5"})

CHEB_LOW, CHEB_HIGH = float(mp.acos(exact("0.8"))), float(mp.acos(exact("-0.2")))
case(four_bar("chebyshev", "SL-CHEB (4:2:5)", ("theta", "gamma", "beta"), 4, 5, 2, 5, {"gamma": deg(120), "beta": deg(120)}, (1, 0),
              bodies=("left", "coupler", "right")), [
    dict(at={"theta": rad(60)}, rate={"theta": 0.1}, accel={"theta": 0.0}),
    dict(at={"theta": math.atan2(4, 3)}, rate={"theta": 1.0}, accel={"theta": 0.0},
         published={"coupler.P.x": (2.0, 1e-12), "coupler.P.y": (4.0, 1e-12)}),
], [dict(over="theta", **{"from": rad(60), "to": rad("36.87")}, steps=600, of=["coupler.P.x", "coupler.P.y"], only_ends=True,
         extremes={"coupler.P.y": [4.0, 4.009753733082251]}, extreme_tolerance=2e-6),
    dict(over="theta", **{"from": rad(60), "to": rad(120)}, steps=60, of=["coupler.P.y"], limit=CHEB_HIGH,
         ranges=[[-CHEB_HIGH, -CHEB_LOW], [CHEB_LOW, CHEB_HIGH]]),  # the mirrored crank has an assembly of the same sign
    dict(over="theta", **{"from": rad(60), "to": rad(0)}, steps=60, of=["coupler.P.y"], limit=CHEB_LOW)])

# the linkage closes while OP = 2 r cos(theta/2) >= l - s
PEAU = float(2 * mp.acos(exact("0.75")))
case(Machine("peaucellier", "closed form: Q.x = (l^2 - s^2)/(2 r) = 3.375", [
    pin("ground", (1, 0), "crank", O, "theta"), pin("ground", O, "upper", O, "beta"), pin("ground", O, "lower", O, "gamma"),
    pin("crank", (1, 0), "pb", O, "phiB"), pin("crank", (1, 0), "pc", O, "phiC"),
    pin("upper", (3, 0), "pb", ("1.5", 0)), pin("lower", (3, 0), "pc", ("1.5", 0)),
    pin("upper", (3, 0), "bq", O, "chiB"), pin("lower", (3, 0), "cq", O, "chiC"), pin("bq", ("1.5", 0), "cq", ("1.5", 0)),
], {"crank.P": ("crank", (1, 0)), "bq.Q": ("bq", ("1.5", 0))},
    {"beta": deg(35), "gamma": deg(-15), "phiB": deg(50), "phiC": deg(-70), "chiB": deg(-85), "chiC": deg(85)}, ["theta"]), [
    dict(at={"theta": rad(20)}, rate={"theta": 0.2}, accel={"theta": 0.0},
         published={"bq.Q.x": (3.375, 1e-12), "bq.Q.x.rate": (0.0, 1e-12), "bq.Q.x.accel": (0.0, 1e-11)}),
    dict(at={"theta": rad(-60)}, rate={"theta": 1.0}, accel={"theta": 0.0}),
], [dict(over="theta", **{"from": rad(20), "to": rad(80)}, steps=60, of=["bq.Q.x", "bq.Q.y"], only_ends=True,
         extremes={"bq.Q.x": [3.375, 3.375]}, extreme_tolerance=1e-11),
    dict(over="theta", **{"from": rad(20), "to": rad(90)}, steps=70, of=["bq.Q.x"], limit=PEAU, ranges=[[-PEAU, PEAU]])],
    all_poses=())  # where B and C coincide Q is free: configurations without number

# ---------------------------------------------------------------------------------------------------- sliders

case(Machine("slider-crank", "REC-KG, 15.5 exact (Khurmi and Gupta, example 15.5)", [
    pin("ground", O, "crank", O, "theta"), pin("crank", ("0.15", 0), "rod", O, "psi"), pin("rod", ("0.6", 0), "piston", O),
    slide("ground", O, "piston", O, distance="x"),
], {"crank.A": ("crank", ("0.15", 0)), "piston.B": ("piston", O)}, {"psi": deg(-70), "x": "0.65"}, ["theta"]), [
    dict(at={"theta": rad(60)}, rate={"theta": rpm(450)}, accel={"theta": 0.0}, published={
        "x": (0.660768725692999, 1e-12), "x.rate": (-6.90535994283575, 1e-11), "x.accel": (-124.94934388520869, 1e-9),
        "rod.angle.rate": (-6.033595820786166, 1e-11), "rod.angle.accel": (484.3947, 1e-4)}),
    dict(at={"theta": rad(150)}, rate={"theta": 10.0}, accel={"theta": 7.0}),
], [turn("theta", 60, ["psi", "x"])])

case(Machine("offset-slider-crank", "Norton, example 4-2", [
    pin("ground", O, "crank", O, "theta2"), pin("crank", ("0.04", 0), "rod", O, "psi"), pin("rod", ("0.12", 0), "block", O),
    slide("ground", (0, "-0.02"), "block", O, distance="d"),
], {"crank.A": ("crank", ("0.04", 0)), "block.B": ("block", O)}, {"psi": deg(-90), "d": "0.12"}, ["theta2"]), [
    dict(at={"theta2": rad(60)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}, published={"d": (0.12684, 5e-6)}),
    dict(at={"theta2": rad(200)}, rate={"theta2": -3.0}, accel={"theta2": 0.0}),
], [turn("theta2", 60, ["psi", "d"])])

case(Machine("inverted-slider-crank", "closed by an independent solver", [
    pin("ground", O, "crank", O, "theta2"), pin("ground", ("0.1", 0), "rocker", O, "theta4"),
    slide("rocker", ("0.02", 0), "rod", O, along=deg(75), turned=deg(75), distance="s"), pin("crank", ("0.04", 0), "rod", O),
], {"rocker.B": ("rocker", ("0.02", 0)), "rod.A": ("rod", O), "rod.tip": ("rod", ("-0.18", 0))},
    {"theta4": deg(100), "s": "0.06"}, ["theta2"]), [
    dict(at={"theta2": rad(30)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}),
    dict(at={"theta2": rad(120)}, rate={"theta2": 5.0}, accel={"theta2": 2.0}),
], [turn("theta2", 30, ["theta4", "s", "rod.tip.x"])])

case(Machine("scotch-yoke", "closed form: x = r cos(theta)", [
    pin("ground", O, "crank", O, "theta"), slide("ground", O, "yoke", O, distance="x"), slot("yoke", O, "crank", ("0.05", 0), along=mp.pi / 2),
], {"crank.A": ("crank", ("0.05", 0)), "yoke.tool": ("yoke", ("0.2", 0))}, {"x": "0.04"}, ["theta"]), [
    dict(at={"theta": rad(30)}, rate={"theta": rpm(120)}, accel={"theta": 0.0},
         published={"x": (0.05 * math.cos(math.pi / 6), 1e-16), "x.rate": (-0.05 * 4 * math.pi * 0.5, 1e-14)}),
    dict(at={"theta": rad(200)}, rate={"theta": 1.0}, accel={"theta": -2.0}),
], [turn("theta", 30, ["x", "yoke.tool.x"])])

case(Machine("elliptic-trammel", "closed form: an ellipse of half axes p and p - l", [
    slide("ground", O, "horizontal", O, distance="x"), pin("horizontal", O, "bar", O, "theta"),
    slide("ground", O, "vertical", O, along=mp.pi / 2, distance="y"), pin("bar", ("0.3", 0), "vertical", O),
], {"bar.A": ("bar", O), "bar.B": ("bar", ("0.3", 0)), "bar.P": ("bar", ("0.45", 0))}, {"x": "0.15", "y": "0.25"}, ["theta"]), [
    dict(at={"theta": rad(120)}, rate={"theta": rpm(30)}, accel={"theta": 0.0}),
    dict(at={"theta": rad(-40)}, rate={"theta": 2.0}, accel={"theta": 3.0}),
], [turn("theta", 120, ["x", "y", "bar.P.x", "bar.P.y"])])

case(Machine("oscillating-cylinder", "closed form: s^2 = r^2 + d^2 - 2 r d cos(theta)", [
    pin("ground", O, "crank", O, "theta"), pin("ground", ("0.25", 0), "cylinder", O, "phi"),
    slide("cylinder", O, "rod", O, distance="s"), pin("crank", ("0.06", 0), "rod", O),
], {"crank.A": ("crank", ("0.06", 0)), "rod.piston": ("rod", ("0.16", 0)), "cylinder.cap": ("cylinder", ("-0.12", 0))},
    {"phi": deg(-10), "s": "-0.22"}, ["theta"]), [
    dict(at={"theta": rad(60)}, rate={"theta": rpm(90)}, accel={"theta": 0.0},
         published={"s": (-math.sqrt(0.06 ** 2 + 0.25 ** 2 - 0.06 * 0.25), 1e-15)}),
    dict(at={"theta": rad(210)}, rate={"theta": 4.0}, accel={"theta": 0.0}),
], [turn("theta", 60, ["phi", "s", "rod.piston.x"])])

case(Machine("pmks-slider-crank", "PMKS-SC (PMKS_Verification, teaching_slider_crank)", [
    pin("ground", ("13.79", "10.01"), "AB", ("13.79", "10.01"), "alpha"), pin("AB", ("13.79", "13.82"), "BC", ("13.79", "13.82"), "beta"),
    pin("BC", ("-0.97", "10.01"), "piston", ("-0.97", "10.01")),
    slide("ground", ("-0.97", "10.01"), "piston", ("-0.97", "10.01"), distance="x"),
], {"AB.B": ("AB", ("13.79", "13.82")), "piston.C": ("piston", ("-0.97", "10.01"))}, {"beta": 0, "x": 0}, ["alpha"]), [
    dict(at={"alpha": 0.0}, rate={"alpha": 1.5812683023068625}, accel={"alpha": 0.0}, published={
        "AB.B.x": (13.79, 1e-12), "AB.B.y": (13.82, 1e-12), "AB.B.x.rate": (-6.024632231789147, 1e-12), "AB.B.y.rate": (0.0, 1e-12),
        "AB.B.x.accel": (0.0, 1e-12), "AB.B.y.accel": (-9.52655998118443, 1e-12), "piston.C.x": (-0.97, 1e-12),
        "piston.C.x.rate": (-6.0246322317891465, 1e-12), "piston.C.x.accel": (-2.4590917024602086, 1e-11),
        "BC.angle": (0.0, 1e-13), "BC.angle.rate": (0.0, 1e-13), "BC.angle.accel": (-0.6454308930341754, 1e-12)}),
    dict(at={"alpha": rad(35)}, rate={"alpha": rpm("15.1")}, accel={"alpha": 0.0}),
], [turn("alpha", 0, ["beta", "x"])], tolerance=1e-12)

case(Machine("doubled-guide", "closed form of the slider-crank; one of two equal guides left out", [
    pin("ground", O, "crank", O, "theta"), pin("crank", ("0.1", 0), "rod", O, "psi"), pin("rod", ("0.35", 0), "crosshead", O),
    slide("ground", (0, "0.06"), "crosshead", (0, "0.06"), distance="x"),
    slide("ground", (0, "-0.06"), "crosshead", (0, "-0.06"), drop="nt"),
], {"crosshead.B": ("crosshead", O), "crosshead.upper": ("crosshead", (0, "0.06"))}, {"psi": deg(-60), "x": "0.4"}, ["theta"]), [
    dict(at={"theta": rad(45)}, rate={"theta": rpm(120)}, accel={"theta": 0.0}),
    dict(at={"theta": rad(160)}, rate={"theta": 3.0}, accel={"theta": 1.0}),
], [turn("theta", 45, ["psi", "x"])], all_poses=())

# ---------------------------------------------------------------------------------------------------- quick returns

case(Machine("crank-slotted-lever", "KG-5, ex52 (Khurmi and Gupta, example 5.2)", [
    pin("ground", (0, "0.24"), "crank", O, "theta"), pin("ground", O, "lever", O, "phi"), slide("lever", O, "block", O, distance="s"),
    pin("crank", ("0.12", 0), "block", O), slide("ground", O, "ram", O, distance="x"), slot("ram", O, "lever", ("0.45", 0), along=mp.pi / 2),
], {"crank.A": ("crank", ("0.12", 0)), "lever.P": ("lever", ("0.45", 0)), "ram.S": ("ram", O)},
    {"phi": deg(80), "s": "0.34", "x": "0.06"}, ["theta"]), [
    dict(at={"theta": rad(60)}, rate={"theta": rpm(30)}, accel={"theta": 0.0}),
    dict(at={"theta": rad(170)}, rate={"theta": 2.0}, accel={"theta": 1.0}),
], [turn("theta", 60, ["phi", "s", "x"]),
    turn("theta", 60, ["x", "x.rate"], steps=1440, only_ends=True, stroke=dict(of="x", length=0.45, ratio=2.0, tolerance=1e-6))])

case(Machine("whitworth-kg", "KG-5, ex54 (Khurmi and Gupta, example 5.4): ratio 2.735239182632302", [
    pin("ground", O, "crank", O, "theta"), pin("ground", (0, "-0.05"), "lever", O, "phi"), slide("lever", O, "block", O, distance="s"),
    pin("crank", ("0.075", 0), "block", O), pin("lever", ("-0.04375", 0), "rod", O, "psi"), pin("rod", ("0.135", 0), "ram", O),
    slide("ground", (0, "-0.05"), "ram", O, distance="x"),
], {"crank.A": ("crank", ("0.075", 0)), "lever.P": ("lever", ("-0.04375", 0)), "ram.B": ("ram", O)},
    {"phi": deg(90), "s": "0.125", "psi": deg(-70), "x": "0.13"}, ["theta"]), [
    dict(at={"theta": rad(90)}, rate={"theta": rpm(60)}, accel={"theta": 0.0}),
    dict(at={"theta": rad(20)}, rate={"theta": rpm(60)}, accel={"theta": 0.0}),
], [turn("theta", 90, ["phi", "s", "psi", "x"]),
    turn("theta", 90, ["x", "x.rate"], steps=1440, only_ends=True,
         stroke=dict(of="x", length=0.0875, ratio=2.735239182632302, tolerance=1e-5))])

case(Machine("marghitu", "MD-E5.3, MD-E5.5 (Marghitu and Dupac, examples 5.3 and 5.5)", [
    pin("ground", O, "crank", O, "phi"), pin("ground", ("-0.3", 0), "lever", O, "phi3"), slide("lever", O, "block", O, distance="s"),
    pin("crank", ("0.15", 0), "block", O), pin("lever", ("-0.2", 0), "rod", O, "phi4"), pin("rod", ("0.14", 0), "slider", O),
    slide("ground", ("-0.55", 0), "slider", O, along=mp.pi / 2, distance="y"),
], {"crank.B": ("crank", ("0.15", 0)), "lever.D": ("lever", ("-0.2", 0)), "lever.F": ("lever", ("0.5", 0)), "slider.E": ("slider", O)},
    {"phi3": deg(19), "s": "0.4", "phi4": deg(100), "y": "0.06"}, ["phi"]), [
    dict(at={"phi": rad(60)}, rate={"phi": rpm(700)}, accel={"phi": 0.0}, published={
        "crank.B.x": (0.075, 1e-15), "crank.B.y": (0.12990381056766578, 1e-15), "lever.D.x": (-0.4889822365046136, 1e-14),
        "lever.D.y": (-0.06546536707079771, 1e-14), "slider.E.x": (-0.55, 1e-14), "slider.E.y": (0.060537936608197514, 1e-14),
        "lever.F.x": (0.17245559126153404, 1e-14), "lever.F.y": (0.1636634176769943, 1e-14),
        "lever.angle": (math.radians(19.10660535), 1e-9), "rod.angle": (math.radians(180 - 64.16116922), 1e-9)}),
    dict(at={"phi": rad(200)}, rate={"phi": rpm(700)}, accel={"phi": 0.0}, published={
        "lever.angle.rate": (-51.93423466961425, 1e-10), "lever.angle.accel": (7157.346811472054, 1e-8), "s.rate": (6.751084595272702, 1e-11),
        "s.accel": (1086.9445398646808, 1e-9), "lever.D.x.rate": (3.1886684812983734, 1e-11), "lever.D.y.rate": (9.885291222069123, 1e-11),
        "lever.D.x.accel": (73.93682941535508, 1e-9), "lever.D.y.accel": (-1527.9482268155741, 1e-9),
        "slider.E.y.rate": (8.383328763288876, 1e-11), "slider.E.y.accel": (-1660.8656182122252, 1e-9),
        "rod.angle.rate": (25.176416231176606, 1e-10), "rod.angle.accel": (882.338887951999, 1e-9),
        "lever.F.x.rate": (-7.971671203245934, 1e-11), "lever.F.y.rate": (-24.713228055172806, 1e-11),
        "lever.F.x.accel": (-184.8420735383877, 1e-9), "lever.F.y.accel": (3819.8705670389354, 1e-9)}),
], [turn("phi", 60, ["phi3", "s", "phi4", "y"])])

# ---------------------------------------------------------------------------------------------------- six bars and more

W = {"A": ("-3.74", "-2.41"), "B": ("-2.72", "0.91"), "C": ("1.58", "0.43"), "D": ("-0.24", "4.01"), "E": ("5.08", "5.31"),
     "F": ("8.14", "3.35"), "G": ("7.32", "-3.51")}
WATT_LINKS = [("AB", 0.0, 1.0471975511965976, 0.0), ("BCD", 0.0, -1.7033236397490774, -8.934593051317965),
              ("DE", 0.0, 2.522416751645328, 3.1258606391772923), ("EF", 0.0, -3.061902045381477, 1.6505485244949112),
              ("CFG", 0.0, 1.0899216286934674, 6.269419366229072)]
WATT_POINTS = [
    ("AB.B", -2.72, 0.91, -3.4766958699727044, 1.0681415022205296, -1.1185551654567938, -3.6407874012907406),
    ("BCD.C", 1.58, 0.43, -4.294291217052262, -6.256150148700504, -17.88279894352001, -40.666908039528536),
    ("BCD.D", -0.24, 4.01, 1.8036074132494346, -3.156101124357183, 19.38343096774334, -34.79264357591623),
    ("DE.E", 5.08, 5.31, -1.475534363889491, 10.263155994395962, -18.529146814165895, -26.43442712516829),
    ("EF.F", 8.14, 3.35, -7.476862372837186, 0.8937357355286436, -43.98231876082036, -3.0082701346117675)]
WATT = {}
for link, a, w, al in WATT_LINKS:
    WATT[link + ".angle"], WATT[link + ".angle.rate"], WATT[link + ".angle.accel"] = (a, 1e-12), (w, 1e-11), (al, 1e-10)
for point, x, y, vx, vy, ax, ay in WATT_POINTS:
    for key, value, tolerance in ((".x", x, 1e-12), (".y", y, 1e-12), (".x.rate", vx, 1e-11), (".y.rate", vy, 1e-11),
                                  (".x.accel", ax, 1e-9), (".y.accel", ay, 1e-9)):
        WATT[point + key] = (value, tolerance)
case(Machine("watt-six-bar", "PMKS-W1 (PMKS_Verification, watt_i, sample matlab_0000)", [
    pin("ground", W["A"], "AB", W["A"], "alpha"), pin("AB", W["B"], "BCD", W["B"], "beta"), pin("ground", W["G"], "CFG", W["G"], "gamma"),
    pin("BCD", W["C"], "CFG", W["C"]), pin("BCD", W["D"], "DE", W["D"], "delta"), pin("DE", W["E"], "EF", W["E"], "epsilon"),
    pin("EF", W["F"], "CFG", W["F"]),
], {"AB.B": ("AB", W["B"]), "BCD.C": ("BCD", W["C"]), "BCD.D": ("BCD", W["D"]), "DE.E": ("DE", W["E"]), "EF.F": ("EF", W["F"])},
    {"beta": 0, "gamma": 0, "delta": 0, "epsilon": 0}, ["alpha"]), [
    dict(at={"alpha": 0.0}, rate={"alpha": 1.0471975511965976}, accel={"alpha": 0.0}, published=WATT),
    dict(at={"alpha": rad(3)}, rate={"alpha": rpm(10)}, accel={"alpha": 0.0}),
    dict(at={"alpha": rad(-4)}, rate={"alpha": -rpm(10)}, accel={"alpha": 0.0}),
], [dict(over="alpha", **{"from": 0.0, "to": rad(5)}, steps=5, of=["beta", "gamma", "delta", "epsilon"])], tolerance=1e-11)


def stephenson(name, drive, start):
    joints = [
        pin("ground", O, "crank", O, "theta2"), pin("crank", (1, 0), "coupler", O, "theta3"), pin("ground", (4, 0), "rocker", O, "theta4"),
        pin("coupler", ("3.5", 0), "rocker", (3, 0)), pin("ground", (6, "2.5"), "output", O, "theta6")]
    if drive == "theta2":
        joints += [pin("coupler", (2, "1.5"), "link", O, "theta5"), pin("link", ("4.5", 0), "output", ("2.5", 0))]
    else:
        joints += [pin("output", ("2.5", 0), "link", ("4.5", 0), "theta5"), pin("coupler", (2, "1.5"), "link", O)]
    return Machine(name, "closed by an independent solver", joints,
                   {"coupler.B": ("coupler", ("3.5", 0)), "coupler.C": ("coupler", (2, "1.5")), "output.D": ("output", ("2.5", 0))}, start, [drive])


STEPHENSON = {"theta3": deg(-25), "theta4": deg(100), "theta5": deg(-15), "theta6": deg(105)}
# driven the easy way, the output's extremes: these are the limits of the awkward input
AWKWARD = [float(mp.fmod(stephenson("", "theta2", STEPHENSON).extreme("theta2", rad(60), near, "theta6") + 4 * mp.pi, 2 * mp.pi))
           for near in (rad(50), rad(240))]

case(stephenson("stephenson-six-bar", "theta2", STEPHENSON), [
    dict(at={"theta2": rad(60)}, rate={"theta2": rpm(60)}, accel={"theta2": 0.0}),
    dict(at={"theta2": rad(120)}, rate={"theta2": 2.0}, accel={"theta2": -1.0}),
], [turn("theta2", 60, ["theta3", "theta4", "theta5", "theta6"])])
case(stephenson("stephenson-awkward", "theta6", {"theta2": deg(120), "theta3": deg(-90), "theta4": deg(119), "theta5": deg(-101)}), [
    dict(at={"theta6": rad(120)}, rate={"theta6": 0.1}, accel={"theta6": 0.0}),
    dict(at={"theta6": rad(140)}, rate={"theta6": -1.0}, accel={"theta6": 0.5}),
], [dict(over="theta6", **{"from": rad(120), "to": rad(150)}, steps=15, of=["theta2", "theta3", "theta4", "theta5"]),
    dict(over="theta6", **{"from": rad(120), "to": rad(90)}, steps=30, of=["theta2"], limit=AWKWARD[0]),
    dict(over="theta6", **{"from": rad(120), "to": rad(170)}, steps=50, of=["theta2"], limit=AWKWARD[1])], all_poses=())


def jansen():
    b, d, e, g, h, i = (exact(v) / 1000 for v in ("41.5", "40.1", "55.8", "36.7", "65.7", "49"))
    hip = mp.acos((b * b + d * d - e * e) / (2 * b * d))          # the triangles by the law of cosines
    knee = mp.acos((g * g + i * i - h * h) / (2 * g * i))
    f_at, foot = (d * mp.cos(hip), d * mp.sin(hip)), (i * mp.cos(knee), i * mp.sin(knee))
    hub, crank = ("-0.038", "-0.0078"), ("0.015", 0)
    return Machine("jansen", "Jansen's eleven lengths; closed by an independent solver", [
        pin("ground", O, "crank", O, "theta"), pin("crank", crank, "upper", O, "thetaJ"), pin("crank", crank, "lower", O, "thetaK"),
        pin("ground", hub, "hip", O, "thetaB"), pin("ground", hub, "strut", O, "thetaC"),
        pin("upper", ("0.05", 0), "hip", (b, 0)), pin("lower", ("0.0619", 0), "strut", ("0.0393", 0)), pin("hip", f_at, "shin", O, "thetaF"),
        pin("strut", ("0.0393", 0), "leg", O, "thetaG"), pin("shin", ("0.0394", 0), "leg", (g, 0)),
    ], {"hip.H": ("hip", (b, 0)), "hip.F": ("hip", f_at), "strut.K": ("strut", ("0.0393", 0)), "leg.N": ("leg", (g, 0)),
        "leg.foot": ("leg", foot)},
        {"thetaJ": deg(140), "thetaK": deg(220), "thetaB": deg(80), "thetaC": deg(-60), "thetaF": deg(130), "thetaG": deg(260)}, ["theta"])


case(jansen(), [
    dict(at={"theta": 0.0}, rate={"theta": rpm(60)}, accel={"theta": 0.0}),
    dict(at={"theta": rad(70)}, rate={"theta": 1.0}, accel={"theta": 2.0}),
], [turn("theta", 0, ["thetaB", "thetaC", "leg.foot.x", "leg.foot.y"])])

K = {"A": ("1.366", "1.366"), "B": ("1.009", "0.574"), "O": ("1.599", "0.750"), "M": ("1.331", "0.750"), "C": ("0.741", "0.750"),
     "knee": ("0.232", "0.866"), "hip": ("0.866", "1.500")}
case(Machine("klann", "US patent 6,260,862, table of coordinates", [
    pin("ground", K["O"], "crank", K["O"], "theta"), pin("crank", K["M"], "connecting", K["M"], "phi"),
    pin("ground", K["B"], "lower", K["B"], "beta"), pin("connecting", K["C"], "lower", K["C"]),
    pin("connecting", K["knee"], "leg", K["knee"], "kappa"), pin("ground", K["A"], "upper", K["A"], "alpha"),
    pin("leg", K["hip"], "upper", K["hip"]),
], {"connecting.knee": ("connecting", K["knee"]), "upper.hip": ("upper", K["hip"]), "leg.foot": ("leg", O)},
    {"phi": 0, "beta": 0, "kappa": 0, "alpha": 0}, ["theta"]), [
    dict(at={"theta": 0.0}, rate={"theta": rpm(60)}, accel={"theta": 0.0},
         published={"leg.foot.x": (0.0, 1e-12), "leg.foot.y": (0.0, 1e-12)}),
    dict(at={"theta": rad(40)}, rate={"theta": 1.0}, accel={"theta": 2.0}),
], [turn("theta", 0, ["beta", "alpha", "leg.foot.x", "leg.foot.y"])])

D = {"P": (3, 0), "L": (0, 0), "R": (7, 0), "LC": ("0.4", "1.5"), "RD": ("6.6", 2), "PC": (2, "1.5"), "PD": ("4.5", "1.2"),
     "CW": ("1.8", "2.8"), "DW": ("4.9", "2.9"), "T": ("3.2", 4)}
case(Machine("double-butterfly", "closed by an independent solver (pose of the file: all angles 0)", [
    pin("ground", D["L"], "left", D["L"], "lambda"), pin("left", D["LC"], "wingC", D["LC"], "gamma"),
    pin("ground", D["R"], "right", D["R"], "rho"), pin("right", D["RD"], "wingD", D["RD"], "delta"),
    pin("ground", D["P"], "wing", D["P"], "omega"), pin("wing", D["PC"], "barC", D["PC"], "sigma"),
    pin("wing", D["PD"], "barD", D["PD"], "tau"), pin("barC", D["CW"], "wingC", D["CW"]), pin("barD", D["DW"], "wingD", D["DW"]),
    pin("wingC", D["T"], "wingD", D["T"]),
], {"wingC.T": ("wingC", D["T"]), "wing.PC": ("wing", D["PC"]), "wing.PD": ("wing", D["PD"])},
    {"gamma": 0, "rho": 0, "delta": 0, "omega": 0, "sigma": 0, "tau": 0}, ["lambda"]), [
    dict(at={"lambda": 0.0}, rate={"lambda": 0.2}, accel={"lambda": 0.0}),
    dict(at={"lambda": rad(2)}, rate={"lambda": 1.0}, accel={"lambda": -1.0}),
], [dict(over="lambda", **{"from": 0.0, "to": rad(5)}, steps=5, of=["gamma", "rho", "delta", "omega", "sigma", "tau"])], all_poses=(),
    tolerance=1e-11)

case(Machine("three-crank-parallelogram", "closed form: all cranks parallel", [
    pin("ground", O, "crank1", O, "theta1"), pin("crank1", ("0.5", 0), "rod", O, "phi"), pin("ground", ("1.5", 0), "crank2", O, "theta2"),
    pin("ground", (4, "0.5"), "crank3", O, "theta3"), pin("rod", ("1.5", 0), "crank2", ("0.5", 0)),
    pin("rod", (4, "0.5"), "crank3", ("0.5", 0), drop="x"),
], {"rod.A1": ("rod", O), "rod.A3": ("rod", (4, "0.5"))}, {"phi": deg(-50), "theta2": deg(50), "theta3": deg(50)}, ["theta1"]), [
    dict(at={"theta1": rad(50)}, rate={"theta1": rpm(60)}, accel={"theta1": 0.0},
         published={"theta2": (rad(50), 1e-13), "theta3": (rad(50), 1e-13), "rod.angle": (0.0, 1e-13)}),
    dict(at={"theta1": rad(130)}, rate={"theta1": 3.0}, accel={"theta1": 2.0}),
], [turn("theta1", 50, ["theta2", "theta3", "rod.angle"], closed_form="parallel", change_points=[rad(180), rad(360)])], all_poses=())

AND = {"rr": "0.007", "d": "0.028", "ss": "0.035", "e": "0.02", "zt": "0.04", "zf": "0.02", "u": "0.04"}
AND_A, AND_B = ("-0.06934", "-0.00227"), ("-0.03635", "0.03273")
AND_P0 = {"beta": "-0.0617138900142764496358948458001", "Theta": "0", "gamma": "0.455279819163070380255912382449",
          "Phi": "0.222668390165885884674473185609", "delta": "0.487364979543842550225598953530",
          "Omega": "-0.222668390165885884674473185609", "epsilon": "1.23054744454982119249735015568"}
AND_END = [("beta", 15.81077119515370709711938730469, 1139.920302259106064198096847786, -24631.76312287463447005079569746),
           ("Theta", -15.75637105841183946972775284486, -1424.379295177540073196026444102, 51850.31963646423153375400078391),
           ("gamma", 0.04082224011964580485828231960096, 11.03291191061859374532731133161, 324102.6007075786058119411030472),
           ("Phi", -0.5347301163420795937701850311192, 19.29337410503204083162755685189, 566749.4220009953264932948369573),
           ("delta", 0.5244099658799540693716557999470, 0.5735699148295024538176878631325, 16743.63541834544460964462615323),
           ("Omega", 0.5347301163420795937701850311172, -19.29337410503204083162755685208, -566749.4220009953264932948369573),
           ("epsilon", 1.048080741041937873068515471841, 0.3231791492491308749907483920071, 9826.507801544162688490504213886)]
case(Machine("andrews", "AND-1: p0, a0 of the IVP test set; its reference solution at t = 0.03 s", [
    pin("ground", O, "K1", O, "beta"), pin("K1", (AND["rr"], 0), "K2", O, "Theta"), pin("ground", AND_B, "K3", O, "gamma"),
    pin("ground", AND_A, "K5", O, "delta"), pin("K5", (AND["zt"], 0), "K4", O, "Phi"), pin("ground", AND_A, "K7", O, "epsilon"),
    pin("K7", (0, "-0.04"), "K6", O, "Omega"), pin("K2", ("-0.028", 0), "K3", (0, "-0.035")), pin("K4", (0, "-0.02"), "K3", (0, "-0.035")),
    pin("K6", (AND["zf"], 0), "K3", (0, "-0.035")),
], {"K3.E": ("K3", (0, "-0.035")), "K3.D": ("K3", ("0.02", "-0.018"))}, AND_P0, ["beta"]), [
    dict(at={"beta": float(AND_P0["beta"])}, rate={"beta": 0.0}, accel={"beta": 14222.4439199541138705911625887}, published=dict(
        [(name, (float(value), 1e-14)) for name, value in AND_P0.items()] +
        [("Theta.accel", (-10666.8329399655854029433719415, 1e-9)), ("gamma.accel", (0.0, 1e-9)), ("delta.accel", (0.0, 1e-9))])),
    dict(at={"beta": AND_END[0][1]}, rate={"beta": AND_END[0][2]}, accel={"beta": AND_END[0][3]}, tolerance=1e-11, published=dict(
        [(n, (v, 1e-12)) for n, v, _, _ in AND_END] + [(n + ".rate", (v, 1e-8)) for n, _, v, _ in AND_END] +
        [(n + ".accel", (v, 1e-4)) for n, _, _, v in AND_END])),
], [turn("beta", -3, ["Theta", "gamma", "Phi", "delta", "Omega", "epsilon"])])

# ---------------------------------------------------------------------------------------------------- several inputs


def five_bar_drive(t):
    t = mpf(t)
    return {"theta1": deg(120) + deg(20) * mp.sin(2 * t), "theta2": deg(50) + mpf(3) / 10 * t - t * t / 10}


def excavator_drive(t):
    t = mpf(t)
    return {"s1": mpf("1.7") + mp.sin(t / 2) / 10, "s2": mpf("2.1") - mpf("0.08") * t}


def timed(drive, t):
    """A pose at a time: values, rates and accelerations of the drives, differenced in long arithmetic."""
    h = mpf(10) ** -15
    low, middle, high = drive(t - h), drive(t), drive(t + h)
    return dict(time=t, at=middle, rate={n: (high[n] - low[n]) / (2 * h) for n in middle},
                accel={n: (high[n] - 2 * middle[n] + low[n]) / h ** 2 for n in middle})


case(Machine("five-bar", "closed by an independent solver", [
    pin("ground", ("-0.06", 0), "left", O, "theta1"), pin("ground", ("0.06", 0), "right", O, "theta2"),
    pin("left", ("0.2", 0), "reachL", O, "phi1"), pin("right", ("0.2", 0), "reachR", O, "phi2"), pin("reachL", ("0.26", 0), "reachR", ("0.26", 0)),
], {"reachL.P": ("reachL", ("0.26", 0)), "left.A": ("left", ("0.2", 0))}, {"phi1": deg(-70), "phi2": deg(70)}, ["theta1", "theta2"]), [
    timed(five_bar_drive, 0.0), timed(five_bar_drive, 0.75),
    dict(at={"theta1": rad(140), "theta2": rad(30)}, rate={"theta1": 1.0, "theta2": -2.0}, accel={"theta1": 0.0, "theta2": 5.0}),
], [dict(over="theta2", **{"from": rad(50), "to": rad(90)}, steps=8, of=["phi1", "phi2", "reachL.P.x", "reachL.P.y"], fixed={"theta1": rad(120)})])

case(Machine("excavator", "closed by an independent solver", [
    pin("ground", O, "boom", O, "theta1"), pin("ground", ("0.5", "-0.4"), "barrel1", O, "beta1"), slide("barrel1", O, "rod1", O, distance="s1"),
    pin("rod1", O, "boom", ("1.5", "0.3")), pin("boom", (4, 0), "stick", O, "theta2"), pin("boom", ("2.2", "0.6"), "barrel2", O, "beta2"),
    slide("barrel2", O, "rod2", O, distance="s2"), pin("rod2", O, "stick", ("-0.6", "0.2")), weld("stick", ("2.2", 0), "bucket", O, turned=deg(-30)),
], {"boom.A": ("boom", (4, 0)), "bucket.tip": ("bucket", ("0.9", 0)), "rod1.C": ("rod1", O)},
    {"theta1": deg(45), "beta1": deg(80), "theta2": deg(-100), "beta2": 0}, ["s1", "s2"]), [
    timed(excavator_drive, 0.0), timed(excavator_drive, 2.0),
    dict(at={"s1": 1.65, "s2": 2.0}, rate={"s1": 0.1, "s2": -0.2}, accel={"s1": 0.3, "s2": 0.0}),
], [dict(over="s1", **{"from": 1.7, "to": 1.9}, steps=8, of=["theta1", "beta1", "bucket.tip.x", "bucket.tip.y"], fixed={"s2": 2.1})])
