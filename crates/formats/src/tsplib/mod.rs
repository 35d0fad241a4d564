//! TSPLIB's `.tsp` (stops and their distances) and `.tour` (a visiting order). Distances follow TSPLIB's own formulas, so that
//! lengths can be compared with published ones; what is not supported is refused by its name, never measured in another way.

mod read;
#[cfg(test)]
mod tests;
mod tour;
mod words;
mod write;

pub(super) use read::import;
pub use tour::tour_file;
pub(super) use tour::with_tour;
pub(super) use write::export;
