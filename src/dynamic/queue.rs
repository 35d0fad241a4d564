//! Cells in the order of their keys, of which each can be given another key or taken out.

use crate::kernel::State;

/// What cells are ordered by: the first number, among equals the second.
pub(super) type Key = [u64; 2];

/// Not in the queue.
const NOWHERE: u32 = u32::MAX;

/// A binary heap that knows where each cell is. Among cells with equal keys the smaller number comes first, so what comes
/// depends on what is in it and on nothing else.
#[derive(Debug, Clone, State)]
pub(super) struct Queue {
    heap: Vec<(Key, u32)>,
    /// Each cell's index in the heap.
    #[state(skip)]
    places: Vec<u32>,
}

impl Queue {
    /// An empty queue for this many cells.
    pub(super) fn new(cells: usize) -> Self {
        Self { heap: Vec::new(), places: vec![NOWHERE; cells] }
    }

    /// The first cell with its key.
    #[inline]
    pub(super) fn first(&self) -> Option<(Key, usize)> {
        self.heap.first().map(|&(key, cell)| (key, cell as usize))
    }

    /// Takes the first cell out.
    pub(super) fn pop(&mut self) -> Option<usize> {
        let (_, cell) = self.first()?;
        self.remove(cell);
        Some(cell)
    }

    /// Puts a cell in, or gives it another key if it is in already.
    pub(super) fn put(&mut self, cell: usize, key: Key) {
        let entry = (key, cell as u32);
        let mut at = self.places[cell] as usize;
        if at >= self.heap.len() {
            at = self.heap.len();
            self.heap.push(entry);
        }
        self.settle(at, entry);
    }

    /// Takes a cell out if it is in.
    pub(super) fn remove(&mut self, cell: usize) {
        let at = std::mem::replace(&mut self.places[cell], NOWHERE);
        if at != NOWHERE
            && let Some(last) = self.heap.pop()
            && (at as usize) < self.heap.len()
        {
            self.settle(at as usize, last);
        }
    }

    /// Takes all out.
    pub(super) fn clear(&mut self) {
        self.heap.drain(..).for_each(|(_, cell)| self.places[cell as usize] = NOWHERE);
    }

    /// Finds the place of an entry whose place may be `at`, or above it, or below it.
    fn settle(&mut self, mut at: usize, entry: (Key, u32)) {
        while at > 0 && entry < self.heap[(at - 1) / 2] {
            self.set(at, self.heap[(at - 1) / 2]);
            at = (at - 1) / 2;
        }
        while let Some(&left) = self.heap.get(2 * at + 1) {
            let right = self.heap.get(2 * at + 2).filter(|right| **right < left);
            let (child, least) = right.map_or((2 * at + 1, left), |&right| (2 * at + 2, right));
            if entry <= least {
                break;
            }
            self.set(at, least);
            at = child;
        }
        self.set(at, entry);
    }

    #[inline]
    fn set(&mut self, at: usize, entry: (Key, u32)) {
        self.heap[at] = entry;
        self.places[entry.1 as usize] = at as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    /// Beside a plain list: cells put in, given other keys, taken out.
    #[test]
    fn cells_leave_by_key_and_then_by_number() {
        let (mut queue, mut rng) = (Queue::new(60), Stream::new(8, 0));
        let mut inside: Vec<Option<Key>> = vec![None; 60];
        for _ in 0..20_000 {
            let (cell, key) = (rng.below(60), [rng.below(6) as u64, rng.below(6) as u64]);
            let least = (0..60).filter_map(|cell| Some((inside[cell]?, cell))).min();
            assert_eq!(queue.first(), least);
            match rng.below(4) {
                0 => {
                    queue.remove(cell);
                    inside[cell] = None;
                }
                1 => {
                    let first = least.map(|(_, cell)| cell);
                    assert_eq!(queue.pop(), first);
                    first.into_iter().for_each(|cell| inside[cell] = None);
                }
                _ => {
                    queue.put(cell, key);
                    inside[cell] = Some(key);
                }
            }
            if rng.unit() < 0.002 {
                queue.clear();
                inside.fill(None);
            }
        }
    }
}
