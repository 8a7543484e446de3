"""Forward kinematics and Jacobians of the robots beside those of other programs, an optional check.

    python3 cross_check.py PROGRAM [--cases N]

PROGRAM is the host program chasles. The others are Pinocchio (PyPI `pin`), the software of Modern Robotics (PyPI
`modern-robotics`) and KDL (Debian's python3-pykdl): those that are not installed are named and left out. Each builds the
robot anew from the rows of its file. For each pair the largest differences are printed, in eps of double: of rotations
and angular rows absolutely, of lengths relative to the length of the arm, sum of |a| + |d|. Two programs that are both
right differ by some eps a joint.
"""

import argparse
import math
import os
import random
import subprocess
import sys

ROBOTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "robots")
EPS = 2.0**-52


def read_rows(name):
    """(degrees?, [(a, alpha, d, theta)], tool z) of a file with rows of the standard convention, angles in radians."""
    rows, degrees = [], False
    with open(os.path.join(ROBOTS, name + ".robot"), encoding="ascii") as file:
        for line in file:
            words = line.split("#")[0].split()
            if words[:1] == ["angles"]:
                degrees = words[1] == "degrees"
            if words[:1] == ["rows"]:
                assert words[1] == "dh-standard"
            if words[:1] == ["revolute"]:
                a, alpha, d, theta = (float(x) for x in words[1:5])
                rows.append((a, math.radians(alpha), d, math.radians(theta)) if degrees else (a, alpha, d, theta))
    return degrees, rows


class Ours:
    name = "chasles"

    def __init__(self, program, robot):
        self.command = [program, "fk", "--exact", "--jacobian", "space", os.path.join(ROBOTS, robot + ".robot")]

    def evaluate(self, q, words):
        """(pose rows, space Jacobian rows, angular first); exit status 1 only tells of limits."""
        run = subprocess.run(self.command + words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        lines = [[float(x) for x in line.split()] for line in run.stdout.splitlines() if line[:1] in "-0123456789"]
        return lines[:3], lines[3:9]


class Pinocchio:
    name = "Pinocchio"

    def __init__(self, rows):
        import numpy
        import pinocchio

        self.numpy, self.pin = numpy, pinocchio
        self.model = pinocchio.Model()
        place, parent = pinocchio.SE3.Identity(), 0
        for i, (a, alpha, d, theta) in enumerate(rows):
            parent = self.model.addJoint(parent, pinocchio.JointModelRZ(), place, "joint%d" % i)
            turn = pinocchio.utils.rotate("z", theta) @ pinocchio.utils.rotate("x", alpha)
            way = numpy.array([a * math.cos(theta), a * math.sin(theta), d])
            place = pinocchio.SE3(turn, way)
        self.tool = place
        self.data = self.model.createData()

    def evaluate(self, q, words):
        J = self.pin.computeJointJacobians(self.model, self.data, self.numpy.array(q))
        T = (self.data.oMi[len(q)] * self.tool).homogeneous
        return T[:3].tolist(), J[3:].tolist() + J[:3].tolist()


class ModernRobotics:
    name = "Modern Robotics"

    def __init__(self, rows):
        import modern_robotics
        import numpy

        self.numpy, self.mr = numpy, modern_robotics
        T, self.screws = numpy.eye(4), []
        for a, alpha, d, theta in rows:
            self.screws.append(numpy.concatenate([T[:3, 2], numpy.cross(T[:3, 3], T[:3, 2])]))
            c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
            T = T @ numpy.array(
                [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
            )
        self.home, self.screws = T, numpy.array(self.screws).T

    def evaluate(self, q, words):
        T = self.mr.FKinSpace(self.home, self.screws, q)
        return T[:3].tolist(), self.mr.JacobianSpace(self.screws, q).tolist()


class KDL:
    name = "KDL"

    def __init__(self, rows):
        import PyKDL

        self.kdl = PyKDL
        self.chain = chain = PyKDL.Chain()  # the solvers do not keep it alive
        for a, alpha, d, theta in rows:
            chain.addSegment(PyKDL.Segment(PyKDL.Joint(PyKDL.Joint.RotZ), PyKDL.Frame.DH(a, alpha, d, theta)))
        self.fk = PyKDL.ChainFkSolverPos_recursive(chain)
        self.jacobian = PyKDL.ChainJntToJacSolver(chain)

    def evaluate(self, q, words):
        values = self.kdl.JntArray(len(q))
        for i, x in enumerate(q):
            values[i] = x
        frame, J = self.kdl.Frame(), self.kdl.Jacobian(len(q))
        self.fk.JntToCart(values, frame)
        self.jacobian.JntToJac(values, J)
        p = [frame.p[i] for i in range(3)]
        T = [[frame.M[i, j] for j in range(3)] + [p[i]] for i in range(3)]
        w = [[J[3 + i, j] for j in range(len(q))] for i in range(3)]
        # Its linear rows are those of the tool's point; p x omega brings them to the origin.
        v = [
            [J[i, j] + p[(i + 1) % 3] * w[(i + 2) % 3][j] - p[(i + 2) % 3] * w[(i + 1) % 3][j] for j in range(len(q))]
            for i in range(3)
        ]
        return T, w + v


def differences(ours, theirs, size):
    """(rotation, position, angular, linear), the largest differences in eps."""
    worst = [0.0] * 4
    for i in range(3):
        for j in range(4):
            kind = 1 if j == 3 else 0
            worst[kind] = max(worst[kind], abs(ours[0][i][j] - theirs[0][i][j]) / (size if kind else 1.0))
    for i in range(6):
        for mine, other in zip(ours[1][i], theirs[1][i]):
            kind = 3 if i >= 3 else 2
            worst[kind] = max(worst[kind], abs(mine - other) / (size if kind == 3 else 1.0))
    return [x / EPS for x in worst]


def peers(rows):
    for peer in (Pinocchio, ModernRobotics, KDL):
        try:
            yield peer(rows)
        except ImportError:
            print("%s is not installed" % peer.name)


def main():
    parser = argparse.ArgumentParser(description="Compare chasles with other programs.")
    parser.add_argument("program", help="the host program chasles")
    parser.add_argument("--cases", type=int, default=1000, metavar="N", help="random joint values a robot")
    arguments = parser.parse_args()
    worst_of_all = 0.0
    for robot in ("ur5e", "puma560"):
        degrees, rows = read_rows(robot)
        size = sum(abs(a) + abs(d) for a, _, d, _ in rows)
        rng = random.Random("chasles " + robot)
        ours, others = Ours(arguments.program, robot), list(peers(rows))
        worst = {other.name: [0.0] * 4 for other in others}
        for _ in range(arguments.cases):
            written = [rng.uniform(-180, 180) if degrees else rng.uniform(-math.pi, math.pi) for _ in rows]
            q = [x * (math.pi / 180.0) for x in written] if degrees else written
            words = [repr(x) for x in written]
            mine = ours.evaluate(q, words)
            for other in others:
                found = differences(mine, other.evaluate(q, words), size)
                worst[other.name] = [max(a, b) for a, b in zip(worst[other.name], found)]
        for name, found in worst.items():
            print("%-8s %-16s rotation %6.2f  position %6.2f  angular %6.2f  linear %6.2f eps" % (robot, name, *found))
            worst_of_all = max(worst_of_all, *found)
    return 0 if worst_of_all < 100 else 1


if __name__ == "__main__":
    sys.exit(main())
