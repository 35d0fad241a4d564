//! The public JavaScript face in wasm under Node: the same stored bits as natively, and errors that are values.
//!
//! `wasm-pack test --node` or `cargo test --target wasm32-unknown-unknown --test wasm` runs it.
#![cfg(target_arch = "wasm32")]

#[path = "support/generated.rs"]
mod generated;
mod support;

use forage::wasm::{
    JsFormat, JsGiven, JsItem, JsKind, JsNamedFiles, JsNames, JsParameterValue, JsScene, JsSetup, Session, arm_pose, arm_solutions,
    catalogue, check_parameter, check_scene, export_scene, generate_scene, import_scene, new_seed, parse_link, reachability,
};
use js_sys::{Array, Float32Array, Float64Array, JSON, Object, Reflect, Uint32Array};
use support::{ITERATIONS, bits, digest, drives, line, logs, motions, stored};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

fn js<T: JsCast>(json: &str) -> T {
    JSON::parse(json).unwrap().unchecked_into()
}

fn get(object: impl AsRef<JsValue>, name: &str) -> JsValue {
    Reflect::get(object.as_ref(), &name.into()).unwrap()
}

fn number(object: impl AsRef<JsValue>, name: &str) -> f64 {
    get(object, name).as_f64().unwrap()
}

fn text(object: impl AsRef<JsValue>, name: &str) -> String {
    get(object, name).as_string().unwrap()
}

fn setup(json: &str) -> Session {
    Session::new(&js::<JsSetup>(json)).unwrap()
}

fn refused(json: &str) -> JsValue {
    Session::new(&js::<JsSetup>(json)).err().unwrap()
}

/// A frame's buffers, copied by JavaScript at once: a view is empty as soon as the wasm memory has grown.
fn drawn(session: &mut Session) -> (Vec<f32>, Vec<u32>) {
    let frame = session.frame(None);
    let vertices = get(&frame, "vertices").unchecked_into::<Float32Array>();
    let spans = get(&frame, "spans").unchecked_into::<Uint32Array>();
    let copies = (vertices.slice(0, vertices.length()), spans.slice(0, spans.length()));
    (copies.0.to_vec(), copies.1.to_vec())
}

#[wasm_bindgen_test]
fn every_golden_run_gives_the_bits_that_it_gives_natively() {
    let runs = stored();
    assert!(runs.len() >= 100);
    for run in runs {
        let params = format!(
            r#"{{"planner": "{}", "scene": "{}", "seed": {}, "params": {{"iterations": {ITERATIONS}{}{}}}}}"#,
            run.planner,
            run.scene,
            run.seed,
            if run.set.is_empty() { "" } else { ", " },
            run.set
        );
        let mut session = setup(&params);
        session.step(Some(f64::from(ITERATIONS / 2)));
        assert_eq!(session.hash(), run.half, "{params}");
        session.step(Some(1e9));
        assert_eq!(session.hash(), run.end, "{params}");
        let outcome = session.outcome();
        assert_eq!(bits(get(&outcome, "cost").as_f64()), run.cost, "{params}");
        let exact = session.exact();
        let whole = |name| {
            let path = get(&outcome, name);
            let known = || if exact.is_null() { JsValue::UNDEFINED } else { get(&exact, name) };
            (!path.is_undefined()).then(|| digest(&[numbers(&path), numbers(&known())].concat()))
        };
        let paths = whole("path").or_else(|| whole("tip_path")).unwrap_or_else(|| "none".to_owned());
        assert_eq!(paths, run.paths, "{params}");
    }
}

/// The coordinates of a path, one after the other.
fn numbers(path: &JsValue) -> Vec<f64> {
    if path.is_undefined() {
        return Vec::new();
    }
    let points = js_sys::Array::from(path);
    points.iter().flat_map(|point| js_sys::Array::from(&point).iter().filter_map(|c| c.as_f64()).collect::<Vec<_>>()).collect()
}

