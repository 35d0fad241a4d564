//! What the entries of the tour planners share: parameters, readings, equations and layers.

use crate::{
    describe::{CONVERGED, Formula, Group, Layer, Member, Reading, layers},
    kernel::{Error, SceneKindId, TourEnds},
    message,
    params::{Choice, Param, Parameter, Parameters},
    scene::{GRID, Scene, TOUR, TourScene},
};

/// The kinds of scene that a tour planner runs on.
pub(super) const KINDS: &[SceneKindId] = &[GRID, TOUR];

/// Who can build roads; a test compares the list with the catalogue.
pub(super) const BUILDERS: &[Choice] = &[
    Choice::new("aco-direction", "Ants with direction", "[ANTBAT] §3.1, the improved ants."),
    Choice::new("aco-dijkstra", "Ants on a Dijkstra path", "[ANTBAT] §3.1, its [14]."),
    Choice::new("aco", "Traditional ants", "[ANTBAT] §3.1, the traditional ants."),
    Choice::new("aco-wolf", "Wolf-pack ant colony", "[WOLF-ANT] §5.1."),
    Choice::new("a-star", "A*", "The shortest paths from cell to cell."),
    Choice::new("dijkstra", "Dijkstra", "The same paths, more slowly."),
    Choice::new("theta-star", "Theta*", "Paths at any angle."),
    Choice::new("cuckoo-search", "Cuckoo search", "Compared in [ANTBAT] fig. 8, its [31], as published by Yang and Deb."),
    Choice::new("pso-rrt", "PSO with RRT", "Compared in [ANTBAT] fig. 8, its [32]. The paper gives no details."),
];

pub(super) const ROADS: Param<&str> = Param::name_of(
    "roads",
    "",
    "Roads by",
    BUILDERS,
    "Which planner finds the path between two stops, [ANTBAT] §3.2. It uses its preset `road`, or its defaults if it has none; each path has its own seed.",
)
.only_on(&[GRID]);
pub(super) const SMOOTH: Param<bool> = Param::flag(
    "smooth",
    "Smooth roads",
    true,
    "Roads without redundant nodes: a node goes if its neighbours see each other, [ANTBAT] §3.1. The tour is then measured by the shortest one at any angle, otherwise by the shortest from cell to cell.",
)
.only_on(&[GRID]);

const ROUNDS: &[Choice; 5] = &[
    Choice::new("scene", "As the scene says", "On grids: closed."),
    Choice::new("closed", "Closed", "Back to where it began."),
    Choice::new("open", "Open", "From any stop to any other."),
    Choice::new("from-first", "From the first stop", "From the first stop to any other."),
    Choice::new("first-to-last", "From the first to the last", "From the first stop to the last."),
];
pub(super) const ROUND: Param<Option<TourEnds>> = Param::choice(
    "round",
    "",
    "Tour",
    ROUNDS,
    &[None, Some(TourEnds::Closed), Some(TourEnds::Open), Some(TourEnds::FromFirst), Some(TourEnds::FirstToLast)],
    "Where a tour begins and ends.",
);

/// Refuses ends in view of the scene's fixed edges.
#[cold]
#[inline(never)]
pub(super) fn refuse_round(ends: TourEnds, scene: &TourScene) -> Error {
    let all = [TourEnds::Closed, TourEnds::Open, TourEnds::FromFirst, TourEnds::FirstToLast];
    // The first is none of them.
    let name = |ends: TourEnds| ROUNDS[1 + ends as usize].value;
    let possible: Vec<&str> = all.into_iter().filter(|&ends| scene.can_have(ends)).map(name).collect();
    let allowed =
        message!("scene-fixed-ends", "{possible}: what tours with the scene’s fixed edges can have", possible = possible.join(", "));
    Error::refused(ROUND.name(), name(ends), allowed)
}

/// What the ends of the tours are.
pub(super) fn round(scene: &Scene, settings: &Parameters) -> TourEnds {
    settings[ROUND].unwrap_or_else(|| scene.get::<TourScene>().map_or(TourEnds::Closed, TourScene::ends))
}

