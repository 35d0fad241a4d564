//! What a planner looks like now: layers of vertices in one buffer, and a table that says what is what.

use serde::Serialize;

use crate::geometry::Bounds;

/// What a layer shows. The page has a style for each role and knows no planner by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[repr(u32)]
pub enum Role {
    /// A swarm's members: points, or the paths they stand for.
    Particles,
    /// Each member's velocity: from where it is to where it alone would take it.
    Velocities,
    /// The best that each member has found.
    PersonalBests,
    /// The best that the planner has found: its result.
    Best,
    /// Members that the hen equation moved in this iteration, [WCPSO] (9).
    Hen,
    /// Members that the chick equation moved in this iteration, [WCPSO] (12).
    Chick,
    /// Curves on which the planner places points: the circles of a polar path, [LTQPSO] (13).
    Guides,
    /// Members whose position natural selection replaced in this iteration, [LTQPSO] §2.2.
    Selected,
    /// Each member's local attractor, [LTQPSO] (7).
    Attractors,
    /// The mean of all personal bests, [LTQPSO] (8).
    MeanBest,
    /// How much pheromone lies on each cell's strongest way out.
    Pheromone,
    /// How much pheromone lies on each step from cell to cell.
    Trails,
    /// The ways that an iteration's ants went, one line each.
    Ants,
    /// Cells that a search has settled, by their distance from the start.
    Closed,
    /// Cells that a search has reached and not settled.
    Frontier,
    /// The ways between stops, one line each; the weight is the length.
    Roads,
    /// The tours of those that search side by side, one line each.
    Tours,
    /// The best tour so far, in its direction: the result.
    Tour,
    /// The stops, in their order in the scene; the weight is the place in the best tour, from 0, or −1.
    Stops,
    /// Obstacles that move, where they are now: tubes of one vertex, as wide as they are.
    Moving,
    /// Where a robot expects the obstacles that it sees to come, grown by itself and its margin: one tube each.
    Predicted,
    /// How far a robot sees: a tube of one vertex.
    Sensor,
    /// The robot: a tube of one vertex, and a segment from its centre to its front.
    Robot,
    /// The way that a robot has gone.
    Track,
    /// The way that a robot means to go.
    Ahead,
    /// Where a detour comes back to the planned way.
    LocalGoal,
    /// Where something happened or was decided, one point each.
    Events,
    /// A tree's edges, from each node's parent to the node; the weight is the node's cost. The first node has none.
    Tree,
    /// The edges of the tree that grows from the goal.
    GoalTree,
    /// A tree's nodes, in their order; of two trees, the start's and then the goal's.
    Nodes,
    /// In an inspection: the samples that were drawn, [ARM-RRT] §3.2.1.
    Samples,
    /// In an inspection: those that were kept.
    Kept,
    /// In an inspection: the one that was taken.
    Chosen,
    /// The result after smoothing.
    Smoothed,
    /// The exact optimum.
    Exact,
    /// In an inspection: what is left of the old velocity.
    Inertia,
    /// In an inspection: the pull of the personal best.
    Cognitive,
    /// In an inspection: the pull of the global best.
    Social,
    /// In an inspection: the sum, as it was carried out.
    Velocity,
    /// In an inspection: a jump that a perturbation made.
    Jump,
    /// In an inspection: the steps to choose from.
    Candidates,
    /// In an inspection: what is not as in the best.
    Different,
    /// In an inspection: where the item was.
    Before,
    /// In an inspection: where the item is.
    After,
}

impl Role {
    /// Every role, in the order of their numbers.
    pub const ALL: [Self; 44] = [
        Self::Particles,
        Self::Velocities,
        Self::PersonalBests,
        Self::Best,
        Self::Hen,
        Self::Chick,
        Self::Guides,
        Self::Selected,
        Self::Attractors,
        Self::MeanBest,
        Self::Pheromone,
        Self::Trails,
        Self::Ants,
        Self::Closed,
        Self::Frontier,
        Self::Roads,
        Self::Tours,
        Self::Tour,
        Self::Stops,
        Self::Moving,
        Self::Predicted,
        Self::Sensor,
        Self::Robot,
        Self::Track,
        Self::Ahead,
        Self::LocalGoal,
        Self::Events,
        Self::Tree,
        Self::GoalTree,
        Self::Nodes,
        Self::Samples,
        Self::Kept,
        Self::Chosen,
        Self::Smoothed,
        Self::Exact,
        Self::Inertia,
        Self::Cognitive,
        Self::Social,
        Self::Velocity,
        Self::Jump,
        Self::Candidates,
        Self::Different,
        Self::Before,
        Self::After,
    ];

