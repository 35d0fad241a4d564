import { texts } from '../texts'

/** A key, or several that belong together, and what they do. */
export type KeyRow = readonly [keys: readonly string[], what: string]

export interface KeyGroup {
  title: string
  rows: readonly KeyRow[]
}

const everywhere: KeyGroup = {
  title: 'Everywhere',
  rows: [
    [['?'], 'shows these keys'],
    [['P'], 'presents: the stage fills the screen'],
    [['M'], 'sets a bookmark at this iteration, or removes it'],
    [['Ctrl', 'Z'], 'undoes an edit'],
    [['Ctrl', 'Shift', 'Z'], 'does it again'],
  ],
}

const time: readonly KeyRow[] = [
  [['Space'], 'plays and pauses'],
  [['Home'], 'goes to the beginning'],
  [['End'], 'goes to the end'],
]

const run: KeyGroup = {
  title: 'The run',
  rows: [
    ...time,
    [['Left', 'Right'], 'go an iteration back and on, with Shift ten'],
    [['Page up', 'Page down'], 'go from part to part'],
    [['N', 'Shift N'], 'go to the next and the previous event'],
  ],
}

const stage: KeyGroup = {
  title: 'The stage',
  rows: [
    [['+', '−'], 'zoom'],
    [['0'], 'shows all'],
    [['Up', 'Down'], 'move the view'],
    [['Arrows'], 'move a selected object, with Shift farther'],
    [['Delete'], 'removes a selected disc or stop'],
    [['Escape'], 'lets go, or leads back'],
    [['Arrows', 'Space'], 'choose a cell, then paint it or look closer, with that tool'],
  ],
}

const space: KeyGroup = {
  title: 'The stage of an arm',
  rows: [
    ...time,
    [['Comma', 'Full stop'], 'go an iteration back and on, with Shift ten'],
    [['Arrows'], 'turn the view'],
    [['+', '−'], 'zoom'],
    [['0'], 'shows all'],
    [['1', '2', '3', '4'], 'look from the front, the side, above and a corner'],
    [['N', 'Shift N'], 'select the next and the previous object'],
    [['Arrows'], 'move what is selected over the floor'],
    [['Page up', 'Page down'], 'lift and lower it'],
    [['Shift', 'Arrows'], 'resize a cuboid by its far faces, and turn the base'],
    [['A'], 'adds a cuboid'],
    [['Delete'], 'removes the selected one'],
    [['J', 'K'], 'look closer at the node before and at the next one'],
    [['Escape'], 'lets go'],
  ],
}

const presenting: KeyGroup = {
  title: 'While presenting',
  rows: [
    [['Page down', 'Page up'], 'go an iteration on and back, as clickers do'],
    [['1', '9'], 'go to the bookmarks; without any, to the tenths of the run'],
    [['B'], 'blanks the screen'],
    [['Q'], 'shows the link as a QR code'],
    [['Escape'], 'leaves'],
  ],
}

const race: KeyGroup = {
  title: 'Watching a comparison',
  rows: [
    ...time,
    [['Left', 'Right'], 'go a step of the clock back and on, with Shift ten'],
    [['+', '−'], 'zoom all lanes, on a lane'],
    [['0'], 'shows all, on a lane'],
  ],
}

/** As a sentence for those who hear it. */
const spoken = ({ rows }: KeyGroup): string => rows.map(([keys, what]) => `${keys.join(', ')}: ${what}.`).join(' ')

export const keys = texts('keys', {
  title: 'Keys',
  groups: [everywhere, run, stage, space, presenting, race],
  stageHelp: `${spoken(run)} ${spoken(stage)}`,
  spaceHelp: spoken(space),
})
