"""What SciPy and NumPy say of some samples: `python3 tests/statistics/make.py > tests/statistics/scipy.json`.

Needs numpy and scipy. tests/statistics.rs compares ours with it.
"""
import json

import numpy as np
import scipy
from scipy import stats

rng = np.random.default_rng(8)
SAMPLES = {
    "lengths": np.round(rng.normal(12.2, 0.05, 30), 4),
    "ties": rng.integers(40, 44, 25).astype(float),
    "errors": 10.0 ** rng.uniform(-120, -90, 20),
    "few": np.array([3.25, 1.5, 2.75]),
    "short": np.array([1.0, 4.0, 2.0, 8.0, 5.5, 7.25, 3.0]),
    "shifted": np.array([9.0, 6.5, 11.0, 4.5, 10.0]),
    "same": np.full(6, 2.5),
}
summaries = []
for name, x in SAMPLES.items():
    lower, median, upper = np.quantile(x, [0.25, 0.5, 0.75], method="median_unbiased")
    std = x.std(ddof=1)
    low, high = stats.t.interval(0.95, len(x) - 1, loc=x.mean(), scale=std / np.sqrt(len(x))) if std > 0 else (x.mean(), x.mean())
    summaries.append({"name": name, "values": x.tolist(), "mean": x.mean(), "std": std, "interval": [low, high],
                      "min": x.min(), "lower": lower, "median": median, "upper": upper, "max": x.max()})

failed = np.concatenate([SAMPLES["lengths"][:20], np.full(5, np.inf)])
PAIRS = [("lengths", "ties"), ("ties", "ties"), ("few", "short"), ("short", "shifted"), ("errors", "errors"), ("lengths", "errors")]
pairs = [(SAMPLES[a], SAMPLES[b] * factor) for a, b in PAIRS for factor in (1.0, 1.001)] + [(failed, SAMPLES["lengths"])]
# A small sample beside many numbers: apart, interleaved at one end, and mixed.
many = np.arange(1000) + 0.5
pairs += [(np.arange(8) - 9.0, many[:200]), (np.arange(8) - 9.0, many), (np.arange(8) * 3.0, many), (np.arange(8) * 120.0 + 0.25, many)]
tests = []
for x, y in pairs:
    found = stats.mannwhitneyu(x, y, alternative="two-sided", method="auto")
    finite = lambda values: [None if np.isinf(v) else v for v in values]
    tests.append({"first": finite(x), "second": finite(y), "u": found.statistic, "p": found.pvalue})

# Holm's procedure as scipy has none: R's p.adjust(p, "holm") by its definition, the running maximum of (m - i) p(i).
def holm(p):
    order = np.argsort(p, kind="stable")
    adjusted = np.minimum(np.maximum.accumulate((len(p) - np.arange(len(p))) * np.asarray(p)[order]), 1)
    out = np.empty(len(p))
    out[order] = adjusted
    return out.tolist()

ps = [[0.01, 0.04, 0.03, 0.005], [0.5, 0.9, 0.2], [1e-9, 1e-9, 0.3, 0.02, 0.02, 0.7]]

BLOCKS = {"plain": rng.normal(size=(12, 4)) + [0, 0.4, 0.8, 0], "ties": rng.integers(0, 4, (10, 3)).astype(float), "two blocks": rng.normal(size=(2, 5))}
friedman = []
for name, blocks in BLOCKS.items():
    found = stats.friedmanchisquare(*blocks.T)
    ranks = stats.rankdata(blocks, axis=1).mean(axis=0)
    friedman.append({"name": name, "blocks": blocks.tolist(), "ranks": ranks.tolist(), "statistic": found.statistic, "p": found.pvalue})

wilson = []
for successes, count in [(0, 10), (10, 10), (47, 50), (1, 3)]:
    interval = stats.binomtest(successes, count).proportion_ci(0.95, method="wilson")
    wilson.append({"successes": successes, "count": count, "interval": [interval.low, interval.high]})

json.dump({"made_by": "python3 tests/statistics/make.py > tests/statistics/scipy.json", "scipy": scipy.__version__,
           "numpy": np.__version__, "summaries": summaries, "rank_sums": tests, "holm": [{"p": p, "corrected": holm(p)} for p in ps],
           "friedman": friedman, "wilson": wilson}, __import__("sys").stdout)
print()
