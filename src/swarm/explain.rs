//! Why a particle moved as it did: its velocity as the sum of inertia, cognitive and social part with the r1 and r2
//! that were drawn, or the hen's or chick's jump.

use crate::{
    frame::{Role, Shape},
    planner::{Column, Inspection, Item, Mark, Quantity},
};

use super::{
    flight::{Swarm, Term, Watch},
    objective::Objective,
    perturbation::Event,
};

/// The TeX strings that inspections use.
pub const SYMBOLS: &[&str] = &[
    "f(x)",
    "f(p)",
    "f(g)",
    "x",
    "p",
    "g",
    "r_1",
    "r_2",
    "\\omega v",
    "c_1 r_1 (p - x)",
    "c_2 r_2 (g - x)",
    "v",
    "x'",
    "r",
    "r'",
    "x_t",
    "s_1",
    "s_2",
    "F_L",
    "\\omega",
    "c_1",
    "c_2",
    "t",
];

/// What the numbers of an inspection are called: name, TeX, a few words.
type Label = (&'static str, &'static str, &'static str);

const COST: [Label; 1] = [("cost", "f(x)", "cost")];
const COSTS: [Label; 3] = [("cost_before", "f(x)", "cost before"), ("cost", "f(x)", "cost after"), ("p_cost", "f(p)", "personal best")];
const MOVED: [Label; 11] = [
    ("w", "\\omega", "inertia weight"),
    ("c1", "c_1", "cognitive coefficient"),
    ("c2", "c_2", "social coefficient"),
    ("v_before", "v", "velocity before, first coordinate"),
    ("r1", "r_1", "random number, first coordinate"),
    ("r2", "r_2", "random number, first coordinate"),
    ("x_before", "x", "position before, first coordinate"),
    ("p", "p", "personal best, first coordinate"),
    ("g", "g", "global best, first coordinate"),
    ("v", "v", "velocity, first coordinate"),
    ("x", "x'", "position after, first coordinate"),
];
const HENNED: [Label; 12] = [
    ("s1", "s_1", "learning factor"),
    ("s2", "s_2", "learning factor"),
    ("t", "t", "the other particle"),
    ("f_i", "f(p)", "own personal best before"),
    ("f_g", "f(g)", "global best before"),
    ("f_t", "f(p)", "the other’s personal best"),
    ("x_before", "x", "position before, first coordinate"),
    ("r", "r", "random number, first coordinate"),
    ("r_", "r'", "random number, first coordinate"),
    ("g", "g", "global best, first coordinate"),
    ("x_t", "x_t", "the other particle, first coordinate"),
    ("x", "x'", "position after, first coordinate"),
];
const CHICKED: [Label; 4] = [
    ("f_l", "F_L", "how far across"),
    ("x_before", "x", "position before, first coordinate"),
    ("g", "g", "global best, first coordinate"),
    ("x", "x'", "position after, first coordinate"),
];

fn quantities(labels: &[Label], values: &[f64]) -> impl Iterator<Item = Quantity> {
    labels.iter().zip(values).map(|(&(name, symbol, title), &value)| Quantity { name, symbol, title, value })
}

const fn column(name: &'static str, symbol: &'static str, title: &'static str) -> Column {
    Column { name, symbol, title }
}

const MOVE: [Column; 9] = [
    column("x_before", "x", "position before"),
    column("inertia", "\\omega v", "inertia"),
    column("r1", "r_1", "random number"),
    column("cognitive", "c_1 r_1 (p - x)", "pull of the personal best"),
    column("r2", "r_2", "random number"),
    column("social", "c_2 r_2 (g - x)", "pull of the global best"),
    column("v", "v", "velocity, limited"),
    column("x", "x'", "position after"),
    column("p", "p", "personal best before"),
];
const HEN: [Column; 5] = [
    column("x_before", "x", "position before"),
    column("r", "r", "random number"),
    column("r_", "r'", "random number"),
    column("x_t", "x_t", "the other particle"),
    column("x", "x'", "position after"),
];
const CHICK: [Column; 3] =
    [column("x_before", "x", "position before"), column("g", "g", "global best"), column("x", "x'", "position after")];
const START: [Column; 1] = [column("x", "x", "position")];

/// What a step did to one particle.
#[derive(Default)]
struct Record {
    particle: usize,
    terms: Vec<Term>,
    other: Option<usize>,
    s: [f64; 2],
    r: Vec<[f64; 2]>,
}

impl Watch for Record {
    fn wants(&self, i: usize) -> bool {
        i == self.particle
    }

    fn term(&mut self, term: Term) {
        self.terms.push(term);
    }

    fn hen(&mut self, i: usize, t: Option<usize>, s: [f64; 2]) {
        if i == self.particle {
            (self.other, self.s) = (t, s);
        }
    }

    fn jump(&mut self, i: usize, r: [f64; 2]) {
        if i == self.particle {
            self.r.push(r);
        }
    }
}

impl<O: Objective> Swarm<O> {
    /// The particle before anything has moved it.
    pub(super) fn introduce(&self, item: Item) -> Option<Inspection> {
        let i = self.particle(item)?;
        let x = &self.population.x[self.population.row(i)];
        let mut told =
            self.sheet(item, "start", format!("Particle {i} begins here, drawn uniformly from the search box; its velocity is zero."));
        told.columns = START.to_vec();
        told.rows = x.iter().map(|&x| vec![x]).collect();
        told.values.extend(quantities(&COST, &[self.population.cost[i]]));
        told.marks = vec![self.mark(Role::After, x)];
        Some(told)
    }

    /// What the next step does to the particle.
    pub(super) fn explain_step(&self, item: Item) -> Option<Inspection> {
        let i = self.particle(item)?;
        let mut record = Record { particle: i, ..Record::default() };
        let mut after = self.clone();
        after.advance(&mut record);
        let mut told = match after.events[i] {
            Event::Move => self.tell_move(item, &after, &record),
            Event::Hen => self.tell_hen(item, &after, &record),
            Event::Chick => self.tell_chick(item, &after),
        };
        told.values.extend(quantities(&COSTS, &[self.population.cost[i], after.population.cost[i], after.population.p_cost[i]]));
        Some(told)
    }

    fn particle(&self, item: Item) -> Option<usize> {
        let known = matches!(item.role, Role::Particles | Role::PersonalBests);
        (known && item.index < self.population.size).then_some(item.index)
    }

    fn tell_move(&self, item: Item, after: &Self, record: &Record) -> Inspection {
        let row = self.population.row(item.index);
        let (x, p, to) = (&self.population.x[row.clone()], &self.population.p[row.clone()], &after.population.x[row.clone()]);
        let terms = &record.terms;
        let mut told = self.sheet(
            item,
            "move",
            format!("Particle {} keeps part of its velocity and is drawn to its own best and to the swarm’s.", item.index),
        );
        told.columns = MOVE.to_vec();
        told.rows = (0..x.len())
            .map(|j| {
                let Term { r, inertia, cognitive, social, step } = terms[j];
                vec![x[j], inertia, r[0], cognitive, r[1], social, step, to[j], p[j]]
            })
            .collect();
        told.formulas = vec!["velocity", "position"];
        let c = after.coefficients;
        told.values.extend(quantities(
            &MOVED,
            &[c.w, c.c1, c.c2, self.v[row.start], terms[0].r[0], terms[0].r[1], x[0], p[0], self.population.g[0], terms[0].step, to[0]],
        ));
        let mut at = x.to_vec();
        let mut arrow = |role, part: fn(&Term) -> f64| {
            let from: Vec<_> = self.population.objective.points(&at).collect();
            at.iter_mut().zip(terms).for_each(|(at, term)| *at += part(term));
            let arrows = from.into_iter().zip(self.population.objective.points(&at)).flat_map(|(a, b)| [a, b]).collect();
            Mark { role, shape: Shape::Segments, vertices: arrows }
        };
        let parts = [arrow(Role::Inertia, |t| t.inertia), arrow(Role::Cognitive, |t| t.cognitive), arrow(Role::Social, |t| t.social)];
        told.marks = vec![self.mark(Role::Before, x), self.mark(Role::After, to)];
        told.marks.extend(parts);
        told.marks.push(self.arrows(Role::Velocity, x, to));
        told
    }

    fn tell_hen(&self, item: Item, after: &Self, record: &Record) -> Inspection {
        let row = self.population.row(item.index);
        let (x, to) = (&self.population.x[row.clone()], &after.population.x[row]);
        let other = record.other.unwrap_or(item.index);
        // A particle that comes earlier in the order has already moved when the hen looks at it.
        let moved = if other < item.index { after } else { self };
        let x_t = &moved.population.x[self.population.row(other)];
        let mut told = self.sheet(
            item,
            "hen",
            format!(
                "Particle {} got worse again and again, so it jumps like a hen, towards the swarm’s best and particle {other}.",
                item.index
            ),
        );
        told.columns = HEN.to_vec();
        told.rows = (0..x.len()).map(|j| vec![x[j], record.r[j][0], record.r[j][1], x_t[j], to[j]]).collect();
        told.formulas = vec!["hen", "s1", "s2"];
        let (f_i, f_g, f_t) = (self.population.p_cost[item.index], self.population.g_cost, moved.population.p_cost[other]);
        let ([s1, s2], [r, r_]) = (record.s, record.r[0]);
        told.values.extend(quantities(&HENNED, &[s1, s2, other as f64, f_i, f_g, f_t, x[0], r, r_, self.population.g[0], x_t[0], to[0]]));
        told.marks = vec![self.mark(Role::Before, x), self.mark(Role::After, to), self.arrows(Role::Jump, x, to)];
        told
    }

    fn tell_chick(&self, item: Item, after: &Self) -> Inspection {
        let row = self.population.row(item.index);
        let (x, to) = (&self.population.x[row.clone()], &after.population.x[row]);
        let mut told = self.sheet(
            item,
            "chick",
            format!("The hen did not help particle {}, so it jumps like a chick, across the swarm’s best.", item.index),
        );
        told.columns = CHICK.to_vec();
        told.rows = (0..x.len()).map(|j| vec![x[j], self.population.g[j], to[j]]).collect();
        told.formulas = vec!["chick"];
        let f_l = self.flight.perturbation.map_or(0.0, |p| p.f_l);
        told.values.extend(quantities(&CHICKED, &[f_l, x[0], self.population.g[0], to[0]]));
        told.marks = vec![self.mark(Role::Before, x), self.mark(Role::After, to), self.arrows(Role::Jump, x, to)];
        told
    }

    fn sheet(&self, item: Item, event: &'static str, summary: String) -> Inspection {
        Inspection {
            item,
            title: format!("Particle {}", item.index),
            event,
            summary,
            values: Vec::new(),
            formulas: Vec::new(),
            columns: Vec::new(),
            labels: (0..self.population.dimension).map(|j| self.population.objective.coordinate(j)).collect(),
            rows: Vec::new(),
            marks: Vec::new(),
        }
    }

    fn mark(&self, role: Role, x: &[f64]) -> Mark {
        let ends = self.population.objective.ends();
        let shape = if ends.is_some() { Shape::Polyline } else { Shape::Points };
        let first = ends.iter().map(|e| e.0);
        let last = ends.iter().map(|e| e.1);
        Mark { role, shape, vertices: first.chain(self.population.objective.points(x)).chain(last).collect() }
    }

    fn arrows(&self, role: Role, from: &[f64], to: &[f64]) -> Mark {
        let objective = &self.population.objective;
        let vertices = objective.points(from).zip(objective.points(to)).flat_map(|(a, b)| [a, b]).collect();
        Mark { role, shape: Shape::Segments, vertices }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::{
        frame::Role,
        planner::Item,
        scene::shipped,
        session::{Session, Setup},
    };

    fn session() -> Session {
        let scene = Arc::clone(&shipped("wcpso-discs").unwrap());
        Session::new(Setup { planner: "wcpso".into(), scene, params: crate::Given::default(), seed: 3 }).unwrap()
    }

    /// Every particle of many iterations: the terms add up to the velocity, and the velocity (or the jump) leads from
    /// where the particle was to where it is. All three events must come up.
    #[test]
    fn the_explanation_adds_up_and_ends_where_the_particle_is() {
        let mut session = session();
        let mut seen = std::collections::BTreeMap::new();
        for _ in 0..80 {
            session.step(1);
            let drawn = session_paths(&session);
            for (index, path) in drawn.iter().enumerate() {
                let told = session.inspect(Item { role: Role::Particles, index }).unwrap();
                *seen.entry(told.event).or_insert(0) += 1;
                let get = |row: &[f64], name| row[told.columns.iter().position(|c| c.name == name).unwrap()];
                for row in &told.rows {
                    if told.event == "move" {
                        let sum = get(row, "inertia") + get(row, "cognitive") + get(row, "social");
                        let v = get(row, "v");
                        assert!((sum - v).abs() < 1e-12 || (v.abs() < sum.abs() && v.signum() == sum.signum()), "{sum} {v}");
                        let reached = get(row, "x_before") + v;
                        let inside = get(row, "x");
                        assert!((inside - reached).abs() < 1e-12 || !(0.0..=8.0).contains(&reached), "{reached} {inside}");
                    }
                }
                let after: Vec<_> = told.marks.iter().find(|m| m.role == Role::After).unwrap().vertices.clone();
                for (a, b) in after.iter().zip(path) {
                    assert!((a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5);
                }
            }
        }
        assert!(seen["move"] > 0 && seen["hen"] > 0 && seen["chick"] > 0, "{seen:?}");
    }

    fn session_paths(session: &Session) -> Vec<Vec<[f64; 2]>> {
        let mut frame = crate::Frame::default();
        session.draw(&mut frame, usize::MAX);
        frame.spans().filter(|s| s.role == Role::Particles).map(|s| frame.points(s).collect()).collect()
    }

    #[test]
    fn nothing_is_said_about_a_particle_that_does_not_exist() {
        let mut session = session();
        assert_eq!(session.inspect(Item { role: Role::Particles, index: 0 }).unwrap().event, "start");
        assert_eq!(session.inspect(Item { role: Role::Particles, index: 150 }), None);
        session.step(2);
        assert_eq!(session.inspect(Item { role: Role::Best, index: 0 }), None);
    }
}
