//! Runs of tour planners on roads that they share: what `antbat-tours` and `antbat-time` have in common.

use std::sync::{
    Arc, Mutex, PoisonError,
    atomic::{AtomicBool, Ordering},
};

use forage::{
    Outcome, Overrides, Setup,
    describe::Preset,
    exact::Distances,
    kernel::{Error, ReferenceOptimum, Subtask, SubtaskResult},
    run,
    scene::Scene,
    standard,
};

/// In the order of [ANTBAT](forage#papers) Table 2, and then two that it does not have.
pub(super) const PLANNERS: [&str; 7] = ["bat", "hybrid-bat", "ga", "tour-pso", "sa", "two-opt", "held-karp"];

/// A planner's parameters as published, where its defaults are others: its preset `paper`.
pub(super) fn published(planner: &str) -> Overrides {
    let preset = standard().planner(planner).ok().and_then(|entry| entry.presets.iter().find(|preset| preset.name == "paper"));
    preset.map_or_else(Overrides::new, Preset::given)
}

/// The roads between a scene's stops. For the same seed all planners ask for the same ones, so they are found once, by
/// whoever comes first; the others wait.
#[derive(Default)]
pub(super) struct Network(Mutex<Option<Arc<Laid>>>);

/// What the runs that build the roads are, and what they found, step by step.
struct Laid {
    steps: Vec<(Vec<Subtask>, Vec<SubtaskResult>)>,
    ms: f64,
}

/// A tour that was found, and how long it took. The milliseconds are no result: they differ from run to run.
pub(super) struct Found {
    pub outcome: Outcome,
    /// What the roads took, one after the other, when they were found.
    pub roads_ms: f64,
    /// What the order took.
    pub order_ms: f64,
}

/// Carries a run out on these roads; `None` if `stop` said to give up.
///
/// # Errors
/// Whatever [`forage::Run::new`] refuses.
#[expect(clippy::disallowed_types, reason = "the paper shows how long its runs took; no planner sees it")]
pub(super) fn carry_out(setup: &Setup, network: &Network, stop: &AtomicBool) -> Result<Option<Found>, Error> {
    let Some(laid) = network.laid(setup, stop)? else { return Ok(None) };
    let mut run = forage::Run::with_keyframes(standard(), setup.clone(), 0)?;
    let begun = std::time::Instant::now();
    for (jobs, found) in &laid.steps {
        // A planner that wants other roads builds them itself: then they count as time for the order.
        if run.subtasks() == *jobs {
            run.provide(found.clone())?;
        }
        run.step(1);
    }
    run.step(u64::MAX);
    let order_ms = begun.elapsed().as_secs_f64() * 1e3;
    Ok(Some(Found { outcome: run.outcome(), roads_ms: laid.ms, order_ms }))
}

impl Network {
    fn laid(&self, setup: &Setup, stop: &AtomicBool) -> Result<Option<Arc<Laid>>, Error> {
        let mut laid = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if laid.is_none() {
            *laid = lay(setup, stop)?.map(Arc::new);
        }
        Ok(laid.clone())
    }
}

/// Finds a setup's roads one after the other, on this thread alone: one that took part in other work while it waits for
/// its own could come back to the network that it has locked.
#[expect(clippy::disallowed_types, reason = "the paper shows how long its runs took; no planner sees it")]
fn lay(setup: &Setup, stop: &AtomicBool) -> Result<Option<Laid>, Error> {
    let mut run = forage::Run::with_keyframes(standard(), setup.clone(), 0)?;
    let (mut steps, mut ms) = (Vec::new(), 0.0);
    loop {
        let jobs = run.subtasks();
        if jobs.is_empty() {
            return Ok(Some(Laid { steps, ms }));
        }
        let begun = std::time::Instant::now();
        let mut found = Vec::with_capacity(jobs.len());
        for job in &jobs {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            found.extend(run::run_subtasks(standard(), &setup.scene, std::slice::from_ref(job))?);
        }
        ms += begun.elapsed().as_secs_f64() * 1e3;
        run.provide(found.clone())?;
        run.step(1);
        steps.push((jobs, found));
    }
}

/// The lengths of the shortest ways between a grid's stops, by a rule; `None` if there is none between two of them.
pub(super) fn exact_distances(scene: &Scene, reference: ReferenceOptimum) -> Result<Option<Distances>, Error> {
    let stops = scene.stops();
    let mut between = Vec::new();
    for (i, &from) in stops.iter().enumerate() {
        for &to in &stops[i + 1..] {
            between.push(scene.between([from, to])?.optimum(reference));
        }
    }
    // They are asked for in the order in which they were found.
    let mut all = between.into_iter().collect::<Option<Vec<_>>>().map(Vec::into_iter);
    Ok(all.as_mut().map(|all| Distances::of(stops.len(), |_, _| all.next().unwrap_or(f64::NAN))))
}

/// An order as a row keeps it: the stops' numbers as commands and pictures count them, from 1.
pub(super) fn printed(order: &[usize]) -> String {
    order.iter().map(|stop| (stop + 1).to_string()).collect::<Vec<_>>().join(" ")
}

/// And back.
pub(super) fn order(printed: &str) -> Vec<usize> {
    printed.split_whitespace().filter_map(|number| number.parse::<usize>().ok()?.checked_sub(1)).collect()
}

/// Whether two lengths are the same up to the order in which steps are added.
pub(super) fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use forage::{Value, shipped};

    fn setup(seed: u64) -> Setup {
        let params =
            Overrides::from_iter([("smooth", Value::Flag(false)), ("roads", Value::from("aco")), ("iterations", Value::from(20.0))]);
        Setup { planner: "bat".into(), scene: shipped("ant-bat-30").unwrap(), params, seed }
    }

    #[test]
    fn shared_roads_give_the_same_run() {
        let (network, stop) = (Network::default(), AtomicBool::new(false));
        let mut alone = forage::Run::new(standard(), setup(3)).unwrap();
        alone.step(u64::MAX);
        for _ in 0..2 {
            let found = carry_out(&setup(3), &network, &stop).unwrap().unwrap();
            assert_eq!(found.outcome.hash, alone.hash());
            assert!(found.roads_ms > 0.0 && found.order_ms > 0.0);
        }
        assert!(carry_out(&setup(3), &Network::default(), &AtomicBool::new(true)).unwrap().is_none(), "it was asked to stop");
    }

    #[test]
    fn an_order_is_kept_as_text() {
        assert_eq!(printed(&[0, 4, 11]), "1 5 12");
        assert_eq!(order("1 5 12"), [0, 4, 11]);
        assert!(order("").is_empty());
    }

    #[test]
    fn exact_distances_give_the_exact_tour_its_length() {
        let scene = shipped("ant-bat-30").unwrap();
        for reference in [ReferenceOptimum::Cells, ReferenceOptimum::AnyAngle] {
            let exact = scene.exact_tour(reference, forage::kernel::TourEnds::Closed).unwrap();
            let distances = exact_distances(&scene, reference).unwrap().unwrap();
            assert!(same(distances.length(&exact.order, true), exact.length), "{reference:?}");
        }
    }
}
