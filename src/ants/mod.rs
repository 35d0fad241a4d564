//! Ants that go from cell to cell of a grid and lay pheromone on their ways, [ANTBAT] §3.1 and [WOLF-ANT] §5.1.
//!
//! There is one `colony`, which `planner` makes a planner. What its planners differ in is exchanged: how an ant sees the cells around it (`ground`), how it
//! chooses among them (`walk`), and what it lays (`update`). `pheromone` keeps τ and the choice weights, which are made
//! once per iteration for each cell that an ant comes to; a step is then a look-up and one random number.

pub mod aco;
pub mod aco_dijkstra;
pub mod aco_direction;
pub mod aco_wolf;
mod colony;
mod draw;
mod explain;
mod ground;
mod parameters;
mod pheromone;
mod planner;
mod scouts;
#[cfg(test)]
mod tests;
mod update;
mod walk;

pub(crate) use colony::Colony;
pub use explain::SYMBOLS;
