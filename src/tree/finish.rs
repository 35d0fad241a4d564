//! What is made of a tree's path, [ARM-RRT](crate#papers) §3.2.2 and step 3: shortened, fitted by a polyline, smoothed. Each
//! part can be left out, and none ever goes through an obstacle.

use crate::{arm::Posture, describe::Formula, kernel::State, params::Parameters};

use super::{
    free::Free,
    hermite::smooth,
    parameters::{BLEND, POLYLINE, SHORTEN, SMOOTH, TOLERANCE},
    polyline::fitted,
    space::Space,
    vector::{between, distance, length},
};

/// What is to be made of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Finish {
    shorten: bool,
    fit: Option<f64>,
    /// How far from a corner the curve begins.
    smooth: Option<f64>,
    /// The step with which the path was made.
    step: f64,
}

impl Finish {
    /// By the settings `shorten`, `polyline`, `tolerance` and `smooth`.
    pub(super) fn new(settings: &Parameters, step: f64) -> Self {
        Self {
            shorten: settings[SHORTEN],
            fit: settings[POLYLINE].then(|| settings[TOLERANCE] * step),
            smooth: settings[SMOOTH].then(|| settings[BLEND] * step),
            step,
        }
    }

    /// Nothing is to be made of it.
    pub(super) fn raw(step: f64) -> Self {
        Self { shorten: false, fit: None, smooth: None, step }
    }

    /// Whether anything is to be made of it.
    pub(super) fn is_raw(&self) -> bool {
        !self.shorten && self.fit.is_none() && self.smooth.is_none()
    }
}

/// What was made of a path.
#[derive(Debug, State)]
pub(super) struct Finished<const N: usize> {
    /// Without its detours.
    pub(super) short: Vec<[f64; N]>,
    /// The result.
    pub(super) path: Vec<[f64; N]>,
}

/// As many coordinates as a path may have, with the angles of a posture.
const MOST: usize = 12;
/// As many angles has a posture.
const JOINTS: usize = 6;
/// What a radian of a posture counts as, in metres: so little that the length of a path is its tip's.
const SCALE: f64 = 1e-6;

/// Shortens, fits and smooths a path whose pieces are free. It is done with as many coordinates as there may be, so that its code is
/// there once: those that are 0 change no bit of the others.
pub(super) fn finish<const N: usize>(raw: &[[f64; N]], postures: &[Posture], how: &Finish, space: &dyn Space<N>) -> Finished<N> {
    const { assert!(N + JOINTS <= MOST) };
    let drop = |point: &[f64; MOST]| std::array::from_fn(|axis| point[axis]);
    let posture_of = |point: &[f64; MOST]| -> Posture { std::array::from_fn(|joint| point[MOST - JOINTS + joint] / SCALE) };
    let mut lifted = vec![[0.0; MOST]; raw.len()];
    for (place, point) in lifted.iter_mut().zip(raw) {
        place[..N].copy_from_slice(point);
    }
    for (place, posture) in lifted.iter_mut().zip(postures) {
        posture.iter().zip(&mut place[MOST - JOINTS..]).for_each(|(angle, to)| *to = angle * SCALE);
    }
    let is_free = |a: &[f64; MOST], b: &[f64; MOST]| space.is_free(&drop(a), &drop(b));
    let reaches = |a: &[f64; MOST], b: &[f64; MOST]| space.posture_at(&drop(a), &posture_of(a), &drop(b), Some(&posture_of(b))).is_some();
    let Finished { short, path } =
        if postures.is_empty() { finished(&lifted, how, &is_free) } else { finished_reachably(&lifted, how, &is_free, &reaches) };
    Finished { short: short.iter().map(drop).collect(), path: path.iter().map(drop).collect() }
}

/// The same where an arm has to get from each point to the next. Mostly it gets along the path for which that was not tested piece by
/// piece: a tenth of the time.
#[inline(never)]
fn finished_reachably(raw: &[[f64; MOST]], how: &Finish, free: Free<MOST>, reaches: Free<MOST>) -> Finished<MOST> {
    let made = finished(raw, how, free);
    let holds = [&made.path, &made.short].iter().all(|path| path.windows(2).all(|w| reaches(&w[0], &w[1])));
    if holds { made } else { finished(raw, how, &|a, b| free(a, b) && reaches(a, b)) }
}

#[inline(never)]
fn finished(raw: &[[f64; MOST]], how: &Finish, free: Free<MOST>) -> Finished<MOST> {
    let short = if how.shorten { shortened(raw, FINE * how.step, free) } else { raw.to_vec() };
    let fit = how.fit.map_or_else(|| short.clone(), |tolerance| fitted(&short, tolerance, how.step, free));
    let path = how.smooth.map_or_else(|| fit.clone(), |blend| smooth(&fit, blend, free));
    Finished { short, path }
}

