//! The fields of a `grid` scene.

use serde_json::Value;

use crate::{
    geometry::YAxis,
    kernel::{
        Error,
        fields::{Fields, each, number, object, point, points, shown},
    },
    message,
    scene::{
        check::this_field,
        moving::{Motion, Moving},
    },
};

use super::body::{GridScene, Robot};

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
        let given = robot.fields().into_iter().filter_map(|(name, value)| value.map(|value| (name, Value::from(value))));
        out.push(("robot", object(given.collect())));
    }
    if !grid.moving.is_empty() {
        let disc = |m: &Moving| {
            let motion = match &m.motion {
                Motion::Velocity(velocity) => ("velocity", point(*velocity)),
                Motion::Waypoints(list) => ("waypoints", list.iter().map(|moment| Value::from(moment.to_vec())).collect()),
            };
            object(vec![("center", point(m.center)), ("radius", m.radius.into()), motion])
        };
        out.push(("moving", Value::Array(grid.moving.iter().map(disc).collect())));
    }
}

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<GridScene, Error> {
    let cell = fields.number("cell")?;
    let y_axis = if fields.has("y_axis") { fields.one_of("y_axis", YAxis::ALL, YAxis::name)? } else { YAxis::Down };
    let (columns, blocked) = rows(fields, y_axis)?;
    let mut scene = GridScene::new(cell, columns, blocked);
    scene.y_axis = y_axis;
    scene.start = fields.optional_point("start")?;
    scene.goal = fields.optional_point("goal")?;
    if fields.has("stops") {
        scene.stops = fields.points("stops")?;
    }
    scene.corner_cutting = fields.flag("corner_cutting", false)?;
    scene.robot = match fields.take("robot") {
        Value::Null => None,
        value => Some(robot(value)?),
    };
    if fields.has("moving") {
        scene.moving = each("moving", fields.list("moving")?, moving)?;
    }
    Ok(scene.snapped())
}

/// The cells' rows: how many columns, and which cells are blocked, by growing y.
fn rows(fields: &mut Fields, y_axis: YAxis) -> Result<(usize, Vec<bool>), Error> {
    let mut lines = fields.list("rows")?;
    if y_axis == YAxis::Up {
        lines.reverse();
    }
    let mut columns = None;
    let mut blocked = Vec::new();
    let count = lines.len();
    for (i, line) in lines.iter().enumerate() {
        let name = format!("rows[{}]", if y_axis == YAxis::Up { count - 1 - i } else { i });
        let Some(line) = line.as_str() else {
            return Err(Error::refused(name, shown(line), message!("scene-row", "a text of . and #")));
        };
        if let Some(wrong) = line.chars().find(|c| !matches!(c, '.' | '#')) {
            let found = message!("scene-character", "the character {character}", character = shown_character(wrong));
            return Err(Error::refused(name, found, message!("scene-row-of", "only . (free) and # (blocked)")));
        }
        if *columns.get_or_insert(line.len()) != line.len() {
            let found = message!("scene-row-cells", "{n} cells", n = line.len());
            return Err(Error::refused(name, found, message!("scene-row-length", "as many cells as the other rows")));
        }
        blocked.extend(line.bytes().map(|c| c == b'#'));
    }
    Ok((columns.unwrap_or(0), blocked))
}

/// A character between quotes; one that a terminal would act on by its number.
fn shown_character(character: char) -> String {
    if character.is_control() { format!("'{}'", character.escape_unicode()) } else { format!("'{character}'") }
}

fn robot(value: Value) -> Result<Robot, Error> {
    let allowed = message!("scene-robot", "an object with length, width, speed, turn_time, sensor, radius, margin, look_ahead");
    let mut fields = Fields::of("robot", value, allowed)?;
    let mut given = |name| fields.optional_number(name);
    let robot = Robot {
        length: given("length")?,
        width: given("width")?,
        speed: given("speed")?,
        turn_time: given("turn_time")?,
        sensor: given("sensor")?,
        disc: given("radius")?,
        margin: given("margin")?,
        look_ahead: given("look_ahead")?,
    };
    fields.end()?;
    Ok(robot)
}

