//! Rapidly-exploring random trees that step like every other planner, [ARM-RRT](crate#papers) §3.2: `rrt`, `rrt-guided`,
//! `rrt-connect`, `rrt-star`, and `rrt-joint` in an arm's six joints. One extension a step.
//!
//! - `space`: what a tree grows through; `joints`: an arm's joints. `sample`: where it is asked to grow to.
//! - `forest`: nodes, parents and lengths; `nearest`: the spatial index.
//! - `grow`: what the planners share, and what the last extension did. A `Method` says how one extension is made:
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
mod nearest;
mod parameters;
pub mod paths;
mod planner;
mod polyline;
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

use crate::{describe::Start, kernel::Error};

use grow::{Grown, Method};
use parameters::MARGIN;
use task::Task;

/// A tree in a plane or in the workspace of an arm's tip, by a method that looks at what it is to do first.
///
/// # Errors
/// A scene without start and goal.
fn grown<M: Method<3>>(start: &Start, goal_bias: f64, method: impl FnOnce(&Task<3>) -> M) -> Result<Grown<3, M>, Error> {
    let task = Task::new(space::of_scene(start.scene, start.parameters[MARGIN])?, start.parameters, goal_bias);
    let method = method(&task);
    Ok(Grown::new(task, method, start.seed))
}
