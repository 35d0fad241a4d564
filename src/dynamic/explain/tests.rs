use crate::{
    Value,
    describe::layers,
    kernel::{Inspection, Item},
};

use super::super::tests::{reading, scene, start};

/// They come towards each other on lines 4 apart, at 2 and 1 a second: nearest where they are abreast, sooner or later by who moves.
#[test]
fn an_obstacle_and_the_robot_can_be_supposed_to_stand_still() {
    let scene = scene(&[".........."; 5], [[1.0, 5.0], [19.0, 5.0]], r#"{"center": [17, 9], "radius": 1, "velocity": [-1, 0]}"#);
    let mut run = start("a-star-drive", &scene, &[], 1);
    run.step(10);
    let item = Item { layer: layers::MOVING.key, index: 0 };
    let inspection = run.inspect(item).unwrap();
    let value = |inspection: &Inspection, name: &str| inspection.values.iter().find(|value| value.label.name == name).unwrap().value;
    let together = value(&inspection, "t");
    // 16 apart along the lines, at 3 a second.
    let now = reading(&run.outcome(), "time");
    assert!((now + together - 16.0 / 3.0).abs() < 1e-9, "{together} from {now} on");
    for (supposition, speed) in [("obstacle", 2.0), ("robot", 1.0)] {
        let supposed = run.suppose(item, supposition, 0).unwrap().unwrap();
        assert!((value(&supposed, "t") - 3.0 / speed * together).abs() < 1e-9, "{supposition}");
        assert!((value(&supposed, "d") - 2.0).abs() < 1e-9, "{supposition}: 4 less both radii");
        assert!(supposed.marks.iter().all(|mark| mark.layer == layers::SUPPOSED.key));
    }
}

/// It goes up from y = 7 at 1 a second and turns at the wall, at y = 9: until then, and no longer, it goes on as it goes.
#[test]
fn how_near_an_obstacle_comes_is_told_until_it_turns() {
    let scene = scene(&[".........."; 5], [[1.0, 5.0], [19.0, 5.0]], r#"{"center": [17, 7], "radius": 1, "velocity": [0, 1]}"#);
    let mut run = start("a-star-drive", &scene, &[("border", Value::from("bounce"))], 1);
    run.step(5);
    let inspection = run.inspect(Item { layer: layers::MOVING.key, index: 0 }).unwrap();
    let time = inspection.values.iter().find(|value| value.label.name == "t").unwrap().value;
    let now = reading(&run.outcome(), "time");
    assert!(now > 0.1 && (now + time - 2.0).abs() < 1e-9, "{time} from {now} on");
}
