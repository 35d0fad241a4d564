//! Why a particle moved as it did: its velocity as the sum of inertia, cognitive and social part with the r1 and r2
//! that were drawn, or the hen's or chick's jump.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Mark, Message, Progress},
    label, message,
};

use super::{
    flight::{Swarm, Term, Watch},
    objective::Objective,
    perturbation::{Event, Partner, Sign},
    schedule::Coefficients,
    sheet::{OTHER_NUMBERS, SUPPOSITIONS, Supposed, arrows, mark, particle, quantities, sheet},
};

const COSTS: [Label; 3] = [
    label!("swarm-cost-before", "cost_before", "f(x)", "cost before"),
    label!("swarm-cost-after", "cost", "f(x)", "cost after"),
    label!("swarm-personal-best", "p_cost", "f(p)", "personal best"),
];
const MOVED: [Label; 14] = [
    label!("swarm-inertia-weight", "w", "\\omega", "inertia weight"),
    label!("swarm-cognitive-coefficient", "c1", "c_1", "cognitive coefficient"),
    label!("swarm-social-coefficient", "c2", "c_2", "social coefficient"),
    label!("swarm-velocity-before-first-coordinate", "v_before", "v", "velocity before, first coordinate"),
    label!("swarm-random-number-first-coordinate", "r1", "r_1", "random number, first coordinate"),
    label!("swarm-random-number-first-coordinate", "r2", "r_2", "random number, first coordinate"),
    label!("swarm-position-before-first-coordinate", "x_before", "x", "position before, first coordinate"),
    label!("swarm-personal-best-first-coordinate", "p", "p", "personal best, first coordinate"),
    label!("swarm-global-best-first-coordinate", "g", "g", "global best, first coordinate"),
    label!("swarm-inertia-first-coordinate", "inertia", "\\omega v", "inertia, first coordinate"),
    label!("swarm-pull-of-own-first-coordinate", "cognitive", "c_1 r_1 (p - x)", "pull of the personal best, first coordinate"),
    label!("swarm-pull-of-best-first-coordinate", "social", "c_2 r_2 (g - x)", "pull of the global best, first coordinate"),
    label!("swarm-velocity-first-coordinate", "v", "v", "velocity, first coordinate"),
    label!("swarm-position-after-first-coordinate", "x", "x'", "position after, first coordinate"),
];
const HENNED: [Label; 12] = [
    label!("swarm-learning-factor", "s1", "s_1", "learning factor"),
    label!("swarm-learning-factor", "s2", "s_2", "learning factor"),
    label!("swarm-the-other-particle", "t", "t", "the other particle"),
    label!("swarm-own-personal-best-before", "f_i", "f(p)", "own personal best before"),
    label!("swarm-global-best-before", "f_g", "f(g)", "global best before"),
    label!("swarm-the-others-personal-best", "f_t", "f(p)", "the other’s personal best"),
    label!("swarm-position-before-first-coordinate", "x_before", "x", "position before, first coordinate"),
    label!("swarm-random-number-first-coordinate", "r", "r", "random number, first coordinate"),
    label!("swarm-random-number-first-coordinate", "r_", "r'", "random number, first coordinate"),
    label!("swarm-global-best-first-coordinate", "g", "g", "global best, first coordinate"),
    label!("swarm-what-is-taken-from-the-other-first-coordinate", "x_t", "x_t", "what is taken from the other, first coordinate"),
    label!("swarm-position-after-first-coordinate", "x", "x'", "position after, first coordinate"),
];
const CHICKED: [Label; 4] = [
    label!("swarm-how-far-across", "f_l", "F_L", "how far across"),
    label!("swarm-position-before-first-coordinate", "x_before", "x", "position before, first coordinate"),
    label!("swarm-global-best-first-coordinate", "g", "g", "global best, first coordinate"),
    label!("swarm-position-after-first-coordinate", "x", "x'", "position after, first coordinate"),
];

