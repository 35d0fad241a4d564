import type { Check, MarkKind, MarkOf } from '../papers/row'

const NAMES: Readonly<{ [K in MarkKind]: Readonly<Record<MarkOf<K>, string>> }> = {
  value: {
    'same digits': 'same digits',
    'no significant difference': 'no significant difference',
    'same power of ten': 'same power of ten',
    differs: 'differs',
  },
  ranking: { same: 'same ranking', partly: 'partly same ranking', reversed: 'reversed ranking', undecided: 'ranking undecided' },
  basis: {
    printed: 'printed in full',
    'our reconstruction': 'our reconstruction',
    fitted: 'fitted to this table',
    'machine-dependent': 'machine-dependent',
  },
  source: { consistent: 'consistent', doubtful: 'doubtful as printed', 'impossible as printed': 'impossible as printed' },
}

/** Text of the papers' cards: loaded with them. The figures themselves come from REPRODUCTION.csv. */
export const papers = {
  title: 'Papers',
  intro:
    'Five papers, what they claim, and what comes out when their experiments are run again here. Every figure below was computed by the same planners that run in this page; next to each is the command that repeats it.',
  overview: 'All papers at a glance',
  paper: 'Paper',
  subject: 'Subject',
  goto: (tag: string) => `To the card of ${tag}`,
  total: 'All five',
  rule: {
    title: 'How a figure gets its marks',
    intro:
      'Each mark follows one rule for all figures, which “forage reproduce” applies; nobody sets one by hand. The numbers behind a mark are in the row, under “Reasons and command”.',
    marks: {
      value: {
        'same digits': 'Our mean, rounded to the digits that are printed, is the printed figure.',
        'no significant difference':
          'A test at 5 % finds no difference: Welch’s t-test where the paper prints a standard deviation and a number of runs and our runs lie within a factor of ten; otherwise the printed figure lies in the middle 95 % of the means of as many of our runs as the paper has, drawn 2,000 times. A fitted number lies in our 95 % interval.',
        'same power of ten': 'Less than a factor of ten lies between the two.',
        differs: 'A factor of ten or more lies between them, or the sign differs.',
      },
      ranking: {
        same: 'Every pair of rows differs significantly, in the printed order.',
        partly: 'Some pairs differ significantly in the printed order, not all.',
        reversed: 'Some pairs differ significantly, all of them against the printed order.',
        undecided: 'No pair differs significantly.',
      },
      basis: {
        printed: 'The paper prints everything that the figure rests on.',
        'our reconstruction': 'The paper leaves something open that we had to choose; the reason says what.',
        fitted: 'We chose values because this table then comes out; the reason says how many values for how many figures.',
        'machine-dependent': 'A run time.',
      },
      source: {
        consistent: 'The printed figure can be what the paper says.',
        doubtful: 'It can only be a figure of something else.',
        'impossible as printed': 'No runs or paths can give it.',
      },
    } satisfies { [K in MarkKind]: Record<MarkOf<K>, string> },
  },
  kinds: {
    value: { title: 'Value', about: 'How near our number is to the printed one.' },
    ranking: {
      title: 'Ranking',
      about:
        'Whether the rows that a table compares have the same order here. Every pair is tested: Wilcoxon’s rank-sum test, Holm’s correction, 5 %.',
    },
    basis: { title: 'Basis', about: 'What our number rests on.' },
    source: { title: 'Source', about: 'Whether the printed figure can be right at all, by arithmetic. No mark: nothing to check.' },
  } satisfies Record<MarkKind, { title: string; about: string }>,
  mark: (kind: MarkKind, mark: MarkOf<MarkKind>): string => (NAMES[kind] as Readonly<Record<string, string>>)[mark] ?? mark,
  count: (n: string, mark: string) => `${n} ${mark}`,
  rows: (n: number) => (n === 1 ? '1 row' : `${n} rows`),
  claims: 'What it claims',
  tries: 'Its experiments',
  triesHelp: 'A planner opens its run in the stage. A batch runs all planners of a line over many seeds, a race lets them go side by side.',
  loading: 'The planners are still being loaded; the experiments can be opened in a moment.',
  open: (planner: string, scene: string) => `${planner}: open on “${scene}” in the stage`,
  batch: 'Batch',
  batchHelp: (scene: string, seeds: string) => `Batch: run these planners on “${scene}” with ${seeds} seeds`,
  race: 'Race',
  raceHelp: (scene: string) => `Race: let these planners race on “${scene}”`,
  figures: 'Published and computed figures',
  none: 'It prints pictures and no figures to compare. Its claims are checked below.',
  checks: {
    title: 'What of it holds here',
    help: 'Each claim as a question to the runs, with the numbers that answer it.',
    hold: (yes: string, all: string) => `${yes} of ${all} hold`,
    answers: { yes: 'holds', NO: 'does not hold', 'not decided': 'not decided' } satisfies Record<Check['answer'], string>,
  },
  group: (table: string, reproduction: string) => `${table} (${reproduction})`,
  whole: 'The whole table:',
  columns: {
    row: 'Row',
    published: 'Published',
    ours: 'Here',
    best: 'best',
    mean: 'mean',
    std: 'std. dev.',
    median: 'median',
    runs: 'runs',
    marks: 'Marks',
    repeat: 'Reasons and command',
  },
  unprinted: 'not printed',
  command: 'To repeat it:',
  repeat: 'Open in the stage',
  repeatHelp: (command: string) => `Open in the stage: ${command}`,
  why: (row: string) => `Reasons and command: ${row}`,
  all: 'Show all reasons and commands',
  copy: 'Copy',
  copyHelp: (command: string) => `Copy the command: ${command}`,
  copied: 'Copied',
  copyFailed: 'Copying was not allowed: select the text instead.',
  cards: {
    WCPSO: {
      title: 'Path planning based on improved particle swarm optimization algorithm',
      subject: 'A swarm with trigonometric parameters, hens and chicks',
      citation: 'Jia Huiqun et al., Transactions of the Chinese Society for Agricultural Machinery, 2018, no. 12.',
      claims: [
        'If inertia and both pulls follow cosine and sine over the run, and particles that stagnate are thrown by the hen’s and the chick’s equations of chicken swarms, a swarm finds more precise minima, more reliably.',
        'Of four swarms on eight function rows, 50 runs each, the new one has the smallest mean wherever they differ (Table 2). Rosenbrock’s valley and Ackley’s function in two variables all four solve alike.',
        'Among seven discs it keeps nearer to the shortest way, 12.141590, than the swarm with linear inertia, and varies less over ten runs. That is drawn (fig. 5), not printed in numbers.',
      ],
    },
    LTQPSO: {
      title: 'Path planning of mobile robots with an improved quantum-behaved PSO',
      subject: 'A quantum swarm with evolution speed, dispersion and selection',
      citation: 'Liu Jie, Zhao Haifang, Zhou Delian, Computer Science, no. 11A.',
      claims: [
        'Evolution speed and dispersion adapt how far particles leap, and natural selection lets the better half replace the worse: so the swarm is said not to converge too early.',
        'On ten metres of walls its paths are shorter on average than those of the plain quantum swarm, vary less (1.02 instead of 3.27 m, and 1.20 beside 5.65 m) and take less time (Tables 3 and 4).',
        'How many particles and iterations are needed follows from the number of a path’s pieces by a power law, fitted for D from 5 to 20 (Tables 1 and 2).',
      ],
    },
    ANTBAT: {
      title: 'Multi-point path planning based on ant colony and bat algorithms',
      subject: 'Ants that mind their direction build roads, bats order the stops',
      citation: 'Fang Min, Jin Shijun, Electronic Measurement Technology, no. 18.',
      claims: [
        'Ants that weigh how far they turn and how far they point away from the goal, rewarded below the median length and punished above it, find shorter paths (42.06 instead of 45.53 and 43.70 cells) with fewer turns, in fewer iterations.',
        'A discrete bat algorithm orders twelve stops better than an earlier one, a genetic algorithm, a swarm and annealing do: the smallest best, worst, mean and variance of 30 runs (Table 2).',
        'Both together take less time than other methods, whatever the number of stops; that is drawn (fig. 8), not printed in numbers.',
      ],
    },
    'ARM-RRT': {
      title: 'The Mechanical Arm of Six-Dof Obstacle Avoidance Path Planning Based on Rapid-Exploring Random Trees',
      subject: 'A tree that looks where the goal is, for an arm with six axes',
      citation: 'Dai Yanhui, Liang Yanyang, Xie Gang, Techniques of Automation & Applications, 2012, no. 10.',
      claims: [
        'A random tree that draws 20 samples, keeps 4 by their direction to the goal and chooses among them by a roulette wheel grows faster, and strays less from the way, than the basic one.',
        'Where nothing is in the way its tip goes about straight, so the path is close to the shortest; past a cuboid it still comes to the goal by a short way (figs 5 to 8).',
        'Smoothed by Hermite curves and followed by inverse kinematics in closed form, with a way out where a point has no posture. The paper prints pictures, no numbers.',
      ],
    },
    'WOLF-ANT': {
      title: 'Dynamic path planning of a mobile robot based on an improved ant colony algorithm',
      subject: 'Wolf-pack ant colony, tuned by a swarm, among moving obstacles',
      citation: 'The copy that we read names neither authors nor journal.',
      claims: [
        'Ants that rank the cells around them by their distance to the goal, and share pheromone as a pack of wolves shares its prey, converge sooner and do not get stuck.',
        'On 20 × 20 cells their way is 562.8427 px long and takes 38.1421 s, that of traditional ants 579.4120 px and that of A* 602.8420 px (Table 2). A true A* cannot be longer than the ants.',
        'A particle swarm finds their best parameters (α 1, β 7, ρ 0.367, Q 333, ε 2), and where an obstacle moves the robot follows the pheromone around it to a local goal.',
      ],
    },
  },
  doi: 'None of the five prints a DOI of its own in the copies that we read.',
  experiments: {
    functions: { title: 'Table 2: four swarms on test functions', about: '60 particles, 1000 iterations, 50 runs each.' },
    discs: { title: '§3.2: a path among seven discs', about: '150 particles, 500 iterations, 10 runs each.' },
    evolution: {
      title: 'Fig. 1: evolution speed and dispersion',
      about: '20 particles, 100 iterations; the readings show both over time.',
    },
    eight: {
      title: 'Table 3: ten metres of walls, uniform start',
      about: 'Eight pieces, 30 particles, 50 iterations, 50 runs each. The robot then drives along the path: see the stage.',
    },
    sixteen: {
      title: 'Table 4: the same, normal start',
      about: 'Sixteen pieces, angles from N(45°, 30°), 52 particles and 99 iterations by the paper’s (11), 50 runs each.',
    },
    empty: { title: 'Tables 1 and 2: without walls', about: 'The square on which particles and iterations were fitted.' },
    colonies: { title: '§3.1: three colonies on 30 × 30 cells', about: '50 ants, 100 iterations, 30 runs each.' },
    tours: { title: 'Table 2: twelve stops, five planners', about: 'Roads from cell to cell by the improved ants, 30 runs each.' },
    free: { title: 'Figs 5 and 6: no obstacle', about: 'The basic and the guided tree, steps of 0.03 and 0.05 m.' },
    cuboid: { title: 'Figs 7 and 8: a cuboid in the way', about: 'The same trees; where the cuboid stands is a reconstruction.' },
    beside: {
      title: 'Not in the paper: what is common today',
      about: 'A tree that rewires itself, two trees in the six joints, and another arm.',
    },
    wolves: { title: 'Table 2: A*, ants and the wolf-pack colony', about: '30 ants, 100 iterations.' },
    tuning: {
      title: '§5.2: a swarm tunes the ants',
      about: '20 particles, 30 iterations. It takes its time: each particle is a colony over three seeds.',
    },
    moving: {
      title: '§5.3: an obstacle moves',
      about: 'Plan, drive, predict conflicts, avoid them; compared with drives on A* and D* Lite.',
    },
  },
} as const
