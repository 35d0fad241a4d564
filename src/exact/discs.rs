//! The exact shortest path among discs: Dijkstra on the tangent graph.
//!
//! A shortest path is made of straight pieces that touch two discs each (or end in start or goal) and of arcs along
//! rims between them. So the graph's nodes are the points where a free common tangent touches a rim, and its edges
//! are those tangents and the free arcs between neighbours on a rim. Discs may overlap: what lies inside another
//! disc is cut out of the rim. The corner between two overlapping discs is never on a shortest path (it is concave).

use std::{cmp::Reverse, collections::BinaryHeap, f64::consts::TAU};

use crate::{
    geometry::{Disc, Vector, arc_outline, vector},
    kernel::Exact,
    math::{self, Length},
};

/// How deep, relative to the scene's size, a tangent may seem to cut a third disc before it counts as blocked:
/// tangents that touch three discs are common in drawn scenes and must not be lost to rounding.
const SLACK: f64 = 1e-11;

/// The shortest path from `start` to `goal` that crosses the inside of no disc; `None` if the discs enclose one of them. The
/// plane has no border. O(n³) at worst for n discs, far less if most tangents are blocked early.
pub fn shortest_among_discs(start: [f64; 2], goal: [f64; 2], discs: &[Disc]) -> Option<Exact> {
    let mut graph = Graph::new(start, goal, discs);
    graph.tangents();
    graph.arcs();
    graph.dijkstra()
}

/// Where a node is: an end of the path, or a point on a disc's rim.
#[derive(Clone, Copy)]
struct Node {
    at: Vector,
    /// The disc and the angle on its rim.
    rim: Option<(usize, f64)>,
}

#[derive(Clone, Copy)]
struct Edge {
    to: usize,
    length: f64,
    /// For an arc: disc, angle it begins at and how far it turns.
    arc: Option<(usize, f64, f64)>,
}

struct Graph<'a> {
    discs: &'a [Disc],
    slack: f64,
    nodes: Vec<Node>,
    edges: Vec<Vec<Edge>>,
}

const START: usize = 0;
const GOAL: usize = 1;

impl<'a> Graph<'a> {
    fn new(start: [f64; 2], goal: [f64; 2], discs: &'a [Disc]) -> Self {
        let size = discs
            .iter()
            .map(|d| d.center[0].abs().max(d.center[1].abs()) + d.radius)
            .chain([start, goal].iter().map(|p| p[0].abs().max(p[1].abs())))
            .fold(0.0, f64::max);
        let ends = [start, goal].map(|p| Node { at: vector(p), rim: None });
        Self { discs, slack: SLACK * size, nodes: ends.to_vec(), edges: vec![Vec::new(); 2] }
    }

    /// All free tangents: between the ends, from an end to a disc, and the four between two discs.
    fn tangents(&mut self) {
        self.connect(START, GOAL, &[]);
        let discs = self.discs;
        for (i, &disc) in discs.iter().enumerate() {
            for end in [START, GOAL] {
                let (from, to) = (self.nodes[end].at, vector(disc.center));
                for side in [1.0, -1.0] {
                    // An end on the rim touches at itself: the square root is clamped, and the length is zero.
                    if let Some(normal) = normal_of_tangent(to - from, side * disc.radius, self.slack) {
                        let foot = self.on_rim(i, -side * normal);
                        self.connect(end, foot, &[i]);
                    }
                }
            }
            for (j, &other) in (i + 1..).zip(&discs[i + 1..]) {
                let between = vector(other.center) - vector(disc.center);
                for side in [1.0, -1.0] {
                    // Outer tangents keep both discs on one side, inner ones cross over between them.
                    for cross in [1.0, -1.0] {
                        let offset = side * (cross * other.radius - disc.radius);
                        if let Some(normal) = normal_of_tangent(between, offset, self.slack) {
                            let (a, b) = (self.on_rim(i, -side * normal), self.on_rim(j, -side * cross * normal));
                            self.connect(a, b, &[i, j]);
                        }
                    }
                }
            }
        }
    }