/// Up to so many nodes, each is tested with each.
const MANY: usize = 150;
/// Corners are cut this often at most, and not any more when that gains less than a share of the length.
const ROUNDS: usize = 30;
const GAIN: f64 = 1e-5;
/// A corner is cut at most so many times finer than its neighbours are away,
const HALVINGS: usize = 7;
/// and no nearer to it than this, in steps: round obstacles would make corners without end.
const FINE: f64 = 0.05;

/// The path without detours: the shortest way over its own nodes that see each other, and then its corners cut, again and
/// again, as far as that is free.
pub(super) fn shortened<const N: usize>(path: &[[f64; N]], fine: f64, free: Free<N>) -> Vec<[f64; N]> {
    let mut path = if path.len() <= MANY { over_seen(path, free) } else { without_needless(path.to_vec(), free) };
    let mut last = length(&path);
    for _ in 0..ROUNDS {
        path = without_needless(cut(&path, fine, free), free);
        let now = length(&path);
        if now > last * (1.0 - GAIN) {
            break;
        }
        last = now;
    }
    path
}

/// The shortest way over a path's nodes, in their order, where each sees the next.
fn over_seen<const N: usize>(path: &[[f64; N]], free: Free<N>) -> Vec<[f64; N]> {
    let n = path.len();
    let mut best = vec![f64::INFINITY; n];
    let mut before = vec![0; n];
    if n > 0 {
        best[0] = 0.0;
    }
    for j in 1..n {
        for i in 0..j {
            let way = best[i] + distance(&path[i], &path[j]);
            // Neighbours are joined already.
            if way < best[j] && (i + 1 == j || free(&path[i], &path[j])) {
                (best[j], before[j]) = (way, i);
            }
        }
    }
    let mut way: Vec<_> = std::iter::successors(n.checked_sub(1), |&j| (j > 0).then(|| before[j])).map(|j| path[j]).collect();
    way.reverse();
    way
}

/// Without the nodes whose neighbours see each other.
fn without_needless<const N: usize>(mut path: Vec<[f64; N]>, free: Free<N>) -> Vec<[f64; N]> {
    loop {
        let before = path.len();
        let mut kept: Vec<[f64; N]> = Vec::with_capacity(before);
        for i in 0..before {
            let needless = i > 0 && i + 1 < before && free(&kept[kept.len() - 1], &path[i + 1]);
            if !needless {
                kept.push(path[i]);
            }
        }
        path = kept;
        if path.len() == before {
            return path;
        }
    }
}

/// Each corner cut by the longest straight piece that is free, between points as far from it on both sides by halves.
fn cut<const N: usize>(path: &[[f64; N]], fine: f64, free: Free<N>) -> Vec<[f64; N]> {
    if path.len() < 3 {
        return path.to_vec();
    }
    let mut out = vec![path[0]];
    for w in path.windows(3) {
        let (from, corner, to) = (out[out.len() - 1], &w[1], &w[2]);
        // The way back is what the last cut has left; the way on only half, or the next corner could not be cut.
        let mut share = 0.5_f64;
        let mut done = false;
        for _ in 0..HALVINGS {
            if share * distance(corner, &from).max(distance(corner, to)) < fine {
                break;
            }
            let (a, b) = (between(corner, &from, share.min(0.999)), between(corner, to, share));
            if free(&a, &b) {
                out.extend([a, b]);
                done = true;
                break;
            }
            share /= 2.0;
        }
        if !done {
            out.push(*corner);
        }
    }
    out.push(path[path.len() - 1]);
    out
}

/// The fit of `polyline`.
pub(super) const FITTED: Formula = Formula::new(
    "polyline",
    "[ARM-RRT] step 3",
    "Polyline by least squares",
    "\\min_{c} \\sum_i \\Bigl\\lVert x_i - \\sum_j \\Lambda_j(u_i)\\, c_j \\Bigr\\rVert^2",
    "",
);
/// The curves of `hermite`.
pub(super) const HERMITE: Formula = Formula::new(
    "hermite",
    "[ARM-RRT] (12)",
    "Hermite smoothing",
    "p(t) = (2t^3 - 3t^2 + 1)\\,p_0 + (t^3 - 2t^2 + t)\\,R_0 + (t^3 - t^2)\\,R_1 + (-2t^3 + 3t^2)\\,p_1",
    "",
);
