//! `d-star-lite-drive`: a drive on ways of D* Lite, which repairs its search at each blockage instead of searching from
//! scratch; a baseline of [WOLF-ANT](crate#papers) §5.3.

use std::{sync::Arc, task::Poll};

use crate::{
    describe::{Case, Entry},
    kernel::State,
};

use super::{a_star_drive, d_star_lite::DStarLite, ground::Ground, planner, route::Route};

/// One search that is kept and repaired.
#[derive(Clone, State)]
struct Repaired {
    #[state(shared)]
    ground: Arc<Ground>,
    search: DStarLite,
}

impl Route for Repaired {
    fn evaluations(&self) -> u64 {
        self.search.expanded()
    }

    fn way(&mut self) -> Option<Vec<usize>> {
        self.search.way(self.ground.endpoints.start)
    }

    fn replan(&mut self, occupied: &[bool], from: usize) {
        self.search.occupy(occupied);
        self.search.go(from);
    }

    fn go_on(&mut self) -> Poll<Option<Vec<usize>>> {
        self.search.go_on()
    }

    fn is_long(&self) -> bool {
        self.ground.is_large()
    }

    fn copy(&self) -> Box<dyn Route> {
        Box::new(self.clone())
    }
}

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "crossing",
    "The search is repaired",
    "Where a disc is foreseen, D* Lite repairs its search instead of starting again.",
    "crossing",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "D* Lite plans a path: length @planned@",
    "drive on at @speed@ cells a second, and look every @period@ s:",
    "  for each obstacle in sight: when will it be nearest if both go on, and how near?",
    "  too near within @look_ahead@ s:",
    "    repair the search where its predicted range changes it, or wait",
    "  so far: new paths @replans@, waits @waits@",
    "after @time@ s: driven @length@, closest @smallest_distance@, collisions @collisions@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "d-star-lite-drive",
    "D* Lite, driving among moving obstacles",
    "Koenig and Likhachev 2002; [WOLF-ANT] §5.3",
    "The same drive on ways of D* Lite: where the robot foresees a collision, the search is repaired where the obstacle’s predicted range has changed it, or the robot waits.",
    |start| {
        planner::start(start, |ground| {
            let search = DStarLite::new(&ground.cells, ground.endpoints.start, ground.endpoints.goal);
            Ok(Box::new(Repaired { search, ground: Arc::clone(ground) }))
        })
    },
)
.like(&a_star_drive::ENTRY)
.cases(CASES)
.pseudocode(PSEUDOCODE);