    /// A new node on the rim of disc `i` in the direction `outward` (unit length).
    #[inline(never)]
    fn on_rim(&mut self, i: usize, outward: Vector) -> usize {
        let disc = &self.discs[i];
        self.nodes.push(Node { at: vector(disc.center) + disc.radius * outward, rim: Some((i, math::atan2(outward.y, outward.x))) });
        self.edges.push(Vec::new());
        self.nodes.len() - 1
    }

    /// Joins two nodes if the straight way crosses no disc other than those it touches by construction.
    fn connect(&mut self, a: usize, b: usize, touching: &[usize]) {
        let (from, to) = (self.nodes[a].at, self.nodes[b].at);
        let (p, q) = ([from.x, from.y], [to.x, to.y]);
        let free = self.discs.iter().enumerate().all(|(k, disc)| touching.contains(&k) || disc.clearance_of_segment(p, q) >= -self.slack);
        if free {
            let length = (to - from).norm();
            self.edges[a].push(Edge { to: b, length, arc: None });
            self.edges[b].push(Edge { to: a, length, arc: None });
        }
    }

    /// Arcs between neighbouring nodes of each rim, where no other disc covers them.
    fn arcs(&mut self) {
        let discs = self.discs;
        for (i, disc) in discs.iter().enumerate() {
            let mut around: Vec<(f64, usize)> = self
                .nodes
                .iter()
                .enumerate()
                .filter(|&(node, _)| !self.edges[node].is_empty())
                .filter_map(|(node, n)| n.rim.filter(|rim| rim.0 == i).map(|rim| (rim.1, node)))
                .collect();
            if around.len() < 2 {
                continue;
            }
            math::sort(&mut around);
            let covered = self.covered(i);
            for (k, &(from, a)) in around.iter().enumerate() {
                let (to, b) = around[(k + 1) % around.len()];
                let sweep = if k + 1 == around.len() { to + TAU - from } else { to - from };
                if covered.iter().all(|&(middle, half)| !overlaps(from, sweep, middle, half, self.slack / disc.radius)) {
                    let length = disc.radius * sweep;
                    self.edges[a].push(Edge { to: b, length, arc: Some((i, from, sweep)) });
                    self.edges[b].push(Edge { to: a, length, arc: Some((i, to, -sweep)) });
                }
            }
        }
    }

    /// The parts of disc `i`'s rim inside other discs: middle angle and half width of each.
    #[inline(never)]
    fn covered(&self, i: usize) -> Vec<(f64, f64)> {
        let disc = &self.discs[i];
        let covers = |(k, other): (usize, &Disc)| {
            let between = vector(other.center) - vector(disc.center);
            let distance = between.norm();
            if k == i || distance >= disc.radius + other.radius - self.slack || distance + other.radius <= disc.radius + self.slack {
                return None; // itself, apart, or inside: covers nothing of this rim
            }
            if distance + disc.radius <= other.radius {
                return Some((0.0, TAU)); // this disc is inside the other
            }
            let cosine = (distance * distance + disc.radius * disc.radius - other.radius * other.radius) / (2.0 * distance * disc.radius);
            Some((math::atan2(between.y, between.x), math::acos(cosine.clamp(-1.0, 1.0))))
        };
        self.discs.iter().enumerate().filter_map(covers).collect()
    }

    fn dijkstra(&self) -> Option<Exact> {
        let mut best = vec![f64::INFINITY; self.nodes.len()];
        let mut via: Vec<Option<(usize, Edge)>> = vec![None; self.nodes.len()];
        let mut open = BinaryHeap::from([Reverse((Length(0.0), START))]);
        best[START] = 0.0;
        while let Some(Reverse((Length(length), node))) = open.pop() {
            if node == GOAL {
                return Some(Exact::way(length, self.outline(&via)));
            }
            if length > best[node] {
                continue;
            }
            for &edge in &self.edges[node] {
                let reached = length + edge.length;
                if reached < best[edge.to] {
                    best[edge.to] = reached;
                    via[edge.to] = Some((node, edge));
                    open.push(Reverse((Length(reached), edge.to)));
                }
            }
        }
        None
    }

