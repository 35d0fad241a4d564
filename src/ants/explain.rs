//! Why an ant would go where, and what one has laid.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Mark, Quantity, Shape, rng::Stream},
    label, math, message,
    scene::grid::words,
};

use super::{
    colony::Colony,
    ground::{Direction, Ground, Heuristic, NOWHERE, theta1},
    update::Update,
    walk::{Ant, End},
};

/// A cell as an ant sees it that comes there now: as the best way so far does, if that leads through the cell; otherwise
/// it starts there.
struct View<'a> {
    colony: &'a Colony,
    ground: &'a Ground,
    cell: usize,
    /// The direction in which it comes.
    from: usize,
    allowed: u8,
    eta: [f64; 8],
    /// τ^α η^β ψ^γ; 0 for what is not allowed.
    weight: [f64; 8],
    sum: f64,
    /// The direction of a step counts, [ANTBAT](crate#papers) (2).
    directed: bool,
}

/// What can be left out of the product by which an ant chooses.
const PHEROMONE: Label = label!("ants-without-pheromone", "pheromone", "\\alpha = 0", "without pheromone");
const SIGHT: Label = label!("ants-without-sight", "sight", "\\beta = 0", "without sight");
const DIRECTION: Label = label!("ants-without-direction", "direction", "\\gamma = 0", "without direction");

/// The product for a step without one of its factors.
#[inline(never)]
fn weight_without(colony: &Colony, cell: usize, [from, to]: [usize; 2], without: &str) -> f64 {
    let ground = &*colony.ground;
    let pull = if without == PHEROMONE.name { 1.0 } else { colony.pheromone.pull(cell, to) };
    let seen = if without == SIGHT.name { 1.0 } else { ground.beta.of(ground.eta(cell)[to]) };
    let angles = ground.direction.exponent(theta1(from, to)) + ground.direction.exponent(ground.theta2(cell, to));
    pull * seen * if without == DIRECTION.name { 1.0 } else { math::exp(-ground.gamma * angles) }
}

impl<'a> View<'a> {
    fn new(colony: &'a Colony, cell: usize, without: Option<&str>) -> Self {
        let ground = &*colony.ground;
        let (from, behind) = arrival(colony, cell);
        // Where it has been it does not go again.
        let open = |d: usize| !behind.contains(&ground.cells.next(cell, d));
        let moves = ground.cells.moves(cell);
        let allowed = (0..8).filter(|&d| moves >> d & 1 != 0 && open(d)).fold(0, |mask, d| mask | 1 << d);
        let eta = ground.eta(cell);
        let known = colony.pheromone.look(ground, cell);
        let mut weight = [0.0; 8];
        for d in (0..8).filter(|&d| allowed >> d & 1 != 0) {
            weight[d] = match without {
                None => known[d] * ground.turn[from][d],
                Some(without) => weight_without(colony, cell, [from, d], without),
            };
        }
        Self {
            colony,
            ground,
            cell,
            from,
            allowed,
            eta,
            weight,
            sum: weight.iter().sum(),
            directed: colony.variant.gamma != 0.0 || matches!(colony.variant.update, Update::Reward { .. }),
        }
    }

    fn allows(&self, d: usize) -> bool {
        self.allowed >> d & 1 != 0
    }

    /// The probability of a step.
    fn share(&self, d: usize) -> f64 {
        if !self.allows(d) {
            0.0
        } else if self.sum > 0.0 {
            self.weight[d] / self.sum
        } else {
            1.0 / f64::from(self.allowed.count_ones())
        }
    }

    fn tau(&self, d: usize) -> f64 {
        self.colony.pheromone.tau(self.cell, d)
    }

    /// θ1, θ2 and ψ, [ANTBAT](crate#papers) (2).
    fn direction(&self, d: usize) -> [f64; 3] {
        let (turn, off) = (theta1(self.from, d), self.ground.theta2(self.cell, d));
        let law = self.ground.direction;
        [turn, off, math::exp(-(law.exponent(turn) + law.exponent(off)))]
    }

    fn likeliest(&self) -> Option<usize> {
        (0..8).filter(|&d| self.allows(d)).max_by(|&a, &b| self.share(a).total_cmp(&self.share(b)))
    }

