//! What a road, a stop and a tour are asked about.

use crate::{
    describe::layers,
    geometry,
    kernel::{Column, Inspection, Item, Mark, Quantity, Shape},
};

use super::{
    moves,
    problem::{Problem, Tour},
    roads::Network,
};

/// The TeX strings that inspections use beside the members' own.
pub(super) const SYMBOLS: &[&str] = &[
    "D",
    "HD",
    "s_i",
    "s_i^*",
    "\\ne",
    "v",
    "D'",
    "\\Delta D'",
    "A",
    "r",
    "\\Delta D",
    "L",
    "t^*",
    "d",
    "d_-",
    "d_+",
    "i",
    "f",
    "D_a",
    "D_b",
    "D_p",
    "w v",
    "p \\ominus x",
    "g \\ominus x",
    "|v|",
    "|x^* \\ominus x|",
    "T",
    "T'",
    "k",
    "k_+",
    "\\Delta_{\\max}",
    "P",
];

const ORDER: [Column; 3] = [
    Column { name: "own", symbol: "s_i", title: "its stop" },
    Column { name: "best", symbol: "s_i^*", title: "the shortest tour’s stop" },
    Column { name: "differs", symbol: "\\ne", title: "1 where they differ" },
];

/// A number with its name.
pub(super) fn quantity(name: &'static str, symbol: &'static str, title: &'static str, value: f64) -> Option<Quantity> {
    value.is_finite().then_some(Quantity { name, symbol, title, value })
}

fn plain(item: Item, title: String, event: &'static str, summary: String) -> Inspection {
    Inspection {
        item,
        title,
        event,
        summary,
        values: Vec::new(),
        formulas: Vec::new(),
        columns: Vec::new(),
        labels: Vec::new(),
        rows: Vec::new(),
        marks: Vec::new(),
    }
}

/// A way to draw clearly.
pub(super) fn way(vertices: Vec<[f64; 2]>) -> Mark {
    Mark::plane(layers::AFTER.key, Shape::Polyline, vertices)
}

/// A tour that is asked about before there are any.
pub(super) fn no_tour(item: Item) -> Inspection {
    plain(item, format!("Tour {}", item.index + 1), "waiting", "There is no tour yet.".to_owned())
}

/// The road of a pair of stops.
pub(super) fn road(network: &Network, item: Item) -> Option<Inspection> {
    if item.index >= network.pairs() {
        return None;
    }
    let [i, j] = network.pair(item.index);
    let Some(road) = network.roads.get(item.index) else {
        return Some(plain(item, format!("Road {} – {}", i + 1, j + 1), "waiting", "It is not built yet.".to_owned()));
    };
    let straight = geometry::length(&[network.stops[i], network.stops[j]]);
    let (from, to) = (i + 1, j + 1);
    let (event, summary) = if road.is_found() {
        ("built", format!("From stop {from} to stop {to}: {:.4}.", road.length))
    } else if road.path.is_empty() {
        ("failed", format!("The run from stop {from} to stop {to} found no way."))
    } else {
        let over: Vec<_> = road.over.iter().map(|stop| (stop + 1).to_string()).collect();
        ("joined", format!("The run from stop {from} to stop {to} found no way; over stop {} it is {:.4}.", over.join(", "), road.length))
    };
    let mut told = plain(item, format!("Road {} – {}", i + 1, j + 1), event, summary);
    let values = [
        quantity("length", "L", "length", road.length),
        quantity("d", "d", "straight line", straight),
        quantity("converged", "t^*", "found in iteration", road.converged),
    ];
    told.values = values.into_iter().flatten().collect();
    if !road.path.is_empty() {
        told.marks.push(way(road.path.clone()));
    }
    Some(told)
}

/// A stop, and its neighbours in the shortest tour.
pub(super) fn stop(best: Option<(&Problem, &Tour)>, places: &[[f64; 2]], item: Item) -> Option<Inspection> {
    let stop = item.index;
    places.get(stop)?;
    let title = format!("Stop {}", stop + 1);
    let Some((problem, tour)) = best else {
        return Some(plain(item, title, "waiting", "There is no tour yet.".to_owned()));
    };
    let order = tour.order(problem);
    let place = order.iter().position(|&other| other == stop)?;
    let closed = problem.round.closes();
    let before = place.checked_sub(1).or(closed.then_some(order.len() - 1)).map(|k| order[k]);
    let after = order.get(place + 1).or(order.first().filter(|_| closed)).copied();
    let ends = [before, after].map(|other| other.map_or_else(|| "nothing".to_owned(), |other| format!("stop {}", other + 1)));
    let mut told =
        plain(item, title, "called", format!("Number {} of the shortest tour, after {} and before {}.", place + 1, ends[0], ends[1]));
    let leg = |other: Option<usize>| other.map_or(f64::NAN, |other| problem.d(stop as u16, other as u16));
    let values = [
        quantity("place", "i", "place in the tour", (place + 1) as f64),
        quantity("from", "d_-", "from the stop before", leg(before)),
        quantity("to", "d_+", "to the stop after", leg(after)),
    ];
    told.values = values.into_iter().flatten().collect();
    Some(told)
}

/// A tour beside the best: what differs.
pub(super) fn tour(problem: &Problem, tour: &Tour, best: &Tour, places: &[[f64; 2]], item: Item) -> Inspection {
    let (own, theirs) = (tour.order(problem), best.order(problem));
    // The direction in which fewer places differ counts, [ANTBAT] (12).
    let m = tour.len();
    let straight = tour.row[1..=m].iter().zip(&best.row[1..=m]).filter(|(a, b)| a != b).count();
    let different = moves::hamming(problem, &tour.row, &best.row);
    let mut own = own;
    if different < straight {
        let fixed = usize::from(problem.round.closes());
        own[fixed..].reverse();
    }
    let differs: Vec<bool> = own.iter().zip(&theirs).map(|(a, b)| a != b).collect();
    let mut told = plain(item, format!("Tour {}", item.index + 1), "moved", String::new());
    told.values = [quantity("length", "D", "length", tour.length), quantity("different", "HD", "places that differ", different as f64)]
        .into_iter()
        .flatten()
        .collect();
    told.formulas = vec!["length"];
    told.columns = ORDER.to_vec();
    told.labels = (1..=own.len()).map(|place| place.to_string()).collect();
    let number = |stop: usize| (stop + 1) as f64;
    told.rows = (0..own.len()).map(|k| vec![number(own[k]), number(theirs[k]), f64::from(u8::from(differs[k]))]).collect();
    let vertices: Vec<_> = own.iter().zip(&differs).filter(|(_, differs)| **differs).map(|(&stop, _)| places[stop]).collect();
    if !vertices.is_empty() {
        told.marks.push(Mark::plane(layers::DIFFERENT.key, Shape::Points, vertices));
    }
    told
}
