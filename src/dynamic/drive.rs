//! A plan, then a drive: the state of both.

use std::sync::Arc;

use crate::kernel::{Progress, State, Status, Track};

use super::{body::Body, ground::Ground, journey::Journey, route::Route};

/// A plan, then a drive.
#[derive(Clone, State)]
pub(super) struct Dynamic {
    #[state(shared)]
    pub(super) ground: Arc<Ground>,
    pub(super) route: Box<dyn Route>,
    pub(super) journey: Option<Journey>,
    /// Planning found no way.
    pub(super) lost: bool,
    pub(super) iteration: u64,
    /// Seconds after which it gives up.
    #[state(shared)]
    pub(super) most: f64,
}

impl Dynamic {
    /// The way is planned: the drive begins.
    pub(super) fn set_out(&mut self) {
        match self.route.way() {
            Some(way) => self.journey = Some(Journey::new(&self.ground, &way)),
            None => self.lost = true,
        }
    }

    pub(super) fn progress(&self) -> Progress {
        match &self.journey {
            _ if self.lost => Progress::Done(Status::Infeasible),
            Some(journey) if journey.arrived => Progress::Done(Status::Solved),
            Some(journey) if journey.now >= self.most => Progress::Done(Status::Exhausted),
            _ => Progress::Continue,
        }
    }

    pub(super) fn track(&self, journey: &Journey) -> Track {
        let Body { radius, border, .. } = self.ground.body;
        Track { path: journey.path(), moments: journey.moments.clone(), radius, border }
    }
}
