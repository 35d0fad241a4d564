//! Paths in polar coordinates about the start, [LTQPSO](crate#papers) §4: a position is (α₁ … α_{D−1}), one angle for each
//! circle between start and goal.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::{
    describe::layers,
    geometry::Bounds,
    kernel::{Frame, Readings, Shape, Solution, rng::Stream},
    math,
    params::Parameters,
};

use super::{
    objective::{Evaluation, Objective, Scratch, SearchBox, subscripted},
    paths::{Angles, INITIAL, INITIAL_MEAN, INITIAL_STD, SEGMENTS},
    terrain::Terrain,
};

/// How the first angles are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Initial {
    /// Uniformly over each circle's range, (15).
    Uniform,
    /// Normally with this mean and standard deviation, in radians, cut off at the range's ends.
    Normal(f64, f64),
}

/// Paths whose `i`-th point lies on the circle of radius ρ_i = i |SG| / D about the start. The goal is fixed.
#[derive(Clone)]
pub struct Polar {
    terrain: Terrain,
    radii: Vec<f64>,
    search_box: SearchBox,
    initial: Initial,
}

impl Polar {
    /// Paths over this terrain with the settings `segments`, `initial`, `initial_mean` and `initial_std`.
    pub(super) fn new(terrain: Terrain, settings: &Parameters) -> Self {
        let d = settings[SEGMENTS];
        let [dx, dy] = [0, 1].map(|axis| terrain.goal[axis] - terrain.start[axis]);
        let distance = (dx * dx + dy * dy).sqrt();
        let radii: Vec<_> = (1..d).map(|i| i as f64 * distance / d as f64).collect();
        let ranges: Vec<_> = radii.iter().map(|&rho| range(terrain.bounds, terrain.start, math::atan2(dy, dx), rho)).collect();
        let initial = match settings[INITIAL] {
            Angles::Uniform => Initial::Uniform,
            Angles::Normal => Initial::Normal(settings[INITIAL_MEAN] * PI / 180.0, settings[INITIAL_STD] * PI / 180.0),
        };
        let search_box = SearchBox::of(ranges.iter().copied());
        Self { terrain, radii, search_box, initial }
    }

    /// The point at the angle `alpha` on the circle of radius `rho`. Rounding must not carry it over the border.
    #[inline]
    fn at(&self, rho: f64, alpha: f64) -> [f64; 2] {
        let Terrain { start, bounds: Bounds { min, max }, .. } = &self.terrain;
        let point = [start[0] + rho * math::cos(alpha), start[1] + rho * math::sin(alpha)];
        [0, 1].map(|axis| math::clamp(point[axis], min[axis], max[axis]))
    }

    fn first_angle(&self, j: usize, rng: &mut Stream) -> f64 {
        match self.initial {
            Initial::Uniform => rng.between(self.search_box.low()[j], self.search_box.high()[j]),
            Initial::Normal(mean, std) => {
                // By whole turns as near the range as it gets: 200° and −160° are the same direction.
                let middle = f64::midpoint(self.search_box.low()[j], self.search_box.high()[j]);
                let mean = mean + TAU * ((middle - mean) / TAU).round();
                self.search_box.clamp(j, mean + std * rng.normal())
            }
        }
    }

    /// Where a path to the goal leaves the circle of radius `rho` for the last time, seen from the start.
    fn last_crossing(&self, path: &[[f64; 2]], rho: f64) -> [f64; 2] {
        let seen = |point: [f64; 2]| [0, 1].map(|axis| point[axis] - self.terrain.start[axis]);
        let squared = |[x, y]: [f64; 2]| x * x + y * y;
        let inside = path.iter().rposition(|&point| squared(seen(point)) <= rho * rho).unwrap_or(0);
        let (a, b) = (seen(path[inside]), seen(path[(inside + 1).min(path.len() - 1)]));
        let way = [b[0] - a[0], b[1] - a[1]];
        // |a + t way| = ρ, the later of two solutions: a lies inside, b outside.
        let (along, length) = (a[0] * way[0] + a[1] * way[1], squared(way));
        let root = (along * along + length * (rho * rho - squared(a))).max(0.0).sqrt();
        let t = if length > 0.0 { (root - along) / length } else { 0.0 };
        [a[0] + t * way[0], a[1] + t * way[1]]
    }

