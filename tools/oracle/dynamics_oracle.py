"""An oracle for machines with forces: answers that owe nothing to libyoke.

Every body has the three absolute coordinates of its centre of mass; every joint and every drive is an equation between them, with
a multiplier that is its reaction (descriptor form, index reduced to 1). The library works with relative coordinates, loops and dyads
instead. The same text runs with doubles (motion in time) and with mpmath's numbers (one pose, 40 digits). Motion is
integrated by Gragg's, Bulirsch's and Stoer's extrapolation to order 16, projected back on the joints after each step; the
library uses Runge-Kutta formulas and never leaves its loops.
"""
import math

from mpmath import mp, mpf

from oracle import exact, pin, slide, slot, solve_linear, weld  # noqa: F401 (the joints are part of this vocabulary)


class Doubles:
    number, sin, cos, sqrt, small = staticmethod(float), staticmethod(math.sin), staticmethod(math.cos), staticmethod(math.sqrt), 1e-15


class Long:
    number, sin, cos, sqrt, small = staticmethod(mpf), staticmethod(mp.sin), staticmethod(mp.cos), staticmethod(mp.sqrt), mpf(10) ** -40


class Mass:
    """mass, centre of mass in the body's axes, inertia about it."""

    def __init__(self, mass, center=(0, 0), inertia=0):
        self.mass, self.inertia = exact(mass), exact(inertia)
        self.center = (exact(center[0]), exact(center[1]))


def rod(mass, length):
    """A uniform rod along x from the origin."""
    mass, length = exact(mass), exact(length)
    return Mass(mass, (length / 2, 0), mass * length * length / 12)


class Spring:
    """Between points (body, at); force k (length - free) + c rate pulls them together."""

    def __init__(self, a, p, b, q, stiffness, free=0, damping=0):
        self.a, self.b = a, b
        self.p, self.q = tuple(map(exact, p)), tuple(map(exact, q))
        self.stiffness, self.free, self.damping = exact(stiffness), exact(free), exact(damping)


class Torsion:
    """Along a coordinate: effort -k (q - free) - c q'."""

    def __init__(self, coordinate, stiffness=0, free=0, damping=0):
        self.coordinate = coordinate
        self.stiffness, self.free, self.damping = exact(stiffness), exact(free), exact(damping)


class Force:
    """At a point of a body, world axes: value(t, values) -> (x, y)."""

    def __init__(self, body, at, value, in_body_axes=False):
        self.body, self.at, self.value, self.in_body_axes = body, tuple(map(exact, at)), value, in_body_axes


class Loaded:
    """A machine with masses and loads.

    joints: {name: Joint}; masses: {body: Mass}; points: {"body.P": (body, at)}; drives: {coordinate: f(t) -> (value, rate,
    acceleration)}; efforts: {coordinate: f(t, values)}; start: {name: value} with guesses and rates; coulomb: {slide with a
    distance: coefficient}, for motions that do not come to rest there.
    """

    def __init__(self, name, source, joints, masses, start, points=None, gravity=(0, 0), drives=None, efforts=None, forces=(),
                 springs=(), coulomb=None):
        self.name, self.source, self.joints, self.masses = name, source, joints, masses
        self.points = {key: (body, tuple(map(exact, at))) for key, (body, at) in (points or {}).items()}
        self.gravity = (exact(gravity[0]), exact(gravity[1]))
        self.start, self.drives, self.efforts = start, dict(drives or {}), dict(efforts or {})
        self.forces, self.springs, self.coulomb = list(forces), list(springs), dict(coulomb or {})
        self.bodies = []
        for joint in joints.values():
            for body in (joint.a, joint.b):
                if body != "ground" and body not in self.bodies:
                    self.bodies.append(body)
        self.where = {}
        for joint in joints.values():
            for kind, label in (("angle", joint.angle), ("distance", joint.distance)):
                if label:
                    self.where[label] = (joint, kind)

    def angles(self):
        return [n for n, (_, kind) in self.where.items() if kind == "angle"] + [b + ".angle" for b in self.bodies]

    def running(self, kind=Doubles, hold=None):
        return Running(self, kind, hold)


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