const MOVE: [Label; 9] = [
    label!("swarm-position-before", "x_before", "x", "position before"),
    label!("swarm-inertia", "inertia", "\\omega v", "inertia"),
    label!("swarm-random-number", "r1", "r_1", "random number"),
    label!("swarm-pull-of-the-personal-best", "cognitive", "c_1 r_1 (p - x)", "pull of the personal best"),
    label!("swarm-random-number", "r2", "r_2", "random number"),
    label!("swarm-pull-of-the-global-best", "social", "c_2 r_2 (g - x)", "pull of the global best"),
    label!("swarm-velocity-limited", "v", "v", "velocity, limited"),
    label!("swarm-position-after", "x", "x'", "position after"),
    label!("swarm-personal-best-before", "p", "p", "personal best before"),
];
const HEN: [Label; 5] = [
    label!("swarm-position-before", "x_before", "x", "position before"),
    label!("swarm-random-number", "r", "r", "random number"),
    label!("swarm-random-number", "r_", "r'", "random number"),
    label!("swarm-the-other-particle", "x_t", "x_t", "the other particle"),
    label!("swarm-position-after", "x", "x'", "position after"),
];
const CHICK: [Label; 3] = [
    label!("swarm-position-before", "x_before", "x", "position before"),
    label!("swarm-global-best", "g", "g", "global best"),
    label!("swarm-position-after", "x", "x'", "position after"),
];
/// What a step did to one particle.
#[derive(Default)]
struct Record<'a> {
    particle: usize,
    supposed: Supposed<'a>,
    terms: Vec<Term>,
    other: Option<usize>,
    s: [f64; 2],
    r: Vec<[f64; 2]>,
    /// What the jump takes from the other particle.
    x_t: Vec<f64>,
    /// Where it jumped from: it may have flown before.
    from: Vec<f64>,
    /// Where it jumped to, if that was not better.
    refused: Option<Vec<f64>>,
}

impl Watch for Record<'_> {
    fn particle(&self) -> Option<usize> {
        Some(self.particle)
    }

    fn begins(&mut self, swarm: &mut Swarm) {
        let Coefficients { w, c1, c2 } = &mut swarm.coefficients;
        match self.supposed {
            Some(("inertia", _)) => *w = 0.0,
            Some(("own", _)) => *c1 = 0.0,
            Some(("best", _)) => *c2 = 0.0,
            Some((_, others)) => swarm.rng = others.clone(),
            None => {}
        }
    }

    fn term(&mut self, term: Term) {
        self.terms.push(term);
    }

    fn hen(&mut self, t: Option<usize>, s: [f64; 2]) {
        (self.other, self.s) = (t, s);
    }

    fn leaves(&mut self, x: &[f64]) {
        self.from = x.to_vec();
    }

    fn jump(&mut self, r: [f64; 2], x_t: f64) {
        self.r.push(r);
        self.x_t.push(x_t);
    }

    fn refused(&mut self, x: &[f64]) {
        self.refused = Some(x.to_vec());
    }
}

impl Swarm {
    /// What the next step does to the particle, or would do.
    pub(super) fn explain_step(&self, item: Item, supposed: Supposed) -> Option<Inspection> {
        let i = particle(&self.population, item)?;
        let mut record = Record { particle: i, supposed, ..Record::default() };
        let mut after = self.clone();
        while after.iterate(&mut record) == Progress::Partly {}
        let (now, next) = (&self.population, &after.population);
        let row = now.row(i);
        let other = record.other.unwrap_or(i);
        // A particle that comes earlier in the order has already moved when the hen looks at it.
        let moved = if other < i { next } else { now };
        let step = Step {
            item,
            meaning: &*now.objective,
            x: &now.x[row.clone()],
            p: &now.p[row.clone()],
            v: &self.v[row.clone()],
            g: &now.g,
            to: &next.x[row],
            costs: [now.cost[i], next.cost[i], next.p_cost[i]],
            bests: [now.p_cost[i], now.g_cost, moved.p_cost[other]],
            other,
            hen: self.flight.perturbation.map_or(["s2", "hen"], |p| {
                [if p.sign == Sign::Printed { "s2" } else { "s2_source" }, if p.partner == Partner::Position { "hen" } else { "hen_best" }]
            }),
            coefficients: after.coefficients,
            f_l: self.flight.perturbation.map_or(0.0, |p| p.f_l),
            patience: self.flight.perturbation.map_or(0, |p| p.patience),
            record: &record,
        };
        Some(step.inspection(after.events[i]))
    }
}