#[wasm_bindgen_test]
fn every_stored_log_of_events_is_the_same_here() {
    for log in logs() {
        let mut session = setup(&format!(
            r#"{{"planner": "{}", "scene": "{}", "seed": {}, "params": {{{}}}}}"#,
            log.planner, log.scene, log.seed, log.set
        ));
        session.step(Some(1e9));
        let told: Vec<_> = Array::from(&session.events(None))
            .iter()
            .map(|event| {
                let place = get(&event, "place").unchecked_into::<Array>();
                let obstacle = get(&event, "obstacle").as_f64().map(|number| number as usize);
                let at = [0, 1].map(|axis| place.get(axis).as_f64().unwrap());
                let iteration = number(&event, "iteration") as u64;
                line(iteration, number(&event, "time"), at, &text(&event, "kind"), obstacle, &text(&event, "reason"))
            })
            .collect();
        assert_eq!(told, log.lines, "{} on {}", log.planner, log.scene);
    }
}

#[wasm_bindgen_test]
fn every_stored_drive_gives_the_bits_that_it_gives_natively() {
    let all = drives();
    assert!(all.len() >= 10);
    for stored in all {
        let run = format!(r#"{{"planner": "{}", "scene": "{}", "seed": {}}}"#, stored.planner, stored.scene, stored.seed);
        let mut session = setup(&run);
        session.step(Some(1e9));
        let params = js::<JsGiven>(&format!(r#"{{"look_ahead": {}}}"#, stored.look_ahead));
        let drive = session.drive(&params).ok().unwrap();
        let rows = get(&drive, "rows").unchecked_into::<Float64Array>().to_vec();
        assert_eq!(digest(&rows), stored.rows, "{run}");
        assert_eq!(number(get(&drive, "parameters"), "look_ahead"), stored.look_ahead);
    }
}

#[wasm_bindgen_test]
fn every_stored_motion_gives_the_bits_that_it_gives_natively() {
    let all = motions();
    assert!(all.len() >= 10);
    for stored in all {
        let run = format!(r#"{{"planner": "{}", "scene": "{}", "seed": {}}}"#, stored.planner, stored.scene, stored.seed);
        let mut session = setup(&run);
        session.step(Some(1e9));
        let motion = session.motion(&js::<JsGiven>(&format!("{{{}}}", stored.set))).ok().unwrap();
        let part = |name| get(&motion, name).unchecked_into::<Float64Array>().to_vec();
        assert_eq!(digest(&[part("rows"), part("skeletons")].concat()), stored.rows, "{run}");
    }
}

#[wasm_bindgen_test]
fn a_drive_crosses_as_its_types_say() {
    let none: JsGiven = JsValue::UNDEFINED.unchecked_into();
    let mut session = setup(r#"{"planner": "ltqpso", "scene": "qpso-10m"}"#);
    session.step(Some(50.0));
    let drive = session.drive(&none).ok().unwrap();
    let columns = get(&drive, "columns").unchecked_into::<Array>().to_vec();
    let entry = get(catalogue(), "drive");
    let named: Vec<_> = get(&entry, "columns").unchecked_into::<Array>().iter().map(|column| get(column, "name")).collect();
    assert_eq!(columns, named);
    assert_eq!(get(&drive, "rows").unchecked_into::<Float64Array>().length() as usize % columns.len(), 0);
    assert_eq!((number(get(&drive, "outline"), "length"), number(get(&drive, "outline"), "width")), (0.4, 0.3));
    assert_eq!(get(get(&drive, "outcome"), "arrived").as_bool(), Some(true));
    assert_eq!(number(get(session.outcome(), "drive"), "time"), number(get(&drive, "outcome"), "time"));
    assert_eq!(get(get(&entry, "parameters").unchecked_into::<Array>().get(0), "kinds").unchecked_into::<Array>().join(","), "grid");
    for (params, field) in [(r#"{"speed": 0}"#, "speed"), (r#"{"speed": []}"#, "speed"), (r#"{"mass": 2.3}"#, "parameter"), ("3", "params")]
    {
        assert_eq!(text(session.drive(&js::<JsGiven>(params)).err().unwrap(), "field"), field);
    }
    let discs = setup(r#"{"planner": "pso", "scene": "wcpso-discs"}"#);
    assert!(discs.drive(&none).ok().unwrap().is_null() && get(setup_outcome(discs), "drive").is_undefined());
}

fn setup_outcome(mut session: Session) -> JsValue {
    session.outcome().into()
}

#[wasm_bindgen_test]
fn a_scene_given_as_an_object_is_the_scene_given_by_name() {
    let by_name = setup(r#"{"planner": "wcpso", "scene": "wcpso-discs", "seed": 4}"#);
    let object = Object::new();
    for (key, value) in [("planner", "wcpso".into()), ("scene", by_name.scene().into()), ("seed", 4.into())] {
        Reflect::set(&object, &key.into(), &value).unwrap();
    }
    let mut by_object = Session::new(object.unchecked_ref::<JsSetup>()).unwrap();
    by_object.step(Some(50.0));
    let mut by_name = by_name;
    by_name.step(Some(50.0));
    assert_eq!(by_object.hash(), by_name.hash());
    assert_eq!(by_object.link(), by_name.link());
}

#[wasm_bindgen_test]
fn seeking_back_gives_the_same_state_and_frame() {
    let mut session = setup(r#"{"planner": "wcpso", "scene": "wcpso-discs", "params": {"population": 30}}"#);
    session.step(Some(37.0));
    let hash = session.hash();
    let (vertices, spans) = drawn(&mut session);
    assert!(vertices.len() % 4 == 0 && spans.len() % 4 == 0 && !spans.is_empty());
    session.step(Some(200.0));
    session.seek(37.0);
    assert_eq!(session.hash(), hash);
    assert_eq!(drawn(&mut session), (vertices, spans));
    assert!(session.rewind(20.0) <= 20.0);
}

#[wasm_bindgen_test]
fn refusals_are_errors_with_field_value_and_range_and_nothing_panics() {
    let error = refused(r#"{"planner": "pso", "scene": "sphere", "params": {"population": 0}}"#);
    assert!(error.is_instance_of::<js_sys::Error>());
    assert_eq!((text(&error, "field"), text(&error, "value")), ("population".into(), "0".into()));
    assert!(text(&error, "message").contains("100000") && text(&error, "allowed").contains("100000"));
    for (json, field) in [
        (r#"{"planner": "psso", "scene": "sphere"}"#, "planner"),
        (r#"{"planner": "pso", "scene": "moon"}"#, "scene"),
        (r#"{"planner": "pso", "scene": "sphere", "seed": -1}"#, "seed"),
        (r#"{"planner": "pso", "scene": "sphere", "seed": 1.5}"#, "seed"),
        (r#"{"planner": "pso", "scene": "sphere", "params": {"w": "much"}}"#, "w"),
        (
            r#"{"planner": "pso", "scene": {"format": "forage-scene", "version": 1, "kind": "function", "name": "a", "title": "a", "function": "sphere", "dimension": 0}}"#,
            "dimension",
        ),
    ] {
        assert_eq!(text(refused(json), "field"), field, "{json}");
    }
    for json in [
        "{}",
        "[]",
        "3",
        "null",
        r#"{"planner": 3}"#,
        r#"{"planner": "pso"}"#,
        r#"{"planner": "pso", "scene": 7}"#,
        r#"{"planner": "pso", "scene": {}}"#,
    ] {
        assert!(!text(refused(json), "message").is_empty(), "{json}");
    }
    assert!(parse_link("#v=7").is_err() && Session::from_link("nothing").is_err());
    let not_finite = js::<JsScene>(
        r#"{"format": "forage-scene", "version": 1, "kind": "discs", "name": "a", "title": "a", "bounds": {"min": [0, 0], "max": [1, 1]},
            "start": [0, 0], "goal": [1, 1], "discs": [{"center": [0.5, 0.5], "radius": 0.1}]}"#,
    );
    assert!(check_scene(&not_finite).is_ok());
    let disc = get(get(&not_finite, "discs"), "0");
    Reflect::set(&disc, &"radius".into(), &f64::NAN.into()).unwrap();
    assert_eq!(text(check_scene(&not_finite).err().unwrap(), "field"), "discs[0].radius");
}

#[wasm_bindgen_test]
fn the_face_tells_everything_a_page_needs() {
    let planners = get(catalogue(), "planners").unchecked_into::<Array>();
    assert!(planners.length() >= 4);
    assert!(get(catalogue(), "scenes").unchecked_into::<Array>().length() >= 7);
    let kind: JsKind = JsValue::from("discs").unchecked_into();
    let check = |value: JsValue| check_parameter("wcpso", &kind, "w_max", &value.unchecked_into::<JsParameterValue>());
    assert!(check(0.9.into()).is_ok() && check(9.into()).is_err() && check("x".into()).is_err());
    let seed = new_seed().unwrap();
    assert!(seed >= 0.0 && seed.fract() == 0.0);

    let mut session = setup(r#"{"planner": "wcpso", "scene": "wcpso-discs"}"#);
    assert_eq!((session.iteration(), session.limit(), session.planner(), session.seed()), (0.0, 500.0, "wcpso".to_owned(), 1.0));
    session.step(Some(10.0));
    assert_eq!(session.status().as_string().unwrap(), "running");
    assert!(number(session.readings(), "w") < 0.95);
    assert_eq!(number(session.parameters(), "population"), 150.0);
    let trace = session.trace(-1.0);
    assert_eq!(number(get(&trace, "iterations"), "length"), 11.0);
    assert_eq!(number(get(session.trace(7.0), "iterations"), "length"), 3.0);
    assert!((number(session.exact(), "length") - 12.141_590).abs() < 5e-7);
    let told = session.inspect(&js::<JsItem>(r#"{"role": "particles", "index": 5}"#)).unwrap();
    assert_eq!(text(&told, "title"), "Particle 5");
    assert_eq!(number(get(get(&told, "table"), "rows"), "length"), 6.0);
    assert!(session.inspect(&js::<JsItem>(r#"{"role": "particles", "index": 150}"#)).unwrap().is_null());
    assert!(session.inspect(&js::<JsItem>(r#"{"role": "fish", "index": 1}"#)).is_err());
    assert_eq!(text(session.pick(0.0, 0.0, 0.5), "role"), "particles");
    assert!(session.pick(-50.0, 0.0, 0.5).is_null());
    assert!(session.svg(true, &js::<JsNames>(r#"["best", "exact"]"#)).unwrap().starts_with("<svg"));
    assert_eq!(session.csv().lines().count(), 12);
    let link = session.link();
    let parsed = parse_link(&link).unwrap();
    assert_eq!((number(&parsed, "iteration"), text(&parsed, "hash")), (10.0, session.hash()));
    let mut opened = Session::from_link(&link).unwrap();
    opened.seek(10.0);
    assert_eq!(opened.hash(), session.hash());
}

#[wasm_bindgen_test]
fn random_grids_are_the_native_ones_and_survive_the_way_through_files() {
    let generators = get(catalogue(), "generators").unchecked_into::<Array>();
    assert!(generators.length() >= 4);
    for (generator, digest) in generators.iter().zip(generated::GENERATED) {
        let name = text(&generator, "name");
        let scene = generate_scene(&name, &js::<JsGiven>(r#"{"columns": 31, "rows": 22}"#), 7.0).ok().unwrap();
        let rows = get(&scene, "rows").unchecked_into::<Array>();
        assert_eq!(generated::digest(&String::from(rows.join("\n"))), digest, "{name}");
        for (format, count) in [("movingai", 2), ("ros", 2), ("json", 1)] {
            let files = export_scene(&scene, &JsValue::from(format).unchecked_into::<JsFormat>()).ok().unwrap();
            assert_eq!(files.unchecked_ref::<Array>().length(), count);
            let read = import_scene(&files, None).ok().unwrap();
            assert_eq!(get(get(&read, "scene"), "rows").unchecked_into::<Array>().join("\n"), rows.join("\n"));
            assert_eq!(number(get(&read, "problems"), "length"), if format == "movingai" { 1.0 } else { 0.0 });
            assert!(get(&read, "notes").is_instance_of::<Array>());
        }
    }
    let stops = generate_scene("stops", &js::<JsGiven>(r#"{"stops": 9, "clusters": 2}"#), 7.0).ok().unwrap();
    for (format, count) in [("tsplib", 2), ("csv", 1), ("json", 1)] {
        let files = export_scene(&stops, &JsValue::from(format).unchecked_into::<JsFormat>()).ok().unwrap();
        assert_eq!(files.unchecked_ref::<Array>().length(), count);
        let read = import_scene(&files, None).ok().unwrap();
        let points = |scene: &JsValue| get(scene, "points").unchecked_into::<Array>().join(" ");
        assert_eq!(points(&get(&read, "scene")), points(&stops));
    }
    let files = |json: &str| {
        let files = js::<Array>(json);
        for file in files.iter() {
            let bytes = text(&file, "bytes");
            Reflect::set(&file, &"bytes".into(), &js_sys::Uint8Array::from(bytes.as_bytes())).unwrap();
        }
        files.unchecked_into::<JsNamedFiles>()
    };
    let error = import_scene(&files(r#"[{"name": "a.map", "bytes": "type octile\nheight 0\n"}]"#), None).err().unwrap();
    assert_eq!(text(&error, "field"), "a.map");
    assert!(text(&error, "message").contains("line 2: found `0`"));
    assert!(import_scene(&js(r#"[{"name": "a.map", "bytes": [1]}]"#), None).is_err() && import_scene(&js("3"), None).is_err());
    assert!(import_scene(&files(r#"[{"name": "a.map", "bytes": ""}]"#), Some(-1.0)).is_err());
    let none: JsGiven = JsValue::UNDEFINED.unchecked_into();
    assert_eq!(text(generate_scene("sand", &none, 1.0).err().unwrap(), "field"), "generator");
    assert_eq!(text(generate_scene("maze", &none, 0.5).err().unwrap(), "field"), "seed");
}

#[wasm_bindgen_test]
fn an_arm_tells_its_poses_and_solutions_and_where_it_can_come() {
    let scene = || js("\"arm-cuboid\"");
    let pose = arm_pose(&scene(), &js("[0, -90, 0, 0, 0, 0]")).unwrap();
    let [x, y, z] = [0, 1, 2].map(|axis| Array::from(&Array::from(&get(&pose, "skeleton")).get(4)).get(axis).as_f64().unwrap());
    assert!((x - 0.895).abs() < 1e-12 && (y - 0.65).abs() < 1e-12 && (z - 0.88).abs() < 1e-12, "{x} {y} {z}");

    // Down to the start; the tip of each solution is there. Without a direction too.
    let start = || js("[-0.2, 0.022, 0.05]");
    for direction in ["[0, 0, -2]", "null"] {
        let found = arm_solutions(&scene(), &start(), &js(direction), &JsValue::UNDEFINED.unchecked_into()).unwrap();
        let solutions = Array::from(&get(&found, "solutions"));
        assert!(solutions.length() > 0 && get(&found, "unreachable").is_undefined());
        let tip = Array::from(&Array::from(&get(solutions.get(0), "skeleton")).get(4));
        assert!((tip.get(2).as_f64().unwrap() - 0.05).abs() < 1e-9);
    }
    let far = arm_solutions(&scene(), &js("[9, 9, 9]"), &js("null"), &js("[0, -90, 0, 0, 0, 0]")).unwrap();
    assert_eq!((text(&far, "unreachable"), get(&far, "direction").is_null()), ("position".to_owned(), true));

    let cloud = reachability(&scene(), 0.25).unwrap();
    assert_eq!(get(&cloud, "points").unchecked_into::<Float32Array>().length(), 4 * 7 * 6 * 3);

    let field = |error: JsValue| text(error, "field");
    assert_eq!(field(reachability(&scene(), 0.001).err().unwrap()), "step");
    assert_eq!(field(arm_pose(&scene(), &js("[0, 1]")).err().unwrap()), "joints");
    assert_eq!(field(arm_pose(&js("\"wcpso-discs\""), &js("[0, 0, 0, 0, 0, 0]")).err().unwrap()), "kind");
    let refused = |point, direction, near| field(arm_solutions(&scene(), &js(point), &js(direction), &js(near)).err().unwrap());
    assert_eq!(refused("[0, 0]", "null", "null"), "point");
    assert_eq!(refused("[0, 0, \"a\"]", "null", "null"), "point[2]");
    assert_eq!(refused("[0, 0, 0]", "[0, 0, 0]", "null"), "direction");
    assert_eq!(refused("[0, 0, 0]", "[0, 0, 1]", "[1]"), "near");
}
