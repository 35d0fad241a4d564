//! Against values computed elsewhere, closed forms, and two slow searches that share no code with the fast one.

use std::f64::consts::{FRAC_PI_2, PI};

use super::*;
use crate::{geometry, kernel::rng::Stream};

/// A grid whose rows are listed from y = 0 upwards.
struct Grid {
    cell: f64,
    columns: usize,
    blocked: Vec<bool>,
    squeeze: bool,
}

impl Grid {
    fn new(cell: f64, rows: &str) -> Self {
        let columns = rows.split_whitespace().next().map_or(0, str::len);
        let blocked = rows.chars().filter(|c| !c.is_whitespace()).map(|c| c == '#').collect();
        Self { cell, columns, blocked, squeeze: false }
    }

    fn random(rng: &mut Stream, columns: usize, rows: usize, share: f64) -> Self {
        let blocked = (0..columns * rows).map(|_| rng.unit() < share).collect();
        Self { cell: 1.0, columns, blocked, squeeze: false }
    }

    fn size(&self) -> [usize; 2] {
        [self.columns, self.blocked.len() / self.columns]
    }

    fn field(&self, radius: f64) -> Field {
        Field::new(self.cell, self.columns, &self.blocked, radius, self.squeeze)
    }

    /// The exact optimum; its path is checked.
    fn shortest(&self, radius: f64, start: [f64; 2], goal: [f64; 2]) -> Option<f64> {
        let field = self.field(radius);
        let exact = shortest_on_grid([start, goal], self.cell, self.columns, &self.blocked, &field, self.squeeze)?;
        let (drawn, path) = (geometry::length(&exact.path), &exact.path);
        assert!(drawn >= exact.length * (1.0 - 1e-12) && drawn <= exact.length * (1.0 + 1.1e-4), "{drawn} drawn, {} exact", exact.length);
        assert_eq!((path[0], path[path.len() - 1]), (start, goal));
        for w in path.windows(2) {
            assert!(field.is_free(w[0], w[1]), "{w:?} is cut, radius {radius}: {path:?}");
        }
        assert!(path.iter().all(|p| (0..2).all(|axis| (0.0..=field.size()[axis]).contains(&p[axis]))), "out of the grid");
        Some(exact.length)
    }

    fn expect(&self, radius: f64, start: [f64; 2], goal: [f64; 2], expected: f64) {
        let length = self.shortest(radius, start, goal).expect("a way exists");
        assert!((length - expected).abs() < 1e-9, "{length}, not {expected}");
    }

    /// Blocked, or outside.
    fn is_solid(&self, x: isize, y: isize) -> bool {
        let [columns, rows] = self.size().map(usize::cast_signed);
        !(0..columns).contains(&x) || !(0..rows).contains(&y) || self.blocked[(y * columns + x) as usize]
    }
}

const WOLF: &str = "..##.........###.... .............###.... ...#................ ...###.............. ...#.......##.###... \
        ...........##....... ...........#####.... .............#####.. .......#...........# #......#...........# \
        #......#........#### ###.............#### ###............#.### ###......##...##.### ..............##.#.# \
        ...###......#..#...# ...###.####.#..#...# ##.###.####.#....#.. .......###..#....... ...##.......#.......";
const BAT: &str = ".........##...####............ ..##.....##...####......###... #.##......###.##........###... #.##......###................. \
        #.##.###..........####........ #.##.###..####..######........ ..........####..######........ ##........####....####........ \
        ##......######................ ##......##.......####.......## ##......##.......####.......## ##......##.......####..##...## \
        ######..##.......####..##..... ........#...######.....##..... ........#..............##..... ........#..............##..... \
        ........#....####............. ........#....####.....####.... ###.....#....####............. ###..........####....#####.... \
        .....###.............#####.... .....###...................... .............................. ...................#.......... \
        .....#....#####....#.......... .....#....#####....#.......... .....#....#####....#.......... .....#.............#....##.... \
        ...................#....##.... ..............................";

#[test]
fn published_grids_have_the_optima_computed_elsewhere() {
    Grid::new(20.0, WOLF).expect(0.0, [30.0, 30.0], [370.0, 370.0], 497.155_990_127_052_3);
    let bat = Grid::new(1.0, BAT);
    bat.expect(0.0, [1.5, 26.5], [28.5, 1.5], 37.990_497_547_955_47);
    // Stops of its tour. The second way would be shorter if a point could slip between a blocked cell and the border.
    bat.expect(0.0, [15.5, 5.5], [7.5, 11.5], 12.722_224_011_480_916);
    bat.expect(0.0, [28.5, 1.5], [4.5, 0.5], 25.502_095_486_278_22);
}

