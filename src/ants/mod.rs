//! Ants that go from cell to cell of a grid and lay pheromone on their paths, [ANTBAT](crate#papers) §3.1 and
//! [WOLF-ANT](crate#papers) §5.1.
//!
//! There is one `colony`; `planner` is its stepped contract, `draw` shows it, `explain` says why an ant chose a step. What the
//! planners differ in is exchanged: how an ant sees the cells around it (`ground`), how it chooses among them (`walk`), and
//! what it lays (`update`). `pheromone` keeps τ and the choice weights, which are made once per iteration for each cell that an
//! ant comes to; a step is then a look-up and one random number. `scouts` are ants sent around obstacles of a drive; `colonies` lists the planners for others to choose from.

pub mod aco;
pub mod aco_dijkstra;
pub mod aco_direction;
pub mod aco_wolf;
mod colonies;
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

pub(crate) use colonies::COLONIES;
pub(crate) use colony::Colony;
