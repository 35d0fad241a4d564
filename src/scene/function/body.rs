//! Scenes of kind `function`: a function over a box, and what is known of its minimum.

use std::{fmt, sync::Arc};

use serde_json::Value;

use crate::{
    geometry::Bounds,
    kernel::{
        Error, Minimum, SceneKindId,
        objective::{Evaluation, Objective, Scratch, SearchBox},
    },
};

use super::named::{Function, Named};

/// The id of the kind in scene files.
pub const ID: SceneKindId = SceneKindId("function");

/// A scene with a function to minimise: one with a name, a formula, or an [`Objective`] of your own.
///
/// ```
/// use forage::scene::{Function, FunctionScene};
///
/// let scene = FunctionScene::named(Function::Rosenbrock, 3, vec![0.5, 0.0, -1.0]);
/// assert_eq!((scene.value(&[1.5, 1.0, 0.0]), scene.minimiser()), (0.0, Some(vec![1.5, 1.0, 0.0])));
/// assert_eq!(scene.search_box().low(), [-4.0, -4.0, -4.0]);
/// ```
#[derive(Clone)]
pub struct FunctionScene {
    objective: Arc<dyn Objective>,
    pub(super) source: Source,
}

/// Where a function comes from, and what is known of its minimum.
#[derive(Debug, Clone)]
pub(super) enum Source {
    Named(Arc<Named>),
    /// Its fields in the order in which they are written.
    Written {
        fields: Vec<(&'static str, Value)>,
        minimum: Option<Minimum>,
        minimiser: Option<Vec<f64>>,
        /// The fields do not say what it computes.
        code: bool,
    },
}

impl fmt::Debug for FunctionScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FunctionScene").field("source", &self.source).finish_non_exhaustive()
    }
}

impl FunctionScene {
    /// A test function in so many variables. `shift` is the position of its origin, a number for each variable; empty: at 0.
    /// A dimension or a shift that the function does not have is refused when a [`Scene`](crate::Scene) is made of it.
    pub fn named(function: Function, dimension: usize, shift: Vec<f64>) -> Self {
        let named = Arc::new(Named::new(function, dimension, shift));
        Self { objective: Arc::<Named>::clone(&named), source: Source::Named(named) }
    }

    /// A function with these fields in a scene file.
    pub(super) fn written(
        objective: Arc<dyn Objective>,
        fields: Vec<(&'static str, Value)>,
        minimum: Option<Minimum>,
        minimiser: Option<Vec<f64>>,
        code: bool,
    ) -> Self {
        Self { objective, source: Source::Written { fields, minimum, minimiser, code } }
    }

    pub(super) fn check_fields(&self) -> Result<(), Error> {
        match &self.source {
            Source::Named(named) => named.check(),
            Source::Written { .. } => Ok(()),
        }
    }

    /// What is minimised.
    pub fn objective(&self) -> &Arc<dyn Objective> {
        &self.objective
    }

    /// Where its minimum is searched.
    pub fn search_box(&self) -> &SearchBox {
        self.objective.search_box()
    }

    /// The number of variables.
    pub fn dimension(&self) -> usize {
        self.search_box().dimension()
    }

    /// The test function that it is, if it is one.
    pub fn function(&self) -> Option<Function> {
        match &self.source {
            Source::Named(named) => Some(named.function),
            Source::Written { .. } => None,
        }
    }

    /// The position of the minimum, if it is known.
    pub fn minimiser(&self) -> Option<Vec<f64>> {
        match &self.source {
            Source::Named(named) => Some(named.minimiser()),
            Source::Written { minimiser, .. } => minimiser.clone(),
        }
    }

    /// The least value, if it is known.
    pub fn minimum(&self) -> Option<Minimum> {
        match &self.source {
            Source::Named(_) => Some(Minimum::from(0.0)),
            Source::Written { minimum, .. } => *minimum,
        }
    }

    /// The value at `x`, whose length is the dimension.
    pub fn value(&self, x: &[f64]) -> f64 {
        self.objective.evaluate(x, &mut Scratch::default()).cost
    }

    /// The values at points of the plane of the first two variables, into `out`; the others are at the minimum, or in the middle of the box if
    /// it is not known.
    pub fn section(&self, points: &[[f64; 2]], out: &mut [f64]) {
        let search_box = self.search_box();
        let middle = || search_box.low().iter().zip(search_box.high()).map(|(low, high)| f64::midpoint(*low, *high)).collect();
        let rest = self.minimiser().unwrap_or_else(middle);
        let mut xs = Vec::with_capacity(points.len() * rest.len());
        for point in points {
            let at = xs.len();
            xs.extend(&rest);
            xs[at..].iter_mut().zip(point).for_each(|(x, value)| *x = *value);
        }
        let mut found = vec![Evaluation::from(0.0); points.len()];
        self.objective.evaluate_all(&xs, &mut Scratch::default(), &mut found);
        out.iter_mut().zip(found).for_each(|(out, found)| *out = found.cost);
    }

    /// The first two sides of the search box; a single one twice, about 0.
    pub(super) fn view(&self) -> Bounds {
        let (low, high) = (self.search_box().low(), self.search_box().high());
        let half = (high[0] - low[0]) / 2.0;
        let [bottom, top] = [low.get(1).copied().unwrap_or(-half), high.get(1).copied().unwrap_or(half)];
        Bounds { min: [low[0], bottom], max: [high[0], top] }
    }
}
