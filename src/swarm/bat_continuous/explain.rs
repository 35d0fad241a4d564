//! What moved a bat, and whether it accepted that.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Progress},
    label, message,
    swarm::sheet::{SUPPOSITIONS, Supposed, arrows, mark, particle, quantities, sheet},
};

use super::{BAT_POSITION, BAT_VELOCITY, BAT_VELOCITY_TOWARD, Bats, FREQUENCY, Last, Term, WALK_ABOUT, Watch};

const MOVED: [Label; 6] = [
    label!("swarm-frequency-first-coordinate", "f", "f", "frequency, first coordinate"),
    label!("swarm-velocity-before-first-coordinate", "v_before", "v", "velocity before, first coordinate"),
    label!("swarm-position-before-first-coordinate", "x_before", "x", "position before, first coordinate"),
    label!("swarm-global-best-first-coordinate", "g", "g", "global best, first coordinate"),
    label!("swarm-velocity-first-coordinate", "v", "v", "velocity, first coordinate"),
    label!("swarm-candidate-first-coordinate", "x", "x'", "candidate, first coordinate"),
];
const WALKED: [Label; 2] = [
    label!("swarm-random-number-first-coordinate", "random", "\\epsilon", "random number, first coordinate"),
    label!("swarm-mean-loudness-before", "mean_loudness", "\\bar A", "mean loudness before"),
];
const AFTERWARDS: [Label; 5] = [
    label!("swarm-cost-before", "cost_before", "f(x)", "cost before"),
    label!("swarm-cost-after", "cost", "f(x)", "cost after"),
    label!("swarm-personal-best", "p_cost", "f(p)", "personal best"),
    label!("swarm-loudness", "loudness", "A", "loudness"),
    label!("swarm-pulse-rate", "pulse_rate", "r", "pulse rate"),
];
const COLUMNS: [Label; 5] = [
    label!("swarm-position-before", "x_before", "x", "position before"),
    label!("swarm-frequency", "f", "f", "frequency"),
    label!("swarm-velocity-limited", "v", "v", "velocity, limited"),
    label!("swarm-random-number-of-a-walk", "random", "\\epsilon", "random number of a walk"),
    label!("swarm-candidate", "x", "x'", "candidate"),
];

struct Record<'a> {
    particle: usize,
    supposed: Supposed<'a>,
    terms: Vec<Term>,
}

impl Watch for Record<'_> {
    fn particle(&self) -> Option<usize> {
        Some(self.particle)
    }

    fn begins(&mut self, bats: &mut Bats) {
        match self.supposed {
            Some(("inertia", _)) => {
                let row = bats.population.row(self.particle);
                bats.v[row].fill(0.0);
            }
            Some(("best", _)) => bats.sign = 0.0,
            Some((_, others)) => bats.rng = others.clone(),
            None => {}
        }
    }

    fn term(&mut self, term: Term) {
        self.terms.push(term);
    }
}

impl Bats {
    /// What the next step does to a bat, or would do.
    pub(super) fn explain_step(&self, item: Item, supposed: Supposed) -> Option<Inspection> {
        let i = particle(&self.population, item)?;
        let mut record = Record { particle: i, supposed, terms: Vec::new() };
        let mut after = self.clone();
        while after.iterate(&mut record) == Progress::Partly {}
        let (now, next, terms) = (&self.population, &after.population, &record.terms);
        let row = now.row(i);
        let (x, to): (_, Vec<_>) = (&now.x[row.clone()], terms.iter().map(|term| term.to).collect());
        let meaning = &*now.objective;
        let Last { walked, accepted } = after.last[i];

        let moved = if walked {
            message!("swarm-bat-walks", "Bat {i} walks about the global best.", i)
        } else {
            message!("swarm-bat-flies", "Bat {i} flies by its frequency and velocity.", i)
        };
        let outcome = if accepted {
            message!("swarm-bat-accepts", "It accepts the new position and gets quieter.")
        } else {
            message!("swarm-bat-stays", "It does not accept the new position and stays.")
        };
        let mut inspection = sheet(meaning, item, if walked { "walk" } else { "flight" }, moved.then(outcome), now.dimension);
        inspection.title = message!("swarm-bat", "Bat {i}", i);
        inspection.columns = COLUMNS.to_vec();
        inspection.rows = terms.iter().zip(x).map(|(term, &x)| vec![x, term.f, term.v, term.epsilon, term.to]).collect();
        let velocity = if self.sign > 0.0 { BAT_VELOCITY } else { BAT_VELOCITY_TOWARD };
        inspection.formulas = if walked { vec![WALK_ABOUT.name] } else { vec![FREQUENCY.name, velocity.name, BAT_POSITION.name] };
        inspection.formulas.extend(if accepted { &["loudness", "pulse"][..] } else { &[] });
        let [inertia, _, best, others] = SUPPOSITIONS;
        inspection.suppositions = if walked { vec![others] } else { vec![inertia, best, others] };
        let first = terms[0];
        let by = |of: &dyn Fn(usize) -> f64| -> Vec<f64> { (0..x.len()).map(|j| x[j] + of(j)).collect() };
        let v = &self.v[row.clone()];
        quantities(&mut inspection, &MOVED, &[first.f, v[0], x[0], now.g[0], first.v, first.to]);
        if walked {
            quantities(&mut inspection, &WALKED, &[first.epsilon, after.mean_loudness]);
        }
        let costs = [now.cost[i], next.cost[i], next.p_cost[i], after.loudness[i], after.pulse_rate[i]];
        quantities(&mut inspection, &AFTERWARDS, &costs);
        inspection.marks = vec![mark(meaning, layers::BEFORE.key, x)];
        if walked {
            inspection.marks.push(arrows(meaning, layers::JUMP.key, &now.g, &to));
        } else {
            let pull = |j: usize| after.sign * (x[j] - now.g[j]) * terms[j].f;
            inspection.marks.extend([
                arrows(meaning, layers::INERTIA.key, x, &by(&|j| v[j])),
                arrows(meaning, layers::SOCIAL.key, x, &by(&pull)),
                arrows(meaning, layers::VELOCITY.key, x, &to),
            ]);
        }
        inspection.marks.push(mark(meaning, layers::AFTER.key, &next.x[row]));
        Some(inspection)
    }
}
