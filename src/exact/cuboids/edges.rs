//! The edges on which a shortest path can bend, and from which to which it can go straight.

use crate::geometry::Cuboid;

/// One of the two faces that meet in an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// Before the face whose normal is the edge's first cross axis, behind the other face.
    First = 0,
    /// The other way round.
    Second = 1,
}

impl Side {
    pub(super) const BOTH: [Self; 2] = [Self::First, Self::Second];

    pub(super) fn other(self) -> Self {
        match self {
            Self::First => Self::Second,
            Self::Second => Self::First,
        }
    }
}

/// A part of a cuboid's edge that lies in the workspace and in no other cuboid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// The axis it runs along.
    pub(super) axis: usize,
    /// Where it is on the other two axes.
    pub(super) at: [f64; 3],
    /// Its extent along its axis.
    pub(super) from: f64,
    pub(super) to: f64,
    /// The outward directions on the other two axes, 1 or −1.
    outward: [f64; 3],
}

/// A straight piece from one edge to another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    /// The edge it goes to.
    pub(super) edge: usize,
    /// Beside which face of it the piece arrives.
    pub(super) enter: Side,
    /// The part of the edge it comes from that lies beside that face.
    pub(super) leave: [f64; 2],
    /// The part of the edge it goes to that lies beside the face at which it left.
    pub(super) arrive: [f64; 2],
}

impl Edge {
    /// The point at a coordinate along it.
    #[inline]
    pub(super) fn point(&self, along: f64) -> [f64; 3] {
        let mut point = self.at;
        point[self.axis] = along;
        point
    }

    /// What must hold beside a face: the axis, and whether coordinates on it are at least or at most the edge's.
    fn beside(&self, side: Side) -> [(usize, bool); 2] {
        let (first, second) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let (before, behind) = if side == Side::First { (first, second) } else { (second, first) };
        [(before, self.outward[before] > 0.0), (behind, self.outward[behind] < 0.0)]
    }

    /// Whether a path that bends here can come from or go to this point on this side: it must lie before one face and
    /// behind the other, else there is a shorter way past the edge.
    pub(super) fn has_beside(&self, side: Side, point: [f64; 3]) -> bool {
        self.beside(side).into_iter().all(|(axis, more)| if more { point[axis] >= self.at[axis] } else { point[axis] <= self.at[axis] })
    }

    /// The part of another edge on this side.
    fn part_beside(&self, side: Side, other: &Self) -> Option<[f64; 2]> {
        let mut range = [other.from, other.to];
        for (axis, more) in self.beside(side) {
            let line = self.at[axis];
            match (axis == other.axis, more) {
                (true, true) => range[0] = range[0].max(line),
                (true, false) => range[1] = range[1].min(line),
                (false, true) if other.at[axis] < line => return None,
                (false, false) if other.at[axis] > line => return None,
                (false, _) => {}
            }
        }
        (range[0] <= range[1]).then_some(range)
    }
}

/// Where a path can go on from an edge on one side of it; not all of it need be in sight.
pub(super) fn steps(edges: &[Edge], from: usize, out: Side) -> impl Iterator<Item = Step> {
    let here = &edges[from];
    edges.iter().enumerate().filter(move |(edge, _)| *edge != from).flat_map(move |(edge, there)| {
        Side::BOTH.into_iter().filter_map(move |enter| {
            let arrive = here.part_beside(out, there)?;
            let leave = there.part_beside(enter, here)?;
            Some(Step { edge, enter, leave, arrive })
        })
    })
}

/// All of them: each cuboid's twelve, without what lies outside the workspace or inside another cuboid.
pub(super) fn all(workspace: &Cuboid, cuboids: &[Cuboid]) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (i, cuboid) in cuboids.iter().enumerate() {
        for (axis, corner) in (0..3).flat_map(|axis| (0..4).map(move |corner| (axis, corner))) {
            let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
            let (mut at, mut outward) = ([0.0; 3], [0.0; 3]);
            for (axis, high) in [(first, corner & 1 != 0), (second, corner & 2 != 0)] {
                at[axis] = if high { cuboid.max[axis] } else { cuboid.min[axis] };
                outward[axis] = if high { 1.0 } else { -1.0 };
            }
            if [first, second].iter().any(|&axis| at[axis] < workspace.min[axis] || at[axis] > workspace.max[axis]) {
                continue;
            }
            let mut parts = vec![[cuboid.min[axis].max(workspace.min[axis]), cuboid.max[axis].min(workspace.max[axis])]];
            for other in
                cuboids.iter().enumerate().filter(|(k, other)| covers(other, [first, second], at, outward, *k < i)).map(|(_, other)| other)
            {
                parts =
                    parts.into_iter().flat_map(|[from, to]| [[from, to.min(other.min[axis])], [from.max(other.max[axis]), to]]).collect();
                parts.retain(|[from, to]| from < to);
            }
            edges.extend(parts.into_iter().filter(|[from, to]| from < to).map(|[from, to]| Edge { axis, at, from, to, outward }));
        }
    }
    edges
}

/// Whether another cuboid, where it is level with an edge, leaves nothing to bend round: the edge lies inside it or on its
/// surface, so that both together are flat there or hollow. Of two cuboids with the same edge, the `earlier` keeps it.
fn covers(other: &Cuboid, across: [usize; 2], at: [f64; 3], outward: [f64; 3], earlier: bool) -> bool {
    let within = across.iter().all(|&axis| other.min[axis] <= at[axis] && at[axis] <= other.max[axis]);
    let same = across.iter().all(|&axis| at[axis] == if outward[axis] > 0.0 { other.max[axis] } else { other.min[axis] });
    within && (earlier || !same)
}
