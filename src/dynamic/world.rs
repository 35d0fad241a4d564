//! What the robot sees of the moving obstacles, where it expects them, and whether a plan comes too near to one: by exact
//! continuous motion, so that nothing tunnels between two moments.

use crate::{
    geometry::{Bounds, Cells, closest_approach, distance_squared},
    kernel::State,
    scene::{CONTACT, GridScene, Moving},
};

use super::body::{Body, Stretch};

/// The most corners of a range.
const CORNERS: usize = 2000;

/// How far away obstacles are to be kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
pub(super) enum Distance {
    /// Radius and margin; of an obstacle that is nearer already, what is left.
    Margin,
    /// Only the bodies must not meet.
    Contact,
}

/// A moving obstacle that the robot sees, as it expects it to go on: as it goes now.
#[derive(Debug, Clone, State)]
pub(super) struct Threat {
    /// Its number in the scene.
    pub number: usize,
    /// From now on: its time 0 is now.
    #[state(shared)]
    disc: Moving,
    /// From centre to centre.
    pub distance: f64,
    /// The distance of the centres that is to be kept, with the margin and without.
    keep: [f64; 2],
}

/// When and where a plan comes too near to an obstacle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Conflict {
    pub time: f64,
    /// Where the robot would be.
    pub place: [f64; 2],
    /// The obstacle's number in the scene.
    pub obstacle: usize,
    /// The step of the plan, from where it is now.
    pub step: usize,
}

/// The obstacles that a robot sees.
#[derive(Debug, Clone, Default, State)]
pub(super) struct View {
    pub now: f64,
    pub threats: Vec<Threat>,
}

impl View {
    /// Looks around.
    pub fn look(&mut self, grid: &GridScene, body: &Body, at: [f64; 2], now: f64) {
        self.now = now;
        self.threats.clear();
        for (number, disc) in grid.moving.iter().enumerate() {
            let leg = disc.leg(now, body.border, grid.bounds());
            let (_, distance) = closest_approach([leg.at[0] - at[0], leg.at[1] - at[1]], [0.0; 2], 0.0);
            if distance - disc.radius > body.sensor {
                continue;
            }
            let contact = disc.radius + body.radius;
            let margin = contact + body.margin;
            // What touches by construction must not be lost to rounding.
            let hair = CONTACT / 10.0 * grid.cell;
            let keep = [margin.min(distance.max(contact)) - hair, contact - hair];
            self.threats.push(Threat { number, disc: Moving::straight(leg.at, disc.radius, leg.velocity), distance, keep });
        }
    }

    /// Whether the robot overlaps something that it sees: then no motion is safe.
    pub fn overlaps(&self) -> bool {
        self.threats.iter().any(|threat| threat.distance < threat.keep[1])
    }

    /// The first time that a motion comes too near to something, before `horizon`.
    pub fn conflict(&self, stretches: &[Stretch], distance: Distance, horizon: f64, grid: &GridScene, body: &Body) -> Option<Conflict> {
        stretches.iter().take_while(|stretch| stretch.from <= horizon).find_map(|stretch| {
            self.meets(stretch, distance, horizon, grid, body).map(|(time, obstacle)| {
                let place = [0, 1].map(|axis| stretch.at[axis] + (time - stretch.from) * stretch.velocity[axis]);
                Conflict { time, place, obstacle, step: stretch.step }
            })
        })
    }

    /// The first time in a stretch, and which obstacle.
    fn meets(&self, stretch: &Stretch, distance: Distance, horizon: f64, grid: &GridScene, body: &Body) -> Option<(f64, usize)> {
        let until = stretch.until.min(horizon);
        let span = [stretch.from - self.now, until - self.now];
        let first = |threat: &Threat| {
            let keep = threat.keep[usize::from(distance == Distance::Contact)];
            let time = threat.disc.first_within(stretch.at, stretch.velocity, span, keep, body.border, grid.bounds())?;
            Some((self.now + time, threat.number))
        };
        self.threats.iter().filter_map(first).min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Whether a stretch keeps away from everything, as far as the horizon.
    pub fn is_clear(&self, stretch: &Stretch, distance: Distance, horizon: f64, grid: &GridScene, body: &Body) -> bool {
        stretch.from >= horizon || self.meets(stretch, distance, horizon, grid, body).is_none()
    }

    /// Where an obstacle is expected between two times: the corners of its way.
    pub fn range(&self, threat: &Threat, [from, until]: [f64; 2], bounds: Bounds, body: &Body) -> Vec<[f64; 2]> {
        let span = [(from - self.now).max(0.0), (until - self.now).min(body.look_ahead)];
        let stretches = threat.disc.stretches([0.0; 2], [0.0; 2], span, body.border, bounds);
        let legs = stretches.map(|(_, seconds, at, velocity)| [at, [0, 1].map(|axis| at[axis] + seconds * velocity[axis])]);
        let mut corners = Vec::new();
        for [from, to] in legs.take(CORNERS) {
            if corners.is_empty() {
                corners.push(from);
            }
            corners.push(to);
        }
        corners
    }

    /// Half the width of that range: robot and margin are part of it, so that the robot's centre must stay out.
    pub fn width(threat: &Threat, body: &Body) -> f64 {
        threat.disc.radius + body.radius + body.margin
    }

    /// Marks the cells whose centres lie in the predicted range of an obstacle about the time of a conflict: as long before
    /// and after as the robot needs to pass and to turn. (Where it was or will be at other times it is in nobody's way.)
    pub fn occupy(&self, conflict: &Conflict, grid: &GridScene, cells: &Cells, body: &Body, occupied: &mut [bool]) {
        let Some(threat) = self.threats.iter().find(|threat| threat.number == conflict.obstacle) else {
            return;
        };
        let reach = Self::width(threat, body);
        let about = reach / body.speed + body.turn_time;
        let corners = self.range(threat, [conflict.time - about, conflict.time + about], grid.bounds(), body);
        for leg in corners.windows(2) {
            let index = |c: f64, n: usize| ((c / cells.side).floor().max(0.0) as usize).min(n - 1);
            let range = |axis: usize, n: usize| {
                let (low, high) = (leg[0][axis].min(leg[1][axis]) - reach, leg[0][axis].max(leg[1][axis]) + reach);
                // None of it may lie inside.
                let inside = high >= 0.0 && low <= n as f64 * cells.side;
                if inside { index(low, n)..index(high, n) + 1 } else { 0..0 }
            };
            let columns = range(0, cells.columns);
            for row in range(1, cells.rows) {
                for cell in columns.clone().map(|column| row * cells.columns + column) {
                    occupied[cell] |= distance_squared(leg[0], leg[1], cells.centre(cell)) < reach * reach;
                }
            }
        }
    }
}
