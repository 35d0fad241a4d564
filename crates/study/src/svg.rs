//! Pictures are drawn in memory, and written as files are.

use std::{error::Error, io, path::Path};

use super::{
    disk,
    failure::{Failure, at},
};

/// Draws a picture as SVG, and writes it.
pub(crate) fn drawn(path: &Path, draw: impl FnOnce(&mut String) -> Result<(), Box<dyn Error>>) -> Result<(), Failure> {
    let mut svg = String::new();
    draw(&mut svg).map_err(|problem| io::Error::other(problem.to_string())).and_then(|()| disk::write(path, svg)).map_err(at(path))
}
