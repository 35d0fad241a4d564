#!/usr/bin/env python3
"""Carries out a sweep on a Ray cluster: a task a shard, merged into the file of a single run.

    scripts/ray-sweep.py FILE.toml --shards 64 --out FILE.csv --address auto

Without --address Ray is started here, on all cores, and ended again. On a cluster the sweep's folder, the one the rows go to and
the `forage` program must be at the same place on all machines. A shard whose machine or program fails is begun again up to
--retries times, and goes on where it stopped; so does the whole, if the same command is given again.
"""

import argparse
import ctypes
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")

import ray  # noqa: E402  (it reads the environment when it is imported)

REFUSED = 2
# A file that cannot be read or written now, or that another one still writes.
LATER = 3
PAUSE = 5


class Refused(Exception):
    """What is refused once is refused again."""


class Failed(Exception):
    """A shard that may be begun again."""


def main():
    args = parse()
    forage = shutil.which(args.forage)
    if forage is None:
        sys.exit(f"ray-sweep: --forage: {args.forage} is not allowed; it must be the forage program (cargo build --release)")
    sweep = args.file.resolve()
    out = args.out.resolve()
    parts = [out.with_suffix(f".{i}-of-{args.shards}{out.suffix}") for i in range(1, args.shards + 1)]
    ray.init(address=args.address, num_cpus=args.cpus, include_dashboard=False, logging_level="ERROR", log_to_driver=False)
    try:
        check_cores(args.threads)
        carry_out(str(Path(forage).resolve()), sweep, parts, args)
    except Refused as problem:
        print(problem, file=sys.stderr)
        sys.exit(REFUSED)
    except Failed as problem:
        sys.exit(f"ray-sweep: {problem}; the same command goes on from there")
    except KeyboardInterrupt:
        print("ray-sweep: interrupted; the same command goes on from there", file=sys.stderr)
        sys.exit(130)
    finally:
        ray.shutdown()
    merge = [forage, "experiment", str(sweep), "--out", str(out), "--merge", *map(str, parts)]
    sys.exit(subprocess.run(merge + (["--json"] if args.json else [])).returncode)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=Path, metavar="FILE.toml", help="the sweep, as `forage experiment` takes it")
    parser.add_argument("--shards", type=positive, required=True, metavar="N", help="how many tasks; more than cores, so that none waits long")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE", help="where the rows go: .csv, .jsonl or .ndjson")
    parser.add_argument("--address", metavar="ADDRESS", help="of a running cluster (`auto`, ray://…); started here, if left out")
    parser.add_argument("--cpus", type=positive, metavar="N", help="how many cores of this machine, if Ray is started here")
    parser.add_argument("--threads", type=positive, default=1, metavar="N", help="cores and threads of a shard (1)")
    parser.add_argument("--retries", type=int, default=3, metavar="N", help="how often a shard that fails is begun again (3)")
    parser.add_argument("--forage", default="forage", metavar="PATH", help="the program; `forage` on the path, if left out")
    parser.add_argument("--json", action="store_true", help="print the statistics as JSON")
    return parser.parse_args()


def positive(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not allowed; it must be a whole number from 1")
    return number


def check_cores(threads):
    """A task that no machine has room for would wait for ever."""
    most = int(max(node["Resources"].get("CPU", 0) for node in ray.nodes() if node["Alive"]))
    if threads > most:
        raise Refused(f"ray-sweep: --threads: {threads} is not allowed; it must be at most {most}, the cores of the largest machine (--cpus)")


def carry_out(forage, sweep, parts, args):
    task = ray.remote(num_cpus=args.threads, max_retries=args.retries, retry_exceptions=[Failed])(shard)
    left = [
        task.remote([forage, "experiment", str(sweep), "--shard", f"{i}/{len(parts)}", "--out", str(part), "--jobs", str(args.threads)])
        for i, part in enumerate(parts, 1)
    ]
    begun = time.monotonic()
    while left:
        done, left = ray.wait(left)
        try:
            ray.get(done)
        except ray.exceptions.RayTaskError as error:
            raise error.cause from None
        except ray.exceptions.RayError as error:
            raise Failed(f"a shard failed: {error}") from None
        finished = len(parts) - len(left)
        seconds = (time.monotonic() - begun) / finished * len(left)
        print(f"{finished} of {len(parts)} shards, {seconds:.0f} s left", file=sys.stderr)


def shard(command):
    """One shard, on whatever machine."""
    finished = subprocess.run(command, capture_output=True, text=True, preexec_fn=end_with_parent)
    if finished.returncode == REFUSED:
        raise Refused(finished.stderr.strip())
    if finished.returncode == LATER:
        time.sleep(PAUSE)
    if finished.returncode != 0:
        raise Failed(f"{' '.join(command)} ended with {finished.returncode}: {finished.stderr.strip()}")


def end_with_parent():
    """Who is left behind by a worker that was killed would still be writing when the shard is begun again. Linux only."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


if __name__ == "__main__":
    main()