    fn columns(&self) -> Vec<Label> {
        let mut columns = vec![label!("ants-pheromone", "tau", "\\tau", "pheromone"), label!("ants-sight", "eta", "\\eta", "sight")];
        if self.directed {
            columns.extend([
                label!("ants-turn", "theta1", "\\theta_1", "turn, radians"),
                label!("ants-off-goal", "theta2", "\\theta_2", "off the goal, radians"),
                label!("ants-direction", "psi", "\\psi", "direction"),
            ]);
        }
        columns.push(label!("ants-probability", "p", "p", "probability"));
        columns
    }

    fn row(&self, d: usize) -> Vec<f64> {
        let [theta1, theta2, psi] = self.direction(d);
        let mut row = if self.allows(d) { vec![self.tau(d), self.eta[d]] } else { vec![0.0; 2] };
        if self.directed {
            row.extend([theta1, theta2, if self.allows(d) { psi } else { 0.0 }]);
        }
        row.push(self.share(d));
        row
    }

    /// What the formulas need for a step.
    fn values(&self, d: usize) -> Vec<Quantity> {
        let ground = self.ground;
        let mut values = vec![
            label!("ants-likeliest", "p", "p", "probability of the likeliest step").is(self.share(d)),
            label!("ants-its-pheromone", "tau", "\\tau", "its pheromone").is(self.tau(d)),
            label!("ants-its-sight", "eta", "\\eta", "its sight").is(self.eta[d]),
            label!("ants-sum", "sum", "\\Sigma", "the sum over all steps").is(self.sum),
            label!("ants-weight-of-pheromone", "alpha", "\\alpha", "weight of pheromone").is(self.colony.pheromone.exponent()),
            label!("ants-weight-of-sight", "beta", "\\beta", "weight of sight").is(ground.beta.exponent),
        ];
        if self.directed {
            let [theta1, theta2, psi] = self.direction(d);
            values.extend([
                label!("ants-its-direction", "psi", "\\psi", "its direction").is(psi),
                label!("ants-its-turn", "theta1", "\\theta_1", "its turn, radians").is(theta1),
                label!("ants-its-off-goal", "theta2", "\\theta_2", "its angle off the goal, radians").is(theta2),
                label!("ants-weight-of-direction", "gamma", "\\gamma", "weight of direction").is(ground.gamma),
            ]);
        }
        match ground.heuristic {
            Heuristic::Ranked { epsilon } => values.extend([
                label!("ants-unit-of-sight", "epsilon", "\\varepsilon", "unit of sight").is(epsilon),
                label!("ants-its-rank", "rank", "\\eta / \\varepsilon", "its rank").is(if epsilon > 0.0 {
                    self.eta[d] / epsilon
                } else {
                    0.0
                }),
            ]),
            Heuristic::Distance => values.push(label!("ants-to-goal", "d", "d", "from there to the goal, cells").is(1.0 / self.eta[d])),
            Heuristic::Own(_) => {}
        }
        values
    }

