//! What a road, a stop and a tour are asked about.

use crate::{
    describe::layers,
    geometry,
    kernel::{Inspection, Item, Label, Mark, Quantity, Shape},
    label,
};

use super::{
    moves,
    problem::{Problem, Tour},
    roads::Network,
};

/// The TeX strings that inspections use beside the members' own.
const ORDER: [Label; 3] = [
    label!("tour-its-stop", "own", "s_i", "its stop"),
    label!("tour-the-shortest-tours-stop", "best", "s_i^*", "the shortest tour’s stop"),
    label!("tour-1-where-they-differ", "differs", "\\ne", "1 where they differ"),
];

/// A number, unless there is none.
pub(super) fn quantity(label: Label, value: f64) -> Option<Quantity> {
    value.is_finite().then_some(label.is(value))
}

fn plain(item: Item, title: String, event: &'static str, summary: String) -> Inspection {
    Inspection {
        item,
        title: title.into(),
        event,
        summary: summary.into(),
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
        quantity(label!("tour-length", "length", "L", "length"), road.length),
        quantity(label!("tour-straight-line", "d", "d", "straight line"), straight),
        quantity(label!("tour-found-in-iteration", "converged", "t^*", "found in iteration"), road.converged),
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
        quantity(label!("tour-place-in-the-tour", "place", "i", "place in the tour"), (place + 1) as f64),
        quantity(label!("tour-from-the-stop-before", "from", "d_-", "from the stop before"), leg(before)),
        quantity(label!("tour-to-the-stop-after", "to", "d_+", "to the stop after"), leg(after)),
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
    told.values = [
        quantity(label!("tour-length", "length", "D", "length"), tour.length),
        quantity(label!("tour-places-that-differ", "different", "HD", "places that differ"), different as f64),
    ]
    .into_iter()
    .flatten()
    .collect();
    told.formulas = vec!["length"];
    told.columns = ORDER.to_vec();
    told.labels = (1..=own.len()).map(|place| place.to_string().into()).collect();
    let number = |stop: usize| (stop + 1) as f64;
    told.rows = (0..own.len()).map(|k| vec![number(own[k]), number(theirs[k]), f64::from(u8::from(differs[k]))]).collect();
    let vertices: Vec<_> = own.iter().zip(&differs).filter(|(_, differs)| **differs).map(|(&stop, _)| places[stop]).collect();
    if !vertices.is_empty() {
        told.marks.push(Mark::plane(layers::DIFFERENT.key, Shape::Points, vertices));
    }
    told
}