    /// The name that the page and the pictures use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Particles => "particles",
            Self::Velocities => "velocities",
            Self::PersonalBests => "personal-bests",
            Self::Best => "best",
            Self::Hen => "hen",
            Self::Chick => "chick",
            Self::Guides => "guides",
            Self::Selected => "selected",
            Self::Attractors => "attractors",
            Self::MeanBest => "mean-best",
            Self::Pheromone => "pheromone",
            Self::Trails => "trails",
            Self::Ants => "ants",
            Self::Closed => "closed",
            Self::Frontier => "frontier",
            Self::Roads => "roads",
            Self::Tours => "tours",
            Self::Tour => "tour",
            Self::Stops => "stops",
            Self::Moving => "moving",
            Self::Predicted => "predicted",
            Self::Sensor => "sensor",
            Self::Robot => "robot",
            Self::Track => "track",
            Self::Ahead => "ahead",
            Self::LocalGoal => "local-goal",
            Self::Events => "events",
            Self::Tree => "tree",
            Self::GoalTree => "goal-tree",
            Self::Nodes => "nodes",
            Self::Samples => "samples",
            Self::Kept => "kept",
            Self::Chosen => "chosen",
            Self::Smoothed => "smoothed",
            Self::Exact => "exact",
            Self::Inertia => "inertia",
            Self::Cognitive => "cognitive",
            Self::Social => "social",
            Self::Velocity => "velocity",
            Self::Jump => "jump",
            Self::Candidates => "candidates",
            Self::Different => "different",
            Self::Before => "before",
            Self::After => "after",
        }
    }
}

/// How a span's vertices belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[repr(u32)]
pub enum Shape {
    /// Each vertex is a point of its own.
    Points,
    /// The vertices form one line.
    Polyline,
    /// Vertices in pairs, a line each.
    Segments,
    /// A grid of values, row by row along x and then y; z of the first vertex is the row's length. A vertex is the middle of
    /// its square, whose side is the distance of neighbours. A weight below 0 is nothing to draw.
    Field,
    /// The vertices form one line with round ends, whose weight is half its width, in the scene's unit. One vertex: a disc.
    Tube,
}

impl Shape {
    /// Every shape, in the order of their numbers.
    pub const ALL: [Self; 5] = [Self::Points, Self::Polyline, Self::Segments, Self::Field, Self::Tube];

    /// The name that the page uses.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Polyline => "polyline",
            Self::Segments => "segments",
            Self::Field => "field",
            Self::Tube => "tube",
        }
    }
}

/// One entry of the table: `count` vertices from `first` on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span {
    /// What they show.
    pub role: Role,
    /// How they belong together.
    pub shape: Shape,
    /// The first vertex.
    pub first: u32,
    /// How many vertices.
    pub count: u32,
}

/// Layers of a moment. The buffers are re-used from frame to frame.
#[derive(Debug, Clone)]
pub struct Frame {
    vertices: Vec<f32>,
    /// The table as it crosses to the page: role, shape, first, count.
    table: Vec<u32>,
    budget: usize,
    thinning: u32,
    /// The part of the plane that is looked at; `None`: all of it.
    window: Option<Bounds>,
}

/// Numbers per vertex: x, y, z, weight.
pub const VERTEX: usize = 4;
/// Numbers per span.
pub const SPAN: usize = 4;

impl Default for Frame {
    fn default() -> Self {
        Self { vertices: Vec::new(), table: Vec::new(), budget: Self::BUDGET, thinning: 1, window: None }
    }
}

impl Frame {
    /// How many vertices a layer draws unless told otherwise: what a canvas draws in a few tens of milliseconds.
    pub const BUDGET: usize = 100_000;

