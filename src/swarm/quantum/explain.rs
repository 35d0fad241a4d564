//! Why a particle leapt where it did: (9) with its numbers, and whose place it took afterwards.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Progress},
    label, message,
    swarm::{
        population::{column, deviation},
        sheet::{SUPPOSITIONS, Supposed, arrows, mark, particle, quantities, sheet},
    },
};

use super::leap::{Leap, Quantum, Watch};

const LEAPT: [Label; 13] = [
    label!("swarm-contraction-expansion", "alpha", "\\alpha", "contraction–expansion"),
    label!("swarm-cognitive-coefficient", "c1", "c_1", "cognitive coefficient"),
    label!("swarm-social-coefficient", "c2", "c_2", "social coefficient"),
    label!("swarm-random-number-first-coordinate", "r1", "r_1", "random number, first coordinate"),
    label!("swarm-random-number-first-coordinate", "r2", "r_2", "random number, first coordinate"),
    label!("swarm-share-of-the-own-best-first-coordinate", "phi", "\\varphi", "share of the own best, first coordinate"),
    label!("swarm-personal-best-first-coordinate", "p", "P", "personal best, first coordinate"),
    label!("swarm-global-best-first-coordinate", "g", "G", "global best, first coordinate"),
    label!("swarm-local-attractor-first-coordinate", "attractor", "p", "local attractor, first coordinate"),
    label!("swarm-mean-best-first-coordinate", "m", "m", "mean best, first coordinate"),
    label!("swarm-random-number-first-coordinate", "u", "u", "random number, first coordinate"),
    label!("swarm-direction-first-coordinate", "sign", "\\pm", "direction, first coordinate"),
    label!("swarm-position-before-first-coordinate", "x_before", "X", "position before, first coordinate"),
];
const LANDED: [Label; 1] =
    [label!("swarm-position-after-the-leap-first-coordinate", "x", "X'", "position after the leap, first coordinate")];
const EVOLVED: [Label; 6] = [
    label!("swarm-evolution-speed", "ip", "ip", "evolution speed"),
    label!("swarm-global-best-before", "f_g", "f(G)", "global best before"),
    label!("swarm-own-personal-best-before", "f_p", "f(P)", "own personal best before"),
    label!("swarm-dispersion-first-coordinate", "gs", "gs", "dispersion, first coordinate"),
    label!("swarm-spread-of-personal-bests-first-coordinate", "sigma_p", "\\sigma(P)", "spread of personal bests, first coordinate"),
    label!("swarm-spread-of-positions-first-coordinate", "sigma_x", "\\sigma(X)", "spread of positions, first coordinate"),
];
const COSTS: [Label; 3] = [
    label!("swarm-cost-before", "cost_before", "f(X)", "cost before"),
    label!("swarm-cost-after", "cost", "f(X)", "cost after"),
    label!("swarm-personal-best", "p_cost", "f(P)", "personal best"),
];

const COLUMNS: [Label; 8] = [
    label!("swarm-position-before", "x_before", "X", "position before"),
    label!("swarm-share-of-the-own-best", "phi", "\\varphi", "share of the own best"),
    label!("swarm-local-attractor", "attractor", "p", "local attractor"),
    label!("swarm-mean-best", "m", "m", "mean best"),
    label!("swarm-dispersion", "gs", "gs", "dispersion"),
    label!("swarm-random-number", "u", "u", "random number"),
    label!("swarm-direction", "sign", "\\pm", "direction"),
    label!("swarm-position-after-the-leap", "x", "X'", "position after the leap"),
];

struct Record<'a> {
    particle: usize,
    supposed: Supposed<'a>,
    leaps: Vec<Leap>,
}

impl Watch for Record<'_> {
    fn particle(&self) -> Option<usize> {
        Some(self.particle)
    }

    fn begins(&mut self, swarm: &mut Quantum) {
        match self.supposed {
            Some(("own", _)) => swarm.c[0] = 0.0,
            Some(("best", _)) => swarm.c[1] = 0.0,
            Some((_, others)) => swarm.rng = others.clone(),
            None => {}
        }
    }

    fn leap(&mut self, leap: Leap) {
        self.leaps.push(leap);
    }
}

