//! The templates, run here: they give the hashes that the npm package gives, and what is hostile stays inside.
#![cfg(not(target_arch = "wasm32"))]

use std::{fs, path::Path, sync::Arc};

use forage::{Overrides, Registry, Run, Setup, kernel::Status, shipped};

fn run(code: &str, scene: &str, seed: u64) -> Result<Run, forage::Error> {
    let entry = forage_isolate::entry(code)?;
    let registry = Arc::new(Registry::standard().with(entry));
    Run::new(&registry, Setup { planner: entry.name.into(), scene: shipped(scene)?, params: Overrides::new(), seed })
}

fn template(name: &str) -> String {
    file(&format!("templates/{name}.js"))
}

fn file(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)).unwrap()
}

/// Hashes after 20 steps, which `tests/templates.test.mjs` compares with those of the package.
const STORED: &str = include_str!("hashes.json");

#[test]
fn codes_have_their_hashes() {
    let stored: Vec<(String, String, u64, String)> = serde_json::from_str(STORED).unwrap();
    for (name, scene, seed, hash) in stored {
        let mut run = run(&file(&name), &scene, seed).unwrap();
        let first = run.hash();
        run.step(20);
        assert_eq!(run.hash(), hash, "{name}");
        run.seek(0);
        assert_eq!(run.hash(), first, "{name}: the way back");
        run.seek(20);
        assert_eq!(run.hash(), hash, "{name}: and forth");
    }
}

#[test]
fn the_swarm_gives_the_bits_of_pso() {
    let mut mine = run(&template("pso"), "rastrigin", 5).unwrap();
    let setup = Setup { planner: "pso".into(), scene: shipped("rastrigin").unwrap(), params: Overrides::new(), seed: 5 };
    let mut published = Run::new(forage::standard(), setup).unwrap();
    for _ in 0..100 {
        mine.step(1);
        published.step(1);
        assert_eq!(mine.best(), published.best());
    }
}

#[test]
fn what_does_not_end_is_stopped() {
    for (code, words) in [
        ("for (;;);", "took longer than 900 ms"),
        ("const all = []; for (;;) all.push(new Float64Array(1e6))", "more than 64 MB"),
        ("const down = () => down() + 1; down()", "nested too deeply"),
        ("import fs from 'node:fs'", "only forage-lab is here"),
        ("Date.now()", "Date"),
        ("'x", "line 1"),
        ("1", "once"),
        ("await new Promise(() => {})", "awaits what never comes"),
        ("(function again() { Promise.resolve().then(again) })(); await new Promise(() => {})", "took longer than 900 ms"),
        // It runs out of memory, or of time where the machine is busy.
        ("const again = () => Promise.resolve().then(again); await again()", "more than 64 MB|took longer than 900 ms"),
    ] {
        let error = forage_isolate::entry(code).err().unwrap_or_else(|| panic!("{code} is accepted"));
        let said = error.to_string();
        assert!(words.split('|').any(|words| said.contains(words)), "{code}: {said}");
    }
    let code =
        "register({ name: 'late', kinds: ['function'], start: ({ box, evaluate }) => ({ x: box.low, cost: evaluate(box.low), n: 0 }),
        advance(state) { state.n += 1; if (state.n === 3) for (;;); }, best: ({ x, cost }) => ({ position: x, cost }) })";
    let mut late = run(code, "sphere-2", 1).unwrap();
    assert_eq!(late.step(10), Status::Failed);
    assert!(serde_json::to_string(&late.outcome()).unwrap().contains("took longer than 900 ms and was stopped (line 2)"));
}
