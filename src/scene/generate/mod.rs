//! Random scenes: each made by a generator with parameters and a seed, the same everywhere; see
//! [`Registry::generate`](crate::Registry::generate).
//!
//! Grids have a way from start to goal without cutting corners: `scatter` blocks a share of the cells, `rooms` begins with
//! all blocked and opens some, `calls` puts stops on them, and `moving` adds moving obstacles. `grids` puts a grid together. `points` are
//! stops in the plane, `discs` obstacles there, and `function` is a test function with its minimum somewhere else, `bbob` one of that suite.

mod bbob;
mod calls;
mod discs;
mod function;
mod grids;
mod moving;
mod plot;
mod points;
mod rooms;
mod scatter;
#[cfg(test)]
mod tests;

pub use bbob::BBOB;
pub use calls::with_stops;
pub use discs::DISCS;
pub use function::SHIFTED;
pub use points::STOPS;
pub use rooms::{MAZE, ROOMS};
pub use scatter::{RANDOM, RUBBLE};