#[test]
fn round_one_block_it_is_straight_pieces_and_arcs() {
    let grid = Grid::new(1.0, "..... ..#.. .....");
    // Under the block, radius 1/2: tangents from 3/2 beside and 1/2 above the corners, both flat after the arcs.
    let (distance, above) = (1.5_f64 * 1.5 + 0.25, 0.5_f64);
    let tangent = (distance - 0.25).sqrt();
    let fall = math::atan2(above, 1.5) + math::asin(0.5 / distance.sqrt());
    grid.expect(0.5, [0.5, 1.5], [4.5, 1.5], 2.0 * (tangent + 0.5 * fall) + 1.0);
    grid.expect(0.0, [0.5, 1.5], [4.5, 1.5], 2.0 * distance.sqrt() + 1.0);
    grid.expect(0.5, [0.0, 0.5], [5.0, 0.5], 5.0);
    grid.expect(0.0, [0.5, 0.5], [0.5, 0.5], 0.0);
    // A start and a goal that touch: a quarter and nothing else.
    grid.expect(0.5, [2.0, 0.5], [1.5, 1.0], 0.25 * PI);
    // In other units.
    Grid::new(0.1, "..... ..#.. .....").expect(0.05, [0.05, 0.15], [0.45, 0.15], 0.1 * (2.0 * (tangent + 0.5 * fall) + 1.0));
}

#[test]
fn a_gap_as_wide_as_the_robot_is_open_and_a_narrower_one_closed() {
    let grid = Grid::new(1.0, "..#.. ..#.. ..... ..#..");
    grid.expect(0.5, [0.5, 2.5], [4.5, 2.5], 4.0);
    // Down on both sides: quarters round the corners, the gap between.
    grid.expect(0.5, [1.5, 1.0], [3.5, 1.0], 3.0 + FRAC_PI_2);
    assert_eq!(grid.shortest(0.500_001, [0.5, 2.5], [4.5, 2.5]), None);
    // Round corners on both sides of a gap that is just wide enough.
    let bend = Grid::new(1.0, ".... ##.# .... ....");
    assert!(bend.shortest(0.5, [0.5, 0.5], [0.5, 2.5]).is_some());
    // The same with a cell that has no exact binary number.
    assert!(Grid::new(1.0, "##..... ....... ..##...").shortest(0.5, [0.5, 1.5], [6.5, 0.5]).is_some());
}

#[test]
fn a_point_does_not_slip_between_cells() {
    let (start, goal) = ([0.5, 1.5], [1.5, 0.5]);
    let mut pinch = Grid::new(1.0, "#... .#.. ....");
    let round = pinch.shortest(0.0, start, goal).unwrap();
    assert!((round - (1.0 + 2.0 * 0.5_f64.sqrt() + 1.0)).abs() < 1e-9, "round the cell (1, 1): {round}");
    pinch.squeeze = true;
    pinch.expect(0.0, start, goal, 2.0_f64.sqrt());
    pinch.expect(0.0, [0.25, 1.25], [1.75, 0.5], 0.625_f64.sqrt() + 0.8125_f64.sqrt());
    assert_eq!(Grid { squeeze: true, ..Grid::new(1.0, "#. .#") }.shortest(0.1, start, goal), None, "a robot with a size");
    assert_eq!(Grid::new(1.0, "#. .#").shortest(0.0, start, goal), None, "shut in");
    for wall in [".#.. .#.. .#..", ".##. .##. .##."] {
        assert_eq!(Grid::new(1.0, wall).shortest(0.0, [0.0, 1.0], [4.0, 1.0]), None, "through a seam");
        assert_eq!(Grid::new(1.0, wall).shortest(0.0, [0.0, 0.0], [4.0, 0.0]), None, "along the border");
        assert_eq!(Grid::new(1.0, wall).shortest(0.3, [0.0, 0.0], [4.0, 0.0]), None);
    }
    let block = Grid::new(1.0, ".... .##. .##. ....");
    block.expect(0.0, [0.0, 1.0], [4.0, 1.0], 4.0);
    block.expect(0.0, [1.0, 0.0], [1.0, 4.0], 4.0);
    block.expect(0.0, [0.0, 2.0], [4.0, 2.0], 2.0 + 2.0 * 2.0_f64.sqrt());
}

/// Dense Dijkstra among points of which `sees` says whether one can go straight from the one to the other.
fn dijkstra(nodes: &[[f64; 2]], sees: impl Fn(usize, usize) -> bool) -> Option<f64> {
    let mut best = vec![f64::INFINITY; nodes.len()];
    let mut done = vec![false; nodes.len()];
    best[0] = 0.0;
    loop {
        let near = (0..nodes.len()).filter(|&i| !done[i] && best[i].is_finite()).min_by(|&a, &b| best[a].total_cmp(&best[b]))?;
        if near == 1 {
            return Some(best[1]);
        }
        done[near] = true;
        for to in 0..nodes.len() {
            let length = best[near] + geometry::length(&[nodes[near], nodes[to]]);
            if !done[to] && length < best[to] && sees(near, to) {
                best[to] = length;
            }
        }
    }
}