    fn formulas(&self) -> Vec<&'static str> {
        let mut formulas = vec!["choice"];
        formulas.extend(match self.ground.heuristic {
            Heuristic::Distance => Some("distance"),
            Heuristic::Ranked { .. } => Some("ranked"),
            Heuristic::Own(_) => None,
        });
        if self.directed {
            formulas.push(if self.ground.direction == Direction::Squared { "direction" } else { "direction_linear" });
        }
        formulas
    }

    /// A step as it is drawn.
    fn segment(&self, d: usize) -> [[f64; 2]; 2] {
        [self.cell, self.ground.cells.next(self.cell, d)].map(|cell| self.ground.cells.centre(cell))
    }

    /// The way that leads here, the steps that are likely, the likeliest, and how far it is from there to the goal.
    fn marks(&self, chosen: usize) -> Vec<Mark> {
        let ground = self.ground;
        let likely = (0..8).filter(|&d| self.share(d) > 0.001).flat_map(|d| self.segment(d)).collect();
        let [_, there] = self.segment(chosen);
        let mut marks = vec![
            Mark::plane(layers::CANDIDATES.key, Shape::Segments, likely),
            Mark::plane(layers::STEP.key, Shape::Segments, self.segment(chosen).to_vec()),
        ];
        if self.directed || !matches!(ground.heuristic, Heuristic::Own(_)) {
            marks.push(Mark::plane(layers::TO_GOAL.key, Shape::Segments, vec![there, ground.cells.centre(ground.endpoints.goal)]));
        }
        if self.from != NOWHERE {
            let way = self.colony.best.iter().flat_map(|best| ground.way(&best.directions)).take_while(|&cell| cell != self.cell);
            let path = way.chain([self.cell]).map(|cell| ground.cells.centre(cell)).collect();
            marks.push(Mark::plane(layers::WAY.key, Shape::Polyline, path));
        }
        marks
    }

    /// What can be left out of the product.
    fn suppositions(&self) -> Vec<Label> {
        let exponents = [self.colony.pheromone.exponent(), self.ground.beta.exponent, self.ground.gamma];
        [PHEROMONE, SIGHT, DIRECTION].into_iter().zip(exponents).filter(|&(_, exponent)| exponent != 0.0).map(|(label, _)| label).collect()
    }
}

/// The eight neighbours of a cell with τ, η, ψ and the probability of each; one of the three may be left out.
pub(super) fn cell(colony: &Colony, item: Item, without: Option<&str>) -> Option<Inspection> {
    let cells = &*colony.ground.cells;
    if item.index >= cells.len() {
        return None;
    }
    let view = View::new(colony, item.index, without);
    let likeliest = view.likeliest();
    let (event, summary) = match likeliest {
        _ if !cells.is_free(item.index) => ("blocked", message!("ants-cell-blocked", "No ant comes here: the cell is blocked.")),
        _ if item.index == colony.ground.endpoints.goal => ("goal", message!("ants-cell-goal", "This is the goal: an ant ends here.")),
        None => ("blocked", message!("ants-cell-no-way", "There is no way on from here.")),
        Some(d) => {
            let (to, share) = (words::compass(cells, d), 100.0 * view.share(d));
            let summary = match view.from {
                NOWHERE => {
                    message!("ants-cell-start", "An ant starting here would most likely go {to}: {share:.1} %.", to, share)
                }
                from => message!(
                    "ants-cell-choice",
                    "An ant coming from the {from}, as the best way does, would most likely go {to}: {share:.1} %.",
                    from = words::compass(cells, from ^ 4),
                    to,
                    share
                ),
            };
            ("choice", summary)
        }
    };
    let choice = likeliest.filter(|_| event == "choice");
    Some(Inspection {
        values: choice.map_or(Vec::new(), |d| view.values(d)),
        formulas: choice.map_or(Vec::new(), |_| view.formulas()),
        columns: view.columns(),
        labels: (0..8).map(|d| words::compass(cells, d)).collect(),
        rows: (0..8).map(|d| view.row(d)).collect(),
        marks: choice.map_or(Vec::new(), |d| match without {
            None => view.marks(d),
            Some(_) => vec![Mark::plane(layers::JUMP.key, Shape::Segments, view.segment(d).to_vec())],
        }),
        suppositions: choice.map_or(Vec::new(), |_| view.suppositions()),
        ..Inspection::new(item, words::cell(cells, item.index), event, summary)
    })
}

/// The direction in which the best way comes to a cell, and the cells that it comes over; nowhere and none if it does not.
fn arrival(colony: &Colony, cell: usize) -> (usize, Vec<usize>) {
    let way = colony.best.as_ref().map_or(&[][..], |best| &best.directions);
    let behind: Vec<_> = colony.ground.way(way).take_while(|&c| c != cell).collect();
    way.get(behind.len().wrapping_sub(1)).map_or((NOWHERE, Vec::new()), |&d| (usize::from(d), behind))
}