    fn outline(&self, via: &[Option<(usize, Edge)>]) -> Vec<[f64; 2]> {
        let mut steps = Vec::new();
        let mut node = GOAL;
        while let Some((from, edge)) = via[node] {
            steps.push(edge);
            node = from;
        }
        let mut path = vec![self.nodes[START].at.into()];
        for edge in steps.into_iter().rev() {
            match edge.arc {
                Some((disc, from, sweep)) if sweep != 0.0 => arc_outline(&self.discs[disc], from, sweep, &mut path),
                _ => path.push(self.nodes[edge.to].at.into()),
            }
        }
        path.dedup();
        path
    }
}

/// The unit normal n of a line that passes the origin at distance 0 and the point `to` at signed distance `offset`:
/// n · to = offset, with `to` ahead. `None` if `to` is nearer than `offset`.
#[inline(never)]
fn normal_of_tangent(to: Vector, offset: f64, slack: f64) -> Option<Vector> {
    let distance = to.norm();
    if distance <= 0.0 || offset.abs() > distance + slack {
        return None;
    }
    let along = to / distance;
    let sine = (offset / distance).clamp(-1.0, 1.0);
    let cosine = (1.0 - sine * sine).sqrt();
    Some(Vector::new(-along.y, along.x) * cosine + along * sine)
}

