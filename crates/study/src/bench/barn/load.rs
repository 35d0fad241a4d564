//! The worlds of a copy of the challenge's repository: cylinders that stand or move, as grids with a robot.

use std::{
    fs,
    path::{Path, PathBuf},
};

use forage::{
    Error,
    geometry::{YAxis, length as along},
    kernel::Message,
    message,
    scene::{GridScene, Motion, Moving, Robot},
};

use super::{
    super::super::failure::{Failure, at},
    motion::Animation,
};

/// Start and goal in the static worlds, in metres, as in run.py.
const STATIC: [[f64; 2]; 2] = [[-2.25, 3.0], [-2.25, 13.0]];
/// Those in the worlds with moving obstacles.
const MOVING: [[f64; 2]; 2] = [[11.0, 0.0], [-9.0, 0.0]];
/// Seconds after which a run has failed.
pub(super) const LIMIT: f64 = 100.0;
/// The fastest that the robot may be, by which the score has the best time, in metres a second.
pub(super) const FASTEST: f64 = 2.0;
/// Half the width of the robot, a Jackal: the clearance with which the worlds' own paths were made.
pub const RADIUS: f64 = 0.215;
/// The time of a turn in place, in seconds: 45° at 1.57 rad/s, rounded.
const TURN: f64 = 0.5;
/// How far its laser sees, in metres.
const SENSOR: f64 = 10.0;
/// How many seconds ahead it foresees.
const LOOK_AHEAD: f64 = 3.0;
/// Safety margin to moving obstacles, in metres.
const MARGIN: f64 = 0.2;
/// The side of a cell, in metres: half a cylinder of the static worlds. Among moving obstacles the robot fits into a cell.
const CELLS: [f64; 2] = [0.075, 0.5];
/// The first number of a world with moving obstacles.
const MOVES: usize = 300;
/// Nothing is farther from the origin, in metres: a grid over more has too many cells.
const FAR: f64 = 50.0;
/// The radius of a cylinder of the paths that come with the worlds.
const CYLINDER: f64 = 0.075;

/// A world.
pub struct World {
    /// Its set: `BARN` or `DynaBARN`.
    pub set: &'static str,
    /// Its number in the challenge, from 0 to 359.
    pub number: usize,
    /// As a scene.
    pub grid: GridScene,
    /// Static cylinders: their centres and radii.
    pub cylinders: Vec<([f64; 2], f64)>,
    /// The length of the challenge's reference path, in metres.
    pub length: f64,
}

/// Worlds by their number, and notes of those that cannot be read.
pub(super) fn worlds(folder: &Path, radius: f64) -> Result<(Vec<World>, Vec<Message>), Failure> {
    let base = [folder.join("jackal_helper"), folder.to_owned()].into_iter().find(|base| base.join("worlds").is_dir());
    let base = base.ok_or_else(|| {
        let allowed =
            message!("study-barn-folder", "a copy of the repository Daffan/the-barn-challenge, with its folder jackal_helper/worlds");
        Error::refused("DIR", folder.display().to_string(), allowed)
    })?;
    let (mut worlds, mut notes) = (Vec::new(), Vec::new());
    for (set, first) in [("BARN", 0), ("DynaBARN", MOVES)] {
        let folder = base.join("worlds").join(set);
        for (number, file) in numbered(&folder)? {
            let text = fs::read_to_string(&file).map_err(at(&file))?;
            let world = if first == 0 { standing(&folder, number, &text, radius) } else { moving(&base, number, &text, radius)? };
            match world {
                Ok(world) => worlds.push(world),
                Err(note) => notes.push(message!("study-at", "{file}: {note}", file = file.display().to_string(), note)),
            }
        }
    }
    if worlds.is_empty() {
        let allowed = message!("study-barn-worlds", "a folder with worlds/BARN/world_0.world and others");
        return Err(Error::refused("DIR", folder.display().to_string(), allowed).into());
    }
    Ok((worlds, notes))
}

/// The files `world_N.world` of a folder, by number.
fn numbered(folder: &Path) -> Result<Vec<(usize, PathBuf)>, Failure> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>).map_err(at(folder))?;
    let number = |path: &PathBuf| path.file_name()?.to_str()?.strip_prefix("world_")?.strip_suffix(".world")?.parse::<usize>().ok();
    let mut all: Vec<_> = entries.iter().map(fs::DirEntry::path).filter_map(|path| Some((number(&path)?, path))).collect();
    all.sort();
    Ok(all)
}

