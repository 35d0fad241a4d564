//! How an arm is held along a tree of its tip's places: a posture for each node, so that the arm gets from each to the next with the
//! tip straight on and without touching anything. Not in [ARM-RRT](crate#papers), whose trees ask the tip alone.

use std::sync::Arc;

use crate::{
    arm::{self, Arm, ArmScene, Holding, Links, Posture},
    kernel::{Error, digits::coordinates},
    message,
};

use super::vector::{between, distance};

/// How far the tip goes from one posture to the next, in metres.
const SPACING: f64 = 0.04;
/// The farthest that a joint turns meanwhile, in radians, so that the tip keeps to its straight way.
const TURN: f64 = 0.35;
/// How far the hand's joints turn where it cannot be held as it is, in radians: the fourth and the fifth, in the order in which that is
/// tried.
const HAND: f64 = 0.3;
const HAND_TURNS: [[f64; 2]; 8] = [[0.0, -1.0], [0.0, 1.0], [-1.0, 0.0], [1.0, 0.0], [-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]];
/// How far any point of a link may go between two tests, in metres.
const RESOLUTION: f64 = 0.002;

/// An arm that goes along with its tip.
pub(super) struct ArmMotion {
    scene: Arc<ArmScene>,
    holding: Holding,
    /// The postures at start and goal.
    ends: [Posture; 2],
}

impl ArmMotion {
    /// Of a scene's arm. It begins in the posture nearest to home that touches nothing; what comes from the goal begins in the one nearest
    /// to that.
    ///
    /// # Errors
    /// [`Error::Refused`] for `start` or `goal` without such a posture.
    pub(super) fn new(scene: &Arc<ArmScene>) -> Result<Self, Error> {
        let nearest = |field, tip, near: &Posture| match free_postures(field, scene, tip, near, 0.0) {
            Err(Error::Refused { field, value, allowed }) => {
                let allowed = message!("tree-reachable-or", "{allowed}; or `reachable=false`, with which only the tip counts", allowed);
                Err(Error::Refused { field, value, allowed })
            }
            found => found.map(|postures| postures[0]),
        };
        let start = nearest("start", scene.start, &scene.arm.home())?;
        let goal = nearest("goal", scene.goal, &start)?;
        Ok(Self { ends: [start, goal], scene: Arc::clone(scene), holding: Holding::new(&scene.arm) })
    }

    /// The posture at the start, and one at the goal.
    pub(super) fn ends(&self) -> [Posture; 2] {
        self.ends
    }

    /// The posture at `b` where the tip goes straight there from `a`: the hand as it is held at `a`, or turned evenly to another on the
    /// way, one that is near. With `to` both postures are given, by their hands: the other joints follow from where the tip is.
    pub(super) fn posture_at(&self, a: &[f64; 3], from: &Posture, b: &[f64; 3], to: Option<&Posture>) -> Option<Posture> {
        let links = Links::new(&self.scene, 0.0);
        let held = |posture: &Posture| self.holding.hand([posture[3], posture[4], posture[5]]);
        if let Some(to) = to {
            let from = self.holding.nearest(&held(from), *a, from)?;
            return self.holding.nearest(&held(to), *b, to).filter(|to| self.motion_is_free(&links, [a, b], &from, to));
        }
        let is_free = |to: &Posture| self.motion_is_free(&links, [a, b], from, to);
        if let Some(next) = self.holding.nearest(&held(from), *b, from).filter(is_free) {
            return Some(next);
        }
        HAND_TURNS.iter().find_map(|&[fourth, fifth]| {
            let mut turned = *from;
            (turned[3], turned[4]) = (from[3] + fourth * HAND, from[4] + fifth * HAND);
            let within = [3, 4].iter().all(|&i| {
                let joint = &self.scene.arm.joints[i];
                (joint.min..=joint.max).contains(&turned[i].to_degrees())
            });
            if within { self.holding.nearest(&held(&turned), *b, from).filter(is_free) } else { None }
        })
    }

    /// Whether the arm gets from one posture to another with the tip straight on and the hand turning evenly.
    #[inline(never)]
    fn motion_is_free(&self, links: &Links, [a, b]: [&[f64; 3]; 2], from: &Posture, to: &Posture) -> bool {
        let pieces = (distance(a, b) / SPACING).ceil().max(1.0);
        let mut before = *from;
        let held = |posture: &Posture| self.holding.hand([posture[3], posture[4], posture[5]]);
        // Mostly it is not turned at all.
        let still = if from[3..] == to[3..] { Some(held(from)) } else { None };
        (1..=pieces as usize).all(|i| {
            let share = i as f64 / pieces;
            let guess: Posture = std::array::from_fn(|j| from[j] + share * (to[j] - from[j]));
            let hand = || still.unwrap_or_else(|| held(&guess));
            let next = if i as f64 == pieces { Some(*to) } else { self.holding.nearest(&hand(), between(a, b, share), &guess) };
            let Some(next) = next.filter(|next| next.iter().zip(before).all(|(x, y)| (x - y).abs() <= TURN)) else { return false };
            let free = links.motion_is_free(&before, &next, RESOLUTION);
            before = next;
            free
        })
    }
}

/// The postures that have the tip at a point and touch nothing, nearest to one first.
pub(super) fn free_postures(field: &str, scene: &ArmScene, point: [f64; 3], near: &Posture, radius: f64) -> Result<Vec<Posture>, Error> {
    let [mut reached, mut free] = [Vec::new(), Vec::new()];
    let mut why = None;
    for direction in Arm::directions() {
        match scene.arm.reaching(point, direction, near) {
            Ok(postures) => reached.extend(postures.iter().copied()),
            Err(unreachable) => why = Some(unreachable),
        }
    }
    free.extend(reached.iter().filter(|posture| !arm::touches(scene, &scene.arm.skeleton(posture), radius)));
    if free.is_empty() {
        let shown = coordinates(&point);
        let allowed = match why {
            Some(unreachable) if reached.is_empty() => {
                message!("tree-reachable", "where the arm can bring its tip: {why}", why = unreachable.message())
            }
            _ => message!("tree-reachable-free", "where the arm can bring its tip without touching a cuboid or its column"),
        };
        return Err(Error::refused(field, shown, allowed));
    }
    let mut order: Vec<_> = free.iter().enumerate().map(|(i, posture)| (arm::distance(posture, near), i)).collect();
    crate::math::sort(&mut order);
    Ok(order.into_iter().map(|(_, i)| free[i]).collect())
}
