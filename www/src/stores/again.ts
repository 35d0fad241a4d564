/**
 * Where a run begins after a change: where the one before was, which it is compared with; at its beginning; as after the change
 * before, which this one continues; or, with another code of the same planner, where the one before was wanted, even if that failed
 * on its way there; or, with the same planner in other words, where it was, with nothing to compare.
 */
export type Again = 'here' | 'begin' | 'on' | 'code' | 'words'
