#!/usr/bin/env python3
"""Runs OMPL's trees on the scenes of `forage bench trees`, with as many runs and evaluations, and puts both in one table.

    forage bench trees --out trees
    target/bench/bin/python scripts/ompl-trees.py trees
    target/bench/bin/ompl_benchmark_statistics trees/ompl/*.log trees/ompl-peers/*.log -d trees.db

An evaluation is a straight segment that is checked for collisions, by the exact test of the scene. Scenes with discs and grids only. OMPL's
planners have a range of a thirtieth of the box's extent and its own goal bias; their paths are simplified, as ours are, which is not counted.
The times are those of tests in Python: they say nothing about OMPL. Writes trees/ompl-peers/NAME.log and trees/ompl.md.
"""

import csv
import json
import re
import statistics
import sys
import time
from pathlib import Path

import numpy
from ompl import base, geometric, util

STEP, BIAS = 0.03, 0.05
PLANNERS = ["RRT", "RRTConnect", "RRTstar"]
TOUCH = 1e-9


class Discs:
    def __init__(self, scene):
        self.low, self.high = scene["bounds"]["min"], scene["bounds"]["max"]
        self.centers = numpy.array([disc["center"] for disc in scene["discs"]])
        self.radii = numpy.array([disc["radius"] for disc in scene["discs"]])

    def is_free(self, a, b):
        along = b - a
        squared = along @ along
        share = numpy.clip((self.centers - a) @ along / squared, 0.0, 1.0) if squared > 0 else numpy.zeros(len(self.radii))
        nearest = a + share[:, None] * along
        return bool((numpy.hypot(*(nearest - self.centers).T) >= self.radii - TOUCH).all())


class Grid:
    def __init__(self, scene):
        rows, cell = scene["rows"], scene["cell"]
        if scene.get("y_axis", "down") == "up":
            rows = rows[::-1]
        self.low, self.high = [0.0, 0.0], [len(rows[0]) * cell, len(rows) * cell]
        blocked = [[x, y] for y, row in enumerate(rows) for x, kind in enumerate(row) if kind == "#"]
        self.cells = numpy.array(blocked, dtype=float).reshape(-1, 2) * cell
        self.cell = cell

    def is_free(self, a, b):
        """The piece must not pass through the inside of a blocked cell; it may touch its border."""
        enter, leave = numpy.zeros(len(self.cells)), numpy.ones(len(self.cells))
        for axis in range(2):
            low, high = self.cells[:, axis] + TOUCH, self.cells[:, axis] + self.cell - TOUCH
            along = b[axis] - a[axis]
            if along == 0.0:
                outside = (a[axis] <= low) | (a[axis] >= high)
                enter[outside], leave[outside] = 1.0, 0.0
            else:
                first, last = (low - a[axis]) / along, (high - a[axis]) / along
                enter = numpy.maximum(enter, numpy.minimum(first, last))
                leave = numpy.minimum(leave, numpy.maximum(first, last))
        return not bool((enter < leave).any())


class Tests(base.MotionValidator):
    """Counts what is tested."""

    def __init__(self, information, scene):
        super().__init__(information)
        self.scene, self.count = scene, 0

    def checkMotion(self, a, b):
        self.count += 1
        return self.scene.is_free(numpy.array([a[0], a[1]]), numpy.array([b[0], b[1]]))


def run(scene, start, goal, planner, budget):
    """One run: whether there is a free way, its length, tests until the budget or the end, nodes, seconds."""
    space = base.RealVectorStateSpace(2)
    bounds = base.RealVectorBounds(2)
    for axis in range(2):
        bounds.setLow(axis, float(scene.low[axis]))
        bounds.setHigh(axis, float(scene.high[axis]))
    space.setBounds(bounds)
    setup = geometric.SimpleSetup(space)
    information = setup.getSpaceInformation()
    tests = Tests(information, scene)
    setup.setStateValidityChecker(lambda state: True)
    information.setMotionValidator(tests)
    ends = []
    for point in (start, goal):
        state = space.allocState()
        state[0], state[1] = float(point[0]), float(point[1])
        ends.append(state)
    setup.setStartAndGoalStates(*ends)
    tree = getattr(geometric, planner)(information)
    tree.setRange(STEP * space.getMaximumExtent())
    if hasattr(tree, "setGoalBias"):
        tree.setGoalBias(BIAS)
    setup.setPlanner(tree)
    begun = time.perf_counter()
    status = str(setup.solve(base.PlannerTerminationCondition(lambda: tests.count >= budget)))
    seconds, spent = time.perf_counter() - begun, tests.count
    data = base.PlannerData(information)
    tree.getPlannerData(data)
    solved = status == "Exact solution"
    length = None
    if solved:
        setup.simplifySolution()
        points = [numpy.array([state[0], state[1]]) for state in setup.getSolutionPath().getStates()]
        solved = all(scene.is_free(a, b) for a, b in zip(points, points[1:]))
        length = float(sum(numpy.hypot(*(b - a)) for a, b in zip(points, points[1:])))
    return {"solved": solved, "length": length if solved else None, "evaluations": spent, "nodes": data.numVertices(), "seconds": seconds}


