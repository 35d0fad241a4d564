#!/usr/bin/env python3
"""Finds the shortest tour of a TSPLIB file (EUC_2D, CEIL_2D or EXPLICIT FULL_MATRIX), proves it, and writes a .tour.

    pip install highspy==1.15.1 numpy
    scripts/optimum.py stops.tsp stops.opt.tour

HiGHS solves the degree-constrained programme of Dantzig, Fulkerson and Johnson; subtour constraints that its solutions
break are added until a solution is one tour. First the relaxation over all edges: it gives a bound, and each edge's
reduced cost. An edge is in no tour shorter than bound + gap if its reduced cost is larger than the gap, so the integer
programme needs the others only. If the tour that it finds is not within the gap, the gap is widened to that tour.

HiGHS keeps its default options, but for the gaps at which it stops, which are 0.
"""

import math
import re
import sys
import time

import highspy
import numpy


def read(path):
    text = open(path).read()
    value = lambda key: re.search(rf"^{key}\s*:\s*(\S+)", text, re.M).group(1)
    n, kind = int(value("DIMENSION")), value("EDGE_WEIGHT_TYPE")
    if kind == "EXPLICIT":
        assert value("EDGE_WEIGHT_FORMAT") == "FULL_MATRIX", "only FULL_MATRIX"
        words = text.split("EDGE_WEIGHT_SECTION")[1].split()
        return numpy.array([int(word) for word in words[: n * n]]).reshape(n, n)
    assert kind in ("EUC_2D", "CEIL_2D"), f"{kind} is not read"
    words = text.split("NODE_COORD_SECTION")[1].split()[: 3 * n]
    points = [(float(words[i + 1]), float(words[i + 2])) for i in range(0, 3 * n, 3)]
    rounded = (lambda d: int(d + 0.5)) if kind == "EUC_2D" else math.ceil
    return numpy.array([[rounded(math.hypot(a - c, b - d)) for c, d in points] for a, b in points])


def components(n, edges):
    """The sets of stops that edges hold together."""
    parent = list(range(n))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for i, j in edges:
        parent[root(i)] = root(j)
    sets = {}
    for i in range(n):
        sets.setdefault(root(i), []).append(i)
    return list(sets.values())


def smallest_cut(n, weights):
    """A cut of the least weight, by Stoer and Wagner: its weight and the stops on one side."""
    w = weights.copy()
    groups = [[i] for i in range(n)]
    alive = list(range(n))
    best = (math.inf, [])
    while len(alive) > 1:
        key = numpy.zeros(n)
        left = numpy.zeros(n, dtype=bool)
        left[alive] = True
        before = last = -1
        for _ in alive:
            at = int(numpy.where(left, key, -1.0).argmax())
            before, last = last, at
            left[at] = False
            key += w[at]
        cut = w[last][[i for i in alive if i != last]].sum()
        if cut < best[0] - 1e-9:
            best = (cut, list(groups[last]))
        groups[before] += groups[last]
        w[before] += w[last]
        w[:, before] += w[:, last]
        w[before, before] = 0
        w[last] = 0
        w[:, last] = 0
        alive.remove(last)
    return best