/// What is between an element's tags, the first one.
fn element<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(&format!("<{name}"))?;
    let (_, rest) = rest.split_once('>')?;
    Some(rest.split_once(&format!("</{name}>"))?.0.trim())
}

/// The models of a world that are cylinders: name, centre, radius and the plugin that moves it.
fn cylinders(text: &str) -> Vec<([f64; 2], f64, Option<String>)> {
    let models = text.split("<model name=").skip(1);
    let cylinder = |model: &str| {
        let model = model.split_once("</model>").map_or(model, |(model, _)| model);
        let radius = element(element(model, "cylinder")?, "radius")?.parse().ok()?;
        let mut pose = element(model, "pose")?.split_whitespace().map_while(|number| number.parse::<f64>().ok());
        let center = [pose.next()?, pose.next()?];
        let plugin = model.split_once("<plugin").and_then(|(_, rest)| rest.split_once("filename='")?.1.split_once('\''));
        Some((center, radius, plugin.map(|(name, _)| name.to_owned())))
    };
    models.filter_map(cylinder).collect()
}

/// A grid over a box, with what a robot of a radius cannot be in, and the robot.
fn grid(low: [f64; 2], high: [f64; 2], cell: f64, blocked: &[([f64; 2], f64)], ends: [[f64; 2]; 2], radius: f64) -> GridScene {
    let [columns, rows] = [0, 1].map(|axis| ((high[axis] - low[axis]) / cell).ceil() as usize);
    // Between two centres that are as far apart as a diagonal the middle must be as far away, too.
    let half = cell / 2_f64.sqrt();
    let near = |center: [f64; 2], own: f64, x: f64, y: f64| {
        let far = (radius + own) * (radius + own) + half * half;
        (x - center[0]) * (x - center[0]) + (y - center[1]) * (y - center[1]) < far
    };
    let at = |k: usize, axis: usize| low[axis] + (k as f64 + 0.5) * cell;
    let is_blocked = |k: usize| {
        let (x, y) = (at(k % columns, 0), at(k / columns, 1));
        blocked.iter().any(|&(center, own)| near(center, own, x, y))
    };
    let mut grid = GridScene::new(cell, columns, (0..columns * rows).map(is_blocked).collect());
    let [start, goal] = ends.map(|end| [end[0] - low[0], end[1] - low[1]]);
    grid.y_axis = YAxis::Up;
    (grid.start, grid.goal) = (Some(start), Some(goal));
    grid.robot = Some(Robot {
        speed: Some(FASTEST),
        turn_time: Some(TURN),
        sensor: Some(SENSOR),
        // What stands has been grown by the radius.
        disc: blocked.is_empty().then_some(radius),
        margin: Some(MARGIN),
        look_ahead: Some(LOOK_AHEAD),
        ..Robot::default()
    });
    grid
}

fn standing(folder: &Path, number: usize, text: &str, radius: f64) -> Result<World, Message> {
    let blocked: Vec<([f64; 2], f64)> = cylinders(text).into_iter().map(|(center, own, _)| (center, own)).collect();
    if number >= MOVES {
        return Err(message!("study-world-number", "static worlds are numbered up to {most}", most = MOVES - 1));
    }
    if blocked.iter().any(|&(center, own)| center.iter().chain([&own]).any(|number| !(-FAR..=FAR).contains(number))) {
        return Err(message!("study-cylinder-far", "a cylinder is more than {far} m away or large, or its numbers are none", far = FAR));
    }
    let path = folder.join(format!("path_files/path_{number}.npy"));
    let length = fs::read(&path).ok().and_then(|bytes| path_length(&bytes));
    let Some(length) = length else {
        return Err(message!("study-world-path", "its path, {path}, cannot be read", path = path.display().to_string()));
    };
    // A metre around all that stands, and around both ends.
    let all = || blocked.iter().map(|(center, _)| *center).chain(STATIC);
    let low = [0, 1].map(|axis| all().map(|point| point[axis]).fold(f64::INFINITY, f64::min) - 1.0);
    let high = [0, 1].map(|axis| all().map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max) + 1.0);
    let grid = grid(low, high, CELLS[0], &blocked, STATIC, radius);
    let cylinders = blocked.into_iter().map(|(center, own)| ([center[0] - low[0], center[1] - low[1]], own)).collect();
    Ok(World { set: "BARN", number, grid, cylinders, length })
}