def log(name, budget, runs, results):
    """As `forage bench trees` writes it."""
    properties = ["time REAL", "solved BOOLEAN", "solution length REAL", "evaluations INTEGER", "graph states INTEGER"]
    lines = ["OMPL version " + version(), f"Experiment {name}", "1 experiment properties", f"budget INTEGER = {budget}"]
    lines += ["Running on unknown", "Starting at " + time.strftime("%Y-%m-%d %H:%M:%S", time.gmtime())]
    lines += ["<<<|", "The scene of forage; times of tests in Python", "|>>>", "1 is the random seed"]
    lines += ["inf seconds per run", "inf MB per run", f"{runs} runs per planner"]
    lines += [f"{sum(one['seconds'] for own in results.values() for one in own)} seconds spent to collect the data", "0 enum types"]
    lines += [f"{len(results)} planners"]
    for planner, own in results.items():
        lines += [f"OMPL {planner}", "0 common properties", f"{len(properties)} properties for each run", *properties, f"{len(own)} runs"]
        for one in own:
            length = "" if one["length"] is None else one["length"]
            values = [one["seconds"], int(one["solved"]), length, one["evaluations"], one["nodes"]]
            lines.append("".join(f"{value}; " for value in values))
        lines.append(".")
    return "\n".join(lines) + "\n"


def version():
    from importlib import metadata

    return metadata.version("ompl")


def row(name, planner, results):
    median = lambda values: f"{statistics.median(values):.4g}" if values else ""
    solved = [one for one in results if one["solved"]]
    lengths, nodes = [one["length"] for one in solved], [one["nodes"] for one in results if one["nodes"] is not None]
    evaluations = [one["evaluations"] for one in results]
    return f"| {name} | {planner} | {len(solved)} of {len(results)} | {median(lengths)} | {median(evaluations)} | {median(nodes)} |"


def ours(folder):
    """The rows of the suite: by scene and planner."""
    found = {}
    with open(folder / "rows.csv", newline="") as file:
        for one in csv.DictReader(file):
            number = lambda name: float(one[name]) if one[name] else None
            planner = " ".join(part for part in (one["planner"], one["params"]) if part)
            values = {"solved": one["solved"] == "true", "length": number("length"), "evaluations": number("evaluations"), "nodes": number("nodes")}
            found.setdefault(one["scene"], {}).setdefault(planner, []).append({**values, "budget": int(one["budget"])})
    return found


def main():
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "rows.csv").is_file():
        sys.exit("usage: ompl-trees.py DIR, the folder of forage bench trees")
    folder = Path(sys.argv[1])
    known = ours(folder)
    util.noOutputHandler()
    util.RNG.setSeed(1)
    title = "Trees of forage and of OMPL on the same scenes, with the same budget: runs solved, medians of length, evaluations and nodes"
    table = [f"**{title}**", "", "| scene | planner | solved | length | evaluations | nodes |", "| --- | --- | --- | --- | --- | --- |"]
    for file in sorted((folder / "ompl").glob("*.json")):
        scene = json.loads(file.read_text())
        kind = {"discs": Discs, "grid": Grid}.get(scene["kind"])
        own = known.get(scene["name"])
        if kind is None or own is None:
            continue
        # What the suite ran last: its rows may also have those of other budgets and scenes.
        log_of_ours = (folder / "ompl" / f"{file.stem}.log").read_text()
        budget = int(re.search(r"^budget INTEGER = (\d+)$", log_of_ours, re.M)[1])
        runs = int(re.search(r"^(\d+) runs per planner$", log_of_ours, re.M)[1])
        own = {planner: [one for one in rows if one["budget"] == budget][-runs:] for planner, rows in own.items()}
        world = kind(scene)
        results = {planner: [run(world, scene["start"], scene["goal"], planner, budget) for _ in range(runs)] for planner in PLANNERS}
        (folder / "ompl-peers").mkdir(exist_ok=True)
        (folder / "ompl-peers" / f"{file.stem}.log").write_text(log(scene["name"], budget, runs, results))
        table += [row(scene["name"], planner, found) for planner, found in own.items()]
        table += [row(scene["name"], f"OMPL {planner}", found) for planner, found in results.items()]
    text = "\n".join(table) + "\n"
    (folder / "ompl.md").write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main()
