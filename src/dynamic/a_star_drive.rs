//! `a-star-drive`: a drive on ways of A*, planned anew at each blockage; a baseline of [WOLF-ANT] §5.3.

use std::sync::Arc;

use crate::{catalogue::Entry, digest::Digest};

use super::{
    Ground,
    a_star::AStar,
    parameters::{
        BORDER, EVENTS, FORMULA_APPROACH, FORMULA_TIME, ITERATIONS, KINDS, LAYERS_BARE, LOOK_AHEAD, MARGIN, PERIOD, READINGS, ROBOT,
        ROBOT_RADIUS, SENSOR, SPEED, TIME_LIMIT, TURN_TIME,
    },
    route::Route,
};

/// A search from scratch each time.
#[derive(Clone)]
struct Anew {
    ground: Arc<Ground>,
    search: AStar,
}

impl Route for Anew {
    fn evaluations(&self) -> u64 {
        self.search.expanded()
    }

    fn way(&mut self) -> Option<Vec<usize>> {
        let nothing = vec![false; self.ground.cells.len()];
        self.search.way(&nothing, self.ground.course.start, self.ground.course.goal)
    }

    fn replan(&mut self, occupied: &[bool], from: usize) -> Option<Vec<usize>> {
        self.search.way(occupied, from, self.ground.course.goal)
    }

    fn digest(&self, out: &mut Digest) {
        out.word(self.search.expanded());
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
    name: "a-star-drive",
    title: "A*, driving among moving obstacles",
    family: "dynamic",
    source: "Hart, Nilsson and Raphael 1968; [WOLF-ANT] §6",
    summary: "The shortest way from cell to cell, then a drive in simulated time: where the robot foresees a collision it searches a new way round the obstacle’s predicted range from scratch, or waits.",
    kinds: KINDS,
    parameters: &[ITERATIONS, BORDER, ROBOT, ROBOT_RADIUS, MARGIN, SPEED, TURN_TIME, SENSOR, LOOK_AHEAD, PERIOD, TIME_LIMIT],
    readings: READINGS,
    formulas: &[FORMULA_APPROACH, FORMULA_TIME],
    layers: LAYERS_BARE,
    stops: false,
    most_stops: None,
    members: &[],
    events: EVENTS,
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, _| {
        super::start(scene, settings, |ground| Ok(Box::new(Anew { search: AStar::new(&ground.cells), ground: Arc::clone(ground) })))
    },
};