    #[inline]
    fn endpoints<'a>(&'a self, x: &'a [f64]) -> impl Iterator<Item = [f64; 2]> + 'a {
        self.radii.iter().zip(x).map(|(&rho, &alpha)| self.at(rho, alpha))
    }
}

/// The angles at which the circle of radius `rho` about `start` lies inside the workspace, (13): for a start in the
/// lower left corner of a square [0, π/2] while ρ ≤ side, then [arccos(side/ρ), arcsin(side/ρ)].
///
/// Reading: where walls cut the circle into several arcs, it is the arc that holds the direction `towards` the goal.
fn range(bounds: Bounds, start: [f64; 2], towards: f64, rho: f64) -> [f64; 2] {
    let walls = [
        (0.0, bounds.max[0] - start[0]),
        (FRAC_PI_2, bounds.max[1] - start[1]),
        (PI, start[0] - bounds.min[0]),
        (-FRAC_PI_2, start[1] - bounds.min[1]),
    ];
    let (mut low, mut high) = (towards - PI, towards + PI);
    for (normal, distance) in walls.into_iter().filter(|&(_, distance)| distance < rho) {
        // Beyond this wall lies the arc of this half width about its normal, and again a turn further on.
        let half = math::acos((distance / rho).max(0.0));
        for middle in [normal - TAU, normal, normal + TAU] {
            if middle > towards {
                high = high.min(middle - half);
            } else {
                low = low.max(middle + half);
            }
        }
    }
    // The goal's own direction always belongs to the range.
    [low.min(towards), high.max(towards)]
}