    /// Empties the frame; layers drawn next keep to `budget` vertices each.
    pub fn clear(&mut self, budget: usize) {
        self.vertices.clear();
        self.table.clear();
        self.budget = budget.max(1);
        self.thinning = 1;
    }

    /// Layers that are only worth drawing from near are drawn for this part of the plane.
    pub fn look_at(&mut self, window: Option<Bounds>) {
        self.window = window;
    }

    /// The part of the plane that is looked at; `None`: all of it.
    pub fn window(&self) -> Option<Bounds> {
        self.window
    }

    /// How many vertices a layer may have.
    pub fn budget(&self) -> usize {
        self.budget
    }

    /// Which pieces to draw of `pieces` with `vertices` vertices each, so that the budget holds: every n-th.
    /// A line's vertex counts four times: that is about what drawing it costs.
    pub fn thin(&mut self, pieces: usize, vertices: usize, lines: bool) -> usize {
        let step = self.thin_context(pieces, vertices, lines);
        self.thinning = self.thinning.max(step as u32);
        step
    }

    /// The same for a layer that is only context (off unless asked for): it does not count as thinning of the picture.
    pub fn thin_context(&self, pieces: usize, vertices: usize, lines: bool) -> usize {
        let cost = pieces.saturating_mul(vertices).saturating_mul(if lines { 4 } else { 1 });
        cost.div_ceil(self.budget).max(1)
    }

    /// Opens a span; vertices pushed from here on belong to it.
    pub fn begin(&mut self, role: Role, shape: Shape) {
        self.table.extend([role as u32, shape as u32, (self.vertices.len() / VERTEX) as u32, 0]);
    }

    /// Adds a vertex of a field's row of this length to the open span.
    #[inline]
    pub fn push_field(&mut self, [x, y]: [f64; 2], row: usize, weight: f64) {
        self.push([x, y], weight);
        let at = self.vertices.len() - 2;
        self.vertices[at] = row as f32;
    }

    /// Adds a vertex in the plane to the open span.
    #[inline]
    pub fn push(&mut self, [x, y]: [f64; 2], weight: f64) {
        self.push_in_space([x, y, 0.0], weight);
    }

    /// Adds a vertex in space to the open span.
    #[inline]
    pub fn push_in_space(&mut self, [x, y, z]: [f64; 3], weight: f64) {
        self.vertices.extend([x as f32, y as f32, z as f32, weight as f32]);
        if let Some(count) = self.table.last_mut() {
            *count += 1;
        }
    }

    /// x, y, z, weight of all vertices.
    pub fn vertices(&self) -> &[f32] {
        &self.vertices
    }

    /// role, shape, first, count of all spans.
    pub fn table(&self) -> &[u32] {
        &self.table
    }

    /// Every how many-th piece of the main layers was drawn (1: all).
    pub fn thinning(&self) -> u32 {
        self.thinning
    }

    /// The spans, in drawing order.
    pub fn spans(&self) -> impl Iterator<Item = Span> + '_ {
        self.table.chunks_exact(SPAN).map(|row| Span {
            role: Role::ALL[row[0] as usize],
            shape: Shape::ALL[row[1] as usize],
            first: row[2],
            count: row[3],
        })
    }

    /// The vertices of a span as points in the plane.
    pub fn points(&self, span: Span) -> impl Iterator<Item = [f64; 2]> + '_ {
        let from = span.first as usize * VERTEX;
        let to = from + span.count as usize * VERTEX;
        self.vertices[from..to].chunks_exact(VERTEX).map(|v| [f64::from(v[0]), f64::from(v[1])])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn role_and_shape_numbers_index_their_lists() {
        for (i, role) in Role::ALL.into_iter().enumerate() {
            assert_eq!(role as usize, i);
        }
        for (i, shape) in Shape::ALL.into_iter().enumerate() {
            assert_eq!(shape as usize, i);
        }
    }

    #[test]
    fn thinning_keeps_to_the_budget() {
        let mut frame = Frame::default();
        frame.clear(1000);
        assert_eq!(frame.thin(1000, 1, false), 1);
        assert_eq!(frame.thin(1001, 1, false), 2);
        assert_eq!(frame.thin(1000, 5, true), 20);
        assert_eq!(frame.thinning(), 20);
    }
}