/// One particle's step and everything that went into it.
struct Step<'a> {
    item: Item,
    meaning: &'a dyn Objective,
    /// Position, personal best and velocity before, the global best before, and the position after.
    x: &'a [f64],
    p: &'a [f64],
    v: &'a [f64],
    g: &'a [f64],
    to: &'a [f64],
    /// Cost before, cost after, personal best after.
    costs: [f64; 3],
    /// f_i, f_g and f_t of (10) and (11).
    bests: [f64; 3],
    /// The hen's other particle.
    other: usize,
    /// The names of (11) and (9) as they are read here.
    hen: [&'static str; 2],
    coefficients: Coefficients,
    f_l: f64,
    /// How often a particle gets worse before it is perturbed.
    patience: u8,
    record: &'a Record<'a>,
}

impl Step<'_> {
    fn inspection(&self, event: Event) -> Inspection {
        let mut inspection = match event {
            Event::Move => self.describe_move(),
            Event::Hen => self.describe_hen(),
            Event::Chick => self.describe_chick(),
        };
        quantities(&mut inspection, &COSTS, &self.costs);
        inspection
    }

    fn describe_move(&self) -> Inspection {
        let Self { x, p, to, .. } = self;
        let terms = &self.record.terms;
        let i = self.item.index;
        let length = |part: fn(&Term) -> f64| terms.iter().map(|term| part(term) * part(term)).sum::<f64>().sqrt();
        let [inertia, own, swarm] = [length(|term| term.inertia), length(|term| term.cognitive), length(|term| term.social)];
        let mostly = if inertia >= own.max(swarm) {
            message!("swarm-move-on", "Particle {i} mostly keeps its course.", i)
        } else if own > swarm {
            message!("swarm-move-own", "Particle {i} moves mostly toward its own best.", i)
        } else {
            message!("swarm-move-best", "Particle {i} moves mostly toward the swarm’s best.", i)
        };
        let parts = message!(
            "swarm-move-parts",
            "Inertia: {inertia:.2}; pull of its own best: {own:.2}, of the swarm’s best: {swarm:.2}.",
            inertia,
            own,
            swarm
        );
        let summary = mostly.then(parts);
        let mut inspection = sheet(self.meaning, self.item, "move", summary, x.len());
        inspection.columns = MOVE.to_vec();
        inspection.rows = (0..x.len())
            .map(|j| {
                let Term { r, inertia, cognitive, social, step } = terms[j];
                vec![x[j], inertia, r[0], cognitive, r[1], social, step, to[j], p[j]]
            })
            .collect();
        inspection.formulas = vec!["velocity", "position"];
        inspection.suppositions = SUPPOSITIONS.to_vec();
        let Coefficients { w, c1, c2 } = self.coefficients;
        let Term { r: [r1, r2], inertia, cognitive, social, step } = terms[0];
        let values = [w, c1, c2, self.v[0], r1, r2, x[0], p[0], self.g[0], inertia, cognitive, social, step, to[0]];
        quantities(&mut inspection, &MOVED, &values);
        inspection.marks = vec![mark(self.meaning, layers::BEFORE.key, x), mark(self.meaning, layers::AFTER.key, to)];
        // Head to tail: each part begins where the one before it ends.
        let mut tip = x.to_vec();
        for (part, layer) in [layers::INERTIA.key, layers::COGNITIVE.key, layers::SOCIAL.key].into_iter().enumerate() {
            let tail = tip.clone();
            tip.iter_mut().zip(terms).for_each(|(tip, term)| *tip += [term.inertia, term.cognitive, term.social][part]);
            inspection.marks.push(arrows(self.meaning, layer, &tail, &tip));
        }
        inspection.marks.push(arrows(self.meaning, layers::VELOCITY.key, x, to));
        inspection
    }

    fn describe_hen(&self) -> Inspection {
        let Self { other, .. } = self;
        let (from, to, x_t) = (&*self.record.from, self.target(), &self.record.x_t);
        let stagnates = self.stagnates();
        let jumps = if self.record.terms.is_empty() {
            message!("swarm-hen", "It jumps like a hen, towards the swarm’s best and particle {other}.", other)
        } else {
            message!("swarm-hen-after", "After its flight it jumps like a hen, towards the swarm’s best and particle {other}.", other)
        };
        let fate = match self.record.refused {
            Some(_) => message!("swarm-hen-stays", "Its cost would not fall, so it stays."),
            None => Message::default(),
        };
        let summary = stagnates.then(jumps).then(fate);
        let mut inspection = sheet(self.meaning, self.item, "hen", summary, from.len());
        let (r, [s1, s2], [f_i, f_g, f_t]) = (&self.record.r, self.record.s, self.bests);
        inspection.columns = HEN.to_vec();
        inspection.rows = (0..from.len()).map(|j| vec![from[j], r[j][0], r[j][1], x_t[j], to[j]]).collect();
        let [formula_s2, formula_hen] = self.hen;
        inspection.formulas = vec![formula_hen, "s1", formula_s2];
        inspection.suppositions = vec![OTHER_NUMBERS];
        let values = [s1, s2, *other as f64, f_i, f_g, f_t, from[0], r[0][0], r[0][1], self.g[0], x_t[0], to[0]];
        quantities(&mut inspection, &HENNED, &values);
        inspection.marks = self.jump();
        inspection
    }

    fn describe_chick(&self) -> Inspection {
        let Self { to, g, .. } = self;
        let from = &*self.record.from;
        let i = self.item.index;
        let summary = if self.record.terms.is_empty() {
            message!("swarm-chick", "The hen did not help particle {i}, so it jumps like a chick, across the swarm’s best.", i)
        } else {
            message!(
                "swarm-chick-after",
                "The hen did not help particle {i}, so after its flight it jumps like a chick, across the swarm’s best.",
                i
            )
        };
        let mut inspection = sheet(self.meaning, self.item, "chick", summary, from.len());
        inspection.columns = CHICK.to_vec();
        inspection.rows = (0..from.len()).map(|j| vec![from[j], g[j], to[j]]).collect();
        inspection.formulas = vec!["chick"];
        quantities(&mut inspection, &CHICKED, &[self.f_l, from[0], g[0], to[0]]);
        inspection.marks = self.jump();
        inspection
    }

    /// Where the jump led, whether it counted or not.
    fn target(&self) -> &[f64] {
        self.record.refused.as_deref().unwrap_or(self.to)
    }

    /// What makes it stagnate.
    fn stagnates(&self) -> Message {
        let i = self.item.index;
        match self.patience {
            1 => message!("swarm-worse", "Particle {i} got worse.", i),
            times => message!("swarm-worse-often", "Particle {i} got worse {times} times in a row.", i, times),
        }
    }

    fn jump(&self) -> Vec<Mark> {
        let (meaning, from) = (self.meaning, &*self.record.from);
        let mut marks = vec![mark(meaning, layers::BEFORE.key, self.x), mark(meaning, layers::AFTER.key, self.to)];
        if !self.record.terms.is_empty() {
            marks.push(arrows(meaning, layers::VELOCITY.key, self.x, from));
        }
        marks.push(arrows(meaning, layers::JUMP.key, from, self.target()));
        marks
    }
}

#[cfg(test)]
mod tests;
