//! What the robot decides when its plan will not do.

use std::sync::Arc;

use crate::{kernel::Message, math, message};

use super::{
    body::{Done, Plan, Pose},
    escape::{End, Escape, escape},
    journey::{Hold, Journey},
    route::{Ways, plan, steps},
    world::{Conflict, Distance},
};

/// Seconds between two searches: for a way round while the robot waits, for a safe motion where none was found.
const RETRY: f64 = 0.5;

/// It acts on what is foreseen within this share of its look-ahead, and takes only what is safe for all of it: otherwise it
/// would stop and go as obstacles come and leave at the edge of what it foresees.
const ACT: f64 = 0.75;

/// How many conflicts a way round takes into account at most.
const BLOCKERS: usize = 8;

/// A plan that could be taken.
struct Offer {
    plan: Plan,
    local_goal: Option<usize>,
    end: f64,
}

impl Journey {
    /// Whether the plan will do, and if not, what instead.
    pub fn think(&mut self, ways: &mut Ways) {
        if self.distance == Distance::Contact && self.conflict(Distance::Margin).is_none() {
            self.distance = Distance::Margin;
        }
        match (self.conflict(self.distance), self.hold) {
            (None, None) => self.calm(),
            (None, Some(hold)) => {
                (self.hold, self.cornered, self.evading) = (None, None, false);
                let waited = self.now - hold.since;
                let said = message!("drive-clear", "The way is clear as far as it looks ahead: on after {waited:.1} s.", waited);
                self.tell("go-on", Some(hold.obstacle), said);
            }
            (Some(conflict), Some(hold)) => {
                if self.now >= hold.retry {
                    self.hold = Some(Hold { retry: self.now + RETRY, ..hold });
                    if self.around(ways, self.distance, conflict) {
                        return;
                    }
                }
                if !self.stands(self.distance) {
                    self.hold = None;
                    self.decide(ways, conflict);
                }
            }
            (Some(conflict), None) if conflict.time - self.now > ACT * self.ground.body.look_ahead => {}
            (Some(_), None) if !self.may_search() => {}
            (Some(conflict), None) => {
                // A robot that gives way looks for the best way out all the time: that is one event.
                if self.cornered.is_none() && !self.evading {
                    self.foresee(conflict);
                }
                self.decide(ways, conflict);
            }
        }
    }

    /// Whether it searches in this period: where no safe motion was found only now and then, not while it overlaps something, and at once
    /// when it does so no longer.
    fn may_search(&mut self) -> bool {
        let Some(due) = self.cornered else { return true };
        if self.view.overlaps() {
            self.cornered = Some(f64::INFINITY);
            return false;
        }
        let searches = self.now >= due || due == f64::INFINITY;
        if searches {
            self.cornered = Some(self.now + RETRY);
        }
        searches
    }

    fn calm(&mut self) {
        if self.cornered.is_some() {
            let said = message!("drive-clear-again", "What it means to do is clear again as far as it looks ahead.");
            self.tell("go-on", None, said);
        }
        (self.cornered, self.evading) = (None, false);
    }

    fn foresee(&mut self, conflict: Conflict) {
        let (within, [x, y]) = (conflict.time - self.now, conflict.place);
        let obstacle = conflict.obstacle + 1;
        let said = match self.distance {
            Distance::Margin => message!(
                "drive-foreseen",
                "In {within:.1} s, at ({x:.1}, {y:.1}), obstacle {obstacle} would come nearer than the margin of {margin}.",
                within,
                x,
                y,
                obstacle,
                margin = self.length_of(self.ground.body.margin)
            ),
            Distance::Contact => message!(
                "drive-foreseen-contact",
                "In {within:.1} s, at ({x:.1}, {y:.1}), obstacle {obstacle} would touch it.",
                within,
                x,
                y,
                obstacle
            ),
        };
        self.tell("foreseen", Some(conflict.obstacle), said);
    }

    fn decide(&mut self, ways: &mut Ways, conflict: Conflict) {
        let mut conflict = conflict;
        let (first, mut last) = (self.distance, None);
        for distance in [Distance::Margin, Distance::Contact] {
            if distance == Distance::Margin && first == Distance::Contact {
                continue;
            }
            if distance != first {
                self.distance = distance;
                let number = conflict.obstacle;
                match self.conflict(distance) {
                    None => {
                        let said = message!(
                            "drive-squeeze",
                            "No way keeps the margin from obstacle {obstacle}: on as planned, which does not touch it.",
                            obstacle = number + 1
                        );
                        self.tell("squeeze", Some(number), said);
                        return;
                    }
                    Some(other) => conflict = other,
                }
            }
            if self.around(ways, distance, conflict) || self.wait(distance, conflict) {
                return;
            }
            if !ways.knows_ahead(&self.ground) {
                return;
            }
            self.searches += 1;
            let found = escape(&self.view, distance, &self.pose, &self.ground);
            if found.end == End::Safe && self.evade(ways, &found, conflict) {
                return;
            }
            last = Some(found);
        }
        if let Some(found) = last {
            self.put_off(ways, &found, conflict);
        }
    }

