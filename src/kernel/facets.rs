//! What some planners can do and others cannot. A new ability is a new facet: neither the contract nor planners without
//! it change.

use super::{Event, Inspection, Item, Recommendation, Status};

/// The abilities of a planner beyond the contract, listed by `Facets::default().explain(self).members(self)` and the like.
#[derive(Default, Clone, Copy)]
#[non_exhaustive]
pub struct Facets<'a> {
    /// It explains single items of its drawing.
    pub explain: Option<&'a dyn Explain>,
    /// It tells numbers of its members.
    pub members: Option<&'a dyn Members>,
    /// It tells what happened, in the order of time.
    pub timeline: Option<&'a dyn Timeline>,
    /// It recommends parameters.
    pub recommend: Option<&'a dyn Recommend>,
    /// It says why it has no result.
    pub failure: Option<&'a dyn Failure>,
}

impl<'a> Facets<'a> {
    /// With explanations.
    #[must_use]
    pub fn explain(self, of: &'a dyn Explain) -> Self {
        Self { explain: Some(of), ..self }
    }

    /// With members.
    #[must_use]
    pub fn members(self, of: &'a dyn Members) -> Self {
        Self { members: Some(of), ..self }
    }

    /// With events.
    #[must_use]
    pub fn timeline(self, of: &'a dyn Timeline) -> Self {
        Self { timeline: Some(of), ..self }
    }

    /// With a recommendation.
    #[must_use]
    pub fn recommend(self, of: &'a dyn Recommend) -> Self {
        Self { recommend: Some(of), ..self }
    }

    /// With a reason for having no result.
    #[must_use]
    pub fn failure(self, of: &'a dyn Failure) -> Self {
        Self { failure: Some(of), ..self }
    }
}

/// Explains single items of a drawing.
pub trait Explain {
    /// What can be said of an item from the present state alone.
    fn inspect(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// What the next step does to an item and why; takes that step on a copy. The run asks the state before, so that
    /// nothing has to be recorded in the inner loop for the one particle that somebody may click.
    fn explain_next(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// The iteration whose step is to be explained, for an item that came about then; `None`: the last one.
    fn created_at(&self, _item: Item) -> Option<u64> {
        None
    }
}

/// Tells the numbers of those that search side by side.
pub trait Members {
    /// For each of them, in the order of the layer that can be inspected, one number for each of the entry's `members`.
    fn members(&self, out: &mut Vec<f64>);
}

/// Tells what happened in simulated time.
pub trait Timeline {
    /// What happened so far, in the order of time.
    fn events(&self) -> &[Event];
}

/// Recommends parameters for another planner.
pub trait Recommend {
    /// The parameters, once there are any.
    fn recommendation(&self) -> Option<Recommendation>;
}

/// Says why there is no result.
pub trait Failure {
    /// What keeps it from a result, if something does, in a sentence without a full stop.
    fn failure(&self, status: Status) -> Option<String>;
}
