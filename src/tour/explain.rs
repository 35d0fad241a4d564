//! What a road, a stop and a tour are asked about.

use crate::{
    describe::layers,
    geometry,
    kernel::{Inspection, Item, Label, Mark, Message, Quantity, Shape},
    label, message,
};

use super::{
    moves,
    problem::{Problem, Tour},
    roads::Network,
};

const ORDER: [Label; 3] = [
    label!("tour-own-stop", "own", "s_i", "its stop"),
    label!("tour-best-stop", "best", "s_i^*", "the shortest tour’s stop"),
    label!("tour-differs", "differs", "\\ne", "1 where they differ"),
];

/// What can be supposed of those that follow the best tour.
pub(super) const WITHOUT_BEST: Label = label!("tour-without-best", "best", "s^*", "without the best tour");

/// A number, unless there is none.
pub(super) fn quantity(label: Label, value: f64) -> Option<Quantity> {
    value.is_finite().then_some(label.is(value))
}

/// A way to draw clearly.
pub(super) fn way(vertices: Vec<[f64; 2]>) -> Mark {
    Mark::plane(layers::WAY.key, Shape::Polyline, vertices)
}

/// A tour that is asked about before there are any.
pub(super) fn no_tour(item: Item) -> Inspection {
    Inspection::new(item, title(item), "waiting", waits())
}

/// The first tour of a search that begins anywhere.
pub(super) fn random_start() -> Message {
    message!("tour-random-start", "It begins with a random tour.")
}

fn title(item: Item) -> Message {
    message!("tour-one", "Tour {i}", i = item.index + 1)
}

fn waits() -> Message {
    message!("tour-none-yet", "There is no tour yet.")
}

/// The road of a pair of stops.
#[inline(never)]
pub(super) fn road(network: &Network, item: Item) -> Option<Inspection> {
    if item.index >= network.pairs() {
        return None;
    }
    let [i, j] = network.pair(item.index);
    let (from, to) = (i + 1, j + 1);
    let title = message!("tour-road", "Road {from} – {to}", from, to);
    let Some(road) = network.roads.get(item.index) else {
        return Some(Inspection::new(item, title, "waiting", message!("tour-road-waits", "It is not built yet.")));
    };
    let straight = geometry::length(&[network.stops[i], network.stops[j]]);
    let (event, summary) = if road.is_found() {
        let length = road.length;
        ("built", message!("tour-road-built", "From stop {from} to stop {to}: {length:.4}.", from, to, length))
    } else if road.path.is_empty() {
        ("failed", message!("tour-road-failed", "The run from stop {from} to stop {to} found no way.", from, to))
    } else {
        let over: Vec<_> = road.over.iter().map(|stop| (stop + 1).to_string()).collect();
        let summary = message!(
            "tour-road-joined",
            "The run from stop {from} to stop {to} found no way; over stop {over} it is {length:.4}.",
            from,
            to,
            over = over.join(", "),
            length = road.length
        );
        ("joined", summary)
    };
    let mut inspection = Inspection::new(item, title, event, summary);
    let values = [
        quantity(label!("tour-length", "length", "L", "length"), road.length),
        quantity(label!("tour-straight-line", "d", "d", "straight line"), straight),
        quantity(label!("tour-found-in-iteration", "converged", "t^*", "found in iteration"), road.converged),
    ];
    inspection.values = values.into_iter().flatten().collect();
    if !road.path.is_empty() {
        inspection.marks.push(way(road.path.clone()));
    }
    Some(inspection)
}

/// A stop, and its neighbours in the shortest tour.
#[inline(never)]
pub(super) fn stop(best: Option<(&Problem, &Tour)>, places: &[[f64; 2]], item: Item) -> Option<Inspection> {
    let stop = item.index;
    places.get(stop)?;
    let title = message!("tour-stop", "Stop {i}", i = stop + 1);
    let Some((problem, tour)) = best else {
        return Some(Inspection::new(item, title, "waiting", waits()));
    };
    let order = tour.order(problem);
    let place = order.iter().position(|&other| other == stop)?;
    let closed = problem.round.closes();
    let before = place.checked_sub(1).or(closed.then_some(order.len() - 1)).map(|k| order[k]);
    let after = order.get(place + 1).or(order.first().filter(|_| closed)).copied();
    let k = place + 1;
    let summary = match [before, after].map(|other| other.map(|other| other + 1)) {
        [Some(a), Some(b)] => {
            message!("tour-called", "Number {k} of the shortest tour, after stop {a} and before stop {b}.", k, a, b)
        }
        [None, Some(b)] => {
            message!("tour-called-first", "Number {k} of the shortest tour, after nothing and before stop {b}.", k, b)
        }
        [Some(a), None] => {
            message!("tour-called-last", "Number {k} of the shortest tour, after stop {a} and before nothing.", k, a)
        }
        [None, None] => message!("tour-called-alone", "Number {k} of the shortest tour, after nothing and before nothing.", k),
    };
    let mut inspection = Inspection::new(item, title, "called", summary);
    // A fixed edge costs nothing.
    let leg = |other: Option<usize>| other.map_or(f64::NAN, |other| problem.d(stop as u32, other as u32).max(0.0));
    let values = [
        quantity(label!("tour-place", "place", "i", "place in the tour"), (place + 1) as f64),
        quantity(label!("tour-from-before", "from", "d_-", "from the stop before"), leg(before)),
        quantity(label!("tour-to-after", "to", "d_+", "to the stop after"), leg(after)),
    ];
    inspection.values = values.into_iter().flatten().collect();
    Some(inspection)
}

/// A tour beside the best: what differs.
#[inline(never)]
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
    let mut inspection = Inspection::new(item, title(item), "moved", Message::default());
    inspection.values = [
        quantity(label!("tour-length", "length", "D", "length"), tour.length),
        quantity(label!("tour-different", "different", "HD", "places that differ"), different as f64),
    ]
    .into_iter()
    .flatten()
    .collect();
    inspection.formulas = vec!["length"];
    inspection.columns = ORDER.to_vec();
    inspection.labels = (1..=own.len()).map(|place| Message::verbatim(place.to_string())).collect();
    let number = |stop: usize| (stop + 1) as f64;
    inspection.rows = (0..own.len()).map(|k| vec![number(own[k]), number(theirs[k]), f64::from(u8::from(differs[k]))]).collect();
    let vertices: Vec<_> = own.iter().zip(&differs).filter(|(_, differs)| **differs).map(|(&stop, _)| places[stop]).collect();
    if !vertices.is_empty() {
        inspection.marks.push(Mark::plane(layers::DIFFERENT.key, Shape::Points, vertices));
    }
    inspection
}
