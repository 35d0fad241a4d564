//! The shortest path over a grid's cells, by Dijkstra's algorithm. Independent of the planners that search grids, since they
//! are measured against it.

use std::{cmp::Reverse, collections::BinaryHeap};

use crate::{
    geometry::{Cells, Endpoints, Steps},
    kernel::Exact,
    math::Length,
};

/// The shortest path from start to goal between neighbouring cells; `None` if there is none.
pub fn shortest_over_cells(cells: &Cells, endpoints: &Endpoints) -> Option<Exact> {
    let way = shortest_way(cells, endpoints.start, endpoints.goal)?;
    Some(Exact::way(endpoints.length(cells, cells.steps(&way)), endpoints.path(cells, way)))
}

/// The cells of a shortest path from one cell to another; `None` if there is none.
pub fn shortest_way(cells: &Cells, start: usize, goal: usize) -> Option<Vec<usize>> {
    let mut best = vec![Steps { straight: u32::MAX, diagonal: u32::MAX }; cells.len()];
    let mut from = vec![u8::MAX; cells.len()];
    let mut open = BinaryHeap::from([Reverse((Length(0.0), start))]);
    best[start] = Steps::default();
    while let Some(Reverse((Length(length), cell))) = open.pop() {
        if cell == goal {
            break;
        }
        if length > best[cell].length() {
            continue; // a shorter way was found since
        }
        for d in (0..8).filter(|d| cells.moves(cell) >> d & 1 != 0) {
            let (next, steps) = (cells.next(cell, d), best[cell].and(d));
            if steps.length() < best[next].length() {
                (best[next], from[next]) = (steps, d as u8);
                open.push(Reverse((Length(steps.length()), next)));
            }
        }
    }
    let mut way = vec![goal];
    while let Some(&cell) = way.last().filter(|&&cell| cell != start) {
        let d = usize::from(from[cell]);
        if d > 7 {
            return None;
        }
        way.push(cells.next(cell, (d + 4) % 8));
    }
    way.reverse();
    Some(way)
}

/// Whether there is a path over cells from one cell to another.
pub fn is_reachable(cells: &Cells, start: usize, goal: usize) -> bool {
    let mut seen = vec![false; cells.len()];
    let mut open = vec![start];
    seen[start] = true;
    while let Some(cell) = open.pop() {
        if cell == goal {
            return true;
        }
        for next in (0..8).filter(|d| cells.moves(cell) >> d & 1 != 0).map(|d| cells.next(cell, d)) {
            if !std::mem::replace(&mut seen[next], true) {
                open.push(next);
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use crate::{
        kernel::ReferenceOptimum,
        scene::{GridScene, grid},
        shipped,
    };

    /// Against the optima that the scene files carry, which another program computed.
    #[test]
    fn it_finds_the_stored_optima_with_and_without_corner_cutting() {
        let length = |name: &str, cutting: bool| {
            let scene = shipped(name).unwrap();
            let mut grid = scene.get::<GridScene>().unwrap().clone();
            grid.corner_cutting = cutting;
            let scene = grid::KIND.scene(scene.header().clone(), grid).unwrap();
            let exact = scene.exact_by(ReferenceOptimum::Cells).unwrap();
            assert!((crate::geometry::length(&exact.path) - exact.length).abs() < 1e-9);
            exact.length
        };
        assert!((length("wolf-ant-20", false) - 562.842_712_474_619).abs() < 1e-9);
        assert!((length("wolf-ant-20", true) - 527.695_526_217_004_7).abs() < 1e-9);
        assert!((length("ant-bat-30", false) - 42.041_630_560_342_62).abs() < 1e-9);
        assert!((length("ant-bat-30", true) - 40.284_271_247_461_9).abs() < 1e-9);
    }
}
