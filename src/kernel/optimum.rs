//! The optimum that results are measured by.

/// The shortest way there is.
#[derive(Debug, Clone, PartialEq)]
pub struct Exact {
    /// Its length, in the scene's unit.
    pub length: f64,
    /// Its course; arcs as corners just outside their discs, so this line is collision-free and hardly longer.
    pub path: Vec<[f64; 2]>,
    /// Of an arm's tip: its course in space; `path` is empty then. Otherwise empty.
    pub tip_path: Vec<[f64; 3]>,
    /// Of a tour: the order of its stops. Otherwise empty.
    pub order: Vec<usize>,
    /// The scene's file says so; it was not computed.
    pub stored: bool,
}

impl Exact {
    /// A way of this length.
    pub fn way(length: f64, path: Vec<[f64; 2]>) -> Self {
        Self { length, path, tip_path: Vec::new(), order: Vec::new(), stored: false }
    }
}
