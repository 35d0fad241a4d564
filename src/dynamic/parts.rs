//! Searches over cells in parts, so that a step that needs a long one can be interrupted.

use std::task::Poll;

/// How many cells are settled in a part: about a twentieth of a second.
pub(super) const PORTION: usize = 50_000;

/// Goes on until there is an answer.
pub(super) fn complete<T>(mut go_on: impl FnMut() -> Poll<T>) -> T {
    loop {
        if let Poll::Ready(answer) = go_on() {
            return answer;
        }
    }
}
