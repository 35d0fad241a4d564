//! An objective of one's own under a swarm that ships: `cargo run --example own_objective`.

use std::sync::Arc;

use forage::{
    Error, Overrides, Run, Value,
    kernel::SceneKindId,
    swarm::{
        objective::{Evaluation, Objective, Scratch, SearchBox},
        wcpso,
    },
};

/// The cost of a round tin of one litre: the area of its sheet metal. x is its radius in decimetres.
struct Tin(SearchBox);

impl Objective for Tin {
    fn search_box(&self) -> &SearchBox {
        &self.0
    }

    fn evaluate(&self, x: &[f64], _scratch: &mut Scratch) -> Evaluation {
        let radius = x[0];
        (2.0 * std::f64::consts::PI * radius * radius + 2.0 / radius).into()
    }
}

fn main() -> Result<(), Error> {
    let tin = Tin(SearchBox::cube(1, 0.1, 2.0)?);
    let parameters = wcpso::ENTRY.configure(SceneKindId("tin"), &Overrides::from_iter([("population", Value::from(20.0))]))?;
    let mut run = Run::with(wcpso::on(Arc::new(tin), &parameters, 1)).described_by(&wcpso::ENTRY);
    run.step(run.limit());
    let outcome = run.outcome();
    let (radius, area) = (outcome.position.unwrap_or_default()[0], outcome.cost.unwrap_or(f64::NAN));
    // The derivative of the area, 4 π r − 2 / r², is 0 where 2 π r³ = 1.
    println!("radius {radius}, area {area}, 2 π r³ = {}", 2.0 * std::f64::consts::PI * radius * radius * radius);
    Ok(())
}
