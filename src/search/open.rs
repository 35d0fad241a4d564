//! The cells that a search has reached and not settled, the most promising first.

use crate::kernel::State;

/// Children of a node of the heap: four lie side by side in memory, and the heap is half as high as with two.
const ARITY: usize = 4;

/// Slots of the table that finds a level by its f: 2 to this power.
const TABLE: u32 = 8;

/// No entry, no level.
const NONE: u32 = u32::MAX;

/// A column and a row in one word, ordered like the cells' numbers.
pub(super) type Place = u32;

/// The place of a column and a row.
pub(super) fn place([column, row]: [usize; 2]) -> Place {
    (row << 16 | column) as Place
}

/// Column and row of a place.
#[inline]
pub(super) fn apart(place: Place) -> [i32; 2] {
    [(place & 0xffff).cast_signed(), (place >> 16).cast_signed()]
}

/// Places by f. Among equals the one put in last comes first: it tends to be nearer to the goal.
///
/// From cell to cell, few values of f occur, each of them often. So the places of one f form a level, a stack; a heap
/// holds the levels (about a hundred where there are thousands of places), and a small table finds the level of an f at
/// once. (It forgets: there may be two levels of one f. What comes first still depends on nothing but what was put in
/// and taken out before.) A place whose f falls is put in again; who takes it out a second time has to see that.
#[derive(Clone, State)]
pub(super) struct Open {
    /// f and level. Numbers that are not negative are ordered as their bits.
    heap: Vec<(u64, u32)>,
    levels: Vec<Level>,
    entries: Vec<Entry>,
    /// The first level and entry to use again.
    free_level: u32,
    free_entry: u32,
    table: [u32; 1 << TABLE],
}

#[derive(Clone, Copy, State)]
struct Level {
    /// The bits of f; of a level that is not in use, those of no f.
    f: u64,
    /// The entry on top; of a level that is not in use, the next such level.
    top: u32,
}

#[derive(Clone, Copy, State)]
struct Entry {
    place: Place,
    /// The entry below; of an entry that is not in use, the next such entry.
    below: u32,
}

const UNUSED: u64 = u64::MAX;

impl Default for Open {
    fn default() -> Self {
        // Every slot of the table leads to a level, at first to one that nobody uses.
        let levels = vec![Level { f: UNUSED, top: NONE }];
        Self { heap: Vec::new(), levels, entries: Vec::new(), free_level: NONE, free_entry: NONE, table: [0; 1 << TABLE] }
    }
}

impl Open {
    /// Puts a place in. `f` is not negative.
    #[inline]
    pub(super) fn push(&mut self, f: f64, place: Place) {
        let f = f.to_bits();
        let slot = (f.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - TABLE)) as usize;
        let mut level = self.table[slot] as usize;
        if self.levels[level].f != f {
            level = self.begin(f, slot);
        }
        let entry = Entry { place, below: self.levels[level].top };
        let at = self.free_entry;
        if let Some(unused) = self.entries.get_mut(at as usize) {
            self.free_entry = std::mem::replace(unused, entry).below;
            self.levels[level].top = at;
        } else {
            self.levels[level].top = self.entries.len() as u32;
            self.entries.push(entry);
        }
    }

    /// The lowest f and its place.
    #[inline]
    pub(super) fn first(&self) -> Option<(f64, Place)> {
        let &(f, level) = self.heap.first()?;
        Some((f64::from_bits(f), self.entries[self.levels[level as usize].top as usize].place))
    }

    /// Takes the first place out.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<(f64, Place)> {
        let &(f, level) = self.heap.first()?;
        let top = &mut self.levels[level as usize].top;
        let entry = &mut self.entries[*top as usize];
        let below = std::mem::replace(&mut entry.below, self.free_entry);
        self.free_entry = std::mem::replace(top, below);
        let place = entry.place;
        if below == NONE {
            self.end(level);
        }
        Some((f64::from_bits(f), place))
    }

    /// A new level for an f.
    #[inline(never)]
    fn begin(&mut self, f: u64, slot: usize) -> usize {
        let level = Level { f, top: NONE };
        let at = if self.free_level == NONE {
            self.levels.push(level);
            self.levels.len() - 1
        } else {
            let at = self.free_level as usize;
            self.free_level = std::mem::replace(&mut self.levels[at], level).top;
            at
        };
        self.table[slot] = at as u32;
        self.rise((f, at as u32));
        at
    }

    /// The first level is empty.
    #[inline(never)]
    fn end(&mut self, level: u32) {
        self.levels[level as usize] = Level { f: UNUSED, top: self.free_level };
        self.free_level = level;
        if let Some(last) = self.heap.pop().filter(|_| !self.heap.is_empty()) {
            self.sink(last);
        }
    }

    /// Puts a level into the heap.
    fn rise(&mut self, level: (u64, u32)) {
        let mut at = self.heap.len();
        self.heap.push(level);
        while at > 0 && level < self.heap[(at - 1) / ARITY] {
            self.heap[at] = self.heap[(at - 1) / ARITY];
            at = (at - 1) / ARITY;
        }
        self.heap[at] = level;
    }

    /// Puts a level where the first one was.
    fn sink(&mut self, level: (u64, u32)) {
        let heap = &mut self.heap[..];
        let mut at = 0;
        while let Some(children) = heap.get(ARITY * at + 1..(ARITY * at + 1 + ARITY).min(heap.len())) {
            let Some((i, &least)) = children.iter().enumerate().min_by_key(|(_, child)| **child) else { break };
            if level <= least {
                break;
            }
            heap[at] = least;
            at = ARITY * at + 1 + i;
        }
        heap[at] = level;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    /// Few values of f and many, put in and taken out in turn: what comes is always a lowest one, and all come once.
    #[test]
    fn places_leave_by_f() {
        for values in [3, 40, 100_000] {
            let (mut open, mut rng) = (Open::default(), Stream::new(5, 0));
            let mut inside: Vec<(u64, u32)> = Vec::new();
            for i in 0..6000 {
                if i < 4000 && (inside.is_empty() || rng.unit() < 0.6) {
                    let f = rng.below(values) as u64;
                    open.push(f as f64, i);
                    inside.push((f, i));
                } else if let Some(&(least, _)) = inside.iter().min_by_key(|(f, _)| *f) {
                    let first = open.first();
                    let (f, place) = open.pop().unwrap();
                    assert_eq!((Some((f, place)), f), (first, least as f64));
                    let at = inside.iter().position(|&one| one == (least, place)).expect("it was put in and not taken out");
                    inside.swap_remove(at);
                }
            }
            assert!(inside.is_empty() && open.pop().is_none() && open.first().is_none());
        }
    }

    #[test]
    fn of_equal_f_the_last_comes_first() {
        let mut open = Open::default();
        [(2.0, 7), (1.0, 8), (2.0, 9), (1.0, 6)].into_iter().for_each(|(f, place)| open.push(f, place));
        let left: Vec<_> = std::iter::from_fn(|| open.pop()).collect();
        assert_eq!(left, [(1.0, 6), (1.0, 8), (2.0, 9), (2.0, 7)]);
    }

    #[test]
    fn a_place_is_a_column_and_a_row() {
        assert_eq!(apart(place([2047, 1025])), [2047, 1025]);
        assert!(place([2047, 1]) < place([0, 2]));
    }
}