    /// The first conflict of the plan as far as it looks ahead.
    fn conflict(&mut self, distance: Distance) -> Option<Conflict> {
        let (pose, plan) = (self.pose, std::mem::take(&mut self.plan));
        let conflict = self.conflict_of(pose, &plan, distance);
        self.plan = plan;
        conflict
    }

    fn conflict_of(&mut self, mut pose: Pose, plan: &Plan, distance: Distance) -> Option<Conflict> {
        let body = &self.ground.body;
        let horizon = self.now + body.look_ahead;
        let (stretches, mut done) = (&mut self.stretches, plan.done);
        stretches.clear();
        pose.follow(&plan.steps, &mut done, body, [self.now, horizon], &mut |stretch| stretches.push(stretch));
        self.view.conflict(stretches, distance, horizon, &self.ground.grid, body)
    }

    /// Whether it may stand where it is as far as it looks ahead.
    fn stands(&self, distance: Distance) -> bool {
        let horizon = self.now + self.ground.body.look_ahead;
        self.view.is_clear(&self.standing(horizon), distance, horizon, &self.ground.grid, &self.ground.body)
    }

    /// The cells that it can go to next: on to the middle ahead of it, or back.
    fn origins(&self) -> impl Iterator<Item = usize> + use<> {
        let [behind, ahead] = self.pose.between;
        [Some(ahead), (behind != ahead).then_some(behind)].into_iter().flatten()
    }

    /// A detour, or else a new way, that keeps away from everything: the one that is at the goal first.
    fn around(&mut self, ways: &mut Ways, distance: Distance, conflict: Conflict) -> bool {
        let rest: Vec<usize> = self.plan.left().iter().map(|step| step.cell).collect();
        for detour in [true, false] {
            let mut blockers = vec![conflict];
            for _ in 0..BLOCKERS {
                self.occupy(&blockers);
                let (mut best, mut other): (Option<Offer>, _) = (None, None);
                for origin in self.origins() {
                    let Some((way, local_goal)) = self.way(ways, origin, detour.then_some((&rest[..], conflict.step))) else {
                        continue;
                    };
                    let plan = plan(&self.ground.cells, &self.ground.endpoints, &way);
                    if let Some(next) = self.conflict_of(self.pose, &plan, distance) {
                        other = other.or(Some(next));
                        continue;
                    }
                    let (mut pose, mut done) = (self.pose, Done::default());
                    let span = [self.now, f64::INFINITY];
                    let end = pose.follow(&plan.steps, &mut done, &self.ground.body, span, &mut |_| {});
                    if best.as_ref().is_none_or(|best| end < best.end) {
                        best = Some(Offer { plan, local_goal, end });
                    }
                }
                if let Some(offer) = best {
                    self.take(offer, detour, &blockers);
                    return true;
                }
                match other {
                    Some(other) => blockers.push(other),
                    None => break,
                }
            }
        }
        false
    }

    /// Marks the predicted ranges of what is in the way.
    fn occupy(&mut self, blockers: &[Conflict]) {
        let ground = Arc::clone(&self.ground);
        self.occupied.fill(false);
        for conflict in blockers {
            self.view.occupy(conflict, &ground.grid, &ground.cells, &ground.body, &mut self.occupied);
        }
    }

    /// A way from a cell to the goal round the occupied cells. `along`: the cells of the planned way that are left, and the
    /// one at which it meets an obstacle; then the way comes back to the first free one beyond it.
    fn way(&self, ways: &mut Ways, origin: usize, along: Option<(&[usize], usize)>) -> Option<(Vec<usize>, Option<usize>)> {
        let Some((rest, met)) = along else {
            return Some((ways.replan(&self.occupied, origin)?, None));
        };
        let beyond = (met + 1..rest.len()).find(|&i| !self.occupied[rest[i]])?;
        let mut way = ways.detour(&self.occupied, origin, rest[beyond])?;
        way.extend(&rest[beyond + 1..]);
        // Where the detour meets what is left of the planned way elsewhere, what is in between is no way to anywhere.
        let way = without_loops(&way);
        let local_goal = Some(rest[beyond]).filter(|goal| way.contains(goal));
        Some((way, local_goal))
    }

