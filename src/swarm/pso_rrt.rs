//! `pso-rrt`: a particle swarm that begins with the paths of random trees; [ANTBAT](crate#papers) fig. 8 compares with one.
//!
//! [ANTBAT](crate#papers) names its source (Liu, thesis, North University of China, 2023: improved PSO and RRT for the paths of
//! vehicles) and prints no details. Our reading: a basic tree (LaValle 1998, [`crate::tree::rrt`]) of its own gives each
//! particle its first path, without redundant nodes. The path's corners become the particle's waypoints, and the middle of its
//! longest piece until there are enough; a path with too many corners becomes points at equal distances along it, which may
//! collide. From there on it is `pso`. A particle whose tree does not come to the goal within `extensions` begins as in `pso`.
//!
//! Every straight piece that a tree tests counts as an evaluation, in extensions and where redundant nodes are removed. A path of
//! the swarm counts as one whatever its number of pieces, so trees are counted at more than their cost.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Preset, ROAD, Reading, Start},
    kernel::{Error, Started, rng::Stream},
    params::{Fixed, Param},
    scene::GRID,
    tree::paths::Paths,
};

use super::{
    encoding,
    flight::{Flight, Swarm},
    parameters::{
        BEST, C1, C2, COGNITIVE, EVALUATIONS, FLIGHT, FREE, FROM_TREES, ITERATIONS, K, LAYERS, LENGTH, MEAN, OMEGA, PATHS, POPULATION,
        POSITION, SMOOTHNESS, SOCIAL, SPREAD, STAGNATING, VELOCITY, W,
    },
    paths::{CHARGED, EARLY_STOP, ENCODING, WAYPOINTS},
    population::Population,
    schedule::{Law, Schedule},
};

/// How many extensions all trees of a run have together: where no tree comes to the goal, a big swarm must begin all the same.
const MOST_EXTENSIONS: u64 = 500_000;

const STEP_SIZE: Param<f64> = Param::number(
    "step_size",
    "L",
    "Step size",
    [0.01, 1e6, 0.5],
    "How far a node of a tree grows, in the scene’s unit; on grids, in cells. A higher value needs fewer extensions and misses narrow passages.",
)
.defaults_on(&[(GRID, Fixed::Number(1.0))])
.slider(0.05, 3.0, true);
const GOAL_BIAS: Param<f64> = Param::number(
    "goal_bias",
    "p_g",
    "Goal bias",
    [0.0, 0.95, 0.05],
    "How often a tree grows toward the goal itself, as a share of the extensions. A higher value makes the first paths more alike.",
)
.slider(0.0, 0.5, false);
const EXTENSIONS: Param<u64> = Param::integer(
    "extensions",
    "n_T",
    "Extensions of a tree",
    [0, 100_000, 3000],
    "How often a tree is extended at most; a particle whose tree does not come to the goal is drawn as in pso. 0: no trees. All trees of a run have 500,000 together.",
)
.slider(0.0, 10_000.0, false);

fn start(start: &Start) -> Result<Started, Error> {
    let &Start { scene, parameters: settings, seed, .. } = start;
    let objective = encoding::objective(scene, settings)?;
    let paths = Paths::new(scene, settings[STEP_SIZE], settings[GOAL_BIAS])?;
    let (size, most) = (settings[POPULATION] as usize, settings[EXTENSIONS]);
    let mut rng = Stream::new(seed, 0);
    let (mut left, mut tested, mut origins) = (MOST_EXTENSIONS, 0, vec![None; size]);
    let mut population = Population::begun(Arc::clone(&objective), size, &mut rng, |i, x, rng| {
        let attempt = paths.grow(most.min(left), rng);
        left -= attempt.extensions;
        tested += attempt.tested;
        let Some(path) = attempt.path else { return false };
        origins[i] = Some(attempt.extensions);
        objective.encode(&path, x)
    });
    population.evaluations += tested;
    let [w, c1, c2] = [settings[W], settings[C1], settings[C2]].map(Law::Constant);
    let flight = Flight { schedule: Schedule { w, c1, c2 }, perturbation: None };
    let mut swarm = Swarm::of(population, settings, rng, flight);
    swarm.origins = Some(origins.into());
    Ok(swarm.into())
}