fn moving(base: &Path, number: usize, text: &str, radius: f64) -> Result<Result<World, Message>, Failure> {
    // The obstacles keep within 10 m of the middle; the robot sets out behind.
    let (low, high) = ([-13.0, -12.0], [13.0, 12.0]);
    let mut grid = grid(low, high, CELLS[1], &[], MOVING, radius);
    for (_, own, plugin) in cylinders(text) {
        let Some(plugin) = plugin else { return Ok(Err(message!("study-obstacle-still", "an obstacle does not move"))) };
        let file = base.join("plugins").join(&plugin);
        let Some(animation) = Animation::read(&file)? else {
            return Ok(Err(message!("study-motion-unreadable", "the motion of {plugin} cannot be read", plugin)));
        };
        let course = animation.course(LIMIT, 100.0);
        let place = |&[time, x, y]: &[f64; 3]| [time, x - low[0], y - low[1]];
        let [_, x, y] = place(&course[0]);
        let motion = Motion::Waypoints(course[1..].iter().map(place).collect());
        grid.moving.push(Moving { center: [x, y], radius: own, motion });
    }
    let [start, goal] = MOVING;
    let length = along(&[start, goal]);
    Ok(Ok(World { set: "DynaBARN", number: MOVES + number, grid, cylinders: Vec::new(), length }))
}

/// The length of a world's path, with the way from the start and to the goal, as run.py computes it.
fn path_length(bytes: &[u8]) -> Option<f64> {
    let file = npyz::NpyFile::new(bytes).ok()?;
    let &[count, 2] = file.shape() else { return None };
    let order = file.order();
    let numbers: Vec<f64> = match npyz::NpyFile::new(bytes).ok()?.into_vec::<f64>() {
        Ok(numbers) => numbers,
        Err(_) => file.into_vec::<i64>().ok()?.into_iter().map(|number| number as f64).collect(),
    };
    let count = usize::try_from(count).ok()?;
    let entry = |row: usize, column: usize| match order {
        npyz::Order::C => numbers[2 * row + column],
        npyz::Order::Fortran => numbers[column * count + row],
    };
    let point = |row: usize| {
        let side = 2.0 * CYLINDER;
        [entry(row, 0) * side - CYLINDER - 30.0 * side, entry(row, 1) * side + CYLINDER + 5.0]
    };
    let points: Vec<[f64; 2]> = [STATIC[0]].into_iter().chain((0..count).map(point)).chain([STATIC[1]]).collect();
    Some(along(&points))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cylinders_are_read_from_a_world() {
        let text = "<model name='ground'><link/></model>
            <model name='unit_cylinder_0'><static>1</static><pose frame=''>-0.5 2.25 0 0 0 0</pose>
              <geometry><cylinder><radius>0.075</radius><length>1</length></cylinder></geometry></model>
            <model name='obs'><pose frame=''>1 2 0 0 0 0</pose><cylinder> <radius>0.5000</radius></cylinder>
              <plugin name='obs' filename='obs.so'/></model>";
        assert_eq!(cylinders(text), [([-0.5, 2.25], 0.075, None), ([1.0, 2.0], 0.5, Some("obs.so".to_owned()))]);
    }

    #[test]
    fn a_robot_between_free_cells_keeps_its_radius() {
        let cylinder = ([1.0, 1.0], 0.075);
        let grid = grid([0.0; 2], [2.0; 2], 0.075, &[cylinder], [[0.1, 0.1], [1.9, 1.9]], 0.215);
        let columns = grid.columns;
        let center = |k: usize| [(k % columns) as f64 * 0.075 + 0.0375, (k / columns) as f64 * 0.075 + 0.0375];
        let free = |k: usize| grid.blocked.get(k) == Some(&false);
        let mut nearest = f64::INFINITY;
        for k in (0..grid.blocked.len()).filter(|&k| free(k)) {
            for next in [k + 1, k + columns, k + columns + 1, k + columns - 1].into_iter().filter(|&next| free(next)) {
                let (a, b) = (center(k), center(next));
                // The last of a row and the first of the next are no neighbours.
                if (a[0] - b[0]).abs() > 0.1 {
                    continue;
                }
                for share in 0..=10 {
                    let t = f64::from(share) / 10.0;
                    let [x, y] = [0, 1].map(|axis| a[axis] + t * (b[axis] - a[axis]));
                    nearest = nearest.min(along(&[[x, y], [1.0, 1.0]]) - 0.075);
                }
            }
        }
        assert!((0.215..0.3).contains(&nearest), "{nearest}");
    }
}
