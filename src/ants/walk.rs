//! An ant's way: where it may go, what it chooses, where it ends.

use crate::{
    geometry::Steps,
    kernel::{State, rng::Stream},
};

use super::{
    ground::{Ground, NOWHERE},
    pheromone::Pheromone,
};

/// How an ant's walk ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
pub(super) enum End {
    /// At the goal.
    Arrived,
    /// In a dead end.
    Stuck,
    /// At the step limit.
    Lost,
}

/// One ant of an iteration.
#[derive(Debug, Clone, State)]
pub(super) struct Ant {
    /// Where its directions begin in [`Walks`], and how many there are.
    first: usize,
    count: usize,
    pub end: End,
    /// The length of its way, in the scene's unit, if it arrived.
    pub length: f64,
    /// Δτ of its way.
    pub laid: f64,
    /// The same for ants that went the same way, and hardly ever for others.
    pub way: u64,
    /// Its directions were not kept: the random numbers with which it goes the same way again.
    pub again: Option<Stream>,
}

/// The walks of an iteration's ants, a byte a step, as far as they are kept.
#[derive(Debug, Clone, Default, State)]
pub(super) struct Walks {
    directions: Vec<u8>,
    pub ants: Vec<Ant>,
    /// Steps taken by all ants so far, those taken back included.
    pub taken: u64,
}

impl Walks {
    pub fn clear(&mut self) {
        self.directions.clear();
        self.ants.clear();
    }

    /// Forgets the last ant's directions if there are more than `most` in all, so that the memory does not grow with the
    /// ants. With the random numbers that it began with it goes the same way again when that is asked for.
    pub fn forget(&mut self, most: usize, begun: Stream) {
        if self.directions.len() > most
            && let Some(ant) = self.ants.last_mut()
        {
            self.directions.truncate(ant.first);
            (ant.count, ant.again) = (0, Some(begun));
        }
    }

    /// An ant's directions from the start on; none if they are forgotten.
    pub fn of(&self, ant: &Ant) -> &[u8] {
        &self.directions[ant.first..ant.first + ant.count]
    }

    #[cfg(test)]
    pub fn push_for_test(&mut self, directions: &[u8], length: f64) {
        let (first, count) = (self.directions.len(), directions.len());
        self.directions.extend(directions);
        let way = fold(directions);
        self.ants.push(Ant { first, count, end: End::Arrived, length, laid: 0.0, way, again: None });
    }

    pub fn arrived(&self) -> impl Iterator<Item = &Ant> {
        self.ants.iter().filter(|ant| ant.end == End::Arrived)
    }

    /// Whether there is anything to lay on: start and goal may be one cell.
    pub fn leads_anywhere(&self) -> bool {
        self.arrived().any(|ant| ant.length > 0.0)
    }
}

/// The cells that the ant under way has seen: a mark for each cell, none to be wiped off between ants.
#[derive(Debug, Clone, State)]
pub(super) struct Seen {
    mark: Vec<u32>,
    ant: u32,
}

impl Seen {
    pub fn new(cells: usize) -> Self {
        Self { mark: vec![0; cells], ant: 0 }
    }

    fn begin(&mut self) {
        if self.ant == u32::MAX {
            self.mark.fill(0);
            self.ant = 0;
        }
        self.ant += 1;
    }
}

/// What holds for all ants.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rules {
    /// An ant in a dead end goes back instead of staying there.
    pub backtracks: bool,
    /// The most steps it takes.
    pub limit: u64,
}

