//! The numbers of a drive, and why it went as it did.

#[cfg(test)]
mod tests;

use crate::{
    describe::layers,
    geometry::closest_approach,
    kernel::{Inspection, Item, Label, LayerKey, Mark, Message, Readings, Shape},
    label, message,
};

use super::{
    drive::Dynamic,
    journey::Journey,
    parameters::{
        COLLISIONS, DETOURS, DRIVING, ESCAPES, GONE, IN_SIGHT, PLANNED, REPLANS, SMALLEST_DISTANCE, TIME, TURNING_TIME, TURNS, WAITED,
        WAITS, title_of,
    },
};

pub(super) fn read(dynamic: &Dynamic, out: &mut Readings) {
    let journey = dynamic.journey.as_deref();
    let number = |of: &dyn Fn(&Journey) -> f64| journey.map_or(0.0, of);
    let planned = journey.map_or(dynamic.route.shortest(), |journey| Some(journey.tally.length + journey.left()));
    out.push(PLANNED, planned.unwrap_or(f64::NAN));
    out.push(TIME, number(&|journey| journey.now));
    out.push(DRIVING, number(&|journey| journey.tally.length / dynamic.ground.body.speed));
    out.push(TURNING_TIME, number(&Journey::turning));
    out.push(WAITED, number(&Journey::waited));
    out.push(GONE, number(&|journey| journey.tally.length));
    out.push(TURNS, number(&|journey| journey.tally.turns as f64));
    out.push(DETOURS, number(&|journey| journey.tally.detours as f64));
    out.push(REPLANS, number(&|journey| journey.tally.replans as f64));
    out.push(WAITS, number(&|journey| journey.tally.waits as f64));
    out.push(ESCAPES, number(&|journey| journey.tally.escapes as f64));
    out.push(IN_SIGHT, number(&|journey| journey.view.threats.len() as f64));
    let gap = journey.map(|journey| journey.tally.gap).filter(|gap| gap.is_finite());
    out.push(SMALLEST_DISTANCE, gap.unwrap_or(f64::NAN));
    out.push(COLLISIONS, number(&|journey| journey.tally.collisions as f64));
}

/// Why the goal was not reached in time, and which parameter ended the drive.
pub(super) fn why_not(journey: &Journey, limit: &str) -> Message {
    let ([x, y], now) = (journey.pose.at, journey.now);
    if let Some((obstacle, since)) = journey.waits_for() {
        message!(
            "drive-late-waits",
            "After {now:.0} s the robot still waits at ({x:.1}, {y:.1}) for obstacle {obstacle}, since {since:.1} s; {limit} gives it longer",
            now,
            x,
            y,
            obstacle = obstacle + 1,
            since,
            limit
        )
    } else {
        message!(
            "drive-late",
            "After {now:.0} s the robot is at ({x:.1}, {y:.1}) and not at the goal; {limit} gives it longer",
            now,
            x,
            y,
            limit
        )
    }
}

pub(super) fn inspect(dynamic: &Dynamic, item: Item) -> Option<Inspection> {
    match item.layer {
        layer if layer == layers::MOVING.key => obstacle(dynamic, item, None),
        layer if layer == layers::EVENTS.key => event(dynamic.journey.as_ref()?, item),
        _ => dynamic.route.inspect(item),
    }
}

pub(super) fn suppose(dynamic: &Dynamic, item: Item, supposition: &str) -> Option<Inspection> {
    if item.layer == layers::MOVING.key { obstacle(dynamic, item, Some(supposition)) } else { dynamic.route.suppose(item, supposition) }
}

/// One of the two that come nearer.
const IT_STANDS: Label = label!("drive-obstacle-stands", "obstacle", "v_o = 0", "if it stood still");
const ROBOT_STANDS: Label = label!("drive-robot-stands", "robot", "v_r = 0", "if the robot stood still");

