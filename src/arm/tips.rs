//! The path of the tip through postures.

use super::{Arm, Posture};

/// Joints turn by no more than this between two points of a tip's path, in radians.
const TURN: f64 = 0.02;

/// The tip's path through postures, with all joints turning evenly from one to the next, as points on the curve: joints turn by
/// at most 0.02 rad between two of them.
pub fn tip_path(arm: &Arm, postures: &[Posture]) -> Vec<[f64; 3]> {
    let tip = |posture: &Posture| arm.skeleton(posture)[4];
    let mut path: Vec<_> = postures.first().map(tip).into_iter().collect();
    for w in postures.windows(2) {
        let turn = (0..6).fold(0.0_f64, |most, i| most.max((w[1][i] - w[0][i]).abs()));
        // Twelve turns at most, a joint having two.
        let n = (turn / TURN).ceil().clamp(1.0, 5000.0) as usize;
        path.extend((1..=n).map(|k| {
            let t = k as f64 / n as f64;
            tip(&if k == n { w[1] } else { std::array::from_fn(|i| w[0][i] + t * (w[1][i] - w[0][i])) })
        }));
    }
    path
}