/// One ant from the start as far as it comes. It never enters a cell twice. `greed` is q0: how often it takes the best
/// step instead of drawing one.
pub(super) fn walk(
    ground: &Ground,
    pheromone: &mut Pheromone,
    rules: Rules,
    greed: f64,
    seen: &mut Seen,
    rng: &mut Stream,
    walks: &mut Walks,
) {
    let cells = &*ground.cells;
    let first = walks.directions.len();
    let (mut cell, mut from, mut taken) = (ground.endpoints.start, NOWHERE, 0);
    seen.begin();
    seen.mark[cell] = seen.ant;
    let end = loop {
        if cell == ground.endpoints.goal {
            break End::Arrived;
        }
        if taken >= rules.limit {
            break End::Lost;
        }
        let mut allowed = cells.moves(cell);
        for d in directions(allowed) {
            if seen.mark[cells.next(cell, d)] == seen.ant {
                allowed &= !(1 << d);
            }
        }
        if allowed == 0 {
            if !rules.backtracks || walks.directions.len() == first {
                break End::Stuck;
            }
            taken += 1;
            // Back to where it came from; the dead end stays marked.
            cell = cells.next(cell, from ^ 4);
            walks.directions.pop();
            from = walks.directions[first..].last().map_or(NOWHERE, |&d| usize::from(d));
            continue;
        }
        let d = choose(pheromone.weights(ground, cell), &ground.turn[from], allowed, greed, rng.unit());
        taken += 1;
        cell = cells.next(cell, d);
        seen.mark[cell] = seen.ant;
        walks.directions.push(d as u8);
        from = d;
    };
    walks.taken += taken;
    let count = walks.directions.len() - first;
    let steps = walks.directions[first..].iter().fold(Steps::default(), |steps, &d| steps.and(usize::from(d)));
    let length = ground.endpoints.length(cells, steps);
    let way = fold(&walks.directions[first..]);
    walks.ants.push(Ant { first, count, end, length, laid: 0.0, way, again: None });
}

/// A number for a way: FNV-1a over its directions.
fn fold(directions: &[u8]) -> u64 {
    directions.iter().fold(0xcbf2_9ce4_8422_2325, |sum, &d| (sum ^ u64::from(d)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// [ANTBAT](crate#papers) (3), [WOLF-ANT](crate#papers) (4): each allowed step with the probability of its share of the
/// weights; with probability `greed` the heaviest (the first of them). `u` is uniform in [0, 1) and decides both.
#[inline]
pub(super) fn choose(weights: &[f64; 8], turn: &[f64; 8], allowed: u8, greed: f64, u: f64) -> usize {
    let mut sum = 0.0;
    let mut sums = [0.0; 8];
    for d in directions(allowed) {
        sum += weights[d] * turn[d];
        sums[d] = sum;
    }
    let last = 7 - (allowed.leading_zeros() as usize & 7);
    if u < greed {
        let share = |d: usize| weights[d] * turn[d];
        return directions(allowed).reduce(|best, d| if share(d) > share(best) { d } else { best }).unwrap_or(last);
    }
    // What is left of u is uniform again.
    let u = if greed > 0.0 { (u - greed) / (1.0 - greed) } else { u };
    if sum <= 0.0 {
        // Nothing attracts: all alike.
        let skip = (u * f64::from(allowed.count_ones())) as usize;
        return directions(allowed).nth(skip).unwrap_or(last);
    }
    let at = u * sum;
    directions(allowed).find(|&d| at < sums[d]).unwrap_or(last)
}

/// The directions whose bits are set.
#[inline]
fn directions(mut mask: u8) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let next = (mask != 0).then(|| mask.trailing_zeros() as usize);
        mask &= mask.wrapping_sub(1);
        next
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_has_its_share_of_the_unit_interval() {
        // Weights 1, 2 and 5 in directions 0, 3 and 6; turns leave 1, 1/2 and 1/5: shares of a third each.
        let (mut weights, mut turn) = ([0.0; 8], [9.0; 8]);
        (weights[0], weights[3], weights[6]) = (1.0, 2.0, 5.0);
        (turn[0], turn[3], turn[6]) = (1.0, 0.5, 0.2);
        let pick = |allowed, greed, u| choose(&weights, &turn, allowed, greed, u);
        assert_eq!([0.0, 0.33, 0.34, 0.66, 0.67, 0.999_999].map(|u| pick(0b0100_1001, 0.0, u)), [0, 0, 3, 3, 6, 6]);
        assert_eq!([0.0, 0.49, 0.51].map(|u| pick(0b0000_1001, 0.0, u)), [0, 0, 3], "what is not allowed has no share");
        assert_eq!([0.0, 0.39].map(|u| pick(0b0100_1001, 0.4, u)), [0, 0], "greedy: the first of the heaviest");
        assert_eq!([0.41, 0.59, 0.61, 0.99].map(|u| pick(0b0100_1001, 0.4, u)), [0, 0, 3, 6], "the rest in the same shares");
        assert_eq!([0.0, 0.49, 0.51, 0.99].map(|u| pick(0b0000_0110, 0.0, u)), [1, 1, 2, 2], "nothing attracts: all alike");
        assert_eq!(pick(0b1000_0000, 1.0, 0.5), 7);
    }
}
