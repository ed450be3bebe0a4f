"""An oracle for planar machines: answers that owe nothing to libyoke.

Every body has three absolute coordinates (x, y, phi); every joint and every input is an equation between them; Newton's
method closes them in floating point first and then to 50 digits. Velocities and accelerations are not derived from
any Jacobian: the positions are solved again at t = -h and t = +h, h = 1e-15, and differenced, so that a mistake
in a derivative has no place to hide. The engine works with loops of relative coordinates, block by block, and with closed forms:
the two share nothing but the problem.
"""
import math
import random
from fractions import Fraction

import mpmath
from mpmath import mp, mpf

mp.dps = 60
STEP = mpf(10) ** -15


def exact(value):
    """A number as mpf: '3/4', '0.15', 2 and 0.5 (a double, taken bit for bit)."""
    if isinstance(value, str):
        fraction = Fraction(value)
        return mpf(fraction.numerator) / fraction.denominator
    return mpf(value)


def deg(value):
    return exact(value) * mp.pi / 180


class Joint:
    """pin, slide, slot or weld between point p of body a and point q of body b (body axes).

    angle, distance: names of coordinates, where the model file names them. along: direction of the line in a's axes.
    turned: constant angle of b to a. drop: equations left out because they repeat others (checked after solving).
    """

    def __init__(self, kind, a, p, b, q, along=0, turned=0, angle=None, distance=None, drop=()):
        self.kind, self.a, self.b = kind, a, b
        self.p = (exact(p[0]), exact(p[1]))
        self.q = (exact(q[0]), exact(q[1]))
        self.along, self.turned = exact(along), exact(turned)
        self.angle, self.distance, self.drop = angle, distance, set(drop)
        direction = self.along / (mp.pi / 2)
        if direction == 0:
            self.u = (mpf(1), mpf(0))
        elif direction == 1:
            self.u = (mpf(0), mpf(1))
        else:
            self.u = (mp.cos(self.along), mp.sin(self.along))


def pin(a, p, b, q, angle=None, drop=()):
    return Joint("pin", a, p, b, q, angle=angle, drop=drop)


def slide(a, p, b, q, along=0, turned=0, distance=None, drop=()):
    return Joint("slide", a, p, b, q, along, turned, None, distance, drop)


def slot(a, p, b, q, along=0, angle=None, distance=None, drop=()):
    return Joint("slot", a, p, b, q, along, 0, angle, distance, drop)


def weld(a, p, b, q, turned=0):
    return Joint("weld", a, p, b, q, 0, turned)


def solve_linear(matrix, right):
    """Gaussian elimination with partial pivoting, for floats and mpf alike; None when singular."""
    n = len(right)
    rows = [list(matrix[i]) + [right[i]] for i in range(n)]
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(rows[i][k]))
        if rows[best][k] == 0:
            return None
        rows[k], rows[best] = rows[best], rows[k]
        pivot = rows[k]
        for i in range(k + 1, n):
            row = rows[i]
            if row[k] != 0:
                factor = row[k] / pivot[k]
                for j in range(k + 1, n + 1):
                    if pivot[j] != 0:
                        row[j] = row[j] - factor * pivot[j]
    x = [0] * n
    for k in range(n - 1, -1, -1):
        row = rows[k]
        total = row[n]
        for j in range(k + 1, n):
            if row[j] != 0:
                total = total - row[j] * x[j]
        x[k] = total / row[k]
    return x