    fn take(&mut self, offer: Offer, detour: bool, blockers: &[Conflict]) {
        let mut blockers: Vec<_> = blockers.iter().map(|conflict| conflict.obstacle).collect();
        math::sort_indices(&mut blockers);
        blockers.dedup();
        self.calm();
        (self.plan, self.local_goal, self.hold) = (offer.plan, offer.local_goal, None);
        if detour {
            self.tally.detours += 1;
            let said = self.detour(&blockers, offer.local_goal.map(|goal| self.ground.cells.centre(goal)));
            self.tell("detour", Some(blockers[0]), said);
        } else {
            self.tally.replans += 1;
            let said = message!(
                "drive-replan",
                "A new way to the goal round the predicted range of {obstacles} {numbers}; {length} to go.",
                obstacles = blockers.len() => "obstacle" | "obstacles",
                numbers = list(&blockers),
                length = self.length_of(self.left())
            );
            self.tell("replan", Some(blockers[0]), said);
        }
    }

    /// What a detour goes round and where it leads.
    fn detour(&self, blockers: &[usize], local_goal: Option<[f64; 2]>) -> Message {
        let (n, numbers, length) = (blockers.len(), list(blockers), self.length_of(self.left()));
        if let Some([x, y]) = local_goal {
            message!(
                "drive-detour",
                "Round the predicted range of {obstacles} {numbers} along the pheromone to a local goal at ({x:.1}, {y:.1}); {length} to go.",
                obstacles = n => "obstacle" | "obstacles",
                numbers,
                x,
                y,
                length
            )
        } else {
            message!(
                "drive-detour-way",
                "Round the predicted range of {obstacles} {numbers} along the pheromone to the planned way; {length} to go.",
                obstacles = n => "obstacle" | "obstacles",
                numbers,
                length
            )
        }
    }

    fn wait(&mut self, distance: Distance, conflict: Conflict) -> bool {
        let safe = self.stands(distance);
        if safe {
            self.hold = Some(Hold { since: self.now, obstacle: conflict.obstacle, retry: self.now + RETRY });
            self.calm();
            self.tally.waits += 1;
            let said = message!(
                "drive-wait",
                "There is no safe way round obstacle {obstacle} now: it stands until the way is clear.",
                obstacle = conflict.obstacle + 1
            );
            self.tell("wait", Some(conflict.obstacle), said);
        }
        safe
    }

    fn evade(&mut self, ways: &mut Ways, found: &Escape, conflict: Conflict) -> bool {
        let taken = self.follow(ways, found);
        if taken {
            self.cornered = None;
            if !std::mem::replace(&mut self.evading, true) {
                self.tally.escapes += 1;
                let said = message!(
                    "drive-evade",
                    "Standing is not safe from obstacle {obstacle} either: it gets out of its way.",
                    obstacle = conflict.obstacle + 1
                );
                self.tell("evade", Some(conflict.obstacle), said);
            }
        }
        taken
    }

    /// Nothing is safe: what is so for longest.
    fn put_off(&mut self, ways: &mut Ways, found: &Escape, conflict: Conflict) {
        if self.cornered.is_none() {
            self.cornered = Some(if self.view.overlaps() { f64::INFINITY } else { self.now + RETRY });
            let obstacle = conflict.obstacle + 1;
            let said = match found.end {
                End::GaveUp(states) => message!(
                    "drive-gave-up",
                    "The search for a safe motion gave up at its limit of {states} states: the robot takes the motion that delays a collision with obstacle {obstacle} longest.",
                    obstacle,
                    states
                ),
                End::Safe | End::Nothing => message!(
                    "drive-cornered",
                    "No safe motion was found: the robot takes the one that delays a collision with obstacle {obstacle} longest.",
                    obstacle
                ),
            };
            self.tell("cornered", Some(conflict.obstacle), said);
        }
        self.follow(ways, found);
    }

    /// Takes the steps of an escape, and from their end the way to the goal.
    fn follow(&mut self, ways: &mut Ways, found: &Escape) -> bool {
        let mut all = found.steps.clone();
        let from = all.last().map_or(self.pose.between[1], |step| step.cell);
        self.occupied.fill(false);
        let Some(way) = ways.replan(&self.occupied, from) else {
            return false;
        };
        all.extend(steps(&self.ground.cells, &self.ground.endpoints, &way));
        (self.plan, self.local_goal, self.hold) = (Plan::new(all), None, None);
        true
    }
}

/// A way that comes to no cell twice: from where it does it goes on as it does the last time.
fn without_loops(way: &[usize]) -> Vec<usize> {
    let mut out: Vec<usize> = Vec::with_capacity(way.len());
    let mut i = 0;
    while i < way.len() {
        i = way.iter().rposition(|&cell| cell == way[i]).unwrap_or(i);
        out.push(way[i]);
        i += 1;
    }
    out
}

/// Obstacles as people count them, with commas between.
fn list(numbers: &[usize]) -> String {
    numbers.iter().map(|number| (number + 1).to_string()).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_are_left_out() {
        assert_eq!(without_loops(&[1, 2, 3, 4, 2, 5, 6, 5, 7]), [1, 2, 5, 7]);
        assert_eq!(without_loops(&[1, 1, 2]), [1, 2]);
        assert_eq!(without_loops(&[1, 2, 3]), [1, 2, 3]);
    }
}