/// The shortest way of a point in whole numbers: from lattice point to lattice point, every pair tried, coordinates doubled.
fn point_by_force(grid: &Grid, ends: [[isize; 2]; 2]) -> Option<f64> {
    let [columns, rows] = grid.size().map(usize::cast_signed);
    let is_pinch = |x, y| {
        let [a, b, c, d] = [grid.is_solid(x - 1, y - 1), grid.is_solid(x, y - 1), grid.is_solid(x, y), grid.is_solid(x - 1, y)];
        !grid.squeeze && a == c && b == d && a != b
    };
    // What is forbidden: the insides of solid cells, and of two side by side together.
    let mut boxes = Vec::new();
    for x in -1..=columns {
        for y in -1..=rows {
            let mut push = |w, h| boxes.push([2 * x, 2 * y, 2 * (x + w), 2 * (y + h)]);
            if grid.is_solid(x, y) {
                push(1, 1);
                if grid.is_solid(x + 1, y) {
                    push(2, 1);
                }
                if grid.is_solid(x, y + 1) {
                    push(1, 2);
                }
            }
        }
    }
    let lattice = (0..=columns).flat_map(|x| (0..=rows).map(move |y| [x, y]));
    let (bad, good): (Vec<_>, Vec<_>) = lattice.partition(|&[x, y]| is_pinch(x, y));
    let nodes: Vec<[isize; 2]> = ends.into_iter().chain(good.iter().map(|p| p.map(|c| 2 * c))).collect();
    let cross = |a: [isize; 2], b: [isize; 2], c: [isize; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let sees = |i: usize, j: usize| {
        let (a, b) = (nodes[i], nodes[j]);
        let apart = |&[x0, y0, x1, y1]: &[isize; 4]| {
            let sides = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(|c| cross(a, b, c));
            a[0].max(b[0]) <= x0
                || a[0].min(b[0]) >= x1
                || a[1].max(b[1]) <= y0
                || a[1].min(b[1]) >= y1
                || (a != b && (sides.iter().all(|&s| s <= 0) || sides.iter().all(|&s| s >= 0)))
        };
        let through = |p: &[isize; 2]| {
            let p = p.map(|c| 2 * c);
            let dot = (p[0] - a[0]) * (b[0] - p[0]) + (p[1] - a[1]) * (b[1] - p[1]);
            cross(a, b, p) == 0 && dot > 0
        };
        boxes.iter().all(apart) && !bad.iter().any(through)
    };
    let points: Vec<_> = nodes.iter().map(|p| p.map(|c| c as f64 / 2.0)).collect();
    if !sees(0, 0) || !sees(1, 1) {
        return None;
    }
    dijkstra(&points, sees)
}

#[test]
fn a_point_s_way_is_what_trying_every_pair_finds() {
    let mut rng = Stream::new(11, 0);
    let mut found = 0;
    for case in 0..if cfg!(debug_assertions) { 150 } else { 4000 } {
        let share = rng.between(0.1, 0.5);
        let mut grid = Grid::random(&mut rng, 7, 6, share);
        grid.squeeze = case % 2 == 0;
        let ends = [0, 1].map(|_| [15, 13].map(|n| rng.below(n).cast_signed()));
        let [start, goal] = ends.map(|p| p.map(|c| c as f64 / 2.0));
        let field = grid.field(0.0);
        if !field.is_free(start, start) || !field.is_free(goal, goal) {
            continue;
        }
        let force = point_by_force(&grid, ends);
        let exact = grid.shortest(0.0, start, goal);
        let agree = match (exact, force) {
            (Some(a), Some(b)) => (a - b).abs() < 1e-9,
            (a, b) => a == b,
        };
        assert!(agree, "case {case}: {exact:?} by tangents, {force:?} by force, {start:?} {goal:?} {:?}", grid.blocked);
        found += usize::from(force.is_some());
    }
    assert!(found > 50);
}

/// The shortest way past cells grown by a polygon of `sides` with its corners at `radius`, by trying every pair of corners.
fn polygon_by_force(grid: &Grid, radius: f64, sides: usize, ends: [[f64; 2]; 2]) -> Option<f64> {
    let [columns, rows] = grid.size();
    let cells: Vec<[f64; 2]> =
        (0..columns * rows).filter(|&i| grid.blocked[i]).map(|i| [(i % columns) as f64, (i / columns) as f64]).collect();
    let direction = |turns: f64| [math::cos(2.0 * PI * turns), math::sin(2.0 * PI * turns)];
    let mut planes: Vec<([f64; 2], f64)> =
        (0..sides).map(|i| (direction((i as f64 + 0.5) / sides as f64), radius * math::cos(PI / sides as f64))).collect();
    planes.extend([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(|n| (n, radius)));
    let free = |a: [f64; 2], b: [f64; 2]| {
        cells.iter().all(|c| {
            if (0..2).any(|i| a[i].max(b[i]) < c[i] - radius || a[i].min(b[i]) > c[i] + 1.0 + radius) {
                return true;
            }
            let (mut from, mut to) = (0.0_f64, 1.0_f64);
            for (n, reach) in &planes {
                let support = (0..2).map(|i| n[i] * c[i] + n[i].max(0.0)).sum::<f64>() + reach - 1e-9;
                let (at, step) = (n[0] * a[0] + n[1] * a[1] - support, n[0] * (b[0] - a[0]) + n[1] * (b[1] - a[1]));
                if step.abs() < 1e-14 {
                    if at >= 0.0 {
                        return true;
                    }
                } else if step > 0.0 {
                    to = to.min(-at / step);
                } else {
                    from = from.max(-at / step);
                }
            }
            from >= to
        })
    };
    let mut nodes = ends.to_vec();
    for [x, y] in &cells {
        for (quarter, corner) in [[1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]].into_iter().enumerate() {
            nodes.extend(
                (0..=sides / 4)
                    .map(|i| direction((quarter * sides / 4 + i) as f64 / sides as f64))
                    .map(|[dx, dy]| [x + corner[0] + radius * dx, y + corner[1] + radius * dy]),
            );
        }
    }
    let inside = |p: &[f64; 2]| p[0] > -1e-9 && p[1] > -1e-9 && p[0] < columns as f64 + 1e-9 && p[1] < rows as f64 + 1e-9;
    nodes.retain(|&p| inside(&p) && free(p, p));
    dijkstra(&nodes, |i, j| free(nodes[i], nodes[j]))
}

#[test]
fn a_round_robot_s_way_is_between_those_past_inner_and_outer_polygons() {
    let mut rng = Stream::new(12, 0);
    let (mut found, mut closed) = (0, 0);
    let (cases, sides) = if cfg!(debug_assertions) { (120, 16) } else { (1500, 40) };
    for case in 0..cases {
        let share = rng.between(0.05, 0.3);
        let grid = Grid::random(&mut rng, 7, 6, share);
        let radius = if case % 5 == 0 { 0.5 - 1e-6 } else { rng.between(0.05, 1.1) };
        let [start, goal] = [0, 1].map(|_| [rng.between(0.0, 7.0), rng.between(0.0, 6.0)]);
        let outside = radius / math::cos(PI / sides as f64);
        let field = grid.field(outside);
        if !field.is_free(start, start) || !field.is_free(goal, goal) {
            continue;
        }
        let exact = grid.shortest(radius, start, goal);
        let low = polygon_by_force(&grid, radius, sides, [start, goal]);
        let high = polygon_by_force(&grid, outside, sides, [start, goal]);
        let [exact, low, high] = [exact, low, high].map(|length| length.unwrap_or(f64::INFINITY));
        assert!(
            low - 1e-7 <= exact && exact <= high + 1e-7,
            "case {case}: {low} {exact} {high}, {radius} {start:?} {goal:?} {:?}",
            grid.blocked
        );
        found += usize::from(exact.is_finite() && exact > geometry::length(&[start, goal]) + 1e-9);
        closed += usize::from(exact.is_infinite());
    }
    assert!(found >= 5 && closed >= 1, "{found} bent, {closed} closed");
}

#[test]
fn corners_in_a_line_and_robots_as_wide_as_cells_are_no_obstacle() {
    let mut rng = Stream::new(13, 0);
    let mut found = 0;
    for case in 0..if cfg!(debug_assertions) { 200 } else { 5000 } {
        let mut grid = Grid::random(&mut rng, 12, 12, 0.12);
        grid.cell = [1.0, 0.5, 0.1, 20.0][case % 4];
        let radius = grid.cell * [0.5, 0.25, 0.499, 0.125, 0.75][case % 5];
        let [start, goal] = [[0.5, 0.5], [11.5, 11.5]].map(|p| p.map(|c| c * grid.cell));
        let field = grid.field(radius);
        // A gap of exactly the robot's width may be closed by rounding, and then nobody may touch at the start.
        let room = if case % 4 == 2 || case % 5 == 0 { 1e-8 * grid.cell } else { 0.0 };
        if [start, goal].iter().all(|&end| field.is_nearly_free(end, end, -room)) {
            found += usize::from(grid.shortest(radius, start, goal).is_some());
        }
    }
    assert!(found > 50, "{found}");
}
