//! Planners whose code is not Rust: what they say of themselves becomes an [`Entry`](forage::describe::Entry), and what they do is called
//! through [`Script`].
//!
//! A script keeps the states of its planner and knows each by a number, so that a state can be copied, hashed and forgotten like any
//! other. Scene, random numbers and costs come from [`Tools`], which are lent to it for the time of a call. `description` reads what a
//! planner says of itself, `planner` steps it.

mod description;
mod planner;
mod read;
#[cfg(test)]
mod tests;
mod tools;

pub use description::{ITERATIONS, entry};
pub use planner::{Advanced, Call, Drawn, Script, begin};
pub use read::{candidate, inspection, not_lent, threw};
pub use tools::{Tools, mathematics};
