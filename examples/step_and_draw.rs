//! Steps a run, reads it, goes back, and writes what it looks like to standard output:
//! `cargo run --example step_and_draw > run.svg`.

use forage::{Error, Overrides, Run, Setup, describe::Shown, picture, shipped, standard};

fn main() -> Result<(), Error> {
    let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs")?, params: Overrides::new(), seed: 7 };
    let mut run = Run::new(standard(), setup)?;
    for _ in 0..4 {
        run.step(25);
        let readings = run.readings();
        eprintln!("best {:?}, inertia weight {:?}", readings.get("best"), readings.get("w"));
    }
    // Any iteration, exactly.
    run.seek(40);
    eprintln!("iteration {} again: hash {}", run.iteration(), run.hash());
    let shown: Vec<_> = run.entry().layers.iter().filter(|layer| layer.shown == Shown::On).map(|layer| layer.key).collect();
    println!("{}", picture::svg(&run, false, &shown));
    Ok(())
}
