//! What a particle stands for.

use crate::{
    describe::layers,
    kernel::{Inspection, Item, Label, Mark, Message, Quantity, Shape},
    label, message,
};

use super::swarm::Tuning;

const COLUMNS: [Label; 4] = [
    label!("tuning-tried", "x", "x", "tried"),
    label!("tuning-velocity", "v", "v", "velocity"),
    label!("tuning-personal-best", "p", "p", "its best"),
    label!("tuning-swarm-best", "g", "g", "the swarm’s best"),
];

/// A row for each parameter: the value that was tried, its velocity, its own best and the swarm's.
pub(super) fn particle(swarm: &Tuning, item: Item) -> Inspection {
    let i = item.index;
    let row = swarm.row(i);
    let (x, v, p) = (&swarm.shown[row.clone()], &swarm.v[row.clone()], &swarm.p[row]);
    let cost = swarm.cost[i];
    let (event, summary) = if swarm.iteration == 0 {
        ("start", message!("tuning-start", "Particle {i} begins with these parameters, drawn at random.", i))
    } else if cost.length.is_finite() {
        let runs = swarm.seeds.len();
        (
            "judged",
            message!(
                "tuning-judged",
                "With particle {i}’s parameters the colony found ways of length {length:.4} on average over {n} {runs}.",
                i,
                length = cost.length,
                n = runs,
                runs => "run" | "runs"
            ),
        )
    } else {
        ("failed", message!("tuning-failed", "With particle {i}’s parameters a run of the colony found no way.", i))
    };
    let rows = (0..x.len()).map(|j| {
        let axis = &swarm.axes[j];
        vec![axis.value(x[j]), v[j], axis.value(p[j]), axis.value(swarm.g[j])]
    });
    let way = &swarm.ways[i];
    Inspection {
        values: [
            label!("tuning-mean-length", "cost", "\\bar L", "mean length").is(cost.length),
            label!("tuning-mean-converged", "converged", "\\bar t^*", "mean iteration of convergence").is(cost.converged),
            label!("tuning-personal-best", "own", "\\bar L_p", "its best").is(swarm.p_cost[i].length),
            label!("tuning-swarm-best", "global", "\\bar L_g", "the swarm’s best").is(swarm.g_cost.length),
        ]
        .into_iter()
        .filter(|inspection: &Quantity| inspection.value.is_finite())
        .collect(),
        formulas: vec!["velocity"],
        columns: COLUMNS.to_vec(),
        labels: swarm.axes.iter().map(|axis| Message::verbatim(axis.parameter.name)).collect(),
        rows: rows.collect(),
        marks: if way.is_empty() { Vec::new() } else { vec![Mark::plane(layers::AFTER.key, Shape::Polyline, way.clone())] },
        ..Inspection::new(item, message!("tuning-particle", "Particle {i}", i), event, summary)
    }
}
