#!/usr/bin/env python3
"""Poses of the PUMA with all branches of inverse kinematics by two independent libraries, which tests/arm_ik.rs compares with ours.

    scripts/setup bench
    target/bench/bin/python scripts/arm-ik.py 100000 > poses.bin
    FORAGE_ARM_IK=poses.bin cargo test --test arm_ik
    target/bench/bin/python scripts/arm-ik.py 120 > tests/arm_ik.bin

The libraries are EAIK (subproblems in closed form) and ssik (another derivation in closed form). A pose is that of a random posture; one in
three is singular: the wrist is stretched or folded back, the elbow is stretched or folded, or the wrist is beside the first axis. Only
branches count that forward kinematics, computed here, takes back to the pose.

Numbers in the file, all of 64 bits: for each pose the kind, a number of KINDS; the pose's first three rows; the posture that it was made of, in
radians; for each library how many branches it has, and their six angles. Where the wrist is stretched both libraries may miss a branch, but
not the posture itself.
"""

import json
import math
import sys
from pathlib import Path

import numpy
from eaik.IK_HP import HPRobot
from ssik import Manipulator

SCENE = Path(__file__).resolve().parent.parent / "scenes/arm-puma.json"
KINDS = ["any", "wrist stretched", "wrist folded", "elbow", "beside the first axis"]
# The kinds by turns.
ORDER = [0, 0, 1, 0, 0, 3, 0, 0, 2, 0, 0, 4]
# What forward kinematics takes back to the pose up to this is a branch.
TOLERANCE = 1e-9


class Arm:
    def __init__(self):
        arm = json.loads(SCENE.read_text())["arm"]
        self.joints, self.tool, self.base = arm["joints"], arm["tool"]["length"], arm["base"]
        assert arm["tool"]["axis"] == "z"
        # The places and axes of the joints where all angles are 0: products of exponentials need no more.
        frame = self.foot()
        axes, places = [], []
        for joint in self.joints:
            frame = frame @ turned_x(math.radians(joint["alpha"])) @ moved(joint["a"], 0, 0)
            axes.append(frame[:3, 2].copy())
            places.append(frame[:3, 3].copy())
            frame = frame @ moved(0, 0, joint["d"])
        tip = frame @ moved(0, 0, self.tool)
        assert numpy.allclose(tip[:3, :3], numpy.eye(3)), "the libraries take the tip's frame for that of the base"
        self.axes = numpy.array(axes)
        self.offsets = numpy.vstack([places[0], numpy.diff(places, axis=0), tip[:3, 3] - places[-1]])

    def foot(self):
        return moved(*self.base["position"]) @ turned_z(math.radians(self.base.get("yaw", 0)))

    def forward(self, q):
        frame = self.foot()
        for joint, angle in zip(self.joints, q):
            frame = frame @ turned_x(math.radians(joint["alpha"])) @ moved(joint["a"], 0, 0) @ turned_z(angle) @ moved(0, 0, joint["d"])
        return frame @ moved(0, 0, self.tool)

    def posture(self, kind, random):
        """A random posture of a kind."""
        q = random.uniform(-math.pi, math.pi, 6)
        upper, (a3, d4) = self.joints[2]["a"], (self.joints[3]["a"], self.joints[3]["d"])
        if kind == 1:
            q[4] = 0.0
        elif kind == 2:
            q[4] = math.pi
        elif kind == 3:
            # The wrist is at (a3, −d4) of the elbow: in line with the shoulder where that is turned into the upper arm.
            q[2] = math.atan2(d4, a3) + (math.pi if random.random() < 0.5 else 0.0)
        elif kind == 4:
            # Shoulder to wrist must point along the first axis: the second angle follows from the third.
            x = upper + a3 * math.cos(q[2]) + d4 * math.sin(q[2])
            y = a3 * math.sin(q[2]) - d4 * math.cos(q[2])
            # Across the first axis the wrist is x cos q2 − y sin q2.
            q[1] = math.atan2(x, y)
        return q


def moved(x, y, z):
    frame = numpy.eye(4)
    frame[:3, 3] = [x, y, z]
    return frame


def turned_x(angle):
    c, s = math.cos(angle), math.sin(angle)
    return numpy.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1.0]])


def turned_z(angle):
    c, s = math.cos(angle), math.sin(angle)
    return numpy.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])


def main():
    count = int(sys.argv[1])
    random = numpy.random.default_rng(7)
    arm = Arm()
    first, second = HPRobot(arm.axes, arm.offsets), Manipulator.from_axes(arm.axes, arm.offsets)
    out = sys.stdout.buffer
    for k in range(count):
        kind = ORDER[k % len(ORDER)]
        posture = arm.posture(kind, random)
        pose = arm.forward(posture)
        branches = [
            [numpy.asarray(q) for q in first.IK(pose).Q],
            [solution.q for solution in second.solve(pose, respect_limits=False, enumerate_windings=False)],
        ]
        numbers = [float(kind), *pose[:3].ravel(), *posture]
        for found in branches:
            found = [q for q in found if numpy.isfinite(q).all() and numpy.abs(arm.forward(q) - pose).max() < TOLERANCE]
            numbers += [float(len(found)), *(angle for q in found for angle in q)]
        out.write(numpy.array(numbers, dtype="<f8").tobytes())


if __name__ == "__main__":
    main()
