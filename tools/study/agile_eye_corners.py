"""Where in the box of the joint errors is the Agile Eye's rotational error largest?

    python3 agile_eye_corners.py [--nodes N]

Briot & Bonev (2008) found it to be inside the box most of the time. Here the largest on a 9 x 9 x 9 grid of joint
errors up to 0.01 degrees is sought at random orientations, with the paper's equations 1 and 2 and with those of
chasles/tilt.h, each in double and in single precision: how often is it not at a corner?
"""

import argparse

import numpy as np

ERROR = np.radians(0.01)
BASE = np.array([[2, 0, 1], [-1, 1, 1], [-1, -1, 1]]) / np.sqrt([6, 2, 3])
PLATFORM = np.array([[1, -1, 1], [1, 1, 1], [-2, 0, 1]]) / np.sqrt([6, 2, 3])
NEXT = (1, 2, 0)


def about(axis, angle):
    R = np.eye(3)
    i, j = NEXT[axis], NEXT[NEXT[axis]]
    R[i, i] = R[j, j] = np.cos(angle)
    R[j, i] = np.sin(angle)
    R[i, j] = -R[j, i]
    return R


def random_orientation(rng):
    phi, theta = rng.uniform(0, 2 * np.pi), rng.uniform(0, np.pi)
    sigma = np.radians(rng.choice(range(0, 121, 20)))
    return BASE @ about(2, phi) @ about(1, theta) @ about(2, sigma - phi) @ PLATFORM.T


def leg(R, i):
    """(cosine, sine) of joint i, times the sine of the angle between its leg's two ends."""
    j, k = NEXT[i], NEXT[NEXT[i]]
    return R[j, j], R[k, j]


def direct(q):
    """Assembly mode 0 of chasles/agile_eye.h for joint angles q[n, 3]."""
    s, c = np.sin(q), np.cos(q)
    D = np.prod(s, axis=1) + np.prod(c, axis=1)
    R = np.empty((len(q), 3, 3), q.dtype)
    for i in range(3):
        j, k = NEXT[i], NEXT[NEXT[i]]
        column = np.empty((len(q), 3), q.dtype)
        column[:, i] = s[:, j] * s[:, i] * c[:, k] * c[:, i] - c[:, j] * s[:, k]
        column[:, j], column[:, k] = c[:, i] * D, s[:, i] * D
        R[:, :, j] = column / np.sqrt(np.sum(column**2, axis=1, keepdims=True))
    return R


def as_printed(r):
    """Equations 1 and 2, the sum of the two angles brought into [-pi, pi]."""
    alpha = np.arccos(np.minimum(r[:, 2, 2], 1))
    with np.errstate(divide="ignore", invalid="ignore"):
        sine = np.sin(alpha)
        beta = np.arctan2(r[:, 2, 1] / sine, -r[:, 2, 0] / sine) + np.arctan2(r[:, 1, 2] / sine, r[:, 0, 2] / sine)
    beta = np.where(alpha == 0, np.arctan2(r[:, 1, 0], r[:, 0, 0]), beta)
    return alpha, np.abs((beta + np.pi) % (2 * np.pi) - np.pi)


def as_in_tilt(r):
    alpha = np.arctan2(np.hypot(r[:, 0, 2], r[:, 1, 2]), r[:, 2, 2])
    return alpha, np.abs(np.arctan2(r[:, 1, 0] - r[:, 0, 1], r[:, 0, 0] + r[:, 1, 1]))


def main():
    parser = argparse.ArgumentParser(description="How often the largest error is not at a corner of the error box.")
    parser.add_argument("--nodes", type=int, default=2000, help="random orientations")
    nodes = parser.parse_args().nodes
    values = np.linspace(-1, 1, 9)
    grid = np.stack(np.meshgrid(values, values, values), axis=-1).reshape(-1, 3)
    at_corner = np.all(np.abs(grid) == 1, axis=1)
    print("largest error not at a corner      alpha    beta")
    for precision in (np.float64, np.float32):
        for name, measure in (("equations 1 and 2", as_printed), ("chasles/tilt.h", as_in_tilt)):
            rng = np.random.default_rng(2008)
            inside, done = np.zeros(2), 0
            while done < nodes:
                R = random_orientation(rng)
                legs = [leg(R, i) for i in range(3)]
                if min(np.hypot(c, s) for c, s in legs) < 0.05:
                    continue  # 3 degrees from a singular curve
                q = np.array([np.arctan2(s, c) for c, s in legs])
                nominal, actual = (direct(x.astype(precision)) for x in (q[None], q + ERROR * grid))
                mode = np.sign(np.sum(nominal[0] * R, axis=0)).astype(precision)
                tool = PLATFORM.astype(precision)
                relative = np.einsum("ji,njk->nik", (nominal[0] * mode) @ tool, (actual * mode) @ tool)
                inside += [not at_corner[np.argmax(np.nan_to_num(x))] for x in measure(relative)]
                done += 1
            print("%-8s %-20s %9.1f%% %7.1f%%" % ((np.dtype(precision).name, name) + tuple(100 * inside / nodes)))


if __name__ == "__main__":
    main()
