//! The same setup with many seeds, and whether two planners differ: `cargo run --release --example seeds`.

use forage::{
    Error, Overrides, Setup, Trial,
    run::trial::WITHIN,
    shipped, standard,
    statistics::{Group, compare},
};

const SEEDS: u64 = 20;

fn main() -> Result<(), Error> {
    let scene = shipped("wcpso-discs")?;
    let mut groups = Vec::new();
    for planner in ["pso", "wcpso"] {
        let mut values = Vec::new();
        for seed in 1..=SEEDS {
            let setup = Setup { planner: planner.into(), scene: scene.clone(), params: Overrides::new(), seed };
            let mut trial = Trial::new(standard(), setup, WITHIN)?;
            trial.step(u64::MAX);
            // A length where the path is feasible, nothing where it is not.
            values.push(trial.record().value);
        }
        groups.push(Group::new(planner, values));
    }
    let comparison = compare(&groups);
    for group in &comparison.groups {
        let mean = group.summary.as_ref().map_or(f64::NAN, |summary| summary.mean);
        println!("{}: mean {mean:.4}, feasible {} of {}", group.name, group.feasible, group.runs);
    }
    for p in comparison.pairs.iter().filter_map(|pair| pair.p) {
        println!("Mann–Whitney U test: p = {p:.4}");
    }
    Ok(())
}
