//! Stops in the plane, evenly or in clusters: scenes of kind `tour`, with whole coordinates, as TSPLIB's instances have.

use crate::{
    describe::{Draft, Generator},
    exact::Metric,
    kernel::{rng::Stream, words},
    math::clamp,
    params::{Choice, Param, ParamValue, Parameters},
    scene::{TOUR, TourScene},
};

impl ParamValue for Metric {}

const COUNT: Param<u64> = Param::integer("stops", "", "Stops", [2, 2000, 52], "How many.").slider(5.0, 300.0, true);
const SIDE: Param<u64> =
    Param::integer("side", "", "Side", [10, 1_000_000, 1000], "Coordinates go from 0 to this.").slider(100.0, 10000.0, true);
const CLUSTERS: Param<u64> =
    Param::integer("clusters", "", "Clusters", [0, 100, 0], "How many clusters; 0: none, the stops are spread evenly.")
        .slider(0.0, 20.0, false);
const SPREAD: Param<f64> = Param::number(
    "spread",
    "",
    "Spread",
    [0.001, 1.0, 0.05],
    "How far a cluster spreads: the standard deviation from its centre along each axis, as a share of the side.",
);
const METRIC: Param<Metric> = Param::choice(
    "metric",
    "",
    "Metric",
    &[
        Choice::new("euc-2d", "EUC_2D", "Straight lines, rounded to whole numbers, as TSPLIB measures."),
        Choice::new("euclidean", "Euclidean", "Straight lines, unrounded."),
    ],
    &[Metric::Euc2d, Metric::Euclidean],
    "How far it is from one stop to another.",
);

/// Stops of a tour.
pub const STOPS: Generator = Generator {
    name: "stops",
    title: "Random stops",
    help: words("Stops in a square, with whole coordinates, each in a place of its own where there is room; evenly, or in clusters."),
    kind: TOUR,
    parameters: &[&[COUNT.entry(), SIDE.entry(), CLUSTERS.entry(), SPREAD.entry(), METRIC.entry()]],
    draw,
};

/// How often another place is tried for a stop whose place is taken or outside.
const TRIES: usize = 100;

fn draw(parameters: &Parameters, seed: u64) -> Draft {
    let stream = &mut Stream::new(seed, 0);
    let side = parameters[SIDE] as f64;
    let spread = parameters[SPREAD] * side;
    let even = |stream: &mut Stream| stream.below(side as usize + 1) as f64;
    let centres: Vec<_> = (0..parameters[CLUSTERS]).map(|_| [even(stream), even(stream)]).collect();
    let mut points: Vec<[f64; 2]> = Vec::new();
    for _ in 0..parameters[COUNT] {
        let mut place = [0.0; 2];
        for _ in 0..TRIES {
            place = if centres.is_empty() {
                [even(stream), even(stream)]
            } else {
                // + 0.0: no −0.
                centres[stream.below(centres.len())].map(|c| (c + spread * stream.normal()).round() + 0.0)
            };
            if place.iter().all(|c| (0.0..=side).contains(c)) && !points.contains(&place) {
                break;
            }
        }
        points.push(place.map(|c| clamp(c, 0.0, side)));
    }
    let size = points.len().to_string();
    Draft::new(TourScene::through(points, parameters[METRIC]), size)
}
