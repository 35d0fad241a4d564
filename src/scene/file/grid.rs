//! The fields of a `grid` scene.

use serde_json::Value;

use crate::error::Error;

use super::{
    super::{GridScene, Motion, Moving, Robot, YAxis},
    Fields, object, point, point_of, points, shown,
};

/// Its fields, in the order in which they are written.
pub(super) fn write(grid: &GridScene, out: &mut Vec<(&'static str, Value)>) {
    let lines = grid.lines().into_iter().map(Value::from).collect();
    out.extend([("cell", Value::from(grid.cell)), ("y_axis", Value::from(grid.y_axis.name())), ("rows", Value::Array(lines))]);
    for (name, end) in [("start", grid.start), ("goal", grid.goal)] {
        out.extend(end.map(|end| (name, point(end))));
    }
    if !grid.stops.is_empty() {
        out.push(("stops", points(&grid.stops)));
    }
    if grid.corner_cutting {
        out.push(("corner_cutting", Value::Bool(true)));
    }
    if let Some(robot) = grid.robot {
        let mut given = robot.fields().into_iter().filter_map(|(name, value)| value.map(|value| (name, Value::from(value))));
        out.push(("robot", object(&mut given)));
    }
    if !grid.moving.is_empty() {
        let disc = |m: &Moving| {
            let motion = match &m.motion {
                Motion::Velocity(velocity) => ("velocity", point(*velocity)),
                Motion::Waypoints(list) => ("waypoints", list.iter().map(|moment| Value::from(moment.to_vec())).collect()),
            };
            object(&mut [("center", point(m.center)), ("radius", m.radius.into()), motion].into_iter())
        };
        out.push(("moving", Value::Array(grid.moving.iter().map(disc).collect())));
    }
}

impl Fields {
    pub(super) fn grid(&mut self) -> Result<GridScene, Error> {
        let cell = self.number("cell")?;
        let y_axis = if self.left.contains_key("y_axis") { self.one_of("y_axis", YAxis::ALL, YAxis::name)? } else { YAxis::Down };
        let (columns, blocked) = self.rows(y_axis)?;
        let mut scene = GridScene::new(cell, columns, blocked);
        scene.y_axis = y_axis;
        scene.start = self.optional_point("start")?;
        scene.goal = self.optional_point("goal")?;
        if self.left.contains_key("stops") {
            scene.stops =
                self.list("stops")?.iter().enumerate().map(|(i, stop)| point_of(&format!("stops[{i}]"), stop)).collect::<Result<_, _>>()?;
        }
        scene.corner_cutting = self.flag("corner_cutting", false)?;
        scene.robot = match self.take("robot") {
            Value::Null => None,
            value => Some(robot(value)?),
        };
        if self.left.contains_key("moving") {
            scene.moving = self.list("moving")?.into_iter().enumerate().map(|(i, value)| moving(i, value)).collect::<Result<_, _>>()?;
        }
        Ok(scene.snapped())
    }

    /// The cells' rows: how many columns, and which cells are blocked, by growing y.
    fn rows(&mut self, y_axis: YAxis) -> Result<(usize, Vec<bool>), Error> {
        let mut lines = self.list("rows")?;
        if y_axis == YAxis::Up {
            lines.reverse();
        }
        let mut columns = None;
        let mut blocked = Vec::new();
        let count = lines.len();
        for (i, line) in lines.iter().enumerate() {
            let name = format!("rows[{}]", if y_axis == YAxis::Up { count - 1 - i } else { i });
            let Some(line) = line.as_str() else {
                return Err(Error::refused(name, shown(line), "a text of . and #"));
            };
            if let Some(wrong) = line.chars().find(|c| !matches!(c, '.' | '#')) {
                return Err(Error::refused(name, format!("the character {wrong:?}"), "only . (free) and # (blocked)"));
            }
            if *columns.get_or_insert(line.len()) != line.len() {
                return Err(Error::refused(name, format!("{} cells", line.len()), "as many cells as the other rows"));
            }
            blocked.extend(line.bytes().map(|c| c == b'#'));
        }
        Ok((columns.unwrap_or(0), blocked))
    }
}

fn robot(value: Value) -> Result<Robot, Error> {
    let mut fields = Fields::of("robot", value, "an object with length, width, speed, turn_time, sensor, radius, margin, look_ahead")?;
    let mut number = |name| if fields.left.contains_key(name) { fields.number(name).map(Some) } else { Ok(None) };
    let robot = Robot {
        length: number("length")?,
        width: number("width")?,
        speed: number("speed")?,
        turn_time: number("turn_time")?,
        sensor: number("sensor")?,
        disc: number("radius")?,
        margin: number("margin")?,
        look_ahead: number("look_ahead")?,
    };
    fields.known = robot.fields().map(|(name, _)| name).to_vec();
    fields.end()?;
    Ok(robot)
}

fn moving(i: usize, value: Value) -> Result<Moving, Error> {
    let name = format!("moving[{i}]");
    let mut fields = Fields::of(&name, value, "an object with center, radius, and velocity or waypoints")?;
    let (center, radius) = (fields.point("center")?, fields.number("radius")?);
    let motion = if fields.left.contains_key("waypoints") {
        let moment = |(k, value): (usize, Value)| {
            let numbers: Option<Vec<f64>> = value.as_array().and_then(|list| list.iter().map(Value::as_f64).collect());
            let moment = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
            moment.ok_or_else(|| Error::refused(format!("{name}.waypoints[{k}]"), shown(&value), "a time and a point, [t, x, y]"))
        };
        Motion::Waypoints(fields.list("waypoints")?.into_iter().enumerate().map(moment).collect::<Result<_, _>>()?)
    } else {
        Motion::Velocity(fields.point("velocity")?)
    };
    if matches!(motion, Motion::Waypoints(_)) && fields.left.contains_key("velocity") {
        return Err(Error::refused(format!("{name}.velocity"), "both", "velocity or waypoints, not both"));
    }
    fields.end()?;
    Ok(Moving { center, radius, motion })
}
