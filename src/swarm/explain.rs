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
mod tests {
    use std::sync::Arc;

    use crate::{
        describe::layers,
        kernel::Item,
        run::{Run, Setup},
        shipped, standard,
    };

    fn run() -> Run {
        let scene = Arc::clone(&shipped("wcpso-discs").unwrap());
        Run::new(standard(), Setup { planner: "wcpso".into(), scene, params: crate::Overrides::default(), seed: 3 }).unwrap()
    }

    /// Every particle of many iterations: the terms add up to the velocity, and the velocity (or the jump) leads from
    /// where the particle was to where it is. All three events must come up.
    #[test]
    fn the_explanation_adds_up_and_ends_where_the_particle_is() {
        let mut run = run();
        let mut seen = std::collections::BTreeMap::new();
        for _ in 0..80 {
            run.step(1);
            let drawn = drawn_paths(&run);
            for (index, path) in drawn.iter().enumerate() {
                let inspection = run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap();
                *seen.entry(inspection.event).or_insert(0) += 1;
                let get = |row: &[f64], name| row[inspection.columns.iter().position(|c| c.name == name).unwrap()];
                for row in &inspection.rows {
                    if inspection.event == "move" {
                        let sum = get(row, "inertia") + get(row, "cognitive") + get(row, "social");
                        let v = get(row, "v");
                        assert!((sum - v).abs() < 1e-12 || (v.abs() < sum.abs() && v.signum() == sum.signum()), "{sum} {v}");
                        let reached = get(row, "x_before") + v;
                        let inside = get(row, "x");
                        assert!((inside - reached).abs() < 1e-12 || !(0.0..=8.0).contains(&reached), "{reached} {inside}");
                    }
                }
                let after: Vec<_> = inspection.marks.iter().find(|m| m.layer == layers::AFTER.key).unwrap().vertices.clone();
                for (a, b) in after.iter().zip(path) {
                    assert!((a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5);
                }
            }
        }
        assert!(seen["move"] > 0 && seen["hen"] > 0 && seen["chick"] > 0, "{seen:?}");
    }

    /// How often each event was explained in 80 iterations; `check` sees every inspection.
    fn inspection(set: &[(&str, &str)], check: impl Fn(&crate::kernel::Inspection)) -> std::collections::BTreeMap<&'static str, usize> {
        let params = set.iter().map(|&(name, value)| (name, crate::Value::from(value))).collect();
        let scene = crate::shipped("wcpso-discs").unwrap();
        let mut run = Run::new(standard(), Setup { planner: "wcpso".into(), scene, params, seed: 4 }).unwrap();
        let mut seen = std::collections::BTreeMap::new();
        for _ in 0..80 {
            run.step(1);
            for (index, path) in drawn_paths(&run).iter().enumerate() {
                let inspection = run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap();
                *seen.entry(inspection.event).or_insert(0) += 1;
                let after = &inspection.marks.iter().find(|m| m.layer == layers::AFTER.key).unwrap().vertices;
                assert!(
                    after.iter().zip(path).all(|(a, b)| (a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5),
                    "{}",
                    inspection.summary
                );
                check(&inspection);
            }
        }
        seen
    }

    /// What is supposed is otherwise, and nothing else is: the other terms of the same step, the same random numbers.
    #[test]
    fn a_supposition_changes_one_thing_of_a_step() {
        let mut run = run();
        let (mut moved, mut hens) = (0, 0);
        for _ in 0..30 {
            run.step(1);
            let hash = run.hash();
            for index in (0..150).step_by(7) {
                let item = Item { layer: layers::PARTICLES.key, index };
                let inspection = run.inspect(item).unwrap();
                let mut suppose = |name: &str, draw| run.suppose(item, name, draw).unwrap().unwrap();
                if inspection.event != "move" {
                    assert_eq!(inspection.suppositions.len(), usize::from(inspection.event == "hen"), "{}", inspection.event);
                    hens += usize::from(inspection.event == "hen" && suppose("random", 0).rows[0][1..3] != inspection.rows[0][1..3]);
                    continue;
                }
                // The columns of `MOVE`: x, inertia, r1, own best, r2, swarm's best, v, x', p.
                for (name, column) in [("inertia", 1), ("own", 3), ("best", 5)] {
                    let supposed = suppose(name, 0);
                    for (was, is) in inspection.rows.iter().zip(&supposed.rows) {
                        assert_eq!(is[column], 0.0, "{name}");
                        for other in [0, 1, 2, 3, 4, 5, 8].into_iter().filter(|&other| other != column) {
                            assert_eq!(is[other], was[other], "{name}, column {other}");
                        }
                        let reached = is[0] + is[6];
                        let stops = reached < 0.0 && is[7] == 0.0 || reached > 8.0 && (is[7] == 8.0 || is[7] == 9.0);
                        assert!((is[7] - reached).abs() < 1e-12 || stops, "{name}: {} is not {reached}", is[7]);
                        moved += usize::from(is[7] != was[7]);
                    }
                    assert!(supposed.marks.iter().all(|mark| mark.layer == layers::SUPPOSED.key) && supposed.marks.len() == 2);
                }
                let [one, other] = [0, 1].map(|draw| suppose("random", draw).rows[0][2]);
                assert!(one != other && one != inspection.rows[0][2]);
            }
            assert_eq!(run.hash(), hash);
        }
        assert!(moved > 1000 && hens > 10, "{moved} coordinates elsewhere, {hens} hens");
        let error = run.suppose(Item { layer: layers::PARTICLES.key, index: 0 }, "luck", 0).unwrap_err();
        assert!(error.to_string().contains("supposition") && error.to_string().contains("luck"), "{error}");
    }

    #[test]
    fn one_pair_of_random_numbers_serves_a_whole_particle() {
        let at = |row: &[f64], name: &str, inspection: &crate::kernel::Inspection| {
            row[inspection.columns.iter().position(|c| c.name == name).unwrap()]
        };
        let seen = inspection(&[("random", "particle")], |inspection| {
            let pair = match inspection.event {
                "move" => ["r1", "r2"],
                "hen" => ["r", "r_"],
                _ => return,
            };
            for name in pair {
                assert!(
                    inspection.rows.iter().all(|row| at(row, name, inspection) == at(&inspection.rows[0], name, inspection)),
                    "{}",
                    inspection.summary
                );
            }
        });
        assert!(seen["move"] > 0 && seen["hen"] > 0, "{seen:?}");
    }

    #[test]
    fn a_hen_that_must_be_better_never_raises_the_cost() {
        let value =
            |inspection: &crate::kernel::Inspection, name: &str| inspection.values.iter().find(|v| v.label.name == name).unwrap().value;
        let refused = std::cell::Cell::new(0);
        let seen = inspection(&[("hen_keep", "better")], |inspection| {
            if inspection.event == "hen" {
                assert!(value(inspection, "cost") <= value(inspection, "cost_before"), "{}", inspection.summary);
                refused.set(refused.get() + usize::from(inspection.summary.text().ends_with("so it stays.")));
            }
        });
        assert!(refused.get() > 0 && refused.get() < seen["hen"], "{seen:?}, {} refused", refused.get());
    }

    #[test]
    fn a_hen_after_the_flight_jumps_from_where_it_led_towards_a_personal_best() {
        let seen = inspection(&[("hen_timing", "after"), ("hen_partner", "best"), ("s2", "source")], |inspection| {
            if inspection.event == "hen" {
                assert!(
                    inspection.marks.iter().any(|m| m.layer == layers::VELOCITY.key)
                        && inspection.marks.iter().any(|m| m.layer == layers::JUMP.key)
                );
                assert_eq!(inspection.formulas, ["hen_best", "s1", "s2_source"]);
                let [s1, s2, g] = ["s1", "s2", "g"].map(|name| inspection.values.iter().find(|v| v.label.name == name).unwrap().value);
                let [x, r, r_, x_t, to] = inspection.rows[0][..] else { panic!("five columns") };
                let expected = (x + s1 * r * (g - x) + s2 * r_ * (x_t - x)).clamp(0.0, 9.0);
                assert!((to - expected).abs() < 1e-12, "{to} {expected}");
            }
        });
        assert!(seen["move"] > 0 && seen["hen"] > 0 && seen["chick"] > 0, "{seen:?}");
    }

    fn drawn_paths(run: &Run) -> Vec<Vec<[f64; 2]>> {
        let mut frame = crate::Frame::default();
        run.draw(&mut frame, usize::MAX);
        frame.spans().filter(|s| s.layer == layers::PARTICLES.key).map(|s| frame.points(s).collect()).collect()
    }

    #[test]
    fn nothing_is_said_about_a_particle_that_does_not_exist() {
        let mut run = run();
        assert_eq!(run.inspect(Item { layer: layers::PARTICLES.key, index: 0 }).unwrap().event, "start");
        assert_eq!(run.inspect(Item { layer: layers::PARTICLES.key, index: 150 }), None);
        run.step(2);
        assert_eq!(run.inspect(Item { layer: layers::BEST.key, index: 0 }), None);
    }
}