/// When an obstacle and the robot come nearest if both go on as they go now, or one of them stands still.
fn obstacle(dynamic: &Dynamic, item: Item, supposed: Option<&str>) -> Option<Inspection> {
    let ground = &*dynamic.ground;
    let (grid, body) = (&ground.grid, &ground.body);
    let disc = grid.moving.get(item.index)?;
    let journey = dynamic.journey.as_deref();
    let now = journey.map_or(0.0, |journey| journey.now);
    let (at, mut going) = journey.map_or((ground.endpoints.ends[0], [0.0; 2]), |journey| (journey.pose.at, journey.velocity()));
    let mut leg = disc.leg(now, body.border, grid.bounds());
    let moves = [(IT_STANDS, leg.velocity), (ROBOT_STANDS, going)].into_iter().filter(|&(_, velocity)| velocity != [0.0; 2]);
    let suppositions = moves.map(|(label, _)| label).collect();
    if supposed == Some(IT_STANDS.name) {
        leg.velocity = [0.0; 2];
    } else if supposed.is_some() {
        going = [0.0; 2];
    }
    let apart = [leg.at[0] - at[0], leg.at[1] - at[1]];
    let closing = [leg.velocity[0] - going[0], leg.velocity[1] - going[1]];
    let (time, centres) = closest_approach(apart, closing, leg.until - now);
    let rims = body.radius + disc.radius;
    let apart_now = closest_approach(apart, [0.0; 2], 0.0).1 - rims;
    let speed = closest_approach(leg.velocity, [0.0; 2], 0.0).1;
    let seen = apart_now + body.radius <= body.sensor;
    let least = centres - rims;
    let summary = match (seen, time == 0.0) {
        (_, true) if supposed.is_some() => {
            message!("drive-supposed-leaves", "It would come no nearer than the {now:.1} now.", now = apart_now)
        }
        (_, false) if supposed.is_some() => {
            message!("drive-supposed-comes", "It would come as near as {least:.1}, in {time:.1} s.", least, time)
        }
        (true, true) => message!(
            "drive-seen-leaves",
            "The robot sees it; it is {now:.1} from the robot’s rim and comes no nearer if both go on.",
            now = apart_now
        ),
        (false, true) => message!(
            "drive-unseen-leaves",
            "It is beyond the sensor’s reach; it is {now:.1} from the robot’s rim and comes no nearer if both go on.",
            now = apart_now
        ),
        (true, false) => {
            message!("drive-seen-comes", "The robot sees it; if both go on, it comes as near as {least:.1} in {time:.1} s.", least, time)
        }
        (false, false) => message!(
            "drive-unseen-comes",
            "It is beyond the sensor’s reach; if both go on, it comes as near as {least:.1} in {time:.1} s.",
            least,
            time
        ),
    };
    let title = message!("drive-obstacle", "Obstacle {i}", i = item.index + 1);
    let mut inspection = Inspection::new(item, title, if seen { "seen" } else { "unseen" }, summary);
    inspection.values = vec![
        label!("drive-until-nearest", "t", "t^*", "until it is nearest, seconds").is(time),
        label!("drive-rims-then", "d", "d^*", "distance of the rims then").is(least),
        label!("drive-rims-now", "now", "d", "distance of the rims now").is(apart_now),
        label!("drive-obstacle-speed", "speed", "|v|", "its speed").is(speed),
        label!("drive-approach", "towards", "-\\Delta p \\cdot \\Delta v", "how fast they approach, times their distance")
            .is(-(apart[0] * closing[0] + apart[1] * closing[1])),
        label!("drive-speed-squared", "squared", "|\\Delta v|^2", "the square of how fast they move against each other")
            .is(closing[0] * closing[0] + closing[1] * closing[1]),
        label!("drive-centres-then", "centres", "|\\Delta p + t^* \\Delta v|", "distance of the centres then").is(centres),
        label!("drive-robot-radius", "robot", "R", "the robot’s radius").is(body.radius),
        label!("drive-obstacle-radius", "radius", "r", "its radius").is(disc.radius),
    ];
    if closing != [0.0; 2] {
        inspection.formulas = vec!["approach"];
    }
    inspection.suppositions = suppositions;
    let after = |from: [f64; 2], velocity: [f64; 2], time: f64| [0, 1].map(|axis| from[axis] + time * velocity[axis]);
    let (robot, it) = (after(at, going, time), after(leg.at, leg.velocity, time));
    let segments = |layer: LayerKey, vertices: Vec<[f64; 2]>| Mark::plane(layer, Shape::Segments, vertices);
    inspection.marks = if supposed.is_some() {
        vec![segments(layers::JUMP.key, vec![robot, it]), Mark::plane(layers::AFTER.key, Shape::Points, vec![it])]
    } else {
        vec![
            segments(layers::VELOCITY.key, vec![leg.at, after(leg.at, leg.velocity, 1.0), at, after(at, going, 1.0)]),
            segments(layers::BEFORE.key, vec![at, leg.at]),
            segments(layers::CANDIDATES.key, vec![robot, it]),
            Mark::plane(layers::AFTER.key, Shape::Points, vec![leg.at]),
        ]
    };
    Some(inspection)
}

/// What happened at a place, and why.
fn event(journey: &Journey, item: Item) -> Option<Inspection> {
    let event = journey.events.get(item.index)?;
    let title = message!("drive-event", "{what}, {time:.1} s", what = title_of(event.kind)?, time = event.time);
    let mut inspection = Inspection::new(item, title, event.kind, event.reason.clone());
    inspection.values = vec![label!("drive-when", "t", "t", "when, seconds").is(event.time)];
    inspection.marks = vec![Mark::plane(layers::AFTER.key, Shape::Points, vec![event.place])];
    Some(inspection)
}
