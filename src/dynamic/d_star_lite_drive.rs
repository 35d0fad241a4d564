//! `d-star-lite-drive`: a drive on ways of D* Lite, which repairs its search at each blockage instead of searching from
//! scratch; a baseline of [WOLF-ANT] §5.3.

use std::sync::Arc;

use crate::{catalogue::Entry, digest::Digest};

use super::{
    Ground,
    d_star_lite::DStarLite,
    parameters::{
        BORDER, EVENTS, FORMULA_APPROACH, FORMULA_TIME, ITERATIONS, KINDS, LAYERS_BARE, LOOK_AHEAD, MARGIN, PERIOD, READINGS, ROBOT,
        ROBOT_RADIUS, SENSOR, SPEED, TIME_LIMIT, TURN_TIME,
    },
    route::Route,
};

/// One search that is kept and repaired.
#[derive(Clone)]
struct Repaired {
    ground: Arc<Ground>,
    search: DStarLite,
}

impl Route for Repaired {
    fn evaluations(&self) -> u64 {
        self.search.expanded()
    }

    fn way(&mut self) -> Option<Vec<usize>> {
        self.search.way(self.ground.course.start)
    }

    fn replan(&mut self, occupied: &[bool], from: usize) -> Option<Vec<usize>> {
        self.search.occupy(occupied);
        self.search.way(from)
    }

    fn digest(&self, out: &mut Digest) {
        self.search.digest(out);
    }

    fn bytes(&self) -> usize {
        self.search.bytes()
    }

    fn copy(&self) -> Box<dyn Route> {
        Box::new(self.clone())
    }
}

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "d-star-lite-drive",
    title: "D* Lite, then a drive among what moves",
    family: "dynamic",
    source: "Koenig and Likhachev 2002; [WOLF-ANT] §5.3",
    summary: "The same drive on ways of D* Lite: where the robot foresees a collision, the search is repaired where the obstacle’s predicted range has changed it, or the robot waits.",
    kinds: KINDS,
    parameters: &[ITERATIONS, BORDER, ROBOT, ROBOT_RADIUS, MARGIN, SPEED, TURN_TIME, SENSOR, LOOK_AHEAD, PERIOD, TIME_LIMIT],
    readings: READINGS,
    formulas: &[FORMULA_APPROACH, FORMULA_TIME],
    layers: LAYERS_BARE,
    stops: false,
    most_stops: None,
    members: &[],
    events: EVENTS,
    suggest: |_| None,
    start: |scene, settings, _| {
        super::start(scene, settings, |ground| {
            let search = DStarLite::new(&ground.cells, ground.course.start, ground.course.goal);
            Ok(Box::new(Repaired { search, ground: Arc::clone(ground) }))
        })
    },
};
