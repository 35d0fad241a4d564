"""The tools of the field read what Forage writes, as it is: COCO's cocopp, IOHprofiler's iohinspector, OMPL's log reader, polars.

scripts/test runs this with the Python of target/bench.
"""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# scripts/test builds it, and says where.
FORAGE = Path(os.environ.get("FORAGE", ROOT / "target/debug/forage"))
PLANNERS = ["pso", "qpso"]
FUNCTIONS = [1, 8]
DIMENSIONS = [2, 3, 5]
INSTANCES = range(1, 16)
BUDGET = 200


def text(numbers):
    return ",".join(str(number) for number in numbers)


class Bbob(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="forage-")))
        lists = ["--functions", text(FUNCTIONS), "--dimensions", text(DIMENSIONS), "--instances", text(INSTANCES)]
        command = [FORAGE, "bench", "bbob", "--planners", ",".join(PLANNERS), "--budget", str(BUDGET), *lists, "--out", "bbob"]
        subprocess.run([str(part) for part in command], cwd=cls.folder, check=True, capture_output=True)

    def test_cocopp_reads_each_run(self):
        import cocopp

        sets = cocopp.load([str(self.folder / "bbob/coco" / planner) for planner in PLANNERS])
        found = {(one.algId, one.funcId, one.dim) for one in sets}
        self.assertEqual(found, {(p, f, d) for p in PLANNERS for f in FUNCTIONS for d in DIMENSIONS})
        for one in sets:
            self.assertTrue(one.consistency_check(), one)
            self.assertEqual(list(one.instancenumbers), list(INSTANCES))
            self.assertTrue(all(0 < evaluations <= BUDGET * one.dim for evaluations in one.maxevals), one.maxevals)
            # What was reached in the end is what the rows say.
            rows = self.gaps(one.algId, one.funcId, one.dim)
            for at, gap in enumerate(one.finalfunvals):
                self.assertAlmostEqual(gap, max(rows[at], 0.0), delta=1e-8 * max(1.0, rows[at]))

    def test_expected_running_times_are_those_of_cocopp(self):
        import cocopp
        import math

        sets = cocopp.load([str(self.folder / "bbob/coco" / planner) for planner in PLANNERS])
        compared = 0
        for one in sets:
            expected = float(one.detERT([0.1])[0])
            cell = self.times(one.dim)[one.funcId][one.algId]
            if math.isinf(expected):
                self.assertEqual(cell, "")
                continue
            # `97 (60 to 132), 5 of 15`
            self.assertAlmostEqual(float(cell.split(" ")[0]), expected, delta=0.5 + 1e-6 * expected)
            self.assertEqual(int(cell.split(", ")[1].split(" ")[0]), int(one.detSuccesses([0.1])[0]))
            compared += 1
        self.assertGreater(compared, len(PLANNERS) * len(DIMENSIONS))

    def times(self, dimension):
        """The report's table of expected running times: by function, then by planner."""
        lines = (self.folder / "bbob/report.md").read_text().splitlines()
        begin = next(at for at, line in enumerate(lines) if line.startswith("**Expected") and f"D = {dimension}," in line) + 2
        split = lambda line: [cell.strip() for cell in line.strip("|").split("|")]
        names = split(lines[begin])[1:]
        rows = {}
        for line in lines[begin + 2 :]:
            if not line.startswith("|"):
                break
            function, *cells = split(line)
            rows[int(function.split(" ")[0][1:])] = dict(zip(names, cells))
        return rows

    def gaps(self, planner, function, dimension):
        import csv

        with open(self.folder / "bbob/rows.csv", newline="") as file:
            rows = csv.DictReader(file)
            chosen = [row for row in rows if (row["planner"], row["function"], row["dimension"]) == (planner, str(function), str(dimension))]
        return [float(row["gap"]) for row in chosen]

    def test_cocopp_makes_its_full_report(self):
        arguments = ["-o", "report", *[f"bbob/coco/{planner}" for planner in PLANNERS]]
        ended = subprocess.run([sys.executable, "-m", "cocopp", *arguments], cwd=self.folder, capture_output=True, text=True, timeout=500)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertIn("ALL done", ended.stdout)
        self.assertTrue((self.folder / "report/index.html").exists())

    def test_iohinspector_reads_each_run(self):
        import iohinspector

        manager = iohinspector.DataManager()
        manager.add_folder(str(self.folder / "bbob/iohprofiler"))
        runs = manager.overview
        self.assertEqual(len(runs), len(PLANNERS) * len(FUNCTIONS) * len(DIMENSIONS) * len(INSTANCES))
        self.assertEqual(set(runs["algorithm_name"]), set(PLANNERS))
        best = dict(zip(runs["data_id"], runs["best_y"]))
        lines = manager.load(True)
        for number, least in best.items():
            values = lines.filter(lines["data_id"] == number)["raw_y"]
            self.assertAlmostEqual(min(values), least, delta=1e-9)


