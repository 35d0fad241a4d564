//! The postures that are smoothest on the whole. Where the tool may point anywhere, first a way is looked for through
//! postures at some points of the path, a few per cent of the arm's reach apart, with the hand turning evenly in between and
//! every move tested; then its hand is drawn taut. Where that finds nothing, and where the tool's orientation is
//! given, the way goes through the postures of every point, and points without any are replaced as the paper does.

use crate::arm::{Posture, squared};

use super::{
    course::{Station, keys},
    follow::{Followed, Pointing, Postures, Stop, evenly, mirrored},
    search::{Layer, Move, cheapest},
};

/// How far apart the points are that a way is looked for through first: shares of the arm's reach.
const APART: [f64; 3] = [0.1, 0.05, 0.025];
/// The farthest that a joint turns from one point to the next, in radians, so that the tip keeps to the path.
const STEP: f64 = 0.35;
/// How often the hand is drawn taut.
const SWEEPS: usize = 4;
/// How many moves are tested for the best way, and for one at most [`GREED`] times as costly.
const TESTS: [usize; 2] = [1500, 20_000];
/// What the second search may waste.
const GREED: f64 = 4.0;
/// How many pairs of neighbouring postures are compared at most where all points are looked at.
const PAIRS: f64 = 2e7;

impl Postures<'_> {
    /// The postures whose joints turn most gently on the whole, among those that touch nothing on the way.
    pub(super) fn smoothest(&mut self, stations: &[Station]) -> Followed {
        if matches!(self.pointing, Pointing::Free) {
            for apart in APART {
                let keys = keys(stations, apart * self.links.reach());
                if let Some(stops) = self.through(stations, &keys) {
                    return Followed { stops, ..Followed::default() };
                }
            }
        }
        self.through_all(stations)
    }

    /// A way through postures at some points, with a posture for every point. `None` if one of them has no posture that
    /// touches nothing, or no moves between them are free.
    fn through(&self, stations: &[Station], keys: &[usize]) -> Option<Vec<Stop>> {
        let home = self.arm().home();
        let mut layers = Vec::with_capacity(keys.len());
        for &station in keys {
            let postures = self.safe(station, stations[station].at, &self.hands, &home);
            if postures.is_empty() {
                return None;
            }
            layers.push(Layer { station, along: stations[station].along, postures });
        }
        let span = |k: usize| &stations[keys[k]..=keys[k + 1]];
        let test = |k: usize, from: &Posture, to: &Posture| {
            if self.turns_evenly(span(k), from, to, |_| {}) { Move::Allowed } else { Move::Impossible }
        };
        let way = cheapest(&layers, 1.0, TESTS[0], test).or_else(|| cheapest(&layers, GREED, TESTS[1], test))?;
        let mut chosen: Vec<_> = layers.iter().zip(way).map(|(layer, i)| layer.postures[i]).collect();
        for _ in 0..SWEEPS {
            self.draw_taut(stations, keys, &mut chosen);
        }
        let mut postures = vec![*chosen.first()?];
        for k in 0..keys.len() - 1 {
            self.turns_evenly(span(k), &chosen[k], &chosen[k + 1], |posture| postures.push(posture));
        }
        Some(stations.iter().zip(postures).map(|(&station, posture)| Stop { station, posture }).collect())
    }

    /// From one posture to another with the tip on the path and the hand turning evenly: calls `each` with the posture at each
    /// point after the first. Whether that can be done, in small steps and without touching anything.
    fn turns_evenly(&self, span: &[Station], from: &Posture, to: &Posture, mut each: impl FnMut(Posture)) -> bool {
        let (begun, last) = (span[0].along, span.len() - 1);
        let way = span[last].along - begun;
        let mut before = *from;
        for (i, station) in (1..).zip(&span[1..]) {
            let guess = evenly(from, to, (station.along - begun) / way);
            let hand = || self.holding.hand([guess[3], guess[4], guess[5]]);
            let next = if i == last { Some(*to) } else { self.holding.nearest(&hand(), station.at, &guess) };
            let Some(next) = next.filter(|next| next.iter().zip(before).all(|(a, b)| (a - b).abs() <= STEP)) else {
                return false;
            };
            if !self.is_free(&before, &next) {
                return false;
            }
            each(next);
            before = next;
        }
        true
    }

    /// Moves each posture's hand to the middle between its neighbours' (or half as far), where that makes the joints turn more
    /// gently and the moves stay free.
    fn draw_taut(&self, stations: &[Station], keys: &[usize], chosen: &mut [Posture]) {
        for k in 0..chosen.len() {
            let (before, after) = (k.checked_sub(1), Some(k + 1).filter(|&after| after < chosen.len()));
            let neighbours: Vec<_> =
                before.into_iter().chain(after).map(|i| (i, (stations[keys[i]].along - stations[keys[k]].along).abs())).collect();
            let cost = |posture: &Posture| neighbours.iter().map(|&(i, way)| squared(posture, &chosen[i]) / way).sum::<f64>();
            let weight: f64 = neighbours.iter().map(|(_, way)| 1.0 / way).sum();
            let middle: [f64; 3] = std::array::from_fn(|j| neighbours.iter().map(|&(i, way)| chosen[i][3 + j] / way).sum::<f64>() / weight);
            let here = chosen[k];
            let better = [1.0, 0.5].into_iter().find_map(|share| {
                let hand = self.holding.hand(std::array::from_fn(|j| here[3 + j] + share * (middle[j] - here[3 + j])));
                let moved = self.holding.nearest(&hand, stations[keys[k]].at, &here)?;
                let free = |from: usize, a: &Posture, b: &Posture| self.turns_evenly(&stations[keys[from]..=keys[from + 1]], a, b, |_| {});
                (cost(&moved) < cost(&here) * (1.0 - 1e-6)
                    && before.is_none_or(|before| free(before, &chosen[before], &moved))
                    && after.is_none_or(|after| free(k, &moved, &chosen[after])))
                .then_some(moved)
            });
            chosen[k] = better.unwrap_or(here);
        }
    }

    /// A way through the postures of all points: one that touches nothing if there is any, with the paper's replacements.
    fn through_all(&mut self, stations: &[Station]) -> Followed {
        let mut followed = Followed::default();
        let (layers, mirrors) = self.layers(stations);
        let (Some(first), Some(last)) = (layers.first(), layers.last()) else {
            return followed.end(self, stations, 0);
        };
        if first.station > 0 {
            return followed.end(self, stations, 0);
        }
        let reached = last.station;
        followed.mirrored = mirrors;
        let test = |_: usize, from: &Posture, to: &Posture| if self.is_free(from, to) { Move::Allowed } else { Move::Reluctant };
        let way = cheapest(&layers, 1.0, TESTS[1], test)
            .or_else(|| cheapest(&layers, GREED, TESTS[1], test))
            .or_else(|| cheapest(&layers, 1.0, usize::MAX, |_, _, _| Move::Allowed));
        let postures: Vec<_> = way.into_iter().flatten().zip(&layers).map(|(i, layer)| (layer.station, layer.postures[i])).collect();
        let mut next = postures.iter();
        for (i, &station) in stations[..=reached].iter().enumerate() {
            let rest = next.as_slice();
            let posture = match (rest.first(), followed.stops.last()) {
                (Some((at, posture)), _) if *at == i => {
                    next.next();
                    Some(*posture)
                }
                (Some((_, after)), Some(before)) => self.draw(&before.posture, after).inspect(|_| followed.drawn += 1),
                _ => None,
            };
            let Some(posture) = posture else {
                return followed.end(self, stations, i);
            };
            followed.stops.push(Stop { station, posture });
        }
        if reached + 1 < stations.len() { followed.end(self, stations, reached + 1) } else { followed }
    }

    /// The postures of all points that have any, and how many of these points had to be mirrored.
    fn layers(&self, stations: &[Station]) -> (Vec<Layer>, u64) {
        let home = self.arm().home();
        // A hand has two postures, more or less.
        let most = (PAIRS / stations.len().max(1) as f64).sqrt() / 2.0;
        let stride = (self.hands.len() as f64 / most).ceil().max(1.0) as usize;
        let hands: Vec<_> = self.hands.iter().copied().step_by(stride).collect();
        let (mut layers, mut mirrors) = (Vec::new(), 0);
        for (i, station) in stations.iter().enumerate() {
            let mut postures = self.safe(i, station.at, &hands, &home);
            if let (true, true, Some(after)) = (postures.is_empty(), i > 0, stations.get(i + 1).filter(|_| self.replaces)) {
                postures = self.safe(i, mirrored(stations[i - 1].at, station.at, after.at), &hands, &home);
                mirrors += u64::from(!postures.is_empty());
            }
            if !postures.is_empty() {
                layers.push(Layer { station: i, along: station.along, postures });
            }
        }
        (layers, mirrors)
    }
}
