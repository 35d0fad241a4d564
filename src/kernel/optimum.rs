//! The optimum that results are measured against.

use serde::Serialize;

/// An exact optimum: a shortest path or tour.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Exact {
    /// Its length, in the scene's unit.
    pub length: f64,
    /// The corners of the path. Arcs become corners just outside their discs, so that this line is collision-free and hardly
    /// longer.
    pub path: Vec<[f64; 2]>,
    /// The path of an arm's tip in space, in metres; `path` is empty then. Otherwise empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<[f64; 3]>>"))]
    pub tip_path: Vec<[f64; 3]>,
    /// The visiting order of a tour's stops; otherwise empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<usize>>"))]
    pub order: Vec<usize>,
    /// Whether it is stated in the scene file and was not computed.
    pub stored: bool,
}

impl Exact {
    /// A computed path of this length.
    pub fn way(length: f64, path: Vec<[f64; 2]>) -> Self {
        Self { length, path, tip_path: Vec::new(), order: Vec::new(), stored: false }
    }
}

/// The least value of a function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Minimum {
    /// The value.
    pub value: f64,
    /// Whether somebody stated it, in a scene file, and it was not proved.
    pub stated: bool,
}

impl From<f64> for Minimum {
    /// One that is proved.
    fn from(value: f64) -> Self {
        Self { value, stated: false }
    }
}

impl Minimum {
    /// Minima are stated with a few digits: by this share of it (or of 1, if it is less) another value may differ from one.
    pub fn rounding(self) -> f64 {
        1e-4 * self.value.abs().max(1.0)
    }

    /// Whether a cost shows that it is none: lower by more than rounding explains.
    pub fn is_refuted_by(self, cost: f64) -> bool {
        self.stated && cost < self.value - self.rounding()
    }
}
