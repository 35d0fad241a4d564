import { texts } from '../texts'

/** The names of marks, by kind. */
const names = {
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
  claim: { upheld: 'upheld', refuted: 'refuted', undecided: 'undecided' },
  answer: { 'as-claimed': 'as claimed', contrary: 'contrary', trivial: 'trivial', undecided: 'undecided' },
} as const

/** Text of the papers' cards: loaded with them. Claims come from REPRODUCTION.claims.json, figures from REPRODUCTION.csv. */
export const papers = texts('papers', {
  title: 'Papers',
  intro:
    'Five papers: what they claim, whether it holds here, and their published figures next to the computed ones. Everything was computed by the planners that run in this page. Open a claim to see the tests behind its mark and to watch the runs.',
  headline: (claims: string, figures: string) => `${claims} claims, ${figures} figures`,
  overview: 'All papers at a glance',
  paper: 'Paper',
  subject: 'Subject',
  goto: (tag: string) => `To the card of ${tag}`,
  total: 'All five',
  rule: {
    title: 'How claims and figures are marked',
    claims: 'Claims',
    figures: 'Figures',
    asked:
      'Each claim is asked as one or more questions, and a named test answers each, with seeds 51 to 100, which no parameter was chosen by. Questions across maps use six maps of each generator with five seeds each. p-values are two-sided and corrected for the claim’s other questions (Holm). A is the share of all pairs of runs in which the first planner is better; ties count half. Layouts that a paper does not print are reconstructions.',
    answers: {
      'as-claimed': 'p < 0.05 as claimed, and A at least 0.60.',
      contrary: 'p < 0.05 the other way.',
      trivial: 'Lengths or costs whose means differ by less than 0.5 %, with 95 % confidence.',
      undecided: 'All else, for example if both planners always find the optimum.',
    },
    claimed: {
      upheld: 'All answers are as claimed.',
      refuted: 'All answers are contrary or trivial; one contrary answer is enough if the claim says “all”, “best” or “never”.',
      undecided: 'All else.',
    },
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
    },
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
  },
  names,
  count: (n: string, mark: string) => `${n} ${mark}`,
  rows: (n: number) => (n === 1 ? '1 row' : `${n} rows`),
  claims: 'Claims',
  place: (place: string) => `Place: ${place}`,
  elsewhere: (claim: string) => `Its figures are shown at claim ${claim}.`,
  questions: {
    of: (claim: string) => `Questions of claim ${claim}`,
    columns: ['Question', 'On', 'Planners', 'Numbers', 'Test', 'p', 'Effect', 'Answer'],
    open: 'Compare',
    runs: (n: string) => `n = ${n}`,
    common: (parameters: string) => `all: ${parameters}`,
  },
  translated: 'our translation',
  pictures: 'Figures without numbers',
  pictureClaims: (claims: string) => `Claims: ${claims}.`,
  open: (planner: string, scene: string) => `${planner}: open on “${scene}” in the Lab`,
  statistics: 'Statistics',
  statisticsHelp: (scene: string, seeds: string) => `Statistics: run these planners on “${scene}” with ${seeds} seeds`,
  watch: 'Watch',
  watchHelp: (scene: string) => `Watch: these planners side by side on “${scene}”`,
  figuresShort: 'Figures',
  otherFigures: 'Other figures',
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
  subjects: {
    WCPSO: 'Swarms with trigonometric parameters and hen and chick moves',
    LTQPSO: 'A quantum swarm with evolution speed, dispersion and selection',
    ANTBAT: 'Direction-aware ants for paths, bats for the order of stops',
    'ARM-RRT': 'Guided RRT for an arm with six axes',
    'WOLF-ANT': 'A wolf-pack ant colony tuned by a swarm, among moving obstacles',
  },
} as const)
