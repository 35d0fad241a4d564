/**
 * Where a run begins after a change: where the one before stood, which it is compared with; at its beginning; or as after the change
 * before, which this one continues.
 */
export type Again = 'here' | 'begin' | 'on'
