//! The shortest path of a point among cuboids in space: the arm's tip among its obstacles, [ARM-RRT](crate#papers) §3.1 without
//! the arm.
//!
//! A shortest path bends only on edges. On given edges in a given order its length is convex in where it crosses them
//! (`taut`), and where it bends it comes from beside one of the edge's two faces and leaves beside the other (`edges`).
//! So the search runs best first over sequences of edges, each with a proven lower bound: the length of the shortest line
//! over its edges to the goal, whatever is in the way. The first line that is free is the shortest path there is: every
//! other is at least as long as its bound, and every shortest path is the taut line of its own edges.

mod edges;
mod grow;
mod joined;
mod search;
mod taut;
#[cfg(test)]
mod tests;

use crate::{
    geometry::{Cuboid, length_in_space},
    kernel::Exact,
};

use grow::grow;
use search::Search;

/// The largest number of cuboids among which the shortest path is computed.
pub const MAX_EXACT_CUBOIDS: usize = 12;

/// How near to a cuboid the path comes, relative to the largest coordinate: what is closer counts as touching.
const HAIR: f64 = 1e-12;

/// The result of [`shortest_among_cuboids`].
#[derive(Debug, Clone, PartialEq)]
pub enum AmongCuboids {
    /// The shortest path.
    Found(Exact),
    /// There is no path: the cuboids enclose start or goal.
    NoWay,
    /// There are more than [`MAX_EXACT_CUBOIDS`], or the search was given up after a set amount of work.
    NotComputed,
}

/// The shortest path of a point from `start` to `goal` that stays in the `workspace` and touches no cuboid.
///
/// More exactly, its length is the infimum over such paths: along a face is as good as free, but between two faces that touch
/// (of two cuboids, or of one and the workspace) there is no path. The path keeps away from all cuboids by at least 5e-13 of
/// the largest coordinate (half of `HAIR`; less where an end is nearer), so it is feasible as it is, and it is no longer than
/// the shortest that keeps away by some 1e-12. A gap as narrow as this is closed.
///
/// Within this the answer is exact for any cuboids, apart, touching or overlapping: lower bounds come from the dual problem and
/// hold whether the minimisation has converged or not. If a line does not converge, its bound may stay below the answer by up
/// to 1e-9 of the largest coordinate; by more, and the result is [`AmongCuboids::NotComputed`].
pub fn shortest_among_cuboids(workspace: &Cuboid, start: [f64; 3], goal: [f64; 3], cuboids: &[Cuboid]) -> AmongCuboids {
    if !cuboids.iter().any(|cuboid| cuboid.meets(start, goal)) {
        return AmongCuboids::Found(way(vec![start, goal]));
    }
    if cuboids.len() > MAX_EXACT_CUBOIDS {
        return AmongCuboids::NotComputed;
    }
    // Both directions are one problem, so that they have one answer.
    let turned = goal.iter().zip(&start).find(|(g, s)| g != s).is_some_and(|(g, s)| g < s);
    let given = if turned { [goal, start] } else { [start, goal] };
    let scale = [workspace.min, workspace.max].as_flattened().iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    let hair = HAIR * scale;
    let obstacles = level(cuboids.iter().map(|cuboid| grow(cuboid, hair)).collect(), hair / 4.0);
    let ends = given.map(|end| obstacles.iter().fold(end, out_of));
    if !joined::joined(workspace, ends, &obstacles) {
        return AmongCuboids::NoWay;
    }
    let barriers = cuboids.iter().map(|cuboid| grow(cuboid, hair / 2.0)).collect();
    let Some(corners) = Search::new(edges::all(workspace, &obstacles), barriers, ends, scale).run() else {
        return AmongCuboids::NotComputed;
    };
    let mut path: Vec<_> = [given[0]].into_iter().chain(corners).chain([given[1]]).collect();
    path.dedup();
    if turned {
        path.reverse();
    }
    AmongCuboids::Found(way(path))
}

fn way(tip_path: Vec<[f64; 3]>) -> Exact {
    let length = length_in_space(&tip_path);
    Exact { tip_path, ..Exact::way(length, Vec::new()) }
}

/// Faces in nearly one plane are put into one: a path over edges that almost coincide would never come to rest.
fn level(mut cuboids: Vec<Cuboid>, near: f64) -> Vec<Cuboid> {
    for axis in 0..3 {
        let mut faces: Vec<&mut f64> = cuboids.iter_mut().flat_map(|cuboid| [&mut cuboid.min[axis], &mut cuboid.max[axis]]).collect();
        let mut plane = f64::NEG_INFINITY;
        for (_, place) in crate::math::ordered(faces.iter().map(|face| **face)) {
            if *faces[place] - plane < near {
                *faces[place] = plane;
            }
            plane = *faces[place];
        }
    }
    cuboids
}

/// A point that lies inside of a cuboid, moved out through the nearest face: ends may be nearer to a cuboid than paths come.
fn out_of(mut point: [f64; 3], cuboid: &Cuboid) -> [f64; 3] {
    let faces = (0..3).flat_map(|axis| {
        [(axis, cuboid.min[axis], point[axis] - cuboid.min[axis]), (axis, cuboid.max[axis], cuboid.max[axis] - point[axis])]
    });
    if let Some((axis, face, depth)) = faces.min_by(|a, b| a.2.total_cmp(&b.2))
        && depth > 0.0
    {
        point[axis] = face;
    }
    point
}
