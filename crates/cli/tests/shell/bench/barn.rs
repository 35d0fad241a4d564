//! `forage bench barn`.

use std::{fs, path::Path};

use forage::{geometry::length, math};

use crate::support::{empty_folder, forage, text};

/// A world with cylinders at these places, and a path of these lattice points.
fn world(folder: &Path, number: usize, cylinders: &[[f64; 2]], path: &[[f64; 2]]) {
    let worlds = folder.join("jackal_helper/worlds/BARN");
    fs::create_dir_all(worlds.join("path_files")).unwrap();
    let models: Vec<String> = cylinders
        .iter()
        .enumerate()
        .map(|(k, [x, y])| {
            format!(
                "<model name='unit_cylinder_{k}'><static>1</static><pose frame=''>{x} {y} 0 0 0 0</pose>\
                 <cylinder><radius>0.075</radius><length>1</length></cylinder></model>"
            )
        })
        .collect();
    fs::write(worlds.join(format!("world_{number}.world")), models.concat()).unwrap();
    let head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, 2), }}", path.len());
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    let padded = format!("{head:<117}\n");
    bytes.extend((padded.len() as u16).to_le_bytes());
    bytes.extend(padded.bytes());
    path.iter().flatten().for_each(|number| bytes.extend(number.to_le_bytes()));
    fs::write(worlds.join(format!("path_files/path_{number}.npy")), bytes).unwrap();
}

fn carry_out(folder: &Path, more: &[&str]) -> std::process::Output {
    let out = folder.join("out");
    forage(&[&["bench", "barn", folder.to_str().unwrap(), "--planners", "a-star-drive", "--out", out.to_str().unwrap()], more].concat())
}

#[test]
fn robots_come_through_or_do_not() {
    let folder = empty_folder("bench-barn");
    // Nothing on the straight way; a ring around the goal; a wall with a gap that is wide enough for half a metre.
    world(&folder, 0, &[[-4.0, 8.0]], &[[14.5, 0.0], [14.5, 50.0]]);
    let wall: Vec<[f64; 2]> = (0..60).map(|k| [-6.5 + 0.15 * f64::from(k), 8.0]).collect();
    let ring: Vec<[f64; 2]> = (0..80)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 80.0)
        .map(|a| [-2.25 + 1.5 * math::cos(a), 13.0 + 1.5 * math::sin(a)])
        .collect();
    world(&folder, 1, &ring, &[[14.5, 0.0], [14.5, 50.0]]);
    let gap: Vec<[f64; 2]> = wall.iter().copied().filter(|[x, _]| !(-1.0..-0.3).contains(x)).collect();
    world(&folder, 2, &gap, &[[14.5, 0.0], [14.5, 50.0]]);
    let output = carry_out(&folder, &[]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows: Vec<std::collections::BTreeMap<String, String>> =
        csv::Reader::from_path(folder.join("out/rows.csv")).unwrap().deserialize().map(Result::unwrap).collect();
    let number = |k: usize, name: &str| rows[k][name].parse::<f64>().unwrap();
    // 9 m to within a metre of the goal, at 2 m/s, and some turns, since the goal is no cell's centre.
    assert!(
        rows[0]["success"] == "true" && (9.0..9.2).contains(&number(0, "length")) && (4.5..7.0).contains(&number(0, "time")),
        "{:?}",
        rows[0]
    );
    assert!((number(0, "score") - 0.5).abs() < 1e-9);
    assert!(rows[1]["success"] == "false" && number(1, "score") == 0.0 && rows[1]["collided"] == "false", "{:?}", rows[1]);
    assert!(rows[2]["success"] == "true" && number(2, "length") > 9.3 && number(2, "clearance") >= 0.0, "{:?}", rows[2]);
    // The challenge's way leads along the path: from the start to its first point, on, and to the goal.
    let [x, y] = [14.5 * 0.15 - 0.075 - 4.5, 5.075];
    let best = length(&[[-2.25, 3.0], [x, y], [x, y + 7.5], [-2.25, 13.0]]);
    assert!((number(0, "best") - best).abs() < 1e-9);
    let lines = fs::read_to_string(folder.join("out/challenge/a-star-drive.txt")).unwrap();
    assert!(lines.starts_with("0 1 0 0 ") && lines.lines().count() == 1, "the challenge's report knows every sixth world: {lines}");
    assert!(fs::read_to_string(folder.join("out/report.md")).unwrap().contains("| BARN | a-star-drive |"));
    // Rows of another radius are others.
    assert_eq!(carry_out(&folder, &["--radius", "0.3"]).status.code(), Some(0));
    assert_eq!(csv::Reader::from_path(folder.join("out/rows.csv")).unwrap().records().count(), 6);
    for arguments in [["--set", "time_limit=3"], ["--every", "0"]] {
        assert_eq!(carry_out(&folder, &arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn what_is_no_copy_of_the_challenge_is_refused() {
    let folder = empty_folder("bench-barn-refused");
    let output = carry_out(&folder, &[]);
    assert!(output.status.code() == Some(2) && text(&output.stderr).contains("jackal_helper/worlds"), "{}", text(&output.stderr));
    fs::create_dir_all(folder.join("worlds/BARN")).unwrap();
    assert!(text(&carry_out(&folder, &[]).stderr).contains("world_0.world"));
    assert!(text(&carry_out(&folder, &["--radius", "3"]).stderr).contains("from 0.01 to 1"));
}
