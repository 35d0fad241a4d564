//! How a cell was reached: from where, by which step, and whether that is settled.

use crate::kernel::State;

/// Whose child a cell is (plus 1), the direction of the last step to it, and whether it is settled, in one word. 0: not
/// reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, State)]
pub(super) struct Link(u32);

const CLOSED: u32 = 1 << 31;
const DIRECTION: u32 = 24;
const PARENT: u32 = (1 << DIRECTION) - 1;

impl Link {
    /// A cell reached from this one by a step in this direction.
    #[inline]
    pub(super) fn new(parent: usize, direction: usize) -> Self {
        Self((direction as u32) << DIRECTION | (parent as u32 + 1))
    }

    /// The same, settled.
    #[inline]
    #[must_use]
    pub(super) fn closed(self) -> Self {
        Self(self.0 | CLOSED)
    }

    /// Whether it is settled.
    #[inline]
    pub(super) fn is_closed(self) -> bool {
        self.0 & CLOSED != 0
    }

    /// The parent of a cell that was reached; the start's is itself.
    #[inline]
    pub(super) fn parent(self) -> usize {
        (self.0 & PARENT).wrapping_sub(1) as usize
    }

    /// The direction of the last step.
    #[inline]
    pub(super) fn direction(self) -> u32 {
        self.0 >> DIRECTION & 7
    }
}

/// The steps from a cell that are worth a look when it was reached from its parent by a step in this direction. The
/// others lead back to it, or to where the parent goes itself, no longer: these ways were known when it was settled.
/// `moves` are the steps that the parent may take.
#[inline]
pub(super) fn onward(moves: u8, direction: u32) -> u8 {
    // Bit i, here and in the table: i · 45° to the left of the step.
    !KNOWN[(direction & 1) as usize][moves.rotate_right(direction) as usize].rotate_left(direction)
}

/// For a straight and for a diagonal step and the parent's moves, as the step sees them: the directions that are known.
static KNOWN: [[u8; 256]; 2] = known();

const fn known() -> [[u8; 256]; 2] {
    let mut table = [[0; 256]; 2];
    let mut moves = 0;
    while moves < 256 {
        let m = moves as u8;
        // The parent's neighbours at 45° and 90° are the cell's at 90° and 135° after a straight step; after a diagonal
        // one, its neighbours at 45° are the cell's at 135°.
        table[0][moves] = 1 << 4 | (m >> 1 & 1) << 2 | (m >> 2 & 1) << 3 | (m >> 7 & 1) << 6 | (m >> 6 & 1) << 5;
        table[1][moves] = 1 << 4 | (m >> 1 & 1) << 3 | (m >> 7 & 1) << 5;
        moves += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::DIRECTIONS;

    #[test]
    fn a_link_keeps_its_parts() {
        let link = Link::new(2048 * 2048 - 1, 7);
        assert_eq!((link.parent(), link.direction(), link.is_closed()), (2048 * 2048 - 1, 7, false));
        let closed = link.closed();
        assert_eq!((closed.parent(), closed.direction(), closed.is_closed()), (2048 * 2048 - 1, 7, true));
        assert!(!Link::default().is_closed() && Link::new(0, 0) != Link::default());
    }

    /// By coordinates: a step leads to something known if it leads back or to where the parent may go.
    #[test]
    fn what_the_parent_reaches_itself_is_not_looked_at_again() {
        for moves in 0..=255_u8 {
            for (direction, step) in DIRECTIONS.into_iter().enumerate() {
                for (d, next) in DIRECTIONS.into_iter().enumerate() {
                    let from_parent = [step[0] + next[0], step[1] + next[1]];
                    let known =
                        from_parent == [0, 0] || DIRECTIONS.iter().enumerate().any(|(k, by)| *by == from_parent && moves >> k & 1 != 0);
                    assert_eq!(onward(moves, direction as u32) >> d & 1 == 0, known, "{moves:b} {direction} {d}");
                }
            }
        }
    }
}