impl Objective for Polar {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        self.terrain.evaluate(self.endpoints(x), scratch)
    }

    /// Angle after angle; one whose piece of the path collides is drawn anew, at most `redraws` times. Beyond a dead end
    /// nothing is.
    fn draw(&self, x: &mut [f64], rng: &mut Stream) {
        let mut from = self.terrain.start;
        let mut redraws = self.terrain.redraws;
        for j in 0..x.len() {
            let mut free = false;
            for _ in 0..=redraws {
                x[j] = self.first_angle(j, rng);
                free = redraws > 0 && self.terrain.is_free(from, self.point(x, j));
                if free {
                    break;
                }
            }
            if !free {
                redraws = 0;
            }
            from = self.point(x, j);
        }
    }

    /// The angle at which the path leaves each circle for the last time.
    fn encode(&self, path: &[[f64; 2]], x: &mut [f64]) -> bool {
        for (j, (x, &rho)) in x.iter_mut().zip(&self.radii).enumerate() {
            let [dx, dy] = self.last_crossing(path, rho);
            let middle = f64::midpoint(self.search_box.low()[j], self.search_box.high()[j]);
            let alpha = math::atan2(dy, dx);
            *x = self.search_box.clamp(j, alpha + TAU * ((middle - alpha) / TAU).round());
        }
        true
    }

    fn redraws(&self) -> u64 {
        self.terrain.redraws
    }

    fn constrained(&self) -> bool {
        true
    }

    fn point_count(&self) -> usize {
        self.radii.len()
    }

    fn point(&self, x: &[f64], i: usize) -> [f64; 2] {
        self.at(self.radii[i], x[i])
    }

    fn ends(&self) -> Option<([f64; 2], [f64; 2])> {
        Some((self.terrain.start, self.terrain.goal))
    }

    fn solution(&self, x: &[f64]) -> Solution {
        self.terrain.solution(self.endpoints(x))
    }

    fn coordinate(&self, j: usize) -> String {
        subscripted('α', j + 1)
    }

    fn read(&self, x: &[f64], out: &mut Readings) {
        self.terrain.read(self.endpoints(x), out);
    }

    /// The circles, as far as they are searched.
    fn draw_guides(&self, frame: &mut Frame) {
        const CORNERS: usize = 64;
        for (j, &rho) in self.radii.iter().enumerate() {
            let (low, high) = (self.search_box.low()[j], self.search_box.high()[j]);
            frame.begin(layers::GUIDES.key, Shape::Polyline);
            (0..=CORNERS).for_each(|i| frame.push(self.at(rho, low + (high - low) * i as f64 / CORNERS as f64), 0.0));
        }
    }

    fn draw_result(&self, x: &[f64], frame: &mut Frame) {
        self.terrain.draw_result(self.endpoints(x), frame);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{
        geometry::Field,
        params::{Overrides, Value},
        scene::{GRID, GridScene},
        shipped,
    };

    fn polar(segments: f64, more: &[(&'static str, Value)]) -> Polar {
        let scene = shipped("qpso-10m-empty").unwrap();
        let given: Overrides = [("segments", Value::from(segments))].into_iter().chain(more.iter().cloned()).collect();
        let settings = Parameters::new(super::super::pso::ENTRY.parameters, GRID, &given).unwrap();
        let grid = scene.get::<GridScene>().unwrap();
        Polar::new(Terrain::among(Arc::<Field>::clone(grid.field()), grid, &settings).unwrap(), &settings)
    }

    fn close(value: f64, expected: f64) {
        assert!((value - expected).abs() < 1e-13 * (1.0 + expected.abs()), "{value} is not {expected}");
    }

    /// (13) for the paper's square of side 10: D = 8, so ρ_i = i · 10√2 / 8.
    #[test]
    fn angles_lie_where_the_circle_is_inside_the_workspace_13() {
        let polar = polar(8.0, &[]);
        assert_eq!(polar.radii.len(), 7);
        for (j, &rho) in polar.radii.iter().enumerate() {
            close(rho, (j + 1) as f64 * 10.0 * std::f64::consts::SQRT_2 / 8.0);
            let (low, high) = if rho <= 10.0 { (0.0, FRAC_PI_2) } else { (math::acos(10.0 / rho), math::asin(10.0 / rho)) };
            close(polar.search_box.low()[j], low);
            close(polar.search_box.high()[j], high);
        }
        // ρ₇ = 12.374…: arccos 0.808… = 36.1°…
        close(polar.search_box.low()[6], 0.629_839_533_948_421_1);
    }

    #[test]
    fn from_the_middle_the_range_is_a_whole_turn_until_it_meets_a_wall() {
        let bounds = Bounds { min: [0.0, 0.0], max: [10.0, 6.0] };
        let whole = range(bounds, [5.0, 3.0], 0.0, 2.9);
        assert_eq!(whole, [-PI, PI]);
        // Radius 4 meets the floor and the ceiling at asin(3/4) from the x axis.
        let [low, high] = range(bounds, [5.0, 3.0], 0.0, 4.0);
        close(high, math::asin(0.75));
        close(low, -math::asin(0.75));
        // Towards the left: the arc about π.
        let [low, high] = range(bounds, [5.0, 3.0], PI, 4.0);
        close(low, PI - math::asin(0.75));
        close(high, PI + math::asin(0.75));
    }

    /// D = 2: one point on the circle of radius 5√2. At α = 90° it is (0, 5√2).
    #[test]
    fn fitness_is_16_with_length_17_and_smoothness_18() {
        let polar = polar(2.0, &[("f1", 3.0.into()), ("f2", 0.5.into())]);
        let alpha = FRAC_PI_2;
        let (rho_1, rho_2, goal) = (50_f64.sqrt(), 200_f64.sqrt(), PI / 4.0);
        let last = rho_1 * rho_1 + rho_2 * rho_2 - 2.0 * rho_1 * rho_2 * math::cos(goal - alpha);
        close(last, 250.0 - 100.0 * std::f64::consts::SQRT_2);
        let found = polar.evaluate(&[alpha], &mut Scratch::default());
        close(found.cost, 3.0 * (rho_1 + last.sqrt()) + 0.5 * (rho_1 * rho_1 + last));
        assert_eq!(found.violation, 0.0);
        let mut readings = Readings::default();
        polar.read(&[alpha], &mut readings);
        close(readings.get("length").unwrap(), rho_1 + last.sqrt());
        close(readings.get("smoothness").unwrap(), 50.0 + last);
    }

    /// D = 2 from (0, 0) to (10, 10): one circle of radius 5√2. The path leaves it at (7, 1), comes back and leaves it at (1, 7).
    #[test]
    fn a_path_is_encoded_by_where_it_leaves_a_circle_for_the_last_time() {
        let polar = polar(2.0, &[]);
        let mut x = [0.0];
        assert!(polar.encode(&[[0.0, 0.0], [7.0, 1.0], [9.0, 1.0], [1.0, 1.0], [1.0, 9.0], [10.0, 10.0]], &mut x));
        close(x[0], math::atan2(7.0, 1.0));
        // A corner on the circle itself.
        assert!(polar.encode(&[[0.0, 0.0], [7.0, 1.0], [10.0, 10.0]], &mut x));
        close(x[0], math::atan2(1.0, 7.0));
    }

    #[test]
    fn a_path_inside_an_obstacle_costs_its_length_there() {
        let mut polar = polar(2.0, &[("f2", 0.0.into())]);
        let mut blocked = vec![false; 400];
        blocked[10 * 20 + 10] = true; // the cell from (5, 5) to (5.5, 5.5)
        polar.terrain.obstacles = super::super::terrain::Obstacles::Field(Arc::new(Field::new(0.5, 20, &blocked, 0.25, false)));
        // Straight through the diagonal: the cell's own, and a radius before and after it.
        let found = polar.evaluate(&[PI / 4.0], &mut Scratch::default());
        // (And twice the margin that planners keep, half a billionth of a cell.)
        close(found.violation, 0.5 * std::f64::consts::SQRT_2 + 0.5 + 2.0 * 5e-10 * 0.5);
        close(found.cost, 200_f64.sqrt() + 10.0 * found.violation);
    }

    #[test]
    fn first_angles_have_the_mean_and_spread_asked_for_and_keep_to_the_range() {
        let sample = |more: &[(&'static str, Value)]| {
            let polar = polar(8.0, more);
            let mut rng = Stream::new(1, 0);
            let mut x = [0.0; 7];
            let firsts: Vec<_> = (0..20_000)
                .map(|_| {
                    polar.draw(&mut x, &mut rng);
                    assert!(x.iter().enumerate().all(|(j, &x)| polar.search_box.clamp(j, x) == x));
                    x[0] * 180.0 / PI
                })
                .collect();
            let mean = firsts.iter().sum::<f64>() / 20_000.0;
            (mean, (firsts.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 20_000.0).sqrt())
        };
        let (mean, std) = sample(&[]);
        assert!((mean - 45.0).abs() < 0.6 && (std - 90.0 / 12_f64.sqrt()).abs() < 0.3, "uniform: {mean} {std}");
        let normal =
            |mean: f64, std: f64| sample(&[("initial", "normal".into()), ("initial_mean", mean.into()), ("initial_std", std.into())]);
        let (mean, std) = normal(40.0, 5.0);
        assert!((mean - 40.0).abs() < 0.1 && (std - 5.0).abs() < 0.1, "normal: {mean} {std}");
        let (mean, std) = normal(45.0, 30.0);
        assert!((mean - 45.0).abs() < 0.6 && std > 24.0 && std < 28.0, "cut off at 0° and 90°: {mean} {std}");
    }
}
