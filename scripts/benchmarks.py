#!/usr/bin/env python3
"""Runs the suites of `forage bench` and other programs for comparison, and writes docs/benchmarks.json, from which docs/benchmarks.md is
generated.

    scripts/setup bench && target/bench/bin/python -m pip install cma==4.5.0 ortools==9.15.6755
    cargo build --release --package forage-lab-cli
    target/bench/bin/python scripts/benchmarks.py --movingai maps --tsplib tsplib95 --barn the-barn-challenge
    node scripts/docs.mjs

The folders are copies of the suites' data, which does not ship. Takes about half an hour on two cores, most of it CMA-ES.

Peers: CMA-ES by the package cma on COCO's own functions, with the targets and the budget of `forage bench bbob`; OR-Tools' routing on the
instances of TSPLIB with rounded straight distances, from its cheapest arcs by its default local search until nothing improves.
"""

import argparse
import csv
import json
import math
import os
import platform
import re
import shutil
import subprocess
import sys
import time
from importlib import metadata
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FORAGE = Path(os.environ.get("FORAGE", ROOT / "target/release/forage"))
TARGETS = [10 ** (2 - 0.2 * k) for k in range(51)]
DIMENSIONS, INSTANCES, BUDGET = [2, 3, 5, 10, 20, 40], range(1, 6), 1000
LARGEST = 200


def table(file):
    with open(file, newline="") as lines:
        columns, *rows = csv.reader(lines)
    return {"columns": columns, "rows": rows}


def suite(out, name, *arguments, shown=()):
    """Runs a suite; its table, its command as it is to be shown, and how long it took."""
    folder = out / name
    command = [name, *[str(argument) for argument in arguments]]
    begun = time.perf_counter()
    ended = subprocess.run([str(FORAGE), "bench", *command, "--out", str(folder), "--fresh"], capture_output=True, text=True)
    if ended.returncode != 0:
        sys.exit(f"{name}: {ended.stderr[-2000:]}")
    for path, stand_in in shown:
        command = [stand_in if argument == str(path) else argument for argument in command]
    seconds = round(time.perf_counter() - begun)
    print(f"{name}: {seconds} s", file=sys.stderr)
    return {"command": "forage bench " + " ".join(command), "seconds": seconds, **table(folder / "table.csv")}


class Spent(Exception):
    pass


def cma_es():
    """The row of the suite's table for CMA-ES: share of targets by dimension and in all, runs solved, runs that ended early."""
    import cma
    import cocoex

    reached, solved, early, runs = {dimension: 0 for dimension in DIMENSIONS}, 0, 0, 0
    options = f"dimensions:{','.join(map(str, DIMENSIONS))} instance_indices:{','.join(map(str, INSTANCES))}"
    for problem in cocoex.Suite("bbob", f"instances:{','.join(map(str, INSTANCES))}", options):
        dimension, budget = problem.dimension, BUDGET * problem.dimension
        best = {"gap": math.inf, "spent": 0}
        minimum = optimum(problem)

        def cost(x):
            if best["spent"] >= budget or best["gap"] <= 1e-8:
                raise Spent
            best["spent"] += 1
            value = problem(x)
            best["gap"] = min(best["gap"], value - minimum)
            return value

        options_of_cma = {"verbose": -9, "seed": problem.id_instance, "bounds": [-5, 5], "maxfevals": budget}
        try:
            cma.fmin2(cost, problem.initial_solution, 2, options_of_cma, restarts=9)
            early += 1
        except Spent:
            pass
        reached[dimension] += sum(best["gap"] <= target for target in TARGETS)
        solved += best["gap"] <= 1e-8
        runs += 1
    of_each = 24 * len(INSTANCES) * len(TARGETS)
    shares = [reached[dimension] / of_each for dimension in DIMENSIONS]
    return ["CMA-ES", *map(str, shares), str(sum(shares) / len(shares)), f"{solved} of {runs}", str(early)]


def optimum(problem):
    """The least value of a function of COCO: at its optimum, which the package writes into a file when it is asked."""
    problem._best_parameter("print")
    x = [float(number) for number in Path("._bbob_problem_best_parameter.txt").read_text().split()]
    Path("._bbob_problem_best_parameter.txt").unlink()
    return problem(x)


def or_tools(folder, rows):
    """The mean gap of OR-Tools over the instances with rounded straight distances, and those of Forage over the same ones."""
    from ortools.constraint_solver import pywrapcp, routing_enums_pb2

    optima = {row["instance"]: float(row["optimum"]) for row in rows if row["optimum"]}
    gaps = {}
    for file in sorted(folder.rglob("*.tsp")):
        text = file.read_text()
        field = lambda key: (re.search(rf"^{key}\s*:\s*(\S+)", text, re.M) or [None, ""])[1]
        name = next((name for name in optima if name == field("NAME") or name == file.stem), None)
        if name is None or field("EDGE_WEIGHT_TYPE") != "EUC_2D":
            continue
        words = text.split("NODE_COORD_SECTION")[1].split()
        n = int(field("DIMENSION"))
        points = [(float(words[3 * k + 1]), float(words[3 * k + 2])) for k in range(n)]
        distance = [[int(math.hypot(a - c, b - d) + 0.5) for c, d in points] for a, b in points]
        manager = pywrapcp.RoutingIndexManager(n, 1, 0)
        model = pywrapcp.RoutingModel(manager)
        arc = model.RegisterTransitMatrix(distance)
        model.SetArcCostEvaluatorOfAllVehicles(arc)
        parameters = pywrapcp.DefaultRoutingSearchParameters()
        parameters.first_solution_strategy = routing_enums_pb2.FirstSolutionStrategy.PATH_CHEAPEST_ARC
        solution = model.SolveWithParameters(parameters)
        gaps[name] = solution.ObjectiveValue() / optima[name] - 1
    return gaps