fn moving(at: &str, value: Value) -> Result<Moving, Error> {
    let allowed = message!("scene-moving", "an object with center, radius, and velocity or waypoints");
    let mut fields = Fields::of(at, value, allowed)?;
    let (center, radius) = (fields.point("center")?, fields.number("radius")?);
    let motion = match ["velocity", "waypoints"].map(|name| fields.has(name)) {
        [true, false] => {
            let velocity = fields.point("velocity")?;
            fields.allow("waypoints");
            Motion::Velocity(velocity)
        }
        [false, true] => {
            fields.allow("velocity");
            Motion::Waypoints(each(&fields.path("waypoints"), fields.list("waypoints")?, |at, value| moment(at, &value))?)
        }
        [false, false] => {
            let allowed = message!("scene-motion", "a velocity, [vx, vy], or else waypoints");
            return Err(fields.refuse("velocity", &Value::Null, allowed));
        }
        [true, true] => {
            let allowed = message!("scene-one-motion", "left out where there are waypoints");
            return Err(Error::refused(fields.path("velocity"), this_field(), allowed));
        }
    };
    fields.end()?;
    Ok(Moving { center, radius, motion })
}

/// A waypoint; `path` is its field.
fn moment(path: &str, found: &Value) -> Result<[f64; 3], Error> {
    let Some([time, x, y]) = found.as_array().map(Vec::as_slice) else {
        return Err(Error::refused(path, shown(found), message!("scene-waypoint", "a time and a point, [t, x, y]")));
    };
    Ok([number(format!("{path}[0]"), time)?, number(format!("{path}[1]"), x)?, number(format!("{path}[2]"), y)?])
}

#[cfg(test)]
mod tests {
    use crate::scene::{MAX_MOVING, MAX_WAYPOINTS};

    use super::*;
    use crate::standard;

    const DISC: &str = r#"{"center": [1, 1.5], "radius": 0.5, "velocity": [0.25, -1]}"#;
    const GUARD: &str = r#"{"center": [2, 1], "radius": 0.25, "waypoints": [[1.5, 2, 3], [3, 2, 3], [4.5, -2, 1e3]]}"#;
    const ROBOT: &str =
        r#"{"length": 0.5, "width": 0.25, "speed": 2, "turn_time": 0, "sensor": 3, "radius": 0.75, "margin": 0, "look_ahead": 8}"#;