/// Whether the arc from angle `from` over `sweep` (positive) shares more than `slack` with the arc around `middle`.
#[inline(never)]
fn overlaps(from: f64, sweep: f64, middle: f64, half: f64, slack: f64) -> bool {
    // Turn so that the arc begins at 0; the other then begins in [0, 2π) or reaches over from before.
    let begin = math::turn(middle - half - from);
    let end = begin + 2.0 * half;
    sweep.min(end) - begin > slack || sweep.min(end - TAU) > slack
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn disc(x: f64, y: f64, radius: f64) -> Disc {
        Disc { center: [x, y], radius }
    }

    fn shortest(start: [f64; 2], goal: [f64; 2], discs: &[Disc]) -> f64 {
        let exact = shortest_among_discs(start, goal, discs).expect("a way exists");
        let drawn = crate::geometry::length(&exact.path);
        assert!(drawn >= exact.length - 1e-9 && drawn < exact.length * 1.001, "{drawn} drawn, {} exact", exact.length);
        for d in discs {
            let clearance = exact.path.windows(2).map(|w| d.clearance_of_segment(w[0], w[1])).fold(f64::INFINITY, f64::min);
            assert!(clearance > -1e-9, "the drawn path cuts {d:?} by {clearance:e}");
        }
        exact.length
    }

    #[test]
    fn with_nothing_in_the_way_it_is_the_straight_line() {
        assert_eq!(shortest([0.0, 0.0], [3.0, 4.0], &[]), 5.0);
        assert_eq!(shortest([0.0, 0.0], [4.0, 0.0], &[disc(2.0, 1.0, 1.0)]), 4.0, "touching is free");
    }

    #[test]
    fn round_one_disc_it_is_two_tangents_and_an_arc() {
        // sin a = 1/2: tangents of length sqrt(3), the arc between them pi - 2 * (pi/2 - pi/6) = pi/3.
        let length = shortest([-2.0, 0.0], [2.0, 0.0], &[disc(0.0, 0.0, 1.0)]);
        assert!((length - (2.0 * 3f64.sqrt() + PI / 3.0)).abs() < 1e-12);
    }

    #[test]
    fn round_two_equal_discs_side_by_side_it_follows_the_outer_tangent() {
        // Discs touch, so there is no gap between them; by symmetry the outer tangent has length 2.
        let length = shortest([-3.0, 0.0], [3.0, 0.0], &[disc(-1.0, 0.0, 1.0), disc(1.0, 0.0, 1.0)]);
        assert!((length - (2.0 * 3f64.sqrt() + 2.0 + PI / 3.0)).abs() < 1e-12, "{length}");
    }

    #[test]
    fn overlapping_discs_leave_no_gap_and_inner_discs_do_not_matter() {
        let wall = [disc(0.0, 0.0, 1.0), disc(0.0, 1.5, 1.0), disc(0.0, -1.5, 1.0)];
        // Round the outer disc at (0, 1.5): from (-3, 1.5) tangents sqrt(8), arc pi - 2 acos(1/3).
        let over = shortest([-3.0, 1.5], [3.0, 1.5], &wall);
        let expected = 2.0 * 8f64.sqrt() + PI - 2.0 * libm::acos(1.0 / 3.0);
        assert!((over - expected).abs() < 1e-12, "{over} {expected}");
        let mut inner = wall.to_vec();
        inner.push(disc(0.1, 1.4, 0.3));
        inner.push(disc(0.0, 1.5, 1.0));
        assert!((shortest([-3.0, 1.5], [3.0, 1.5], &inner) - expected).abs() < 1e-9);
    }

    #[test]
    fn a_closed_ring_has_no_way_out() {
        let ring: Vec<Disc> = (0..12).map(|i| f64::from(i) * PI / 6.0).map(|a| disc(2.0 * libm::cos(a), 2.0 * libm::sin(a), 0.7)).collect();
        assert_eq!(shortest_among_discs([0.0, 0.0], [5.0, 0.0], &ring), None);
        assert!(shortest_among_discs([0.0, 0.0], [5.0, 0.0], &ring[1..]).is_some());
    }

    #[test]
    fn an_end_on_a_rim_can_follow_it() {
        let length = shortest([-1.0, 0.0], [1.0, 0.0], &[disc(0.0, 0.0, 1.0)]);
        assert!((length - PI).abs() < 1e-9, "{length}");
    }

    #[test]
    fn never_longer_than_a_fine_visibility_graph_and_never_shorter_by_more_than_its_error() {
        use crate::kernel::rng::Stream;
        for seed in 0..30 {
            let mut rng = Stream::new(seed, 0);
            let count = 3 + rng.below(5);
            let discs: Vec<Disc> = (0..count).map(|_| disc(rng.between(1.0, 9.0), rng.between(1.0, 9.0), rng.between(0.3, 2.0))).collect();
            let (start, goal) = ([0.0, 0.0], [10.0, 10.0]);
            if discs.iter().any(|d| d.clearance(start) < 0.0 || d.clearance(goal) < 0.0) {
                continue;
            }
            let Some(exact) = shortest_among_discs(start, goal, &discs) else {
                continue;
            };
            let graph = polygon_graph(start, goal, &discs);
            assert!(exact.length <= graph + 1e-9, "seed {seed}: {} against {graph}", exact.length);
            assert!(exact.length >= graph * 0.997, "seed {seed}: {} against {graph}", exact.length);
        }
    }

    /// An independent answer: visibility graph over 72-gons around the discs, by Floyd–Warshall-free dense Dijkstra.
    fn polygon_graph(start: [f64; 2], goal: [f64; 2], discs: &[Disc]) -> f64 {
        let mut nodes = vec![start, goal];
        for d in discs {
            let radius = d.radius / libm::cos(PI / 72.0) + 1e-9;
            nodes.extend(
                (0..72)
                    .map(|i| f64::from(i) * PI / 36.0)
                    .map(|a| [d.center[0] + radius * libm::cos(a), d.center[1] + radius * libm::sin(a)]),
            );
        }
        let mut best = vec![f64::INFINITY; nodes.len()];
        let mut done = vec![false; nodes.len()];
        best[0] = 0.0;
        loop {
            let Some(u) = (0..nodes.len()).filter(|&i| !done[i] && best[i].is_finite()).min_by(|&a, &b| best[a].total_cmp(&best[b])) else {
                return f64::INFINITY;
            };
            if u == 1 {
                return best[1];
            }
            done[u] = true;
            for v in 0..nodes.len() {
                if !done[v] && discs.iter().all(|d| d.clearance_of_segment(nodes[u], nodes[v]) >= 0.0) {
                    best[v] = best[v].min(best[u] + crate::geometry::length(&[nodes[u], nodes[v]]));
                }
            }
        }
    }
}