impl Quantum {
    /// What the next step does to the particle, or would do.
    pub(super) fn explain_step(&self, item: Item, supposed: Supposed) -> Option<Inspection> {
        let i = particle(&self.population, item)?;
        let mut record = Record { particle: i, supposed, leaps: Vec::new() };
        let mut after = self.clone();
        while after.iterate(&mut record) == Progress::Partly {}
        let (now, next, leaps) = (&self.population, &after.population, &record.leaps);
        let (row, n) = (now.row(i), now.dimension);
        let (x, p, attractor) = (&now.x[row.clone()], &now.p[row.clone()], &after.attractors[row.clone()]);
        let landed: Vec<_> = leaps.iter().map(|leap| leap.to).collect();
        let meaning = &*now.objective;

        let (event, summary) = match after.replaced[i] {
            None => {
                ("leap", message!("swarm-leap", "Particle {i} leaps about its attractor, a point between its own best and the swarm’s.", i))
            }
            Some(other) => (
                "replaced",
                message!(
                    "swarm-leap-replaced",
                    "Particle {i} leaps about its attractor, a point between its own best and the swarm’s; there it is among the worse half, so it takes the place of particle {other}.",
                    i,
                    other
                ),
            ),
        };
        let mut inspection = sheet(meaning, item, event, summary, n);
        inspection.columns = COLUMNS.to_vec();
        inspection.rows = leaps
            .iter()
            .enumerate()
            .map(|(j, leap)| vec![x[j], leap.phi, attractor[j], after.m[j], after.gs[j], leap.u, leap.sign, leap.to])
            .collect();
        inspection.formulas = vec!["leap", "attractor", "phi"];
        let Leap { r: [r1, r2], phi, u, sign, to } = leaps[0];
        // It has no velocity that it could do without.
        inspection.suppositions = SUPPOSITIONS[1..].to_vec();
        let [c1, c2] = after.c;
        quantities(&mut inspection, &LEAPT, &[after.width, c1, c2, r1, r2, phi, p[0], now.g[0], attractor[0], after.m[0], u, sign, x[0]]);
        quantities(&mut inspection, &LANDED, &[to]);
        if self.adaptive.is_some() {
            inspection.formulas.extend(["ip", "gs"]);
            let sigma = |rows| deviation(column(rows, n, 0));
            let numbers = [after.ip[i], now.g_cost, now.p_cost[i], after.gs[0], sigma(&now.p), sigma(&now.x)];
            quantities(&mut inspection, &EVOLVED, &numbers);
        }
        quantities(&mut inspection, &COSTS, &[now.cost[i], next.cost[i], next.p_cost[i]]);
        inspection.marks = vec![
            mark(meaning, layers::BEFORE.key, x),
            mark(meaning, layers::MEAN_BEST.key, &after.m),
            mark(meaning, layers::ATTRACTORS.key, attractor),
            arrows(meaning, layers::JUMP.key, x, &landed),
            mark(meaning, layers::AFTER.key, &next.x[row]),
        ];
        Some(inspection)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::{
        Overrides, Run, Setup, Value,
        describe::layers,
        kernel::{Frame, Item},
        shipped, standard,
    };

    /// Every particle of several iterations: the numbers shown give the leap, and the leap (or the exchange) ends where
    /// the particle is drawn. Both events come up.
    #[test]
    fn the_explanation_ends_where_the_particle_is() {
        let scene = Arc::clone(&shipped("qpso-10m").unwrap());
        let params = Overrides::from_iter([("population", Value::from(12.0))]);
        let mut run = Run::new(standard(), Setup { planner: "ltqpso".into(), scene, params, seed: 3 }).unwrap();
        let mut seen = std::collections::BTreeMap::new();
        for _ in 0..20 {
            run.step(1);
            let mut frame = Frame::default();
            run.draw(&mut frame, usize::MAX);
            let drawn: Vec<Vec<_>> =
                frame.spans().filter(|s| s.layer == layers::PARTICLES.key).map(|s| frame.points(s).collect()).collect();
            for (index, path) in drawn.iter().enumerate() {
                let inspection = run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap();
                *seen.entry(inspection.event).or_insert(0) += 1;
                let of = |name| inspection.values.iter().find(|v| v.label.name == name).unwrap().value;
                let to =
                    of("attractor") + of("sign") * of("alpha") * of("gs") * (of("m") - of("x_before")).abs() * -crate::math::ln(of("u"));
                assert!((of("x") - to).abs() < 1e-12 || of("x") == 0.0 || of("x") > 1.57, "{} {to}", of("x"));
                let after = &inspection.marks.iter().find(|m| m.layer == layers::AFTER.key).unwrap().vertices;
                for (a, b) in after.iter().zip(path) {
                    assert!((a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5);
                }
            }
        }
        assert_eq!((seen["leap"], seen["replaced"]), (120, 120));
    }
}
