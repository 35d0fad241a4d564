//! What hangs together in a grid: which cells can be reached from one another, and how far apart they are.

use std::collections::VecDeque;

/// The cells that share a side with one.
pub(super) fn beside(cell: usize, columns: usize, count: usize) -> impl Iterator<Item = usize> {
    let column = cell % columns;
    let left = (column > 0).then(|| cell - 1);
    let right = (column + 1 < columns).then(|| cell + 1);
    let (before, after) = (cell.checked_sub(columns), Some(cell + columns).filter(|&next| next < count));
    [right, after, left, before].into_iter().flatten()
}

/// Marks every cell that can be reached from one, and lists them, the farthest last, by straight steps. (Diagonal steps
/// reach no more cells: without corner cutting they need both cells beside them free.)
pub fn reach(blocked: &[bool], columns: usize, from: usize, seen: &mut [bool]) -> Vec<usize> {
    let mut found = vec![from];
    seen[from] = true;
    let mut next = 0;
    while let Some(&cell) = found.get(next) {
        next += 1;
        for other in beside(cell, columns, blocked.len()) {
            if !blocked[other] && !seen[other] {
                seen[other] = true;
                found.push(other);
            }
        }
    }
    found
}

/// The way from one cell to another by straight steps that crosses the fewest blocked cells, both ends included.
pub(super) fn crossing(blocked: &[bool], columns: usize, from: usize, to: usize) -> Vec<usize> {
    const FAR: u32 = u32::MAX;
    let mut crossed = vec![FAR; blocked.len()];
    let mut before = vec![from; blocked.len()];
    // Free cells go to the front, blocked ones to the back: what is taken out has crossed the fewest.
    let mut open = VecDeque::from([from]);
    crossed[from] = 0;
    while let Some(cell) = open.pop_front() {
        for other in beside(cell, columns, blocked.len()) {
            let through = crossed[cell] + u32::from(blocked[other]);
            if through < crossed[other] {
                (crossed[other], before[other]) = (through, cell);
                if blocked[other] {
                    open.push_back(other);
                } else {
                    open.push_front(other);
                }
            }
        }
    }
    let mut way = vec![to];
    while let Some(&cell) = way.last().filter(|&&cell| cell != from) {
        way.push(before[cell]);
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(rows: &[&str]) -> Vec<bool> {
        rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect()
    }

    #[test]
    fn all_that_hangs_together_is_found_the_farthest_last() {
        let blocked = cells(&["..#.", "#.#.", "...#"]);
        let mut seen = vec![false; 12];
        assert_eq!(reach(&blocked, 4, 0, &mut seen), [0, 1, 5, 9, 10, 8]);
        assert_eq!(seen.iter().filter(|&&seen| seen).count(), 6);
        assert_eq!(reach(&blocked, 4, 3, &mut seen), [3, 7], "not past the corner");
    }

    #[test]
    fn a_way_crosses_no_more_than_it_must() {
        let blocked = cells(&[".#.", "###", ".#."]);
        let way = crossing(&blocked, 3, 0, 8);
        assert_eq!((way.first(), way.last(), way.len()), (Some(&8), Some(&0), 5));
        assert_eq!(way.iter().filter(|&&cell| blocked[cell]).count(), 2);
        let winding = cells(&["...", "##.", "...", ".##", "..."]);
        assert_eq!(crossing(&winding, 3, 0, 14).iter().filter(|&&cell| winding[cell]).count(), 0);
    }
}
