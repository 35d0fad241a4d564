//! Who follows a path that was found: a robot ([`drive`]), an arm ([`motion`]). A folder each, with its entry.

pub mod drive;
pub mod motion;
