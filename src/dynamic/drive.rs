//! A plan, then a drive: the state of both.

use std::sync::Arc;

use crate::kernel::{Progress, State, Status, Track};

use super::{
    body::Body,
    ground::Ground,
    journey::Journey,
    route::{Open, Route, Ways},
};

/// A plan, then a drive.
#[derive(Clone, State)]
pub(super) struct Dynamic {
    #[state(shared)]
    pub(super) ground: Arc<Ground>,
    pub(super) route: Box<dyn Route>,
    /// Copies share it until it goes on.
    pub(super) journey: Option<Arc<Journey>>,
    /// What the drive has asked for in this period, and what it waits for: nothing between two periods.
    #[state(skip)]
    pub(super) found: Vec<Option<Vec<usize>>>,
    #[state(shared)]
    pub(super) waits: Option<Open>,
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
            Some(way) => self.journey = Some(Arc::new(Journey::new(&self.ground, &way))),
            None => self.lost = true,
        }
    }

    /// A period of the drive, or a part of one. A period that waits for a way is carried out again when there is one: until then the drive
    /// is where it was.
    pub(super) fn drive(&mut self) -> Progress {
        let Some(journey) = &mut self.journey else {
            return Progress::Continue;
        };
        let over = match &mut self.waits {
            None => true,
            Some(Open::Way) => self.route.go_on().map(|way| self.found.push(way)).is_ready(),
            Some(Open::Ahead(ahead)) => ahead.go_on(&self.ground).map(|all| self.ground.ahead.set(all)).is_ready(),
        };
        if !over {
            return Progress::Partly;
        }
        self.waits = None;
        let before = self.route.is_long().then(|| Arc::clone(journey));
        let mut ways = Ways { route: &mut *self.route, found: &mut self.found, asked: 0, open: None };
        Arc::make_mut(journey).step(&mut ways, self.iteration + 1);
        if let (Some(open), Some(before)) = (ways.open, before) {
            (*journey, self.waits) = (before, Some(open));
            return Progress::Partly;
        }
        self.found.clear();
        Progress::Continue
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