def machine():
    cpu = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text())
    memory = re.search(r"MemTotal:\s*(\d+)", Path("/proc/meminfo").read_text())
    return {
        "cpu": cpu[1] if cpu else platform.processor(),
        "cores": os.cpu_count(),
        "memory_gib": round(int(memory[1]) / 2**20) if memory else None,
        "system": platform.system(),
        "python": platform.python_version(),
        "forage": subprocess.run([str(FORAGE), "--version"], capture_output=True, text=True).stdout.split()[-1],
        "libraries": {name: metadata.version(name) for name in ["cma", "coco-experiment", "ompl", "ortools"]},
    }


def bbob(out, _given):
    lists = ["--dimensions", ",".join(map(str, DIMENSIONS)), "--instances", f"{INSTANCES[0]}-{INSTANCES[-1]}"]
    return {**suite(out, "bbob", *lists, "--budget", BUDGET), "peers": [cma_es()]}


def centre_bias(out, _given):
    return suite(out, "centre-bias")


def movingai(out, given):
    """The graph searches on all problems, and all planners on the smallest map alone: a colony takes minutes for a problem on a large one."""
    results = suite(out, "movingai", given.movingai, shown=[(given.movingai, "maps")])
    smallest = min(given.movingai.rglob("*.map"), key=lambda path: (path.stat().st_size, path.name))
    folder = out / smallest.stem
    folder.mkdir(parents=True, exist_ok=True)
    for file in [smallest, smallest.with_name(smallest.name + ".scen")]:
        shutil.copy(file, folder)
    catalogue = json.loads(subprocess.run([str(FORAGE), "list", "--json"], capture_output=True, text=True, check=True).stdout)
    planners = [entry["name"] for entry in catalogue["planners"] if "grid" in entry["kinds"] and not entry["stops"]]
    arguments = ["--per-bucket", 1, "--planners", ",".join(planners)]
    return {**results, "all": suite(out, "movingai", folder, *arguments, shown=[(folder, smallest.stem)])}


def tsplib(out, given):
    planners = "two-opt,sa,ga,bat,hybrid-bat,tour-pso"
    results = suite(out, "tsplib", given.tsplib, "--largest", LARGEST, "--planners", planners, shown=[(given.tsplib, "tsplib95")])
    with open(out / "tsplib/rows.csv", newline="") as lines:
        rows = list(csv.DictReader(lines))
    gaps = or_tools(given.tsplib, rows)
    means = {}
    for row in rows:
        if row["instance"] in gaps and row["length"]:
            means.setdefault(row["planner"], []).append(float(row["length"]) / float(row["optimum"]) - 1)
    mean = lambda values: 100 * sum(values) / len(values)
    budget = int(rows[0]["budget"]) / int(rows[0]["stops"])
    # Moves of one tour are quick enough for the largest.
    largest = suite(out, "tsplib", given.tsplib, "--planners", "two-opt", shown=[(given.tsplib, "tsplib95")])
    same = {"instances": len(gaps), "budget": budget, "gaps": {planner: mean(values) for planner, values in means.items()}}
    return {**results, "same": {**same, "OR-Tools": mean(list(gaps.values()))}, "all": largest}


def trees(out, _given):
    results = suite(out, "trees", "--runs", 20)
    ended = subprocess.run([sys.executable, str(ROOT / "scripts/ompl-trees.py"), str(out / "trees")], capture_output=True, text=True)
    if ended.returncode != 0:
        sys.exit(ended.stderr[-2000:])
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in ended.stdout.splitlines() if line.startswith("| ")]
    return {**results, "peers": {"columns": lines[0], "rows": lines[2:]}}


def barn(out, given):
    return suite(out, "barn", given.barn, shown=[(given.barn, "the-barn-challenge")])


SUITES = {"bbob": bbob, "centre-bias": centre_bias, "movingai": movingai, "tsplib": tsplib, "trees": trees, "barn": barn}


def main():
    arguments = argparse.ArgumentParser()
    for name in ["movingai", "tsplib", "barn"]:
        arguments.add_argument(f"--{name}", type=Path, required=True)
    arguments.add_argument("--out", type=Path, default=ROOT / "target/benchmarks")
    arguments.add_argument("--only", nargs="+", choices=SUITES, default=list(SUITES), help="measure only these; the other results stay")
    given = arguments.parse_args()
    file = ROOT / "docs/benchmarks.json"
    results = json.loads(file.read_text()) if file.exists() else {}
    if results and set(given.only) != set(SUITES) and results["machine"] != machine():
        sys.exit("the other results are of another machine or of other versions: measure all")
    results["machine"] = machine()
    for name in given.only:
        results[name] = SUITES[name](given.out, given)
    ordered = {name: results[name] for name in ["machine", *SUITES]}
    file.write_text(json.dumps(ordered, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
