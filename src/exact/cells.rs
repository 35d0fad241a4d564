//! The shortest way over a grid's cells, by Dijkstra's search. Independent of the planners that search grids: it is what
//! they are measured by.

use std::{cmp::Reverse, collections::BinaryHeap};

use crate::scene::{Cells, Course, Steps};

use super::{Exact, Length};

/// The shortest way from start to goal from cell to neighbouring cell; `None` where there is none.
pub fn shortest_over_cells(cells: &Cells, course: &Course) -> Option<Exact> {
    let mut best = vec![Steps { straight: u32::MAX, diagonal: u32::MAX }; cells.len()];
    let mut from = vec![u8::MAX; cells.len()];
    let mut open = BinaryHeap::from([Reverse((Length(0.0), course.start))]);
    best[course.start] = Steps::default();
    while let Some(Reverse((Length(length), cell))) = open.pop() {
        if cell == course.goal {
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
    let mut way = vec![course.goal];
    while let Some(&cell) = way.last().filter(|&&cell| cell != course.start) {
        let d = usize::from(from[cell]);
        if d > 7 {
            return None;
        }
        way.push(cells.next(cell, (d + 4) % 8));
    }
    Some(Exact { length: course.length(cells, best[course.goal]), path: course.path(cells, way.into_iter().rev()) })
}

#[cfg(test)]
mod tests {
    use crate::{Scene, planner::Yardstick, scene::Body, shipped};

    /// Against the optima that the scene files carry, which another program computed.
    #[test]
    fn it_finds_the_stored_optima_with_and_without_corner_cutting() {
        let length = |name: &str, cutting: bool| {
            let scene = shipped(name).unwrap();
            let Body::Grid(mut grid) = scene.body().clone() else { panic!() };
            grid.corner_cutting = cutting;
            let scene = Scene::new(scene.header().clone(), Body::Grid(grid)).unwrap();
            let exact = scene.exact_by(Yardstick::Cells).unwrap();
            assert!((crate::geometry::length(&exact.path) - exact.length).abs() < 1e-9);
            exact.length
        };
        assert!((length("wolf-ant-20", false) - 562.842_712_474_619).abs() < 1e-9);
        assert!((length("wolf-ant-20", true) - 527.695_526_217_004_7).abs() < 1e-9);
        assert!((length("ant-bat-30", false) - 42.041_630_560_342_62).abs() < 1e-9);
        assert!((length("ant-bat-30", true) - 40.284_271_247_461_9).abs() < 1e-9);
    }
}
