"""The tools of the field read what `forage bench` writes, as it is: COCO's cocopp and IOHprofiler's iohinspector.

scripts/test runs this with the Python of target/bench.
"""

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


if __name__ == "__main__":
    unittest.main()