class Running:
    """A machine with its numbers made doubles or long ones.

    State: q = [x, y, phi of every body], v its rate. Held coordinates: drives of the machine, or `hold`, {coordinate: f(t)}.
    """

    def __init__(self, machine, kind, hold=None):
        self.machine, self.kind = machine, kind
        n = kind.number
        self.index = {body: 3 * i for i, body in enumerate(machine.bodies)}
        self.size = 3 * len(machine.bodies)
        self.mass, self.center = [], {"ground": (n(0), n(0))}
        for body in machine.bodies:
            mass = machine.masses.get(body, Mass(0))
            self.mass += [n(mass.mass), n(mass.mass), n(mass.inertia)]
            self.center[body] = (n(mass.center[0]), n(mass.center[1]))
        self.drives = machine.drives if hold is None else hold
        self.gravity = [n(g) for g in machine.gravity]
        self.rows = []  # (joint name or None, what, joint, function or None)
        for name, joint in machine.joints.items():
            for what in {"pin": ("x", "y"), "slide": ("normal", "turn"), "slot": ("normal",), "weld": ("x", "y", "turn")}[joint.kind]:
                if what not in joint.drop:
                    self.rows.append((name, what, joint, None))
        for name, function in self.drives.items():
            joint, what = machine.where[name]
            self.rows.append((name, {"angle": "turn", "distance": "along"}[what], joint, function))
        self.local = {}
        for joint in machine.joints.values():
            self.local[joint] = (self.from_center(joint.a, joint.p), self.from_center(joint.b, joint.q),
                                 (n(joint.u[0]), n(joint.u[1])), n(joint.turned))
        self.spring = {s: (self.from_center(s.a, s.p), self.from_center(s.b, s.q), n(s.stiffness), n(s.free), n(s.damping))
                       for s in machine.springs if isinstance(s, Spring)}
        self.torsion = {s: (n(s.stiffness), n(s.free), n(s.damping)) for s in machine.springs if isinstance(s, Torsion)}
        self.force = {f: self.from_center(f.body, f.at) for f in machine.forces}
        self.point = {key: (body, self.from_center(body, at)) for key, (body, at) in machine.points.items()}

    def from_center(self, body, at):
        c = self.center[body]
        return (self.kind.number(at[0]) - c[0], self.kind.number(at[1]) - c[1])

    # --- geometry -------------------------------------------------------------------------------------------

    def frames(self, q, v):
        """Of every body: cos, sin, index or None, angular rate."""
        zero, one = self.kind.number(0), self.kind.number(1)
        frames = {"ground": (one, zero, None, zero, zero)}
        for body, i in self.index.items():
            frames[body] = (self.kind.cos(q[i + 2]), self.kind.sin(q[i + 2]), i, v[i + 2], q[i + 2])
        return frames

    def placed(self, frames, q, v, body, s):
        """(arm, position, velocity) of a point given from the centre of mass."""
        c, sn, i, w, _ = frames[body]
        arm = (c * s[0] - sn * s[1], sn * s[0] + c * s[1])
        if i is None:
            return arm, arm, (0 * c, 0 * c)
        return arm, (q[i] + arm[0], q[i + 1] + arm[1]), (v[i] - w * arm[1], v[i + 1] + w * arm[0])

    def joint_geometry(self, frames, q, v, joint):
        p, s, u, turned = self.local[joint]
        arm_a, at_a, vel_a = self.placed(frames, q, v, joint.a, p)
        arm_b, at_b, vel_b = self.placed(frames, q, v, joint.b, s)
        c, sn = frames[joint.a][:2]
        line = (c * u[0] - sn * u[1], sn * u[0] + c * u[1])
        d, dv = (at_b[0] - at_a[0], at_b[1] - at_a[1]), (vel_b[0] - vel_a[0], vel_b[1] - vel_a[1])
        return {"arm": (arm_a, arm_b), "at": (at_a, at_b), "line": line, "d": d, "dv": dv, "turned": turned,
                "w": (frames[joint.a][3], frames[joint.b][3]), "phi": (frames[joint.a][4], frames[joint.b][4])}

    def row(self, what, g, joint):
        """value, rate part, bias (what the second derivative has without accelerations), {index: coefficient} of an equation."""
        ia, ib = (self.index.get(b) for b in (joint.a, joint.b))
        one = self.kind.number(1)
        if what == "turn":
            entries = {}
            if ib is not None:
                entries[ib + 2] = one
            if ia is not None:
                entries[ia + 2] = -one
            return g["phi"][1] - g["phi"][0] - g["turned"], 0 * one, entries
        if what in "xy":
            direction, wa = ((one, 0 * one) if what == "x" else (0 * one, one)), 0 * one
        else:
            u, wa = g["line"], g["w"][0]
            direction = u if what == "along" else (-u[1], u[0])
        perp = (-direction[1], direction[0])
        d, dv = g["d"], g["dv"]
        value = direction[0] * d[0] + direction[1] * d[1]
        bias = 0 * one
        entries = {}
        for sign, i, arm, w in ((1, ib, g["arm"][1], g["w"][1]), (-1, ia, g["arm"][0], g["w"][0])):
            if i is None:
                continue
            entries[i], entries[i + 1] = sign * direction[0], sign * direction[1]
            entries[i + 2] = sign * (direction[1] * arm[0] - direction[0] * arm[1])
            bias -= sign * w * w * (direction[0] * arm[0] + direction[1] * arm[1])
        if what not in "xy" and ia is not None:
            entries[ia + 2] += perp[0] * d[0] + perp[1] * d[1]
            bias += 2 * wa * (perp[0] * dv[0] + perp[1] * dv[1]) - wa * wa * value
        return value, bias, entries

    def equations(self, t, q, v):
        """[value, wanted rate, wanted second derivative less bias, entries] of every joint and drive."""
        frames = self.frames(q, v)
        cache, rows = {}, []
        for _, what, joint, function in self.rows:
            if joint not in cache:
                cache[joint] = self.joint_geometry(frames, q, v, joint)
            value, bias, entries = self.row(what, cache[joint], joint)
            wanted = function(t) if function else (0, 0, 0)
            rows.append((value - wanted[0], wanted[1], wanted[2] - bias, entries))
        return rows

    def values(self, q, v, frames=None):
        """All coordinates and their rates, by name."""
        frames = frames or self.frames(q, v)
        found = {}
        for name, (joint, kind) in self.machine.where.items():
            g = self.joint_geometry(frames, q, v, joint)
            if kind == "angle":
                found[name], found[name + ".rate"] = g["phi"][1] - g["phi"][0] - g["turned"], g["w"][1] - g["w"][0]
            else:
                u, d, dv = g["line"], g["d"], g["dv"]
                found[name] = u[0] * d[0] + u[1] * d[1]
                found[name + ".rate"] = u[0] * dv[0] + u[1] * dv[1] + g["w"][0] * cross(u, d)
        return found

    # --- loads ------------------------------------------------------------------------------------------------

    def push(self, load, frames, body, arm, f):
        i = self.index.get(body)
        if i is not None:
            load[i] += f[0]
            load[i + 1] += f[1]
            load[i + 2] += cross(arm, f)

    def along(self, load, frames, q, v, name, effort):
        """An effort along a coordinate: on the second body, and its reaction on the first."""
        joint, kind = self.machine.where[name]
        g = self.joint_geometry(frames, q, v, joint)
        for i, coefficient in self.row("turn" if kind == "angle" else "along", g, joint)[2].items():
            load[i] += coefficient * effort

    def loads(self, t, q, v):
        frames = self.frames(q, v)
        load = [0 * self.kind.number(1)] * self.size
        for i in range(0, self.size, 3):
            load[i] += self.mass[i] * self.gravity[0]
            load[i + 1] += self.mass[i] * self.gravity[1]
        values = self.values(q, v, frames)
        for force, s in self.force.items():
            f = force.value(t, values)
            if force.in_body_axes:
                c, sn = frames[force.body][:2]
                f = (c * f[0] - sn * f[1], sn * f[0] + c * f[1])
            self.push(load, frames, force.body, self.placed(frames, q, v, force.body, s)[0], f)
        for spring, (p, s, stiffness, free, damping) in self.spring.items():
            arm_a, at_a, vel_a = self.placed(frames, q, v, spring.a, p)
            arm_b, at_b, vel_b = self.placed(frames, q, v, spring.b, s)
            d = (at_b[0] - at_a[0], at_b[1] - at_a[1])
            length = self.kind.sqrt(d[0] * d[0] + d[1] * d[1])
            u = (d[0] / length, d[1] / length)
            rate = u[0] * (vel_b[0] - vel_a[0]) + u[1] * (vel_b[1] - vel_a[1])
            pull = stiffness * (length - free) + damping * rate
            self.push(load, frames, spring.a, arm_a, (pull * u[0], pull * u[1]))
            self.push(load, frames, spring.b, arm_b, (-pull * u[0], -pull * u[1]))
        for spring, (stiffness, free, damping) in self.torsion.items():
            name = spring.coordinate
            self.along(load, frames, q, v, name, -stiffness * (values[name] - free) - damping * values[name + ".rate"])
        for name, function in self.machine.efforts.items():  # a load, also where a drive holds the coordinate: that gives the rest
            self.along(load, frames, q, v, name, function(t, values))
        return load

    def energies(self, q, v):
        kinetic = sum(m * w * w for m, w in zip(self.mass, v)) / 2
        potential = 0
        for i in range(0, self.size, 3):
            potential -= self.mass[i] * (self.gravity[0] * q[i] + self.gravity[1] * q[i + 1])
        frames = self.frames(q, v)
        values = self.values(q, v, frames)
        for spring, (p, s, stiffness, free, _) in self.spring.items():
            a, b = (self.placed(frames, q, v, body, at)[1] for body, at in ((spring.a, p), (spring.b, s)))
            stretch = self.kind.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) - free
            potential += stiffness * stretch * stretch / 2
        for spring, (stiffness, free, _) in self.torsion.items():
            potential += stiffness * (values[spring.coordinate] - free) ** 2 / 2
        return kinetic, potential

    # --- motion -----------------------------------------------------------------------------------------------

    def accelerate(self, t, q, v):
        """(accelerations, multipliers): M a - G^T multiplier = loads, G a = what the joints demand."""
        rows, load = self.equations(t, q, v), self.loads(t, q, v)
        a, multipliers = self.balance(rows, load)
        for _ in range(60 if self.machine.coulomb else 0):
            rubbed, before = list(load), multipliers
            self.rub(rubbed, q, v, multipliers)
            a, multipliers = self.balance(rows, rubbed)
            if max(abs(x - y) for x, y in zip(before, multipliers)) <= self.kind.small * max(map(abs, multipliers)):
                break
        return a, multipliers

    def rub(self, load, q, v, multipliers):
        """Dry friction of slides under the normal forces found last."""
        frames = self.frames(q, v)
        values = self.values(q, v, frames)
        for (name, what, joint, _), value in zip(self.rows, multipliers):
            if what == "normal" and name in self.machine.coulomb:
                against = -1 if values[joint.distance + ".rate"] > 0 else 1
                self.along(load, frames, q, v, joint.distance, against * self.kind.number(self.machine.coulomb[name]) * abs(value))

    def balance(self, rows, load):
        n, m = self.size, len(rows)
        zero = 0 * self.kind.number(1)
        matrix = [[zero] * (n + m) for _ in range(n + m)]
        right = list(load) + [row[2] for row in rows]
        for i in range(n):
            matrix[i][i] = self.mass[i]
        for k, row in enumerate(rows):
            for i, coefficient in row[3].items():
                matrix[i][n + k] = -coefficient
                matrix[n + k][i] = coefficient
        solution = solve_linear(matrix, right)
        if solution is None:
            raise ArithmeticError("%s: singular" % self.machine.name)
        return solution[:n], solution[n:]

    def correction(self, rows, residual):
        """The least change of coordinates (every body weighted alike) that removes a residual."""
        n, m = self.size, len(rows)
        zero, one = 0 * self.kind.number(1), self.kind.number(1)
        matrix = [[zero] * (n + m) for _ in range(n + m)]
        for i in range(n):
            matrix[i][i] = one
        for k, row in enumerate(rows):
            for i, coefficient in row[3].items():
                matrix[i][n + k] = matrix[n + k][i] = coefficient
        solution = solve_linear(matrix, [zero] * n + residual)
        if solution is None:
            raise ArithmeticError("%s: singular joints" % self.machine.name)
        return solution[:n]

    def project(self, t, q, v, rounds=2):
        """Puts a pose and its rates on the joints and drives."""
        for _ in range(rounds):
            rows = self.equations(t, q, v)
            step = self.correction(rows, [-row[0] for row in rows])
            q = [a + b for a, b in zip(q, step)]
        rows = self.equations(t, q, v)
        residual = [row[1] - sum(c * v[i] for i, c in row[3].items()) for row in rows]
        step = self.correction(rows, residual)
        return q, [a + b for a, b in zip(v, step)]

    def start(self, t=0):
        """The pose and rates of `start`: tree coordinates placed, held values kept exactly by extra equations, loops closed by Newton."""
        machine, n = self.machine, self.kind.number
        guess = {name: n(value) for name, value in machine.start.items()}
        for name, function in self.drives.items():
            guess[name], guess[name + ".rate"] = n(function(t)[0]), n(function(t)[1])
        q = self.tree(guess)
        v = [0 * n(1)] * self.size
        freedom = self.size - len(self.rows)
        held = [name for name in machine.start if name in machine.where and name not in self.drives]
        rates = [name[:-5] for name in machine.start if name.endswith(".rate") and name[:-5] not in self.drives]
        rates += [name for name in held if name not in rates]
        full = {}
        for kind, names in (("q", held[:freedom]), ("v", rates[:freedom])):
            hold = dict(self.drives)
            hold.update({name: (lambda _, a=guess.get(name, n(0)), b=guess.get(name + ".rate", n(0)): (a, b, 0)) for name in names})
            full[kind] = Running(machine, self.kind, hold)
        for _ in range(12 if self.kind is Doubles else 16):
            q, _ = full["q"].project(t, q, v, 1)
        return q, full["v"].project(t, q, v, 1)[1] if len(full["v"].rows) == self.size else self.project(t, q, v, 1)[1]

    def tree(self, guess):
        """Absolute coordinates from the tree's: joints with coordinates one after the other."""
        n = self.kind.number
        zero = 0 * n(1)
        pose = {"ground": (zero, zero, zero)}  # of the origin
        pending = [j for j in self.machine.joints.values() if j.angle or j.distance or j.kind == "weld"]
        pending += [j for j in self.machine.joints.values() if j not in pending]
        while pending:
            left = []
            for joint in pending:
                if joint.a in pose and joint.b not in pose:
                    x, y, phi = pose[joint.a]
                    angle = phi + n(joint.turned) + (guess.get(joint.angle, zero) if joint.angle else zero)
                    distance = guess.get(joint.distance, zero) if joint.distance else zero
                    c, s = self.kind.cos(phi), self.kind.sin(phi)
                    px, py = n(joint.p[0]) + distance * n(joint.u[0]), n(joint.p[1]) + distance * n(joint.u[1])
                    c2, s2 = self.kind.cos(angle), self.kind.sin(angle)
                    qx, qy = n(joint.q[0]), n(joint.q[1])
                    pose[joint.b] = (x + c * px - s * py - c2 * qx + s2 * qy, y + s * px + c * py - s2 * qx - c2 * qy, angle)
                elif joint.b not in pose or joint.a not in pose:
                    left.append(joint)
            if len(left) == len(pending):
                break
            pending = left
        q = []
        for body in self.machine.bodies:
            x, y, phi = pose[body]
            cx, cy = self.center[body]
            c, s = self.kind.cos(phi), self.kind.sin(phi)
            q += [x + c * cx - s * cy, y + s * cx + c * cy, phi]
        return q

    # --- answers ----------------------------------------------------------------------------------------------

    def channels(self, t, q, v):
        """Everything that `--of` can name, at a pose."""
        a, multipliers = self.accelerate(t, q, v)
        frames = self.frames(q, v)
        found = self.values(q, v, frames)
        for name, (joint, kind) in self.machine.where.items():
            g = self.joint_geometry(frames, q, v, joint)
            _, bias, entries = self.row("turn" if kind == "angle" else "along", g, joint)
            found[name + ".accel"] = bias + sum(c * a[i] for i, c in entries.items())
        for key, (body, s) in self.point.items():
            arm, at, velocity = self.placed(frames, q, v, body, s)
            i = self.index.get(body)
            w, alpha = (0, 0) if i is None else (v[i + 2], a[i + 2])
            base = (0, 0) if i is None else (a[i], a[i + 1])
            acceleration = (base[0] - alpha * arm[1] - w * w * arm[0], base[1] + alpha * arm[0] - w * w * arm[1])
            for k, axis in enumerate((".x", ".y")):
                found[key + axis], found[key + axis + ".rate"], found[key + axis + ".accel"] = at[k], velocity[k], acceleration[k]
        for body, i in self.index.items():
            found[body + ".angle"], found[body + ".angle.rate"], found[body + ".angle.accel"] = q[i + 2], v[i + 2], a[i + 2]
        self.reactions(found, frames, q, v, multipliers)
        values = {name: value for name, value in found.items()}
        for name, function in self.machine.efforts.items():
            if name not in self.drives:
                found[name + ".effort"] = function(t, values)
        kinetic, potential = self.energies(q, v)
        found["kinetic"], found["potential"], found["energy"] = kinetic, potential, kinetic + potential
        return found

    def reactions(self, found, frames, q, v, multipliers):
        """Multipliers are what the first body exerts on the second: along x, y, the line's normal, or a moment."""
        for name, joint in self.machine.joints.items():
            found[name + ".force.x"], found[name + ".force.y"], found[name + ".moment"] = 0, 0, 0
        for (name, what, joint, function), value in zip(self.rows, multipliers):
            if function:
                found[name + ".effort"] = value
            elif what == "turn":
                found[name + ".moment"] += value
            elif what in "xy":
                found[name + ".force." + what] += value
            else:
                u = self.joint_geometry(frames, q, v, joint)["line"]
                found[name + ".force.x"] += -u[1] * value
                found[name + ".force.y"] += u[0] * value

    def pose(self, t=0):
        """The answers at the start, in this kind of numbers."""
        q, v = self.start(t)
        return self.channels(t, q, v)

    def rates(self, t, y):
        n = self.size
        return y[n:] + self.accelerate(t, y[:n], y[n:])[0]

    def simulate(self, times, step, tolerance=1e-13):
        """[(t, q, v)] at rising times, from the start at times[0]. step: first guess of a step, s."""
        t = times[0]
        q, v = self.start(t)
        found = [(t, q, v)]
        n = self.size
        h = step
        for end in times[1:]:
            while t < end:
                last = t + h >= end * (1 - 1e-15)
                used = end - t if last else h
                y, error = extrapolate(self.rates, t, q + v, used)
                scale = max(1e-3, max(abs(w) for w in v))
                worst = max(max(abs(e) for e in error[:n]), max(abs(e) for e in error[n:]) / scale)
                if worst > tolerance:
                    h = used / 2
                    continue
                t = end if last else t + used
                q, v = self.project(t, y[:n], y[n:], 1)
                if worst < tolerance / 1000 and not last:
                    h = min(used * 1.5, 4 * step)
            found.append((t, q, v))
        return found


def extrapolate(rates, t, y, h, columns=8):
    """One step of Gragg's midpoint rule, extrapolated in h^2 over 2, 4, ..., 2 columns sub-steps: (y, error estimate)."""
    first = rates(t, y)
    table = []
    for k in range(1, columns + 1):
        n = 2 * k
        sub = h / n
        before, now = y, [a + sub * b for a, b in zip(y, first)]
        for i in range(1, n):
            slope = rates(t + i * sub, now)
            before, now = now, [a + 2 * sub * b for a, b in zip(before, slope)]
        slope = rates(t + h, now)
        row = [[(a + b + sub * c) / 2 for a, b, c in zip(before, now, slope)]]
        for j in range(1, k):
            ratio = (n / (n - 2 * j)) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[j - 1], table[-1][j - 1])])
        table.append(row)
    best = table[-1][-1]
    return best, [a - b for a, b in zip(best, table[-1][-2])]