class Machine:
    """name: the model file without ending. start: guesses of coordinates, by name. inputs: held or driven coordinates."""

    def __init__(self, name, source, joints, points, start, inputs, freedom=None):
        self.name, self.source, self.joints = name, source, joints
        self.points = {key: (body, (exact(at[0]), exact(at[1]))) for key, (body, at) in points.items()}
        self.start = {key: exact(value) for key, value in start.items()}
        self.inputs = list(inputs)
        self.freedom = len(self.inputs) if freedom is None else freedom
        self.bodies = []
        for joint in joints:
            for body in (joint.a, joint.b):
                if body != "ground" and body not in self.bodies:
                    self.bodies.append(body)
        self.index = {body: 3 * i for i, body in enumerate(self.bodies)}
        self.size = self._size()

    def _size(self):
        at = {}
        for joint in self.joints:
            at.setdefault(joint.a, []).append(joint.p)
            at.setdefault(joint.b, []).append(joint.q)
        for body, point in self.points.values():
            at.setdefault(body, []).append(point)
        best = mpf(0)
        for list_ in at.values():
            for p in list_:
                for q in list_:
                    best = max(best, mp.hypot(p[0] - q[0], p[1] - q[1]))
        for name in self.start:
            if not self.is_angle(name):
                best = max(best, abs(self.start[name]))
        return best if best > 0 else mpf(1)

    def coordinates(self):
        names = []
        for joint in self.joints:
            names += [name for name in (joint.angle, joint.distance) if name]
        return names

    def is_angle(self, name):
        return any(joint.angle == name for joint in self.joints)

    # --- one pose -----------------------------------------------------------------------------------------------

    def tree_pose(self, values):
        """World poses of all bodies from the coordinates of the spanning tree: only a guess for Newton's method."""
        pose = {"ground": (mpf(0), mpf(0), mpf(0))}
        pending = [j for j in self.joints if j.angle or j.distance or j.kind == "weld"]
        while pending:
            left = []
            for joint in pending:
                if joint.a in pose and joint.b not in pose:
                    pose[joint.b] = self._other(joint, pose[joint.a], values, +1)
                elif joint.b in pose and joint.a not in pose:
                    pose[joint.a] = self._other(joint, pose[joint.b], values, -1)
                else:
                    left.append(joint)
            if len(left) == len(pending):
                raise ValueError(self.name + ": coordinates do not reach every body")
            pending = [j for j in left if j.a not in pose or j.b not in pose]
        vector = []
        for body in self.bodies:
            vector += list(pose[body])
        return vector

    def _other(self, joint, known, values, direction):
        angle = exact(values.get(joint.angle, 0)) if joint.angle else joint.turned
        distance = exact(values.get(joint.distance, 0)) if joint.distance else mpf(0)
        p = (joint.p[0] + distance * joint.u[0], joint.p[1] + distance * joint.u[1])
        own, others = (p, joint.q) if direction > 0 else (joint.q, p)
        x, y, phi = known
        c, s = mp.cos(phi), mp.sin(phi)
        wx, wy = x + c * own[0] - s * own[1], y + s * own[0] + c * own[1]
        phi = phi + direction * angle
        c, s = mp.cos(phi), mp.sin(phi)
        return (wx - c * others[0] + s * others[1], wy - s * others[0] - c * others[1], phi)

    def _frames(self, vector, number, cos, sin):
        frames = {"ground": (number(0), number(0), number(0), number(1), number(0))}
        for body in self.bodies:
            i = self.index[body]
            phi = vector[i + 2]
            frames[body] = (vector[i], vector[i + 1], phi, cos(phi), sin(phi))
        return frames

    def equations(self, vector, inputs, number, cos, sin):
        """Residuals and Jacobian rows (dicts column -> value) of all joints and inputs; dropped rows apart."""
        frames = self._frames(vector, number, cos, sin)
        kept, dropped = [], []
        for joint in self.joints:
            a, b = frames[joint.a], frames[joint.b]
            ia, ib = self.index.get(joint.a), self.index.get(joint.b)
            px, py = number(joint.p[0]), number(joint.p[1])
            qx, qy = number(joint.q[0]), number(joint.q[1])
            rpx, rpy = a[3] * px - a[4] * py, a[4] * px + a[3] * py
            rqx, rqy = b[3] * qx - b[4] * qy, b[4] * qx + b[3] * qy
            dx, dy = b[0] + rqx - a[0] - rpx, b[1] + rqy - a[1] - rpy
            ux, uy = number(joint.u[0]), number(joint.u[1])
            ux, uy = a[3] * ux - a[4] * uy, a[4] * ux + a[3] * uy
            nx, ny = -uy, ux

            def along(ex, ey, turns):
                """Row of e . (Q - P), where e turns with a when `turns`."""
                row = {}
                if ib is not None:
                    row[ib], row[ib + 1], row[ib + 2] = ex, ey, -ex * rqy + ey * rqx
                if ia is not None:
                    row[ia], row[ia + 1] = -ex, -ey
                    row[ia + 2] = ex * rpy - ey * rpx + ((-ey * dx + ex * dy) if turns else 0)
                return row

            def turn():
                row = {}
                if ib is not None:
                    row[ib + 2] = number(1)
                if ia is not None:
                    row[ia + 2] = number(-1)
                return row

            found = []
            if joint.kind in ("pin", "weld"):
                found.append(("x", dx, along(number(1), number(0), False)))
                found.append(("y", dy, along(number(0), number(1), False)))
            else:
                found.append(("n", nx * dx + ny * dy, along(nx, ny, True)))
            if joint.kind in ("slide", "weld"):
                found.append(("t", b[2] - a[2] - number(joint.turned), turn()))
            for key, residual, row in found:
                (dropped if key in joint.drop else kept).append((residual, row))
            if joint.angle in inputs:
                kept.append((b[2] - a[2] - number(inputs[joint.angle]), turn()))
            if joint.distance in inputs:
                kept.append((ux * dx + uy * dy - number(inputs[joint.distance]), along(ux, uy, True)))
        return kept, dropped

    def newton(self, vector, inputs, precise, iterations=60):
        """Closes all equations from a guess; None when it does not converge."""
        number, cos, sin = (mpf, mp.cos, mp.sin) if precise else (float, math.cos, math.sin)
        vector = [number(v) for v in vector]
        n = len(vector)
        size = number(self.size)
        target = size * (mpf(10) ** -52 if precise else 1e-13)
        for _ in range(iterations):
            kept, dropped = self.equations(vector, inputs, number, cos, sin)
            if len(kept) != n:
                raise ValueError("%s: %d equations for %d unknowns" % (self.name, len(kept), n))
            worst = max(abs(r) for r, _ in kept)
            if not worst < 1e30:
                return None
            if worst < target:
                if dropped and max(abs(r) for r, _ in dropped) > (mpf(10) ** -40 if precise else 1e-9) * size:
                    return None
                return vector
            matrix = [[row.get(j, 0) for j in range(n)] for _, row in kept]
            change = solve_linear(matrix, [-r for r, _ in kept])
            if change is None:
                return None
            # a step turns no body by more than half a radian and moves none by more than half the size
            longest = max(abs(change[i]) / (number(1) if i % 3 == 2 else size) for i in range(n))
            factor = number(1) if longest < 0.5 else number(1) / (2 * longest)
            vector = [v + factor * d for v, d in zip(vector, change)]
        return None

    # --- answers ------------------------------------------------------------------------------------------------

    def values(self, vector):
        """All coordinates, body angles and points of a solved pose."""
        frames = self._frames(vector, mpf, mp.cos, mp.sin)
        result = {}
        for joint in self.joints:
            a, b = frames[joint.a], frames[joint.b]
            if joint.angle:
                result[joint.angle] = b[2] - a[2]
            if joint.distance:
                p, q, u = joint.p, joint.q, joint.u
                dx = b[0] + b[3] * q[0] - b[4] * q[1] - a[0] - a[3] * p[0] + a[4] * p[1]
                dy = b[1] + b[4] * q[0] + b[3] * q[1] - a[1] - a[4] * p[0] - a[3] * p[1]
                result[joint.distance] = (a[3] * u[0] - a[4] * u[1]) * dx + (a[4] * u[0] + a[3] * u[1]) * dy
        for body in self.bodies:
            result[body + ".angle"] = frames[body][2]
        for name, (body, p) in self.points.items():
            x, y, _, c, s = frames[body]
            result[name + ".x"] = x + c * p[0] - s * p[1]
            result[name + ".y"] = y + s * p[0] + c * p[1]
        return result

    def angles(self):
        return [n for n in self.coordinates() if self.is_angle(n)] + [b + ".angle" for b in self.bodies]

    def at_start(self, inputs):
        """The pose that closes nearest to the start guesses, in floats: Newton from the tree's pose at these inputs."""
        values = dict(self.start)
        values.update(inputs)
        return self.newton(self.tree_pose(values), inputs, False)

    def follow(self, vector, begin, end, steps=90):
        """Moves from inputs `begin` to `end` in small steps, staying on the branch; None when it is lost."""
        before = None
        for k in range(1, steps + 1):
            inputs = {n: begin[n] + (end[n] - begin[n]) * k / steps for n in begin}
            guess = vector if before is None else [2 * v - w for v, w in zip(vector, before)]
            solved = self.newton(guess, inputs, False, 12)
            if solved is None:
                return None
            before, vector = vector, solved
        return vector

    def motion(self, vector, at, rate, accel):
        """Values, rates and accelerations of everything, to about 30 digits, near a pose found in floats."""
        samples = []
        for t in (-STEP, mpf(0), STEP):
            inputs = {n: mpf(at[n]) + mpf(rate.get(n, 0)) * t + mpf(accel.get(n, 0)) * t * t / 2 for n in self.inputs}
            solved = self.newton(vector, inputs, True, 20)
            if solved is None:
                raise ValueError(self.name + ": no convergence at " + str(at))
            samples.append(self.values(solved))
        low, middle, high = samples
        result = {}
        for name in middle:
            result[name] = middle[name]
            result[name + ".rate"] = (high[name] - low[name]) / (2 * STEP)
            result[name + ".accel"] = (high[name] - 2 * middle[name] + low[name]) / STEP ** 2
        return result

    def extreme(self, over, begin, near, channel):
        """The extreme value of a channel over an input, near a value of it: the root of its rate, by the secant method."""
        inputs = {over: begin}
        vector = self.follow(self.at_start(inputs), inputs, {over: near})
        rate = {over: 1}

        def slope(x):
            return self.motion(vector, {over: x}, rate, {})[channel + ".rate"]

        x0, x1 = mpf(near), mpf(near) + mpf("0.01")
        f0, f1 = slope(x0), slope(x1)
        while abs(x1 - x0) > mpf(10) ** -20 and f1 != f0:
            x0, x1, f0 = x1, x1 - f1 * (x1 - x0) / (f1 - f0), f1
            f1 = slope(x1)
        return self.motion(vector, {over: x1}, rate, {})[channel]

    def closed(self, vector, inputs):
        """Values only, to 50 digits."""
        return self.values(self.newton(vector, {n: mpf(v) for n, v in inputs.items()}, True, 20))

    def distance_to_start(self, values):
        """The measure by which the format chooses a configuration: squared differences to the guesses."""
        total = mpf(0)
        for name, guess in self.start.items():
            difference = values[name] - guess
            if self.is_angle(name):
                difference = difference - 2 * mp.pi * mp.nint(difference / (2 * mp.pi))
            else:
                difference /= self.size
            if name not in self.inputs:
                total += difference ** 2
        return total

    def configurations(self, inputs, tries=300, seed=1):
        """Configurations found from random starts (coordinates of each); complete only with luck: a check, not a proof."""
        chance = random.Random(seed)
        found = []
        for _ in range(tries):
            guess = {}
            for name in self.coordinates():
                guess[name] = chance.uniform(-math.pi, math.pi) if self.is_angle(name) else \
                    chance.uniform(-2, 2) * float(self.size)
            guess.update(inputs)
            solved = self.newton(self.tree_pose(guess), inputs, False)
            if solved is None:
                continue
            values = self.values([mpf(v) for v in solved])
            if not any(self.same(values, other) for other, _ in found):
                found.append((values, solved))
        return found

    def same(self, a, b):
        for name in self.coordinates():
            difference = a[name] - b[name]
            if self.is_angle(name):
                difference = difference - 2 * mp.pi * mp.nint(difference / (2 * mp.pi))
            if abs(difference) > 1e-6 * (1 if self.is_angle(name) else self.size):
                return False
        return True