class Programme:
    """Degree constraints over some edges, and the subtour constraints that were needed."""

    def __init__(self, distances, edges, sets, whole):
        self.n, self.edges, self.sets = len(distances), edges, []
        self.highs = highspy.Highs()
        self.highs.setOptionValue("output_flag", False)
        self.highs.setOptionValue("mip_rel_gap", 0.0)
        self.highs.setOptionValue("mip_abs_gap", 0.0)
        for i, j in edges:
            self.highs.addVar(0.0, 1.0)
        for k, (i, j) in enumerate(edges):
            self.highs.changeColCost(k, float(distances[i, j]))
            if whole:
                self.highs.changeColIntegrality(k, highspy.HighsVarType.kInteger)
        for i in range(self.n):
            at = [k for k, edge in enumerate(edges) if i in edge]
            self.highs.addRow(2.0, 2.0, len(at), numpy.array(at), numpy.ones(len(at)))
        for stops in sets:
            self.add(stops)

    def add(self, stops):
        """At least two edges lead out of a set; written with the edges inside, which are fewer in a small one."""
        inside = set(stops) if 2 * len(stops) <= self.n else set(range(self.n)) - set(stops)
        at = [k for k, (i, j) in enumerate(self.edges) if i in inside and j in inside]
        self.highs.addRow(-highspy.kHighsInf, len(inside) - 1.0, len(at), numpy.array(at), numpy.ones(len(at)))
        self.sets.append(stops)

    def solve(self):
        self.highs.run()
        status = self.highs.getModelStatus()
        if status != highspy.HighsModelStatus.kOptimal:
            return None
        return self.highs.getInfo().objective_function_value, numpy.array(self.highs.getSolution().col_value)


def relaxation(distances, sets):
    """The relaxation with all subtour constraints: its bound, the reduced costs, and the constraints that it needed."""
    n = len(distances)
    edges = [(i, j) for i in range(n) for j in range(i + 1, n)]
    programme = Programme(distances, edges, sets, whole=False)
    while True:
        bound, x = programme.solve()
        used = [edge for edge, value in zip(edges, x) if value > 1e-7]
        parts = components(n, used)
        if len(parts) > 1:
            cuts = parts
        else:
            weights = numpy.zeros((n, n))
            for (i, j), value in zip(edges, x):
                weights[i, j] = weights[j, i] = max(value, 0.0)
            cut, side = smallest_cut(n, weights)
            cuts = [side] if cut < 2 - 1e-6 else []
        if not cuts:
            return bound, edges, numpy.array(programme.highs.getSolution().col_dual), programme.sets
        for stops in cuts:
            programme.add(stops)


def tour(n, edges):
    """The order in which edges that are one tour call at the stops."""
    beside = [[] for _ in range(n)]
    for i, j in edges:
        beside[i].append(j)
        beside[j].append(i)
    # From the first stop, towards the smaller of its two neighbours: a closed tour has one writing only.
    order = [0, min(beside[0])]
    while len(order) < n:
        before, at = order[-2:]
        order.append(beside[at][0] if beside[at][1] == before else beside[at][1])
    return order


def shortest(distances):
    """The shortest tour and its length."""
    n = len(distances)
    bound, edges, reduced, sets = relaxation(distances, [])
    gap = math.ceil(bound * 1.01) - bound
    while True:
        kept = [edge for edge, cost in zip(edges, reduced) if cost <= gap + 1e-3]
        print(f"bound {bound:.3f}, gap {gap:.3f}: {len(kept)} of {len(edges)} edges, {len(sets)} constraints", flush=True)
        programme = Programme(distances, kept, sets, whole=True)
        while (solution := programme.solve()) is not None:
            value, x = solution
            used = [edge for edge, one in zip(kept, x) if one > 0.5]
            parts = components(n, used)
            print(f"  {value:.3f}, {len(parts)} subtours", flush=True)
            if len(parts) == 1:
                break
            for stops in parts:
                programme.add(stops)
        sets = programme.sets
        if solution is None:
            gap *= 2
            continue
        order = tour(n, used)
        length = int(sum(distances[order[k - 1], order[k]] for k in range(n)))
        if length <= bound + gap:
            return order, length
        gap = length - bound


def main(source, target):
    begun = time.time()
    order, length = shortest(read(source))
    name = target.replace("\\", "/").rsplit("/", 1)[-1]
    with open(target, "w") as out:
        out.write(f"NAME : {name}\nTYPE : TOUR\nDIMENSION : {len(order)}\nTOUR_SECTION\n")
        out.writelines(f"{stop + 1}\n" for stop in order)
        out.write("-1\nEOF\n")
    print(f"{name}: {length}, proven, {time.time() - begun:.1f} s")


if __name__ == "__main__":
    main(*sys.argv[1:])
