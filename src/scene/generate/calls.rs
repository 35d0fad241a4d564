//! Stops on a grid, so that tours can be looked for where there was one way.

use std::sync::Arc;

use crate::{
    kernel::{Error, limits, rng::Stream},
    math, message,
    scene::{GridScene, Header, MAX_GRID_STOPS, Scene, grid},
};

/// The same grid with `n` stops: centres of free cells, each another one, that can all be reached from each other and,
/// if there is a start, from there; start and goal stay without. The same for the same seed.
///
/// # Errors
/// [`Error::Refused`] for a scene that is no grid, for a number of stops that is not allowed or for which there is no
/// room, and for a seed that is too large.
pub fn with_stops(scene: &Scene, n: usize, seed: u64) -> Result<Scene, Error> {
    let grid = scene.get::<GridScene>()?;
    let mut stream = Stream::new(limits::check_whole("seed", seed)?, 1);
    let mut places = room(grid);
    let most = places.len().min(MAX_GRID_STOPS);
    if !(1..=most).contains(&n) {
        let allowed = message!(
            "generate-stops",
            "from 1 to {room}: as many as the grid has room for, {most} at most",
            room = most,
            most = MAX_GRID_STOPS
        );
        return Err(Error::refused("stops", n, allowed));
    }
    let stops = draw(grid, &mut places, n, &mut stream);
    let header = scene.header();
    let base = &header.name[..header.name.floor_char_boundary(80)];
    let source = header.source.as_ref().map_or(String::new(), |source| format!("{source}; "));
    let header = Header {
        name: format!("{base}-{n}-stops"),
        title: format!("{}, {n} stops", header.title),
        source: Some(format!("{source}{n} stops by seed {seed}")),
        exact: None,
        published: None,
        ..header.clone()
    };
    Scene::new(header, Arc::new(GridScene { stops, ..grid.clone() }), grid::KIND.optimum)
}

/// Puts up to `n` stops on a grid; returns how many there was room for.
pub(super) fn place(grid: &mut GridScene, n: usize, stream: &mut Stream) -> usize {
    let mut places = room(grid);
    let n = n.min(places.len());
    grid.stops = draw(grid, &mut places, n, stream);
    n
}

fn draw(grid: &GridScene, places: &mut Vec<usize>, n: usize, stream: &mut Stream) -> Vec<[f64; 2]> {
    (0..n).map(|_| grid.cells().centre(places.swap_remove(stream.below(places.len())))).collect()
}

/// The cells where stops can be: all that the start is connected with, or else the largest region that hangs together.
fn room(grid: &GridScene) -> Vec<usize> {
    let cells = grid.cells();
    let mut seen = vec![false; cells.len()];
    let mut region = |from: usize| {
        let mut found = Vec::new();
        if cells.is_free(from) && !seen[from] {
            seen[from] = true;
            found.push(from);
        }
        let mut next = 0;
        while let Some(&cell) = found.get(next) {
            next += 1;
            for other in (0..8).filter(|d| cells.moves(cell) >> d & 1 != 0).map(|d| cells.next(cell, d)) {
                if !std::mem::replace(&mut seen[other], true) {
                    found.push(other);
                }
            }
        }
        found
    };
    let ends = [grid.start, grid.goal].map(|end| end.map(|end| cells.at(end)));
    let mut largest = match ends[0] {
        Some(start) => region(start),
        None => (0..cells.len()).fold(Vec::new(), |best, from| Some(region(from)).filter(|found| found.len() > best.len()).unwrap_or(best)),
    };
    largest.retain(|&cell| !ends.contains(&Some(cell)));
    // In reading order: where a search came along first is nobody's business.
    math::sort_indices(&mut largest);
    largest
}
