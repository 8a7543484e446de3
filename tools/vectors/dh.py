"""Chains of joint axes and Denavit-Hartenberg parameters, exactly: line.h says what is chosen where there is a choice."""

from mpmath import atan2, cos, inf, mpf, pi, sin, sqrt

import exact
from exact import add, column, cross, dot, norm, subtract, times
from vectors import Unclear

X, Y, Z = ([mpf(i == k) for i in range(3)] for k in range(3))
ORIGIN = [mpf(0)] * 3


def step(axis, angle, travel):
    """The pose of a turn about, and a travel along, a coordinate axis."""
    return exact.axis_rotation(axis, angle), times(travel, axis)


def row_steps(modified, row):
    """(steps before the joint's axis is z, steps after) of a row (a, alpha, d, theta)."""
    link, joint = step(X, row[1], row[0]), step(Z, row[3], row[2])
    return ([link], [joint]) if modified else ([], [joint, link])


def from_rows(modified, base, rows, tool):
    """(lines (d, m), home)."""
    pose, lines = base, []
    for row in rows:
        before, after = row_steps(modified, row)
        for one in before:
            pose = exact.compose(pose, one)
        z = column(pose[0], 2)
        lines.append((z, cross(pose[1], z)))
        for one in after:
            pose = exact.compose(pose, one)
    return lines, exact.compose(pose, tool)


class Chain:
    """The frames of a chain of lines. `zero` is what counts as zero; anything near it is unclear."""

    def __init__(self, modified, lines, home, zero):
        self.modified = modified
        self.zero = zero
        tool = (column(home[0], 2), cross(home[1], column(home[0], 2)))
        raw = [Z + ORIGIN] + lines if modified else lines + [tool[0] + tool[1]]
        self.raw = raw
        self.lines = [exact.axis_line(x)[0] for x in raw]
        self.home = home
        self.reach = max([norm(home[1])] + [norm(x[3:6]) for x in lines])
        self.least_sine, self.least_gap = mpf(1), inf
        self.kinds = []

    def clear(self, x, limit):
        """Is x above the limit? Neither near it."""
        if limit / 4 < x < 4 * limit:
            raise Unclear
        return x > limit

    def across(self, z, first, second):
        along = abs(dot(first, z))
        if mpf("0.86") < along < mpf("0.872"):
            raise Unclear
        axis = second if along > mpf("0.866") else first
        return exact.unit(subtract(axis, times(dot(axis, z), z)))

    def sense(self, x, before):
        """x or -x, which turns less; x itself where it is a right angle."""
        turned = dot(x, before)
        return -1 if self.clear(abs(turned), self.zero) and turned < 0 else 1

    def link(self, k, x_before, origin):
        """(a, alpha, x axis, foot on line k - 1, foot on line k)."""
        a, b = self.lines[k - 1], self.lines[k]
        n = cross(a[0], b[0])
        sine, far = norm(n), self.reach + norm(a[1]) + norm(b[1])
        if self.clear(sine, self.zero):
            self.least_sine = min(self.least_sine, sine)
            turned = -(dot(a[0], b[1]) + dot(b[0], a[1]))
            x, gap, alpha = exact.unit(n), turned / sine, exact.line_angle(self.raw[k - 1], self.raw[k])
            meet = not self.clear(abs(turned), self.zero * far)
            if not meet and gap < 0:
                x, gap, alpha = times(-1, x), -gap, -alpha
            way = self.sense(x, x_before)
            self.kinds.append("meet" if meet else "skew")
            return (mpf(0) if meet else way * gap), way * alpha, times(way, x), *exact.line_gap(a, b)
        gap = exact.apply(exact.cross_twice(a[0]), subtract(cross(*b), cross(*a)))
        to_tool = not self.modified and k == len(self.lines) - 1
        foot_a = exact.nearest_point(a, self.home[1] if to_tool else origin)
        foot_b = exact.nearest_point(b, foot_a)
        alpha = mpf(0) if dot(a[0], b[0]) > 0 else +pi
        if not self.clear(norm(gap), self.zero * far):
            self.kinds.append("coincident")
            x = column(self.home[0], 0) if to_tool else x_before
            return mpf(0), alpha, x, foot_a, foot_b
        self.kinds.append("parallel")
        self.least_gap = min(self.least_gap, norm(gap))
        x = exact.unit(gap)
        way = self.sense(x, x_before)
        return way * norm(gap), alpha, times(way, x), foot_a, foot_b

    @staticmethod
    def joint(z, x, origin, next_x, next_origin):
        """(d, theta)"""
        theta = atan2(dot(z, cross(x, next_x)), dot(x, next_x))
        return dot(z, subtract(next_origin, origin)), theta

    @staticmethod
    def pose(z, x, origin):
        y = cross(z, x)
        return [v[i] for i in range(3) for v in (x, y, z)], origin

    def parameters(self):
        """(rows, base, tool)"""
        count = len(self.lines) - 1
        z = self.lines[0][0]
        x, origin = self.across(z, X, Y), cross(*self.lines[0])
        base, links, joints = self.pose(z, x, origin), [], []
        for k in range(1, count + 1):
            a, alpha, next_x, foot_a, foot_b = self.link(k, x, origin)
            links.append((a, alpha))
            joints.append(self.joint(z, x, origin, next_x, foot_a))
            if self.modified and k == 1:
                base = self.pose(z, next_x, foot_a)
            z, x, origin = self.lines[k][0], next_x, foot_b
        if self.modified:
            R, p = self.home
            last_x, last = self.across(z, column(R, 0), column(R, 1)), exact.nearest_point(self.lines[count], p)
            joints.append(self.joint(z, x, origin, last_x, last))
            if abs(abs(joints[-1][1]) - pi) < 1e-4:
                raise Unclear  # pi or -pi
            joints, x, origin = joints[1:], last_x, last
        tool = exact.compose(exact.inverse(self.pose(z, x, origin)), self.home)
        return [list(link) + list(joint) for link, joint in zip(links, joints)], base, tool

    def status(self):
        """9, 8 or 0, by the neighbours that are joint axes."""
        kinds = self.kinds[1:] if self.modified else self.kinds[:-1]
        return 9 if "coincident" in kinds else 8 if "parallel" in kinds else 0

    def condition(self):
        return max(mpf(1), 1 / self.least_sine, self.reach / self.least_gap)