class Trees(unittest.TestCase):
    SCENES = ["wcpso-discs", "rooms-20", "arm-cuboid"]
    RUNS = 6

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="forage-")))
        command = [FORAGE, "bench", "trees", *cls.SCENES, "--runs", cls.RUNS, "--budget", 3000, "--out", "trees"]
        subprocess.run([str(part) for part in command], cwd=cls.folder, check=True, capture_output=True)

    def database(self, name):
        """What OMPL's own program makes of the logs."""
        import sqlite3

        program = Path(sys.executable).parent / "ompl_benchmark_statistics"
        logs = sorted(str(log) for log in (self.folder / "trees").glob("ompl*/*.log"))
        ended = subprocess.run([str(program), *logs, "-d", name], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return sqlite3.connect(self.folder / name)

    def rows(self):
        import csv

        with open(self.folder / "trees/rows.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_ompl_reads_each_run(self):
        database = self.database("trees.db")
        self.assertLessEqual(set(self.SCENES), {name for (name,) in database.execute("SELECT name FROM experiments")})
        query = """SELECT e.name, p.name, r.random_seed, r.solved, r.solution_length, r.evaluations, r.graph_states, r.id
                   FROM runs r JOIN experiments e ON r.experimentid = e.id JOIN plannerConfigs p ON r.plannerid = p.id WHERE p.name NOT LIKE 'OMPL %'"""
        found = {(scene, planner, seed): rest for scene, planner, seed, *rest in database.execute(query)}
        rows = self.rows()
        self.assertEqual(len(found), len(rows))
        for row in rows:
            solved, length, evaluations, states, run = found[row["scene"], row["planner"], int(row["seed"])]
            self.assertEqual((bool(solved), evaluations), (row["solved"] == "true", int(row["evaluations"])))
            self.assertEqual((length, states), (float(row["length"]) if row["length"] else None, float(row["nodes"])))
            progress = list(database.execute("SELECT time, evaluations, best_cost FROM progress WHERE runid = ? ORDER BY time", (run,)))
            self.assertEqual(bool(progress), row["improvements"] != "")
            if progress:
                self.assertEqual(progress[-1][2], length)
        # Four planners on each scene, and one more on the arm's.
        self.assertEqual(len(rows), (4 + 4 + 5) * self.RUNS)

    def test_ompl_runs_beside_ours(self):
        script = ROOT / "scripts/ompl-trees.py"
        ended = subprocess.run([sys.executable, str(script), "trees"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(ended.returncode, 0, ended.stderr[-2000:])
        lines = [line for line in ended.stdout.splitlines() if "OMPL RRT" in line]
        self.assertEqual(len(lines), 2 * 3)
        # An optimum is known for both scenes, and OMPL's paths are none that are shorter.
        optima = {"wcpso-discs": 12.14159, "rooms-20": 28.0}
        for line in lines:
            scene, planner, solved, length = [cell.strip() for cell in line.strip("|").split("|")][:4]
            if planner == "OMPL RRTConnect":
                self.assertEqual(solved, f"{self.RUNS} of {self.RUNS}", line)
            if length:
                self.assertTrue(optima[scene] - 1e-3 <= float(length) <= 1.3 * optima[scene], line)
        database = self.database("both.db")
        count = "SELECT COUNT(*) FROM runs r JOIN plannerConfigs p ON r.plannerid = p.id WHERE p.name LIKE 'OMPL %'"
        self.assertEqual(database.execute(count).fetchone(), (2 * 3 * self.RUNS,))


class Curves(unittest.TestCase):
    def test_polars_reads_curves(self):
        import polars

        with tempfile.TemporaryDirectory(prefix="forage-") as folder:
            sweep = "scenes = ['sphere']\nseeds = [1, 2]\nbudget = 500\n[[planner]]\nname = 'pso'\nparams = { w = [0.4, 0.7] }\n[[planner]]\nname = 'wcpso'\n"
            (Path(folder) / "sweep.toml").write_text(sweep)
            for curves in ["curves.csv", "curves.parquet"]:
                subprocess.run([str(FORAGE), "experiment", "sweep.toml", "--curves", curves], cwd=folder, check=True, capture_output=True)
            parquet = polars.read_parquet(Path(folder) / "curves.parquet")
            text = polars.read_csv(Path(folder) / "curves.csv")
            self.assertEqual(parquet.columns, text.columns)
            self.assertTrue(parquet.equals(text))
            self.assertEqual(parquet.schema["w"], polars.Float64)
            rows = polars.read_csv(Path(folder) / "sweep.csv")
            last = parquet.group_by("planner", "w", "seed", maintain_order=True).last()
            self.assertEqual(last["value"].to_list(), rows["value"].to_list())


class Published(unittest.TestCase):
    """What docs/benchmarks.json has, from which the book is made, is what Forage finds now. Times are left out."""

    @staticmethod
    def results(suite):
        return json.loads((ROOT / "docs/benchmarks.json").read_text())[suite]

    def measured(self, *arguments):
        folder = self.enterContext(tempfile.TemporaryDirectory(prefix="forage-"))
        subprocess.run([str(FORAGE), "bench", *arguments, "--out", folder], check=True, capture_output=True)
        with open(Path(folder) / "table.csv", newline="") as lines:
            return list(csv.DictReader(lines))

    def test_bbob(self):
        stored = self.results("bbob")
        command = stored["command"].split()[2:]
        command[command.index("--dimensions") + 1] = "2"
        column = stored["columns"].index("D = 2")
        self.assertEqual({row["planner"]: row["D = 2"] for row in self.measured(*command)}, {row[0]: row[column] for row in stored["rows"]})

    def test_trees(self):
        stored = self.results("trees")
        times = {"time, ms"}
        expected = [{name: cell for name, cell in zip(stored["columns"], row) if name not in times} for row in stored["rows"]]
        found = self.measured(*stored["command"].split()[2:])
        self.assertEqual([{name: cell for name, cell in row.items() if name not in times} for row in found], expected)


if __name__ == "__main__":
    unittest.main()
