//! A slice through the configuration space: the obstacles that the links make of what they touch.

use crate::{arm::ArmScene, kernel::Error, message};

use super::{Links, Posture};

/// How many cells a slice has on each side.
pub const SLICE: usize = 64;

/// Where an arm touches something while two of its joints turn and the others keep a posture's angles: [`SLICE`] rows of as many
/// cells, 1 where it does in the middle of a cell. `pair` are the two, counted from 0; `from` and `to` are their angles at the
/// borders, in radians: the first joint's change within a row, the second's from row to row. The links have this radius, in metres.
///
/// ```
/// use forage::arm::{SLICE, slice};
/// let scene = forage::shipped("arm-cuboid")?;
/// let scene = scene.get::<forage::arm::ArmScene>()?;
/// let cells = slice(scene, &scene.arm.home(), [0, 1], [-3.0, -2.0], [3.0, 2.0], 0.0)?;
/// assert_eq!(cells.len(), SLICE * SLICE);
/// assert!(cells.contains(&0) && cells.contains(&1));
/// # Ok::<(), forage::Error>(())
/// ```
///
/// # Errors
/// [`Error::Refused`] for a `pair` that is not two of the six joints, and for a negative `radius`.
pub fn slice(scene: &ArmScene, posture: &Posture, pair: [usize; 2], from: [f64; 2], to: [f64; 2], radius: f64) -> Result<Vec<u8>, Error> {
    let [across, up] = pair;
    if across == up || across > 5 || up > 5 {
        return Err(Error::refused("pair", format!("{across}, {up}"), message!("arm-two-joints", "two different joints from 0 to 5")));
    }
    if !(radius >= 0.0 && radius.is_finite()) {
        return Err(Error::refused("radius", radius, message!("arm-no-negative-length", "a length of 0 or more")));
    }
    let links = Links::new(scene, radius);
    let angle = |axis: usize, cell: usize| from[axis] + (to[axis] - from[axis]) * ((cell as f64 + 0.5) / SLICE as f64);
    let mut at = *posture;
    let mut cells = Vec::with_capacity(SLICE * SLICE);
    for row in 0..SLICE {
        at[up] = angle(1, row);
        for column in 0..SLICE {
            at[across] = angle(0, column);
            cells.push(u8::from(links.touch(&scene.arm.skeleton(&at))));
        }
    }
    Ok(cells)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::touches;

    #[test]
    fn a_cell_is_what_the_arm_touches_in_its_middle() {
        let scene = crate::shipped("arm-cuboid").unwrap();
        let scene = scene.get::<ArmScene>().unwrap();
        let (from, to) = ([-2.5, -1.0], [2.5, 1.5]);
        let mut seen = [0; 2];
        for (joints, radius) in [([0, 1], 0.0), ([2, 4], 0.0), ([1, 0], 0.05)] {
            let cells = slice(scene, &scene.arm.home(), joints, from, to, radius).unwrap();
            for (row, column) in [(0, 0), (5, 40), (31, 12), (32, 60), (63, 63), (20, 20), (48, 33)] {
                let mut posture = scene.arm.home();
                posture[joints[0]] = from[0] + (to[0] - from[0]) * (column as f64 + 0.5) / 64.0;
                posture[joints[1]] = from[1] + (to[1] - from[1]) * (row as f64 + 0.5) / 64.0;
                let touched = touches(scene, &scene.arm.skeleton(&posture), radius);
                assert_eq!(cells[row * SLICE + column] == 1, touched, "joints {joints:?}, row {row}, column {column}");
            }
            cells.iter().for_each(|&cell| seen[usize::from(cell)] += 1);
        }
        assert!(seen.iter().all(|&seen| seen > 200), "{seen:?}");
        assert!(slice(scene, &scene.arm.home(), [3, 3], from, to, 0.0).is_err());
        assert!(slice(scene, &scene.arm.home(), [0, 6], from, to, 0.0).is_err());
    }
}
