//! What a drive looks like: obstacles, what is expected of them, the robot and its way, and where it decided what.

use crate::{
    describe::layers,
    kernel::{Frame, LayerKey, Shape},
};

use super::{drive::Dynamic, journey::Journey, world::View};

pub(super) fn draw(dynamic: &Dynamic, frame: &mut Frame) {
    dynamic.route.draw(dynamic.journey.is_some(), frame);
    let ground = &*dynamic.ground;
    let (grid, body) = (&ground.grid, &ground.body);
    let journey = dynamic.journey.as_deref();
    let (now, at) = journey.map_or((0.0, ground.endpoints.ends[0]), |journey| (journey.now, journey.pose.at));
    // What it sees where it is now: the journey's own view is the one before the last period.
    let mut view = View::default();
    view.look(grid, body, at, now);
    for threat in &view.threats {
        frame.begin(layers::PREDICTED.key, Shape::Tube);
        for corner in view.range(threat, [now, f64::INFINITY], grid.bounds(), body) {
            frame.push(corner, View::width(threat, body));
        }
    }
    tube(frame, layers::SENSOR.key, at, body.sensor);
    if let Some(journey) = journey {
        ways(journey, frame);
    }
    for disc in &grid.moving {
        tube(frame, layers::MOVING.key, disc.at(now, body.border, grid.bounds()), disc.radius);
    }
    // A point is drawn as large as can be seen.
    let radius = if body.radius > 0.0 { body.radius } else { grid.cell / 5.0 };
    tube(frame, layers::ROBOT.key, at, radius);
    if let Some(heading) = journey.map(|journey| journey.pose.heading).filter(|&heading| heading != [0.0; 2]) {
        frame.begin(layers::ROBOT.key, Shape::Segments);
        frame.push(at, 0.0);
        frame.push([0, 1].map(|axis| at[axis] + radius * heading[axis]), 0.0);
    }
}

fn ways(journey: &Journey, frame: &mut Frame) {
    let ground = &*journey.ground;
    let at = journey.pose.at;
    frame.begin(layers::TRACK.key, Shape::Polyline);
    journey.moments.iter().for_each(|&[time, x, y]| frame.push([x, y], time));
    frame.push(at, journey.now);
    let left = journey.plan.left();
    if !left.is_empty() {
        frame.begin(layers::AHEAD.key, Shape::Polyline);
        frame.push(at, 0.0);
        left.iter().for_each(|step| frame.push(step.to, 0.0));
    }
    if let Some(goal) = journey.local_goal {
        frame.begin(layers::LOCAL_GOAL.key, Shape::Points);
        frame.push(ground.cells.centre(goal), 0.0);
    }
    if !journey.events.is_empty() {
        frame.begin(layers::EVENTS.key, Shape::Points);
        journey.events.iter().for_each(|event| frame.push(event.place, event.time));
    }
}

fn tube(frame: &mut Frame, layer: LayerKey, at: [f64; 2], radius: f64) {
    frame.begin(layer, Shape::Tube);
    frame.push(at, radius);
}
