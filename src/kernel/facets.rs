//! Facets: abilities that some planners have. A new ability is a new facet: neither the contract nor planners without it
//! change.

use super::{Event, Inspection, Item, Message, Recommendation, Status, rng::Stream};

/// The abilities of a planner beyond the contract, listed by `Facets::default().explain(self).members(self)` and the like.
#[derive(Default, Clone, Copy)]
#[non_exhaustive]
pub struct Facets<'a> {
    /// Explanations of single items of its drawing.
    pub explain: Option<&'a dyn Explain>,
    /// Numbers of each of its members.
    pub members: Option<&'a dyn Members>,
    /// Events in simulated time.
    pub timeline: Option<&'a dyn Timeline>,
    /// A recommendation of parameters.
    pub recommend: Option<&'a dyn Recommend>,
    /// The reason for having no result.
    pub failure: Option<&'a dyn Failure>,
}

impl<'a> Facets<'a> {
    /// Adds explanations.
    #[must_use]
    pub fn explain(self, of: &'a dyn Explain) -> Self {
        Self { explain: Some(of), ..self }
    }

    /// Adds members.
    #[must_use]
    pub fn members(self, of: &'a dyn Members) -> Self {
        Self { members: Some(of), ..self }
    }

    /// Adds events.
    #[must_use]
    pub fn timeline(self, of: &'a dyn Timeline) -> Self {
        Self { timeline: Some(of), ..self }
    }

    /// Adds a recommendation.
    #[must_use]
    pub fn recommend(self, of: &'a dyn Recommend) -> Self {
        Self { recommend: Some(of), ..self }
    }

    /// Adds the reason for having no result.
    #[must_use]
    pub fn failure(self, of: &'a dyn Failure) -> Self {
        Self { failure: Some(of), ..self }
    }
}

/// Explains single items of a drawing.
pub trait Explain {
    /// Explains an item from the present state alone.
    fn inspect(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// Explains what the next step does to an item; takes that step on a copy. The run asks the state before, so that nothing
    /// has to be recorded in the inner loop for the one particle that somebody may select.
    fn explain_next(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// Explains what the next step would do to an item with one thing otherwise: one of the `suppositions` of its explanation.
    /// Takes that step on a copy; `others` are the other random numbers, where those are supposed (by the name `random`). Its `after`, `velocity` and
    /// `jump` marks are shown.
    fn suppose(&self, _item: Item, _supposition: &str, _others: &Stream) -> Option<Inspection> {
        None
    }
    /// The same where an item is explained from the present state: what would be said of it with one thing otherwise. The run asks this
    /// first.
    fn suppose_now(&self, _item: Item, _supposition: &str) -> Option<Inspection> {
        None
    }
    /// The iteration that created the item, whose step is explained; `None`: the last iteration.
    fn created_at(&self, _item: Item) -> Option<u64> {
        None
    }
}

/// Lists numbers of each member of a population: particle, bat, ant, …
pub trait Members {
    /// For each member, in the order of the layer that can be inspected, one number for each of the entry's `members`.
    fn members(&self, out: &mut Vec<f64>);
}

/// Lists events in simulated time.
pub trait Timeline {
    /// The events so far, in order of time.
    fn events(&self) -> &[Event];
}

/// Recommends parameters for another planner.
pub trait Recommend {
    /// The parameters, once there are any.
    fn recommendation(&self) -> Option<Recommendation>;
}

/// Explains why there is no result.
pub trait Failure {
    /// The reason for having no result, if there is one: a sentence without a full stop.
    fn failure(&self, status: Status) -> Option<Message>;
    /// The position at which a cost could not be computed, if that is the reason.
    fn failed_at(&self) -> Option<&[f64]> {
        None
    }
}
