//! A path for a six-axis arm's tip past a cuboid, and how the whole arm follows it: `cargo run --example arm`.

use forage::{Error, Overrides, Run, Setup, Value, follow::motion::MotionOutcome, shipped, standard};

fn main() -> Result<(), Error> {
    let setup = Setup { planner: "rrt-guided".into(), scene: shipped("arm-cuboid")?, params: Overrides::new(), seed: 2 };
    let mut run = Run::new(standard(), setup)?;
    run.step(run.limit());
    let outcome = run.outcome();
    println!("{:?}: tip {:?} m, shortest {:?} m, after {} extensions", outcome.status, outcome.length, outcome.exact, outcome.iterations);
    if let Some(motion) = outcome.followed.get::<MotionOutcome>() {
        println!("the arm arrives: {}, touches nothing: {}, in {:.2} s", motion.arrived, motion.free, motion.time);
    }
    // The same with postures at larger distances; a row each moment: time, tip, six joints in degrees, clearance.
    let followed = run.follow("motion", &Overrides::from_iter([("spacing", Value::from(0.05))]))?;
    println!("{} numbers", followed.map_or(0, |followed| followed.rows().len()));
    Ok(())
}