    fn text(robot: &str, moving: &str) -> String {
        format!(
            r#"{{"format": "forage-scene", "version": 1, "kind": "grid", "name": "a", "title": "A", "cell": 1, "rows": ["...", "...", ".#."],
            "start": [0.5, 0.5], "goal": [2.5, 0.5], "robot": {robot}, "moving": {moving}}}"#
        )
    }

    #[test]
    fn every_field_of_what_moves_and_of_the_robot_survives_a_round_trip() {
        let scene = standard().read_scene(&text(ROBOT, &format!("[{DISC}, {GUARD}]"))).unwrap();
        let grid = scene.get::<GridScene>().unwrap();
        let guard = Motion::Waypoints(vec![[1.5, 2.0, 3.0], [3.0, 2.0, 3.0], [4.5, -2.0, 1000.0]]);
        let expected = [Moving::straight([1.0, 1.5], 0.5, [0.25, -1.0]), Moving { center: [2.0, 1.0], radius: 0.25, motion: guard }];
        assert_eq!(grid.moving, expected);
        let robot = Robot {
            length: Some(0.5),
            width: Some(0.25),
            speed: Some(2.0),
            turn_time: Some(0.0),
            sensor: Some(3.0),
            disc: Some(0.75),
            margin: Some(0.0),
            look_ahead: Some(8.0),
        };
        assert_eq!(grid.robot, Some(robot));
        for again in [scene.to_json(), scene.to_compact_json()] {
            assert_eq!(standard().read_scene(&again).unwrap(), scene);
            assert_eq!(again.matches("velocity").count() + again.matches("waypoints").count(), 2);
        }
    }

    /// JavaScript's whole numbers lose the sign of 0 on their way in: the bits must not depend on it.
    #[test]
    fn no_number_of_what_moves_is_minus_zero() {
        let signs = DISC.replace("[1, 1.5]", "[-0.0, 1]").replace("[0.25, -1]", "[-0.0, -0.0]");
        let guard = GUARD.replace("[3, 2, 3]", "[3, -0.0, -0.0]");
        let scene = standard().read_scene(&text(ROBOT, &format!("[{signs}, {guard}]"))).unwrap();
        let moving = &scene.get::<GridScene>().unwrap().moving;
        let (Motion::Velocity(velocity), Motion::Waypoints(points)) = (&moving[0].motion, &moving[1].motion) else { panic!("{moving:?}") };
        let all = [&moving[0].center[..], velocity, points.as_flattened()].concat();
        assert!(all.iter().all(|c| c.to_bits() != (-0.0_f64).to_bits()), "{all:?}");
    }

    #[test]
    fn each_wrong_field_is_refused_with_what_it_holds_and_what_is_allowed() {
        let change = |text: &str, from: &str, to: &str| {
            assert!(text.contains(from), "{from}");
            text.replacen(from, to, 1)
        };
        let refused = |robot: &str, moving: &str| {
            let error = standard().read_scene(&text(robot, moving)).unwrap_err();
            [error.field(), error.value(), &error.allowed()].map(str::to_owned)
        };
        let far = "from -1000000 to 1000000";
        let size = "greater than 0, at most 1000000";
        for (from, to, expected) in [
            ("\"center\": [1, 1.5], ", "", ["center", "nothing", "a point, [x, y]"]),
            ("[1, 1.5]", "[1]", ["center", "a list of 1", "a point, [x, y]"]),
            ("[1, 1.5]", "[1, -1000001]", ["center[1]", "-1000001", far]),
            ("\"radius\": 0.5, ", "", ["radius", "nothing", "a finite number"]),
            ("0.5", "0", ["radius", "0", size]),
            ("0.5", "-0.5", ["radius", "-0.5", size]),
            ("0.5", "2e6", ["radius", "2000000", size]),
            ("0.5", "\"0.5\"", ["radius", "\"0.5\"", "a finite number"]),
            (", \"velocity\": [0.25, -1]", "", ["velocity", "nothing", "a velocity, [vx, vy], or else waypoints"]),
            ("[0.25, -1]", "null", ["velocity", "nothing", "a point, [x, y]"]),
            ("[0.25, -1]", "[0.25, null]", ["velocity[1]", "nothing", "a finite number"]),
            ("[0.25, -1]", "[-1e7, -1]", ["velocity[0]", "-10000000", far]),
            ("\"velocity\"", "\"waypoints\": [[1, 2, 3]], \"velocity\"", ["velocity", "this field", "left out where there are waypoints"]),
            ("\"velocity\"", "\"speed\"", ["velocity", "nothing", "a velocity, [vx, vy], or else waypoints"]),
            (
                "\"velocity\"",
                "\"mass\": 1, \"velocity\"",
                ["mass", "this field", "left out, or one of center, radius, velocity, waypoints"],
            ),
        ] {
            let [field, value, allowed] = refused(ROBOT, &format!("[{GUARD}, {}]", change(DISC, from, to)));
            let path = format!("moving[1].{}", expected[0]);
            assert_eq!([field.as_str(), &value, &allowed], [&path, expected[1], expected[2]]);
        }
        for (from, to, expected) in [
            ("[[1.5, 2, 3], [3, 2, 3], [4.5, -2, 1e3]]", "3", ["", "3", "a list"]),
            ("[[1.5, 2, 3], [3, 2, 3], [4.5, -2, 1e3]]", "[]", ["", "an empty list", "1 to 10000 waypoints"]),
            ("[3, 2, 3]", "[2, 3]", ["[1]", "a list of 2", "a time and a point, [t, x, y]"]),
            ("[3, 2, 3]", "[3, 2, 3, 4]", ["[1]", "a list of 4", "a time and a point, [t, x, y]"]),
            ("[3, 2, 3]", "{}", ["[1]", "an object", "a time and a point, [t, x, y]"]),
            ("[3, 2, 3]", "[3, 2, true]", ["[1][2]", "true", "a finite number"]),
            ("[3, 2, 3]", "[\"3\", 2, 3]", ["[1][0]", "\"3\"", "a finite number"]),
            ("[3, 2, 3]", "[3, 2e6, 3]", ["[1][1]", "2000000", far]),
            ("[3, 2, 3]", "[3, 2, -2e6]", ["[1][2]", "-2000000", far]),
            ("[3, 2, 3]", "[1.5, 2, 3]", ["[1][0]", "1.5", "after 1.5, at most 1000000: the times of waypoints grow"]),
            ("[3, 2, 3]", "[1, 2, 3]", ["[1][0]", "1", "after 1.5, at most 1000000: the times of waypoints grow"]),
            ("[4.5, -2, 1e3]", "[1e7, -2, 1e3]", ["[2][0]", "10000000", "after 3, at most 1000000: the times of waypoints grow"]),
            ("[1.5, 2, 3]", "[0, 2, 3]", ["[0][0]", "0", "after 0, at most 1000000: the times of waypoints grow"]),
            ("[1.5, 2, 3]", "[1e-9, 2, 3]", ["[0][0]", "0.000000001", "late enough to be there at no more than 1000000 a second"]),
            ("[1.5, 2, 3]", "[4e-324, 2, 3]", ["[0][0]", "0", "late enough to be there at no more than 1000000 a second"]),
        ] {
            let [field, value, allowed] = refused(ROBOT, &format!("[{}]", change(GUARD, from, to)));
            let path = format!("moving[0].waypoints{}", expected[0]);
            let value = if value.len() > 20 { "0" } else { &value };
            assert_eq!([field.as_str(), value, &allowed], [&path, expected[1], expected[2]]);
        }
        for (from, to, expected) in [
            ("\"speed\": 2", "\"speed\": 0", ["speed", "0", "from 0.000000001 to 1000000000"]),
            ("\"sensor\": 3", "\"sensor\": -3", ["sensor", "-3", "from 0 to 1000000000"]),
            ("\"radius\": 0.75", "\"radius\": -1", ["radius", "-1", "from 0 to 1000000000"]),
            ("\"radius\": 0.75", "\"radius\": \"big\"", ["radius", "\"big\"", "a finite number"]),
            ("\"margin\": 0", "\"margin\": -1", ["margin", "-1", "from 0 to 1000000000"]),
            ("\"turn_time\": 0", "\"turn_time\": 1e7", ["turn_time", "10000000", "from 0 to 1000000"]),
            ("\"look_ahead\": 8", "\"look_ahead\": 1e7", ["look_ahead", "10000000", "from 0 to 1000000"]),
            ("\"look_ahead\": 8", "\"look_ahead\": null", ["look_ahead", "nothing", "a finite number"]),
            ("\"width\": 0.25, ", "", ["width", "nothing", "a width, as there is a length"]),
            (
                "\"margin\"",
                "\"disc\"",
                ["disc", "this field", "left out, or one of length, width, speed, turn_time, sensor, radius, margin, look_ahead"],
            ),
        ] {
            let [field, value, allowed] = refused(&change(ROBOT, from, to), "[]");
            assert_eq!([field.as_str(), &value, &allowed], [&format!("robot.{}", expected[0]), expected[1], expected[2]]);
        }
        let all = "an object with center, radius, and velocity or waypoints";
        for (moving, expected) in
            [("3", ["moving", "3", "a list"]), ("[[1, 2]]", ["moving[0]", "a list of 2", all]), ("[null]", ["moving[0]", "nothing", all])]
        {
            assert_eq!(refused(ROBOT, moving), expected);
        }
    }

    #[test]
    fn there_is_a_most_of_discs_and_of_way_points() {
        let list = |n: usize, one: &dyn Fn(usize) -> String| (1..=n).map(one).collect::<Vec<_>>().join(", ");
        let discs = |n| text(ROBOT, &format!("[{}]", list(n, &|_| DISC.to_owned())));
        let guard = |n| {
            let points = list(n, &|k| format!("[{k}, 1, 1]"));
            text(ROBOT, &format!(r#"[{{"center": [1, 1], "radius": 1, "waypoints": [{points}]}}]"#))
        };
        for (most, more, field) in
            [(discs(MAX_MOVING), discs(MAX_MOVING + 1), "moving"), (guard(MAX_WAYPOINTS), guard(MAX_WAYPOINTS + 1), "moving[0].waypoints")]
        {
            assert!(standard().read_scene(&most).is_ok());
            assert_eq!(standard().read_scene(&more).unwrap_err().field(), field);
        }
    }
}
