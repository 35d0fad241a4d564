//! Drives among moving obstacles, [WOLF-ANT](crate#papers) §5.3: a way is planned, then a robot drives it in simulated time,
//! sees what moves, foresees collisions and goes round, replans or waits.
//!
//! A plan and then a `drive` are one planner (`planner`), on a `ground` that does not change. What its planners differ in is
//! who plans the paths, a `Route`, a file each. The robot's `journey` decides in one way (`decide`): `body` is how it moves,
//! `world` what it sees and foresees, `escape` what it does when neither a way round nor standing is safe. `a_star` and
//! `d_star_lite` search in `parts`, over the `queue` and the `steps` that they share; `draw` and `explain` show the drive.

mod a_star;
pub mod a_star_drive;
mod body;
mod d_star_lite;
pub mod d_star_lite_drive;
mod decide;
mod draw;
mod drive;
mod escape;
mod explain;
mod ground;
mod journey;
mod parameters;
mod parts;
mod planner;
mod queue;
mod route;
mod steps;
#[cfg(test)]
mod tests;
pub mod wolf_ant_drive;
mod world;
