//! The colonies to choose from, for planners that tune one or go on with its pheromone.

use crate::{describe::Entry, params::Choice};

use super::{aco, aco_dijkstra, aco_direction, aco_wolf};

/// Every colony. A test compares the list with the catalogue.
pub(crate) const COLONIES: &[Choice] =
    &[option(&aco_wolf::ENTRY), option(&aco_direction::ENTRY), option(&aco_dijkstra::ENTRY), option(&aco::ENTRY)];

/// A planner as an option: its name, title and source.
const fn option(entry: &Entry) -> Choice {
    Choice { value: entry.name, title: entry.title, help: entry.source }
}
