//! The standard layers, with the look that they have in every planner. An entry lists those that it draws, under its own titles:
//! `layers::BEST.titled("Path", "The path along the tree.")`.

use crate::kernel::{LayerKey, Shape};

use super::{Color, Glyph, Layer, Look, Ramp, Weight};

const fn layer(key: &'static str, title: &'static str, help: &'static str, look: &'static Look) -> Layer {
    Layer::new(LayerKey(key), title, help, look)
}

/// The colours of a function's heights, from the lowest value to the highest: calm, and monotone in lightness so that they also read in
/// grey.
pub const HEIGHTS: [Color; 5] =
    [Color::named("height-1"), Color::named("height-2"), Color::named("height-3"), Color::named("height-4"), Color::named("height-5")];

const fn look(color: &'static str, width: f64, order: i16) -> Look {
    Look { color: Color::named(color), width, order, ..Look::PLAIN }
}

const fn ramp(colors: [&'static str; 3], root: bool) -> Ramp {
    let [weak, middle, strong] = colors;
    Ramp { colors: [Color::named(weak), Color::named(middle), Color::named(strong)], root }
}

// Results.

const BEST_LOOK: Look = Look { point: 9.0, glyph: Glyph::Ring, result: 1, ..look("best", 3.0, 40) };
const TOUR_LOOK: Look = Look { point: 9.0, glyph: Glyph::Arrow, result: 2, ..look("best", 2.75, 40) };
const SMOOTHED_LOOK: Look = Look { point: 9.0, glyph: Glyph::Ring, result: 3, ..look("best", 3.25, 41) };
/// The best solution so far.
pub const BEST: Layer = layer("best", "Best", "The best so far: the result.", &BEST_LOOK);
/// The best tour, in its direction.
pub const TOUR: Layer = layer("tour", "Shortest tour", "The shortest tour so far, in its direction: the result.", &TOUR_LOOK);
/// The result after smoothing.
pub const SMOOTHED: Layer = layer("smoothed", "Smoothed", "The best, smoothed: the result that is handed over.", &SMOOTHED_LOOK);

// Swarms.

const GUIDES_LOOK: Look = Look { dash: &[2.0, 4.0], ..look("guide", 1.0, 5) };
const PERSONAL_BESTS_LOOK: Look = Look { point: 2.5, opacity: [0.35, 0.35], ..look("accent", 0.75, 10) };
const PARTICLES_LOOK: Look = Look { point: 5.0, opacity: [0.55, 0.1], ..look("particle", 1.0, 20) };
const ATTRACTORS_LOOK: Look = Look { point: 4.0, opacity: [0.6, 0.6], dash: &[8.0, 2.0, 1.0, 2.0], ..look("attractor", 1.0, 22) };
const VELOCITIES_LOOK: Look = Look { point: 2.0, opacity: [0.55, 0.55], shape: Some(Shape::Segments), ..look("inertia", 0.75, 25) };
const SELECTED_LOOK: Look = Look { point: 6.0, opacity: [0.9, 0.9], glyph: Glyph::Diamond, ..look("selected", 1.6, 29) };
const HENS_LOOK: Look = Look { point: 5.0, opacity: [0.9, 0.9], glyph: Glyph::Ring, ..look("hen", 1.6, 30) };
const CHICKS_LOOK: Look = Look { point: 5.0, opacity: [0.95, 0.95], dash: &[7.0, 3.0], glyph: Glyph::Diamond, ..look("chick", 1.6, 31) };
const MEAN_BEST_LOOK: Look = Look { point: 8.0, dash: &[7.0, 4.0], glyph: Glyph::Diamond, ..look("mean", 2.25, 33) };
/// Curves on which the planner places points: the circles of a polar path, [LTQPSO](crate#papers) (13).
pub const GUIDES: Layer = layer(
    "guides",
    "Circles",
    "The circles on which a path’s points lie, as far as their angles are searched, [LTQPSO] (13).",
    &GUIDES_LOOK,
);
/// Each member's personal best.
pub const PERSONAL_BESTS: Layer =
    layer("personal-bests", "Personal bests", "The best that each particle has found.", &PERSONAL_BESTS_LOOK).off();
/// A swarm's members: points, or the paths they stand for.
pub const PARTICLES: Layer =
    layer("particles", "Particles", "Where the particles are: points, or the paths they stand for.", &PARTICLES_LOOK)
        .weighted(Weight::Rank)
        .pickable();
/// Each member's local attractor, [LTQPSO](crate#papers) (7).
pub const ATTRACTORS: Layer =
    layer("attractors", "Attractors", "Each particle’s local attractor p: between its own best and the swarm’s.", &ATTRACTORS_LOOK).off();
/// Each member's velocity, from its position to where the velocity alone would take it.
pub const VELOCITIES: Layer = layer("velocities", "Velocities", "The particles’ velocities, to scale.", &VELOCITIES_LOOK).off();
/// Members whose position natural selection replaced in this iteration, [LTQPSO](crate#papers) §2.2.
pub const SELECTED: Layer =
    layer("selected", "Replaced", "Particles that natural selection put where a better one was.", &SELECTED_LOOK).off();
/// Members that the hen equation moved in this iteration, [WCPSO](crate#papers) (9).
pub const HENS: Layer = layer("hen", "Hens", "Particles that the hen equation moved in this iteration.", &HENS_LOOK);
/// Members that the chick equation moved in this iteration, [WCPSO](crate#papers) (12).
pub const CHICKS: Layer = layer("chick", "Chicks", "Particles that the chick equation moved in this iteration.", &CHICKS_LOOK);
/// The mean of all personal bests, [LTQPSO](crate#papers) (8).
pub const MEAN_BEST: Layer = layer(
    "mean-best",
    "Mean best",
    "The mean m of all personal bests: the farther a particle is from it, the wider it leaps.",
    &MEAN_BEST_LOOK,
)
.off();

// Ants.

const PHEROMONE_RAMP: Ramp = ramp(["pheromone-low", "pheromone", "pheromone-high"], true);
const PHEROMONE_LOOK: Look = Look { ramp: Some(&PHEROMONE_RAMP), ..look("pheromone-high", 1.0, 2) };
const TRAILS_LOOK: Look = Look { opacity: [0.0, 0.55], swell: 3.0, near: true, ..look("trail", 0.5, 4) };
const ANTS_LOOK: Look = Look { point: 5.0, opacity: [0.14, 0.6], ..look("ant", 1.0, 18) };
/// The pheromone on each cell's strongest edge: what differs from where no ant has been.
pub const PHEROMONE: Layer =
    layer("pheromone", "Pheromone", "How much more lies on each cell’s strongest step than where no ant has been.", &PHEROMONE_LOOK)
        .weighted(Weight::Pheromone)
        .pickable();
/// The pheromone on each directed edge.
pub const TRAILS: Layer =
    layer("trails", "Trails", "How much more lies on each step than where no ant has been; seen from near.", &TRAILS_LOOK)
        .weighted(Weight::Share);
/// The paths of the iteration's ants, one line each.
pub const ANTS: Layer = layer("ants", "Ants", "The ways of this iteration’s ants.", &ANTS_LOOK).weighted(Weight::Arrived).pickable();

// Searches on cells.

const CLOSED_RAMP: Ramp = ramp(["closed-low", "closed", "closed-high"], false);
const CLOSED_LOOK: Look = Look { ramp: Some(&CLOSED_RAMP), ..look("closed-high", 1.0, 1) };
const FRONTIER_LOOK: Look = Look { point: 4.0, opacity: [0.9, 0.9], shape: Some(Shape::Points), ..look("frontier", 1.0, 16) };
/// Expanded cells, the closed list, by their distance from the start.
pub const CLOSED: Layer = layer(
    "closed",
    "Settled",
    "Cells that are settled, the farther from the start the darker: no shorter way to them is looked for.",
    &CLOSED_LOOK,
)
.weighted(Weight::Length)
.pickable();
/// Cells on the open list.
pub const FRONTIER: Layer =
    layer("frontier", "Frontier", "Cells that are reached and not settled: the next one is among them.", &FRONTIER_LOOK)
        .weighted(Weight::Length);

// Tours.

const ROADS_LOOK: Look = Look { opacity: [0.55, 0.55], ..look("road", 1.5, 12) };
const TOURS_LOOK: Look = Look { opacity: [0.22, 0.22], ..look("particle", 1.0, 19) };
const STOPS_LOOK: Look = Look { point: 9.0, glyph: Glyph::Number, shape: Some(Shape::Points), ..look("stop", 2.0, 45) };
/// The pairwise paths between stops, one line each.
pub const ROADS: Layer =
    layer("roads", "Roads", "The paths between pairs of stops that are built so far.", &ROADS_LOOK).weighted(Weight::Length).pickable();
/// The tours of all members, one line each.
pub const TOURS: Layer = layer("tours", "All tours", "The tours of those that search side by side.", &TOURS_LOOK).weighted(Weight::Length);
/// The stops, in their order in the scene.
pub const STOPS: Layer =
    layer("stops", "Stops", "The stops, numbered in the shortest tour’s order.", &STOPS_LOOK).weighted(Weight::Place).pickable();

// Trees.

const TREE_LOOK: Look = Look { opacity: [0.7, 0.7], ..look("tree", 1.0, 14) };
const GOAL_TREE_LOOK: Look = Look { opacity: [0.8, 0.8], dash: &[5.0, 2.0], ..look("goal-tree", 1.0, 15) };
const NODES_LOOK: Look = Look { point: 4.0, opacity: [0.75, 0.75], shape: Some(Shape::Points), ..look("tree", 1.0, 17) };
const SAMPLES_LOOK: Look = Look { point: 5.0, opacity: [0.85, 0.85], shape: Some(Shape::Points), ..look("sample", 1.0, 37) };
const KEPT_LOOK: Look = Look { point: 8.0, glyph: Glyph::Ring, shape: Some(Shape::Points), ..look("kept", 1.5, 38) };
const CHOSEN_LOOK: Look = Look { point: 11.0, glyph: Glyph::Diamond, shape: Some(Shape::Points), ..look("chosen", 2.0, 39) };
/// A tree's edges, from each node's parent to the node. The first node has none.
pub const TREE: Layer = layer("tree", "Tree", "Each node is joined to its parent.", &TREE_LOOK).weighted(Weight::Length);
/// The edges of the tree that grows from the goal.
pub const GOAL_TREE: Layer =
    layer("goal-tree", "Goal’s tree", "The tree that grows from the goal.", &GOAL_TREE_LOOK).weighted(Weight::Length);
/// A tree's nodes, in their order; of two trees, the start's and then the goal's.
pub const NODES: Layer = layer("nodes", "Nodes", "Select one to see how it came about.", &NODES_LOOK).weighted(Weight::Length).pickable();
/// The samples that were drawn, [ARM-RRT](crate#papers) §3.2.1.
pub const SAMPLES: Layer =
    layer("samples", "Samples", "The random points of the last extension. Select one to see what became of it.", &SAMPLES_LOOK).pickable();
/// The samples that were kept as candidates.
pub const KEPT: Layer =
    layer("kept", "Kept", "Those of them whose directions are nearest to the goal’s.", &KEPT_LOOK).weighted(Weight::Share);
/// The sample that the extension used.
pub const CHOSEN: Layer = layer("chosen", "Chosen", "The sample that was taken.", &CHOSEN_LOOK).inspection();

// Drives.

const PREDICTED_LOOK: Look = Look { fill: Some(Color::named("predicted")), glyph: Glyph::Band, ..look("predicted-edge", 1.25, 7) };
const SENSOR_LOOK: Look = Look { opacity: [0.7, 0.7], dash: &[3.0, 6.0], glyph: Glyph::Reach, ..look("robot", 1.25, 8) };
const AHEAD_LOOK: Look = Look { dash: &[1.0, 5.0], lifted: true, ..look("robot", 2.0, 42) };
const TRACK_LOOK: Look = Look { lifted: true, ..look("robot", 2.5, 43) };
const MOVING_LOOK: Look = Look { fill: Some(Color::named("moving-soft")), point: 9.0, glyph: Glyph::Disc, ..look("moving", 2.0, 44) };
const LOCAL_GOAL_LOOK: Look =
    Look { point: 13.0, glyph: Glyph::Diamond, shape: Some(Shape::Points), lifted: true, ..look("robot", 2.0, 46) };
const EVENTS_LOOK: Look = Look { fill: Some(Color::named("best")), point: 13.0, glyph: Glyph::Event, ..look("ink", 1.5, 47) };
const ROBOT_LOOK: Look = Look { fill: Some(Color::named("robot-soft")), point: 9.0, glyph: Glyph::Robot, ..look("robot", 2.25, 48) };
/// The predicted regions of detected obstacles, inflated by the robot and its safety margin: one tube each.
pub const PREDICTED: Layer = layer(
    "predicted",
    "Predicted",
    "Where the robot expects the obstacles that it sees as far as it looks ahead, grown by itself and its margin: its centre must stay out while they are there.",
    &PREDICTED_LOOK,
)
.weighted(Weight::HalfWidth);
/// The robot's sensor range: a tube of one vertex.
pub const SENSOR: Layer =
    layer("sensor", "Sensor", "How far the robot sees the rims of obstacles.", &SENSOR_LOOK).weighted(Weight::HalfWidth);
/// The path that the robot is going to take.
pub const AHEAD: Layer = layer("ahead", "Ahead", "The way that it means to go.", &AHEAD_LOOK);
/// The path that the robot has taken.
pub const TRACK: Layer = layer("track", "Track", "The way that the robot has gone.", &TRACK_LOOK).weighted(Weight::Time);
/// The local goal, where a detour returns to the planned path.
pub const LOCAL_GOAL: Layer = layer("local-goal", "Local goal", "Where a detour comes back to the planned way.", &LOCAL_GOAL_LOOK);
/// The positions of events, one point each.
pub const EVENTS: Layer =
    layer("events", "Events", "Where something happened or was decided.", &EVENTS_LOOK).weighted(Weight::Time).pickable();
/// The present positions of moving obstacles: tubes of one vertex, as wide as the obstacles.
pub const MOVING: Layer = layer("moving", "Moving obstacles", "Where they are now.", &MOVING_LOOK).weighted(Weight::HalfWidth).pickable();
/// The robot: a tube of one vertex, and a segment from its centre to its front.
pub const ROBOT: Layer = layer("robot", "Robot", "The robot, and where it is headed.", &ROBOT_LOOK).weighted(Weight::HalfWidth);

// Explanations.

const CANDIDATES_LOOK: Look = Look { opacity: [0.8, 0.8], ..look("ant", 1.75, 49) };
const BEFORE_LOOK: Look = Look { point: 6.0, opacity: [0.7, 0.7], dash: &[3.0, 3.0], ..look("ink", 1.5, 50) };
const AFTER_LOOK: Look = Look { point: 7.0, ..look("ink", 2.0, 51) };
const WAY_LOOK: Look = Look { point: 7.0, ..look("attractor", 2.0, 50) };
const TO_GOAL_LOOK: Look = Look { dash: &[4.0, 3.0], ..look("mean", 1.75, 50) };
const STEP_LOOK: Look = look("selected", 2.75, 52);
const INERTIA_LOOK: Look = look("inertia", 2.0, 52);
const COGNITIVE_LOOK: Look = look("cognitive", 2.0, 53);
const SOCIAL_LOOK: Look = look("social", 2.0, 54);
const VELOCITY_LOOK: Look = Look { dash: &[5.0, 3.0], ..look("ink", 1.5, 55) };
const JUMP_LOOK: Look = look("hen", 2.25, 56);
const SUPPOSED_LOOK: Look = Look { point: 8.0, dash: &[2.0, 3.0], ..look("different", 2.25, 58) };
const DIFFERENT_LOOK: Look = Look { point: 27.0, glyph: Glyph::Ring, shape: Some(Shape::Points), ..look("different", 2.0, 57) };
/// The edges to choose from.
pub const CANDIDATES: Layer = layer("candidates", "Candidates", "The steps to choose from.", &CANDIDATES_LOOK).inspection();
/// The item's position before the step.
pub const BEFORE: Layer = layer("before", "Before", "Where it was.", &BEFORE_LOOK).inspection();
/// The item's position after the step.
pub const AFTER: Layer = layer("after", "After", "Where it is.", &AFTER_LOOK).inspection();
/// The way that leads to the item, or that it has gone.
pub const WAY: Layer = layer("way", "Way", "The way that leads there.", &WAY_LOOK).inspection();
/// What is still ahead: to the goal, as if nothing were in the way.
pub const TO_GOAL: Layer =
    layer("to-goal", "To the goal", "What is still ahead, as if nothing were in the way.", &TO_GOAL_LOOK).inspection();
/// One step: the likeliest, or the last one of a way.
pub const STEP: Layer = layer("step", "Step", "One step of the way.", &STEP_LOOK).inspection();
/// The inertia term: what is left of the old velocity.
pub const INERTIA: Layer = layer("inertia", "Inertia", "What is left of its old velocity.", &INERTIA_LOOK).inspection();
/// The cognitive term: the pull toward the personal best.
pub const COGNITIVE: Layer = layer("cognitive", "Cognitive", "The pull toward its personal best.", &COGNITIVE_LOOK).inspection();
/// The social term: the pull toward the global best.
pub const SOCIAL: Layer = layer("social", "Social", "The pull toward the global best.", &SOCIAL_LOOK).inspection();
/// The new velocity, as it was applied.
pub const VELOCITY: Layer = layer("velocity", "Velocity", "The velocity that was carried out.", &VELOCITY_LOOK).inspection();
/// A jump that a perturbation made.
pub const JUMP: Layer = layer("jump", "Jump", "The jump that it made.", &JUMP_LOOK).inspection();
/// What the item would have done.
pub const SUPPOSED: Layer = layer("supposed", "Supposed", "Where it would have gone.", &SUPPOSED_LOOK).inspection();
/// Where a tour differs from the best one.
pub const DIFFERENT: Layer = layer("different", "Different", "Where it differs from the best.", &DIFFERENT_LOOK).inspection();

// Of the scene.

const EXACT_LOOK: Look = Look { point: 4.0, dash: &[2.0, 5.0], ..look("exact", 1.75, 35) };
const PRINTED_LOOK: Look = Look { point: 4.0, dash: &[10.0, 5.0], ..look("printed", 2.25, 36) };
const ARM_LOOK: Look = Look { point: 9.0, ..look("robot", 4.0, 48) };
/// The exact optimum.
pub const EXACT: Layer = layer("exact", "Exact optimum", "The exact optimum by the planner’s rule.", &EXACT_LOOK);
/// The path that a paper prints.
pub const PRINTED: Layer = layer("printed", "Printed", "The path that the paper prints.", &PRINTED_LOOK).off();
/// The robot arm.
pub const ARM: Layer = layer("arm", "Arm", "At home, or following the path.", &ARM_LOOK);

/// Those whose looks suit planners of any kind: a planner that brings a layer of such a name has its look.
pub const COMMON: &[Layer] =
    &[PARTICLES, PERSONAL_BESTS, VELOCITIES, BEST, TOUR, ATTRACTORS, MEAN_BEST, ANTS, FRONTIER, TREE, NODES, TOURS, STOPS];
/// The layers that a page draws of a scene itself, whatever the planner draws.
pub const SCENE: &[Layer] = &[EXACT, PRINTED, MOVING, ARM];
