//! Why an ant would go where, and what one has laid.

use crate::{
    frame::{Role, Shape},
    planner::{Column, Inspection, Item, Mark, Quantity},
};

use super::{
    Colony,
    ground::{Heuristic, NOWHERE, theta1},
    update::Update,
    walk::End,
};

/// The TeX strings that inspections use.
pub const SYMBOLS: &[&str] = &[
    "\\tau",
    "\\eta",
    "\\psi",
    "p",
    "\\theta_1",
    "\\theta_2",
    "\\Sigma",
    "\\alpha",
    "\\beta",
    "\\gamma",
    "d",
    "\\varepsilon",
    "L",
    "Q",
    "\\Delta\\tau",
    "\\varphi_1",
    "\\varphi_2",
    "L_{\\text{median}}",
    "L_{\\text{global}}",
    "\\delta - \\omega",
    "\\eta / \\varepsilon",
];

/// Names of directions, for rows that grow upwards and for rows that grow downwards.
const COMPASS: [[&str; 8]; 2] = [
    ["east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east"],
    ["east", "south-east", "south", "south-west", "west", "north-west", "north", "north-east"],
];

const fn column(name: &'static str, symbol: &'static str, title: &'static str) -> Column {
    Column { name, symbol, title }
}

fn quantity(name: &'static str, symbol: &'static str, title: &'static str, value: f64) -> Quantity {
    Quantity { name, symbol, title, value }
}

/// The eight neighbours of a cell with τ, η, ψ and the probability of each, for an ant that comes there now. It comes as
/// the best way so far does, if that leads through the cell; otherwise it starts there.
pub(super) fn cell(colony: &Colony, item: Item) -> Option<Inspection> {
    let ground = &*colony.ground;
    let cells = &*ground.cells;
    let cell = item.index;
    if cell >= cells.len() {
        return None;
    }
    let from = arrival(colony, cell);
    let [x, y] = cells.place(cell);
    let title = format!("Column {x}, row {}", if ground.down { y } else { cells.rows - 1 - y });
    let allowed = cells.moves(cell);
    let eta = ground.eta(cell);
    let weights = colony.pheromone.look(ground, cell);
    let weight = |d: usize| if allowed >> d & 1 == 0 { 0.0 } else { weights[d] * ground.turn[from][d] };
    let sum: f64 = (0..8).map(weight).sum();
    let ways = allowed.count_ones();
    let share = |d: usize| match (allowed >> d & 1, sum > 0.0) {
        (0, _) => 0.0,
        (_, true) => weight(d) / sum,
        _ => 1.0 / f64::from(ways),
    };
    let psi = |d: usize| {
        let angles = theta1(from, d) + ground.theta2(cell, d);
        crate::math::exp(-angles / std::f64::consts::FRAC_PI_2)
    };
    let names = &COMPASS[usize::from(ground.down)];
    let directed = ground.gamma != 0.0;
    let mut columns = vec![column("tau", "\\tau", "pheromone"), column("eta", "\\eta", "sight")];
    if directed {
        columns.extend([
            column("theta1", "\\theta_1", "turn, radians"),
            column("theta2", "\\theta_2", "off the goal, radians"),
            column("psi", "\\psi", "direction"),
        ]);
    }
    columns.push(column("p", "p", "probability"));
    let row = |d: usize| {
        let free = allowed >> d & 1 != 0;
        let mut row = vec![if free { colony.pheromone.tau(cell, d) } else { 0.0 }, if free { eta[d] } else { 0.0 }];
        if directed {
            row.extend([theta1(from, d), ground.theta2(cell, d), if free { psi(d) } else { 0.0 }]);
        }
        row.push(share(d));
        row
    };
    let best = (0..8).filter(|&d| allowed >> d & 1 != 0).max_by(|&a, &b| share(a).total_cmp(&share(b)));
    let comes =
        if from == NOWHERE { "starting here".to_owned() } else { format!("coming from the {}, as the best way does,", names[from ^ 4]) };
    let (event, summary) = match best {
        _ if !cells.is_free(cell) => ("blocked", "No ant comes here: the cell is blocked.".to_owned()),
        _ if cell == ground.course.goal => ("goal", "This is the goal: an ant ends here.".to_owned()),
        None => ("blocked", "There is no way on from here.".to_owned()),
        Some(d) => ("choice", format!("An ant {comes} would most likely go {}: {:.1} %.", names[d], 100.0 * share(d))),
    };
    let mut values = Vec::new();
    let mut formulas = Vec::new();
    let mut marks = Vec::new();
    if let (Some(d), "choice") = (best, event) {
        let parameters = [
            ("alpha", "\\alpha", "weight of pheromone", colony.pheromone.exponent()),
            ("beta", "\\beta", "weight of sight", ground.beta.exponent),
            ("gamma", "\\gamma", "weight of direction", ground.gamma),
        ];
        values = vec![
            quantity("p", "p", "probability of the likeliest step", share(d)),
            quantity("tau", "\\tau", "its pheromone", colony.pheromone.tau(cell, d)),
            quantity("eta", "\\eta", "its sight", eta[d]),
        ];
        if directed {
            values.push(quantity("psi", "\\psi", "its direction", psi(d)));
            values.push(quantity("theta1", "\\theta_1", "its turn, radians", theta1(from, d)));
            values.push(quantity("theta2", "\\theta_2", "its angle off the goal, radians", ground.theta2(cell, d)));
        }
        // The sum as the formula writes it: with η and ψ as they are.
        values.push(quantity("sum", "\\Sigma", "the sum over all steps", sum));
        values.extend(parameters.into_iter().filter(|(name, ..)| directed || *name != "gamma").map(|(n, s, t, v)| quantity(n, s, t, v)));
        formulas.push("choice");
        if let Heuristic::Ranked { epsilon } = ground.heuristic {
            values.push(quantity("epsilon", "\\varepsilon", "unit of sight", epsilon));
            values.push(quantity("rank", "\\eta / \\varepsilon", "its rank", if epsilon > 0.0 { eta[d] / epsilon } else { 0.0 }));
            formulas.push("ranked");
        } else {
            values.push(quantity("d", "d", "from there to the goal, cells", 1.0 / eta[d]));
            formulas.push("distance");
        }
        if directed {
            formulas.push("direction");
        }
        let centre = cells.centre(cell);
        let vertices = (0..8).filter(|&d| share(d) > 0.001).flat_map(|d| [centre, cells.centre(cells.next(cell, d))]).collect();
        marks.push(Mark { role: Role::Candidates, shape: Shape::Segments, vertices });
    }
    Some(Inspection {
        item,
        title,
        event,
        summary,
        values,
        formulas,
        columns,
        labels: names.iter().map(|&name| name.to_owned()).collect(),
        rows: (0..8).map(row).collect(),
        marks,
    })
}

