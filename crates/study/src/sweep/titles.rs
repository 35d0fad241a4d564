//! Titles of a sweep's tables.

use forage::{kernel::Message, message, statistics::Friedman};

use super::super::table::{p_is, significant};

/// What a table of mean ranks shows.
pub(super) fn rank_title(friedman: &Friedman) -> Message {
    let blocks = friedman.blocks;
    let title = message!("study-mean-ranks", "Mean ranks over {blocks} blocks, scene × seed (Friedman)", blocks);
    let title = match (friedman.statistic, friedman.p) {
        (Some(statistic), Some(p)) => {
            message!("study-friedman", "{title}: χ² = {statistic}, {p}", title, statistic = significant(statistic, 4), p = p_is(p))
        }
        _ => title,
    };
    match friedman.critical_difference {
        Some(difference) => message!(
            "study-nemenyi",
            "{title}; they differ significantly from {difference} on (Nemenyi, 5 %); planners that share a letter do not differ",
            title,
            difference = significant(difference, 3)
        ),
        None => title,
    }
}
