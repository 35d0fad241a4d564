//! One flight of a bat, condition by condition.

use super::*;
use crate::{exact::Distances, kernel::TourEnds, params::Overrides, scene::TOUR};

/// A bat at the tour 0 1 2 … n − 1 of stops on a circle, which is the shortest, but for `wrong` reversed places from 1
/// on; the best is the shortest but for its last two stops.
fn bats(n: usize, wrong: usize, pulse_rate: f64, loudness: f64) -> Bats {
    let place = |i: usize| [math::cos_turns(i as f64 / n as f64), math::cos_turns(i as f64 / n as f64 - 0.25)];
    let distances = Distances::of(n, |i, j| crate::geometry::length(&[place(i), place(j)]));
    let problem = Arc::new(Problem::new(&distances, TourEnds::Closed));
    let given: Overrides = [("population", crate::Value::from(1.0)), ("local_search", crate::Value::from("none"))].into_iter().collect();
    let settings = Parameters::new(ENTRY.parameters, TOUR, &given).unwrap();
    let mut bats = begin(&problem, &settings, Stream::new(1, 0));
    let mut best = Tour::first(&problem);
    best.row.swap(n - 2, n - 1);
    best.settle(&problem);
    let mut own = best.clone();
    own.row[1..=wrong].reverse();
    own.settle(&problem);
    bats.best = best;
    bats.swarm[0] = Bat { tour: own, loudness, pulse_rate, ..bats.swarm[0].clone() };
    bats
}

#[test]
fn half_of_all_places_is_far_and_fewer_are_near() {
    for (n, wrong, hamming, range) in [(12, 6, 6, Range::Far), (12, 4, 4, Range::Near), (8, 4, 4, Range::Far), (8, 2, 2, Range::Near)] {
        let mut bats = bats(n, wrong, 1.0, 1.0);
        bats.step();
        let last_move = bats.swarm[0].last_move;
        assert_eq!((last_move.hamming, last_move.range), (hamming, range), "{n} stops, {wrong} reversed");
        assert!((1..=hamming).contains(&last_move.tries));
        assert_eq!(last_move.local, Local::Passed, "with a pulse rate of 1 nobody looks around the best");
    }
}

#[test]
fn a_bat_that_takes_a_tour_gets_quieter_and_its_pulse_rate_falls() {
    let mut taken = 0;
    for t in 0..40 {
        // Its own tour is bad: what is found around the best is often shorter. It always looks there, and always accepts.
        let mut bats = bats(12, 10, -1.0, -1.0);
        bats.rng = Stream::new(t, 1);
        bats.t = t;
        bats.swarm[0].tour.row = vec![0, 6, 1, 7, 2, 8, 3, 9, 4, 10, 5, 11, 0];
        bats.swarm[0].tour.settle(&bats.problem);
        bats.step();
        let bat = &bats.swarm[0];
        if bat.last_move.local == Local::Taken {
            taken += 1;
            assert_eq!(bat.loudness, -0.98, "(10): ε A");
            let factor = 1.0 - math::exp(-0.98 * (t + 1) as f64);
            assert_eq!(bat.pulse_rate, -factor, "(11): r (1 − e^(−λt))");
            assert!(bat.last_move.local_gain > 0.0);
        } else {
            assert_eq!((bat.loudness, bat.pulse_rate), (-1.0, -1.0));
        }
    }
    assert!(taken >= 10, "only {taken} of 40 took what they found");
}

#[test]
fn a_loud_bat_takes_nothing_from_around_the_best() {
    for seed in 0..40 {
        let mut bats = bats(12, 10, -1.0, 1.0);
        bats.rng = Stream::new(seed, 1);
        bats.step();
        assert_eq!(bats.swarm[0].last_move.local, Local::Tried);
        assert_eq!((bats.swarm[0].loudness, bats.swarm[0].pulse_rate), (1.0, -1.0));
    }
}

#[test]
fn bats_begin_half_loud_at_least_and_with_any_pulse_rate() {
    let problem = Arc::new(Problem::new(&Distances::of(9, |i, j| (j - i) as f64), TourEnds::Closed));
    let given: Overrides = [("population", crate::Value::from(400.0))].into_iter().collect();
    let settings = Parameters::new(ENTRY.parameters, TOUR, &given).unwrap();
    let bats = begin(&problem, &settings, Stream::new(1, 0));
    assert!(bats.swarm.iter().all(|bat| (0.5..1.0).contains(&bat.loudness) && (0.0..1.0).contains(&bat.pulse_rate)));
    let mean = |of: fn(&Bat) -> f64| bats.mean(of);
    assert!((mean(|bat| bat.loudness) - 0.75).abs() < 0.03 && (mean(|bat| bat.pulse_rate) - 0.5).abs() < 0.05);
}

/// Far from the best with one try, a child is rarely shorter: whether a bat takes it all the same is the reading.
#[test]
fn a_bat_takes_its_best_try_always_or_if_it_is_shorter() {
    let gains = |always: bool| -> Vec<f64> {
        let fly = |seed| {
            let mut bats = bats(12, 6, 1.0, 1.0);
            (bats.always, bats.rng) = (always, Stream::new(seed, 1));
            let before = bats.swarm[0].tour.length;
            bats.step();
            let Bat { tour, last_move, .. } = &bats.swarm[0];
            assert_eq!(before - tour.length, last_move.gain);
            last_move.gain
        };
        (0..40).map(fly).collect()
    };
    let (always, better) = (gains(true), gains(false));
    assert!(always.iter().any(|&gain| gain < 0.0), "{always:?}");
    let kept: Vec<_> = always.iter().map(|&gain| gain.max(0.0)).collect();
    assert_eq!(better, kept, "the same tries, and the longer ones refused");
}