/// The direction in which the best way comes to a cell.
fn arrival(colony: &Colony, cell: usize) -> usize {
    let Some(best) = &colony.best else {
        return NOWHERE;
    };
    let at = colony.ground.way(&best.directions).position(|c| c == cell);
    at.and_then(|at| at.checked_sub(1)).map_or(NOWHERE, |before| usize::from(best.directions[before]))
}

/// How far an ant of this iteration came and what it laid.
pub(super) fn ant(colony: &Colony, item: Item) -> Option<Inspection> {
    let ground = &*colony.ground;
    let ant = colony.walks.ants.get(item.index)?;
    let path: Vec<_> = ground.way(colony.walks.of(ant)).map(|cell| ground.cells.centre(cell)).collect();
    let steps = colony.walks.of(ant).len();
    let (event, summary) = match ant.end {
        End::Arrived => ("arrived", format!("Ant {} reached the goal in {steps} steps.", item.index)),
        End::Stuck => ("stuck", format!("Ant {} came into a dead end after {steps} steps and lays nothing.", item.index)),
        End::Lost => ("lost", format!("Ant {} reached the step limit on its way and lays nothing.", item.index)),
    };
    let mut values = Vec::new();
    let mut formulas = Vec::new();
    if ant.end == End::Arrived {
        values.extend([
            quantity("length", "L", "length of its way", ant.length),
            quantity("q", "Q", "pheromone of an ant", colony.q),
            quantity("laid", "\\Delta\\tau", "what it laid on each step", ant.laid),
        ]);
        match colony.traits.update {
            Update::Traditional => {}
            Update::Reward { phi1, phi2 } => {
                let global = colony.best.as_ref().map_or(ant.length, |best| best.length);
                let mut lengths: Vec<_> = colony.walks.arrived().map(|ant| ant.length).collect();
                values.extend([
                    quantity("phi1", "\\varphi_1", "reward by the median", phi1),
                    quantity("phi2", "\\varphi_2", "reward by the best", phi2),
                    quantity("median", "L_{\\text{median}}", "median length", super::update::median(&mut lengths)),
                    quantity("global", "L_{\\text{global}}", "shortest so far", global),
                ]);
            }
            Update::Wolf => {
                let share = if colony.q > 0.0 { (ant.laid * ant.length / colony.q).round() } else { 0.0 };
                values.push(quantity("share", "\\delta - \\omega", "shares: 2 on the best way, 0 on the worst", share));
            }
        }
        formulas.push("laid");
    }
    Some(Inspection {
        item,
        title: format!("Ant {}", item.index),
        event,
        summary,
        values,
        formulas,
        columns: Vec::new(),
        labels: Vec::new(),
        rows: Vec::new(),
        marks: vec![Mark { role: Role::After, shape: if path.len() > 1 { Shape::Polyline } else { Shape::Points }, vertices: path }],
    })
}
