//! The nearest neighbour's tour.

use super::{
    field::Field,
    moves::turn,
    problem::{Problem, Stop, Tour},
};
use crate::kernel::rng::Stream;

/// The tour that goes on to the nearest stop not called at yet (Rosenkrantz et al. 1977), from a random one.
pub fn nearest_neighbour(problem: &Problem, rng: &mut Stream) -> Tour {
    let mut tour = Tour::first(problem);
    let m = tour.len();
    if m < 2 {
        return tour;
    }
    // A closed tour may begin anywhere and is turned afterwards; where the first stop is fixed it begins there.
    let closed = problem.round.closes();
    if closed || problem.two_way() {
        let first = usize::from(closed);
        let row = &mut tour.row[1 - first..=m];
        let start = rng.below(row.len());
        row.swap(0, start);
        chain(problem, row);
        if let Some(home) = row.iter().position(|&stop| closed && stop == 0) {
            turn(row, home);
        }
    } else {
        chain(problem, &mut tour.row[..=m]);
    }
    tour.settle(problem);
    tour
}

/// Orders stops after the first, each by its distance from the one before; by the straight line where distances are computed.
fn chain(problem: &Problem, row: &mut [Stop]) {
    if !problem.points().is_empty() {
        let mut field = Field::new(problem.points(), &row[1..]);
        for k in 1..row.len() {
            row[k] = field.take_nearest(row[k - 1]).unwrap_or(row[k]);
        }
        return;
    }
    for k in 1..row.len() {
        let from = row[k - 1];
        let nearest = (k..row.len()).min_by(|&i, &j| problem.d(from, row[i]).total_cmp(&problem.d(from, row[j])).then(row[i].cmp(&row[j])));
        row.swap(k, nearest.unwrap_or(k));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{exact::Distances, kernel::TourEnds};

    #[test]
    fn the_nearest_neighbour_comes_next() {
        // Stops on a line at 0, 10, 1, 3: from any of them it goes on to the nearest.
        let at = [0.0_f64, 10.0, 1.0, 3.0];
        let distances = Distances::of(4, |i, j| (at[i] - at[j]).abs());
        for round in [TourEnds::FromFirst, TourEnds::FirstToLast] {
            let problem = Problem::new(&distances, round);
            let order = nearest_neighbour(&problem, &mut Stream::new(1, 0)).order(&problem);
            assert_eq!(order, if round == TourEnds::FromFirst { [0, 2, 3, 1] } else { [0, 2, 1, 3] });
        }
        let problem = Problem::new(&distances, TourEnds::Closed);
        for seed in 0..9 {
            let tour = nearest_neighbour(&problem, &mut Stream::new(seed, 0));
            assert_eq!(tour.length, 20.0, "every such tour goes there and back");
        }
    }
}
