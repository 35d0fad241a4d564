"""Values of the 24 functions of the suite `bbob`, from the package that defines them, for tests/bbob.rs.

    python3 -m pip install coco-experiment==2.8.2
    python3 scripts/bbob.py COUNT > tests/bbob.bin

So many points are looked at of each function, dimension and instance. They are drawn as in tests/bbob.rs. What is written are
numbers of 8 bytes, little-endian: by function, dimension, instance and point.
"""

import sys

import cocoex
import numpy as np

DIMENSIONS = [2, 3, 5, 10, 20, 40]
INSTANCES = range(1, 16)
# Beyond the box, too: from -6 to 6.
REACH = 6.0


def points(function, dimension, instance, count):
    """SplitMix64, each number by its place."""
    first = ((function * 100 + dimension) * 100 + instance) * 1_000_000
    with np.errstate(over="ignore"):
        z = (np.arange(first, first + count * dimension, dtype=np.uint64) + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
        z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        z ^= z >> np.uint64(31)
    return (2 * REACH * ((z >> np.uint64(11)) * 2.0**-53) - REACH).reshape(count, dimension)


def main():
    count = int(sys.argv[1])
    suite = cocoex.Suite("bbob", "instances: 1-15", "")
    for function in range(1, 25):
        for dimension in DIMENSIONS:
            for instance in INSTANCES:
                problem = suite.get_problem_by_function_dimension_instance(function, dimension, instance)
                values = [problem(x) for x in points(function, dimension, instance, count)]
                sys.stdout.buffer.write(np.array(values, dtype="<f8").tobytes())


main()
