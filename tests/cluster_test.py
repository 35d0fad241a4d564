"""A sweep beyond one machine gives the file of a single run: as Ray tasks, and as the tasks of a Slurm array.

Ray is started here, on two cores. scripts/test runs this with the Python of target/python.
"""

import os
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# scripts/test builds it, and says where.
FORAGE = Path(os.environ.get("FORAGE", ROOT / "target/debug/forage"))
SWEEP = """
scenes = ["sphere", "wcpso-discs"]
seeds = { from = 1, count = 5 }
iterations = 20
[[planner]]
name = "pso"
params = { w = [0.8, 0.4] }
"""


class Cluster(unittest.TestCase):
    def setUp(self):
        # Short: Ray puts sockets there, whose paths may not be long.
        self.folder = Path(tempfile.mkdtemp(prefix="forage-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "sweep.toml").write_text(SWEEP)
        self.run_(FORAGE, "experiment", "sweep.toml", "--out", "whole.csv")

    def run_(self, *command, code=0, **environment):
        environment = {**os.environ, "RAY_TMPDIR": str(self.folder), **environment}
        ended = subprocess.run([str(part) for part in command], cwd=self.folder, env=environment, capture_output=True, text=True)
        self.assertEqual(ended.returncode, code, ended.stderr)
        return ended

    def ray(self, *options, forage=FORAGE, code=0):
        script = ROOT / "scripts/ray-sweep.py"
        common = ["--shards", 3, "--cpus", 2, "--out", "ray.csv", "--forage", forage]
        return self.run_(sys.executable, script, "sweep.toml", *common, *options, code=code)

    def read(self, name):
        return (self.folder / name).read_bytes()

    def test_ray_gives_the_file_of_a_single_run_though_a_shard_fails_once(self):
        failing = self.folder / "failing"
        failing.write_text(
            f"""#!/bin/sh
case "$*" in *"--shard 2/3"*) if mkdir {self.folder}/failed; then exit 7; fi ;; esac
case "$*" in *"--shard 1/3"*) if mkdir {self.folder}/busy; then exit 3; fi ;; esac
exec {FORAGE} "$@"
"""
        )
        failing.chmod(failing.stat().st_mode | stat.S_IXUSR)
        ended = self.ray(forage=failing)
        self.assertTrue((self.folder / "failed").exists() and (self.folder / "busy").exists())
        self.assertEqual(self.read("ray.csv"), self.read("whole.csv"))
        self.assertIn("3 of 3 shards", ended.stderr)
        self.assertIn("Friedman", ended.stdout)
        self.assertEqual(self.left_behind(), [])

    def test_what_forage_refuses_is_told_once_and_leaves_nothing_behind(self):
        (self.folder / "sweep.toml").write_text(SWEEP.replace("0.4", "9"))
        ended = self.ray(code=2)
        self.assertEqual(ended.stderr.count("`planner[0].params.w[1]` is 9; it must be"), 1)
        self.assertFalse((self.folder / "ray.csv").exists())
        self.assertEqual(self.left_behind(), [])

    def test_more_threads_than_cores_are_refused_and_do_not_wait(self):
        ended = self.ray("--threads", 3, code=2)
        self.assertIn("--threads: 3 is not allowed; it must be at most 2", ended.stderr)

    def left_behind(self):
        """Processes that were given this test's folder."""
        commands = []
        for process in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                commands.append(process.read_bytes().replace(b"\0", b" ").decode(errors="replace"))
            except OSError:
                pass  # It has ended meanwhile.
        return [command for command in commands if str(self.folder) in command]

    def test_the_tasks_of_a_slurm_array_give_the_file_of_a_single_run(self):
        for task in ["2", "3", "1"]:
            variables = {"FORAGE": str(FORAGE), "SHARDS": "3", "SLURM_ARRAY_TASK_ID": task, "SLURM_CPUS_PER_TASK": "2"}
            self.run_(ROOT / "scripts/slurm-sweep.sh", "sweep.toml", **variables)
        merge = f"{FORAGE} experiment sweep.toml --merge sweep.*-of-3.csv"
        self.run_("sh", "-c", merge)
        self.assertEqual(self.read("sweep.csv"), self.read("whole.csv"))


if __name__ == "__main__":
    unittest.main()