const ONE_ROAD: Preset = Preset::new(
    ROAD,
    "One of many roads",
    "Sizes for one of many roads between stops: 20 particles and 100 iterations instead of 150 and 500. Paths are longer, and found sooner.",
    "ant-bat-30",
    &[("population", Fixed::Number(20.0)), ("iterations", Fixed::Number(100.0))],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "slalom",
    "Trees, then a swarm",
    "Each first path comes from a random tree and is free; the swarm then shortens them.",
    "discs-slalom",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "for each of the @population@ particles:",
    "  a random tree grows from start to goal; its path becomes the particle’s (@from_trees@ did)",
    "  where the tree finds none, the particle is drawn at random",
    "repeat until iteration @iterations@, with $\\omega$ = @w@, $c_1$ = @c1@, $c_2$ = @c2@:",
    "  for each particle:",
    "    $v \\leftarrow \\omega v + c_1 r_1 (p - x) + c_2 r_2 (g - x)$, then $x \\leftarrow x + v$",
    "    if $f(x) < f(p)$: $p \\leftarrow x$",
    "  $g \\leftarrow$ the best $p$, with $f(g)$ = @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "pso-rrt",
    "PSO with RRT: trees, then a swarm",
    "[ANTBAT] fig. 8, its [32]",
    "A random tree from start to goal gives each particle its first path; then a swarm with constant coefficients shortens the paths. A particle whose tree finds none is drawn at random.",
    start,
)
.family("swarm")
.evaluating("a position, or a straight segment that a tree checks for collisions")
.kinds(PATHS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), STEP_SIZE.entry(), GOAL_BIAS.entry(), EXTENSIONS.entry(), W.entry(), C1.entry(), C2.entry()],
    FLIGHT,
    &[EARLY_STOP.entry(), ENCODING.defaults_on(&[]).entry(), WAYPOINTS.defaults_on(&[(GRID, Fixed::Number(8.0))]).entry()],
    CHARGED,
])
.readings(&[
    BEST,
    MEAN,
    SPREAD,
    FREE,
    LENGTH,
    SMOOTHNESS,
    K,
    OMEGA,
    COGNITIVE,
    SOCIAL,
    STAGNATING,
    FROM_TREES,
    Reading { help: "How many positions were evaluated so far, and straight pieces tested by trees.", ..EVALUATIONS },
])
.formulas(&[VELOCITY, POSITION])
.layers(LAYERS)
.presets(&[ONE_ROAD])
.cases(CASES)
.pseudocode(PSEUDOCODE);

#[cfg(test)]
mod tests {
    use crate::{Run, Setup, Value, describe::layers, kernel::Item, shipped, standard};

    fn run(scene: &str, params: &[(&str, f64)], seed: u64) -> Run {
        let params = params.iter().map(|&(name, value)| (name, Value::from(value))).collect();
        Run::new(standard(), Setup { planner: "pso-rrt".into(), scene: shipped(scene).unwrap(), params, seed }).unwrap()
    }

    fn reading(run: &mut Run, name: &str) -> f64 {
        run.readings().get(name).unwrap()
    }

    #[test]
    fn particles_begin_on_the_free_paths_of_trees() {
        for scene in ["ant-bat-30", "wolf-ant-20", "wcpso-discs"] {
            let mut run = run(scene, &[("population", 20.0), ("waypoints", 30.0), ("extensions", 100_000.0)], 1);
            assert_eq!(reading(&mut run, "from_trees"), 20.0, "{scene}");
            let outcome = run.outcome();
            assert!(outcome.feasible, "{scene}: with a waypoint for each corner nothing is lost");
            assert!(outcome.evaluations > 20, "{scene}: what the trees tested counts");
            let inspection = run.inspect(Item { layer: layers::PARTICLES.key, index: 3 }).unwrap();
            assert!(inspection.summary.text().contains("on the path of a tree of"), "{}", inspection.summary);
        }
    }

    #[test]
    fn without_extensions_it_is_pso() {
        let mut alone = run("wcpso-discs", &[("extensions", 0.0)], 4);
        let params = [("population", Value::from(150.0))].into_iter().collect();
        let mut pso =
            Run::new(standard(), Setup { planner: "pso".into(), scene: shipped("wcpso-discs").unwrap(), params, seed: 4 }).unwrap();
        for _ in 0..20 {
            assert_eq!(alone.best().unwrap().cost, pso.best().unwrap().cost);
            assert_eq!(alone.outcome().evaluations, pso.outcome().evaluations);
            alone.step(1);
            pso.step(1);
        }
        assert_eq!(reading(&mut alone, "from_trees"), 0.0);
        let inspection = run("wcpso-discs", &[("extensions", 0.0)], 4).inspect(Item { layer: layers::PARTICLES.key, index: 3 }).unwrap();
        assert!(inspection.summary.text().contains("drawn at random"), "{}", inspection.summary);
    }
}