/// Where a tour begins and ends, and who builds roads.
pub const TOURS: &[Parameter] = &[ROUND.entry(), ROADS.entry(), SMOOTH.entry()];

/// How many steps the search for the tour takes.
pub const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "t_{\\max}",
    "Iterations",
    [1, 1_000_000, 100],
    "After how many iterations it stops; building roads comes first.",
)
.slider(10.0, 10_000.0, true);

pub(super) const POPULATION: Param<u64> =
    Param::integer("population", "N", "Population", [1, 100_000, 50], "How many search side by side.").slider(2.0, 500.0, true);

/// Whether every tour that is found is improved by local search.
pub(super) const LOCAL_SEARCH: Param<bool> = Param::choice(
    "local_search",
    "",
    "Local search",
    &[
        Choice::new("2-opt", "2-opt and Or-opt", "Every tour is improved by 2-opt and Or-opt moves until none helps."),
        Choice::new("none", "None", "Tours stay as the equations make them."),
    ],
    &[true, false],
    "What improves each tour. Swarms of the literature have a local search (Shi et al. 2007; Saji and Riffi 2016), and need it on more than about 50 stops. [ANTBAT] has none.",
);

/// The length of the shortest tour so far.
pub const BEST: Reading =
    Reading::new("best", "D_{\\text{best}}", "Shortest", Group::Cost, "The length of the shortest tour so far: the result.");
/// The mean length of the members' tours.
pub const MEAN: Reading = Reading::new("mean", "\\bar D", "Mean", Group::Cost, "The mean length of this iteration’s tours.");
/// How many roads are built; on grids.
pub const BUILT: Reading = Reading::new("roads", "", "Roads", Group::Count, "Roads built so far.");
/// How many roads were not found; on grids.
pub const FAILED: Reading =
    Reading::new("failed", "", "Failed", Group::Count, "Roads that their runs did not find: other roads lead there instead.");
/// The shortest tour by the roads that were built; on grids.
pub const BY_ROAD: Reading = Reading::new(
    "by_road",
    "D_{\\text{road}}",
    "Shortest by road",
    Group::Length,
    "The shortest tour by these very roads, computed for up to 15 stops: what is above it is the order’s fault, what it is above the exact optimum is the roads’.",
);
/// When the shortest tour was found.
pub const FOUND: Reading = CONVERGED.described("t^*", "Converged", "The search’s iteration in which the shortest tour was found.");
/// How much the members' tours differ from the shortest.
pub const DIFFERENT: Reading = Reading::new(
    "different",
    "\\overline{HD}",
    "Different",
    Group::Measure,
    "At how many places a tour differs from the shortest one, on average: Hamming’s distance.",
);

pub(super) const MEAN_LOUDNESS: Reading =
    Reading::new("loudness", "\\bar A", "Loudness", Group::Schedule, "The mean of the bats’ loudness.");
pub(super) const MEAN_PULSE_RATE: Reading =
    Reading::new("pulse_rate", "\\bar r", "Pulse rate", Group::Schedule, "The mean of the bats’ pulse rates.");

pub(super) const LENGTH: Formula =
    Formula::new("length", "[ANTBAT] (6)", "Length of a tour", "\\class{way}{D(s)} = \\sum_{i=1}^{n-1} d(s_i, s_{i+1}) + d(s_n, s_1)", "");

pub(super) const MEMBER_LENGTH: Member = Member::new("length", "D", "Length", "The length of its tour.");
pub(super) const MEMBER_DIFFERENT: Member =
    Member::new("different", "HD", "Different", "At how many places its tour differs from the shortest one.");

pub(super) const ROADS_LAYER: Layer = layers::ROADS.on_kinds(&[GRID]);

/// What a planner draws whose members hold a tour each.
pub(super) const fn layers_with(tours: &'static str) -> [Layer; 7] {
    let all = layers::TOURS.titled("All tours", tours).off().pickable();
    [ROADS_LAYER, all, layers::TOUR, layers::STOPS, layers::DIFFERENT, layers::WAY, layers::SUPPOSED]
}

/// What a planner with one tour draws.
pub(super) const LAYERS: &[Layer] = &[ROADS_LAYER, layers::TOUR, layers::STOPS, layers::WAY];