/// An ant that walks as the next iteration's do, with other random numbers or by sight alone.
pub(super) fn other_ant(colony: &Colony, item: Item, supposition: &str, others: &Stream) -> Option<Inspection> {
    let mut next = colony.clone();
    next.rng.clone_from(others);
    if supposition == PHEROMONE.name {
        next.pheromone.wipe();
    }
    next.iteration += 1;
    next.walks.clear();
    next.send();
    let mut inspection = next.walks.ants.first().filter(|_| item.index < colony.ants).map(|ant| walked(&next, item, ant))?;
    inspection.marks.iter_mut().for_each(|mark| mark.layer = layers::AFTER.key);
    Some(inspection)
}

/// How far an ant of this iteration came and what it laid.
pub(super) fn ant(colony: &Colony, item: Item) -> Option<Inspection> {
    colony.walks.ants.get(item.index).map(|ant| walked(colony, item, ant))
}

fn walked(colony: &Colony, item: Item, ant: &Ant) -> Inspection {
    let ground = &*colony.ground;
    let path: Vec<_> = ground.way(colony.walks.of(ant)).map(|cell| ground.cells.centre(cell)).collect();
    let (i, n) = (item.index, colony.walks.of(ant).len());
    let (event, summary) = match ant.end {
        _ if ant.again.is_some() => {
            ("forgotten", message!("ants-forgotten", "Ant {i}’s steps are not kept: all ants’ together are too many.", i))
        }
        End::Arrived => {
            ("arrived", message!("ants-arrived", "Ant {i} reached the goal in {n} {steps}.", i, n, steps = n => "step" | "steps"))
        }
        End::Stuck => (
            "stuck",
            message!(
                "ants-stuck",
                "Ant {i} came into a dead end after {n} {steps} and lays nothing.",
                i,
                n,
                steps = n => "step" | "steps"
            ),
        ),
        End::Lost => ("lost", message!("ants-lost", "Ant {i} reached the step limit on its way and lays nothing.", i)),
    };
    let mut suppositions = vec![label!("ants-other-random-numbers", "random", "r", "with other random numbers")];
    if colony.pheromone.exponent() != 0.0 {
        suppositions.push(PHEROMONE);
    }
    let mut values = Vec::new();
    let mut formulas = Vec::new();
    let mut marks = vec![Mark::plane(layers::WAY.key, if path.len() > 1 { Shape::Polyline } else { Shape::Points }, path)];
    if ant.end == End::Arrived {
        values.extend([
            label!("ants-length", "length", "L", "length of its way").is(ant.length),
            label!("ants-pheromone-of-an-ant", "q", "Q", "pheromone of an ant").is(colony.q),
            label!("ants-laid", "laid", "\\Delta\\tau", "what it laid on each step").is(ant.laid),
        ]);
        match colony.variant.update {
            Update::Traditional | Update::Own(_) => {}
            Update::Reward { phi1, phi2 } => {
                let global = colony.best.as_ref().map_or(ant.length, |best| best.length);
                if let Some(best) = &colony.best {
                    marks.push(Mark::plane(layers::BEST.key, Shape::Polyline, best.way.path.clone()));
                }
                let mut lengths: Vec<_> = colony.walks.arrived().map(|ant| ant.length).collect();
                values.extend([
                    label!("ants-reward-median", "phi1", "\\varphi_1", "reward by the median").is(phi1),
                    label!("ants-reward-best", "phi2", "\\varphi_2", "reward by the best").is(phi2),
                    label!("ants-median-length", "median", "L_{\\text{median}}", "median length").is(super::update::median(&mut lengths)),
                    label!("ants-shortest-so-far", "global", "L_{\\text{global}}", "shortest so far").is(global),
                ]);
            }
            Update::Wolf => {
                let share = if colony.q > 0.0 { (ant.laid * ant.length / colony.q).round() } else { 0.0 };
                values.push(label!("ants-shares", "share", "\\delta - \\omega", "shares: 2 on the best way, 0 on the worst").is(share));
            }
        }
        formulas.extend(match colony.variant.update {
            Update::Wolf => Some("laid_shares"),
            Update::Traditional | Update::Reward { .. } => Some("laid"),
            Update::Own(_) => None,
        });
    }
    Inspection { values, formulas, marks, suppositions, ..Inspection::new(item, message!("ants-ant", "Ant {i}", i), event, summary) }
}
