/** One run of many, summed up: what a row of a sweep holds. No times: those are no property of the run. */
export interface TrialRecord {
  planner: string;
  /** The scene's name. */
  scene: string;
  seed: number;
  /** The parameters that differ from the defaults. */
  parameters: Record<string, ParameterValue>;
  status: Status;
  iterations: number;
  /** Candidate solutions evaluated. */
  evaluations: number;
  cost: number | null;
  length: number | null;
  /** What runs are compared by: a feasible result's length, or where there is no path its cost. */
  value: number | null;
  feasible: boolean;
  clearance: number | null;
  exact: number | null;
  exact_by: Outcome['exact_by'];
  gap: number | null;
  /** Evaluations when the best was first feasible and within `within` of the optimum. */
  reached: number | null;
  /** The same in iterations. */
  reached_iteration: number | null;
  /** The iteration from which the population's mean stayed within 1 % of its best; null if it never did, or without such a reading. */
  settled: number | null;
  turns: number | null;
  /** No random number has a part in the run: other seeds give the same result. */
  deterministic: boolean;
  hash: string;
}

/** The values of a run's feasible best, whenever it changed: three equally long columns. */
export interface TrialCurve {
  iterations: Float64Array;
  evaluations: Float64Array;
  values: Float64Array;
}

/** Runs that are compared; small values are good, null stands for a run without a feasible result. In all groups the same place
 * stands for the same scene and seed. */
export interface Group {
  name: string;
  values: (number | null)[];
}

/** Mean, spread and order statistics. */
export interface Summary {
  count: number;
  mean: number;
  /** With n − 1; null for a single number. */
  std: number | null;
  /** The 95 % confidence interval of the mean (Student's t). */
  interval: [number, number] | null;
  min: number;
  /** Quartiles: Hyndman and Fan's type 8. */
  lower: number;
  median: number;
  upper: number;
  max: number;
}

export interface GroupSummary {
  name: string;
  runs: number;
  feasible: number;
  /** The share of feasible runs. */
  rate: number;
  /** Its 95 % confidence interval (Wilson). */
  rate_interval: [number, number];
  /** Of the feasible runs. */
  summary: Summary | null;
}

/** Two groups beside each other. */
export interface Pair {
  /** Places among the groups. */
  first: number;
  second: number;
  /** Mann and Whitney's U of the first. */
  u: number;
  /** Wilcoxon's rank-sum test, two-sided; runs without a feasible result rank last. */
  p: number;
  /** Corrected for the number of pairs (Holm). */
  corrected: number;
  /** How probable it is that a run of the first is better than one of the second; ties count half. */
  better: number;
}

/** Friedman's test over the places of the groups. */
export interface Friedman {
  blocks: number;
  /** Mean ranks; 1 is best. */
  ranks: number[];
  /** null for fewer than three groups, or if everything is tied. */
  statistic: number | null;
  p: number | null;
}

export interface Comparison {
  groups: GroupSummary[];
  pairs: Pair[];
  /** null for fewer than two groups, or if they are not equally long. */
  friedman: Friedman | null;
}
