//! What a particle stands for.

use crate::{
    describe::layers,
    kernel::{Column, Inspection, Item, Mark, Quantity, Shape},
};

use super::swarm::Tuning;

const COLUMNS: [Column; 4] = [
    Column { name: "x", symbol: "x", title: "tried" },
    Column { name: "v", symbol: "v", title: "velocity" },
    Column { name: "p", symbol: "p", title: "its best" },
    Column { name: "g", symbol: "g", title: "the swarm’s best" },
];

/// A row for each parameter: the value that was tried, its velocity, its own best and the swarm's.
pub(super) fn particle(swarm: &Tuning, item: Item) -> Inspection {
    let i = item.index;
    let row = swarm.row(i);
    let (x, v, p) = (&swarm.shown[row.clone()], &swarm.v[row.clone()], &swarm.p[row]);
    let cost = swarm.cost[i];
    let quantity = |name, symbol, title, value: f64| value.is_finite().then_some(Quantity { name, symbol, title, value });
    let (event, summary) = if swarm.iteration == 0 {
        ("start", format!("Particle {i} begins with these parameters, drawn at random."))
    } else if cost.length.is_finite() {
        let runs = swarm.seeds.len();
        (
            "judged",
            format!("With particle {i}’s parameters the colony found ways of length {:.4} on average over {runs} runs.", cost.length),
        )
    } else {
        ("failed", format!("With particle {i}’s parameters a run of the colony found no way."))
    };
    let rows = (0..x.len()).map(|j| {
        let axis = &swarm.axes[j];
        vec![axis.value(x[j]), v[j], axis.value(p[j]), axis.value(swarm.g[j])]
    });
    let way = &swarm.ways[i];
    Inspection {
        item,
        title: format!("Particle {i}"),
        event,
        summary,
        values: [
            quantity("cost", "\\bar L", "mean length", cost.length),
            quantity("converged", "\\bar t^*", "mean iteration of convergence", cost.converged),
            quantity("own", "\\bar L_p", "its best", swarm.p_cost[i].length),
            quantity("global", "\\bar L_g", "the swarm’s best", swarm.g_cost.length),
        ]
        .into_iter()
        .flatten()
        .collect(),
        formulas: vec!["velocity"],
        columns: COLUMNS.to_vec(),
        labels: swarm.axes.iter().map(|axis| axis.parameter.name.to_owned()).collect(),
        rows: rows.collect(),
        marks: if way.is_empty() { Vec::new() } else { vec![Mark::plane(layers::AFTER.key, Shape::Polyline, way.clone())] },
    }
}
