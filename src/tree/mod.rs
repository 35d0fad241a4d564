//! Rapidly-exploring random trees that step like every other planner, [ARM-RRT](crate#papers) §3.2: `rrt`, `rrt-guided`,
//! `rrt-connect`, `rrt-star`, and `rrt-joint` in an arm's six joints. One extension a step.
//!
//! A tree grows through a [`Space`], in any number of dimensions. An own one is a box, a start, goals and a test whether a straight
//! piece is free; each planner's `on` starts in it. A [`Method`] says how one extension of the [`Forest`] is made; an own one is a
//! planner by [`Trees::new`].
//!
//! ```
//! use std::sync::Arc;
//! use forage::{Overrides, kernel::{SceneKindId, Stepper}, tree::{Space, rrt_star}};
//!
//! /// The unit square with a wall at x = 0.5, open above y = 0.6.
//! struct Door;
//!
//! impl Space<2> for Door {
//!     fn bounds(&self) -> ([f64; 2], [f64; 2]) {
//!         ([0.0; 2], [1.0; 2])
//!     }
//!     fn start(&self) -> [f64; 2] {
//!         [0.1, 0.5]
//!     }
//!     fn goals(&self) -> &[[f64; 2]] {
//!         &[[0.9, 0.5]]
//!     }
//!     fn is_free(&self, a: &[f64; 2], b: &[f64; 2]) -> bool {
//!         let at = |x: f64| a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
//!         (a[0] < 0.5) == (b[0] < 0.5) || at(0.5) >= 0.6
//!     }
//! }
//!
//! let parameters = rrt_star::ENTRY.configure(SceneKindId("door"), &Overrides::default())?;
//! let mut run = Stepper::from(rrt_star::on(Arc::new(Door), &parameters, 1)?);
//! while run.step(|_| Vec::new()) {}
//! let (shortest, found) = (2.0 * f64::hypot(0.4, 0.1), run.planner.best().unwrap().cost);
//! assert!(shortest <= found && found < 1.01 * shortest);
//! # Ok::<(), forage::Error>(())
//! ```
//!
//! # The parts
//! - `space`: what a tree grows through; `joints`: an arm's joints; `postures`: how an arm goes along with its tip. `sample`: where it is asked to grow to.
//! - `forest`: nodes, parents and lengths; `nearest`: the spatial index.
//! - `grow`: what a method works on, and what the last extension did. `method`: how one extension is made:
//!   [`rrt`], [`rrt_guided`], [`rrt_connect`], [`rrt_star`], [`rrt_joint`], a file a planner.
//! - `found`, `finish`, `polyline`, `hermite`: the path, and what is made of it. [`paths`]: paths for other planners to begin with.
//! - `planner`: the stepped contract; `draw` and `explain`: what it looks like and why; `parameters`: what the entries share.

mod draw;
mod explain;
mod finish;
mod forest;
mod found;
mod free;
mod grow;
mod hermite;
mod joints;
mod method;
mod nearest;
mod parameters;
pub mod paths;
mod planner;
mod polyline;
mod postures;
pub mod rrt;
pub mod rrt_connect;
pub mod rrt_guided;
pub mod rrt_joint;
pub mod rrt_star;
mod sample;
mod space;
mod task;
#[cfg(test)]
mod tests;
mod vector;

pub use forest::Tree;
pub use grow::{By, Forest, SampleOutcome, Source};
pub use method::{Method, Trees};
pub use space::Space;
pub use task::Task;

/// What an evaluation of a tree is.
pub(crate) const EVALUATION: &str = "a straight segment that is checked for collisions";
