//! The planner under test, and the runs that are drawn for it.

use std::sync::Arc;

use crate::{
    describe::{Entry, Generator, Registry},
    kernel::{Error, Scene, SceneKindId, Status, rng::Stream},
    math,
    params::{Choice, Domain, Overrides, Parameter, Value, When},
    run::{Run, Setup},
};

use super::fault::{Fault, refusal};

/// The seed of all that a suite draws.
pub const SEED: u64 = 19;

/// A small population.
pub const SMALL: f64 = 4.0;

/// A parameter that every planner has.
pub const ITERATIONS: &str = "iterations";

/// A planner, and what it is checked with.
pub struct Subject<'a> {
    pub registry: &'a Arc<Registry>,
    pub entry: &'static Entry,
    pub random_runs: u32,
    /// The scenes that it runs on: shipped, given, generated.
    pub scenes: Vec<Arc<Scene>>,
    fixed: &'a Overrides,
}

impl<'a> Subject<'a> {
    pub fn new(registry: &'a Arc<Registry>, entry: &'static Entry, random_runs: u32, fixed: &'a Overrides, given: &[Arc<Scene>]) -> Self {
        let mut stream = Stream::new(SEED, 0);
        let generated: Vec<_> = registry.generators().iter().filter_map(|generator| generate(registry, generator, &mut stream)).collect();
        let all = registry.scenes().iter().chain(given).chain(&generated);
        let scenes = all.filter(|scene| entry.check_scene(scene).is_ok()).cloned().collect();
        Self { registry, entry, random_runs, scenes, fixed }
    }

    /// The first scene of each kind.
    pub fn one_scene_a_kind(&self) -> impl Iterator<Item = &Arc<Scene>> {
        self.entry.kinds.iter().filter_map(|kind| self.scenes.iter().find(|scene| scene.kind() == *kind))
    }

    /// The first and the last scene of each kind: a shipped and a generated one, if there are both.
    pub fn few_scenes(&self) -> Vec<&Arc<Scene>> {
        let few = |kind: &SceneKindId| {
            let mut of_kind = self.scenes.iter().filter(move |scene| scene.kind() == *kind);
            [of_kind.next(), of_kind.next_back()]
        };
        self.entry.kinds.iter().flat_map(few).flatten().collect()
    }

    /// A setup with so many iterations, and with values that are fixed.
    pub fn setup(&self, scene: &Arc<Scene>, seed: u64, iterations: u64, values: &Overrides) -> Setup {
        let kind = scene.kind();
        let mut params = Overrides::new();
        let fixed = self.fixed.iter().map(|(name, value)| (name, value.clone()));
        let sized = [(ITERATIONS, Value::from(iterations as f64))];
        let given = values.iter().map(|(name, value)| (name, value.clone()));
        for (name, value) in sized.into_iter().chain(fixed).chain(given) {
            if self.entry.parameters_on(kind).any(|parameter| parameter.name == name && parameter.check(&value).is_ok()) {
                params.insert(name, value);
            }
        }
        self.drop_unmet(kind, &mut params);
        Setup { planner: self.entry.name.to_owned(), scene: Arc::clone(scene), params, seed }
    }

    /// Removes the values of parameters that do not apply with the others.
    pub fn drop_unmet(&self, kind: SceneKindId, params: &mut Overrides) {
        loop {
            let unmet = |name: &str| self.entry.parameter(name).is_some_and(|parameter| !self.applies(kind, parameter, params));
            let kept: Overrides = params.iter().filter(|(name, _)| !unmet(name)).map(|(name, value)| (name, value.clone())).collect();
            if kept.iter().count() == params.iter().count() {
                return;
            }
            *params = kept;
        }
    }

    /// Whether a parameter's conditions are met.
    fn applies(&self, kind: SceneKindId, parameter: &Parameter, params: &Overrides) -> bool {
        let Some(When { parameter: other, value }) = parameter.when else { return true };
        self.entry.parameters_on(kind).find(|p| p.name == other).is_some_and(|other| {
            let set = params.get(other.name).cloned().unwrap_or_else(|| other.default_on(kind));
            set.to_string() == value && self.applies(kind, other, params)
        })
    }

    /// Gives the parameters that this one depends on the values that it needs.
    pub fn meet_conditions(&self, parameter: &Parameter, params: &mut Overrides) {
        let mut next = parameter.when;
        // A circle of conditions is found elsewhere.
        for _ in 0..self.entry.all_parameters().count() {
            let Some(When { parameter: name, value }) = next else { return };
            params.insert(name, Value::from(value));
            next = self.entry.parameter(name).and_then(|other| other.when);
        }
    }

    /// Small sizes: every whole number as near to this one as its domain and its default allow.
    pub fn sizes(&self, kind: SceneKindId, size: f64) -> Overrides {
        let small = |parameter: &Parameter| match (parameter.domain, parameter.default_on(kind)) {
            (Domain::Integer { min, .. }, Value::Number(default)) => Some((parameter.name, Value::from(default.min(size).max(min as f64)))),
            _ => None,
        };
        self.free(kind).filter_map(small).collect()
    }

    /// The parameters that a suite varies on a kind of scene.
    pub fn free(&self, kind: SceneKindId) -> impl Iterator<Item = &'static Parameter> {
        self.entry.parameters_on(kind).filter(|parameter| parameter.name != ITERATIONS && self.fixed.get(parameter.name).is_none())
    }

    /// Draws a scene, parameters and a seed.
    pub fn draw(&self, stream: &mut Stream, iterations: u64) -> Option<Setup> {
        let scene = self.scenes.get(stream.below(self.scenes.len().max(1)))?;
        let kind = scene.kind();
        let drawn = self.free(kind).filter_map(|parameter| Some((parameter.name, drawn(parameter, kind, stream)?))).collect();
        Some(self.setup(scene, stream.below(1 << 20) as u64, iterations, &drawn))
    }

    /// Why `start` refuses a setup, if it does: parameters may contradict each other or the scene.
    pub fn refusal(&self, setup: &Setup) -> Option<Error> {
        Run::with_keyframes(self.registry, setup.clone(), 0).err()
    }

    /// For each option of each choice and flag but the default, the values that choose it, and small sizes; subsets are chosen
    /// as a whole.
    pub fn options(&self, kind: SceneKindId) -> Vec<Overrides> {
        let whole = |parameter: &Parameter| match parameter.domain {
            Domain::Subset { options, .. } => Some((parameter.name, Value::Text(names(options).join(",")))),
            _ => None,
        };
        let wholes: Overrides = self.free(kind).filter_map(whole).collect();
        let mut small = self.sizes(kind, SMALL);
        wholes.iter().for_each(|(name, value)| small.insert(name, value.clone()));
        let mut all = if wholes.is_empty() { Vec::new() } else { vec![small.clone()] };
        for parameter in self.free(kind) {
            let values: Vec<_> = match parameter.domain {
                Domain::Choice { options } => names(options).into_iter().map(|name| Value::Text(name.to_owned())).collect(),
                Domain::Flag { .. } => vec![Value::Flag(false), Value::Flag(true)],
                Domain::Subset { .. } | Domain::Number { .. } | Domain::Integer { .. } => Vec::new(),
            };
            for value in values.into_iter().filter(|value| *value != parameter.default_on(kind)) {
                let mut overrides = small.clone();
                self.meet_conditions(parameter, &mut overrides);
                overrides.insert(parameter.name, value);
                all.push(overrides);
            }
        }
        all
    }

    /// Starts a run.
    pub fn start(&self, setup: &Setup) -> Result<Run, Fault> {
        self.start_with_keyframes(setup, Run::KEYFRAME_BUDGET)
    }

    /// Starts a run that keeps keyframes up to so many bytes.
    pub fn start_with_keyframes(&self, setup: &Setup, bytes: usize) -> Result<Run, Fault> {
        Run::with_keyframes(self.registry, setup.clone(), bytes).map_err(|error| refusal(&error))
    }
}

/// A value that a parameter may have; `None`: its default. Sizes are drawn up to the default, so that runs stay short.
fn drawn(parameter: &Parameter, kind: SceneKindId, stream: &mut Stream) -> Option<Value> {
    if stream.unit() < 0.4 {
        return None;
    }
    Some(match parameter.domain {
        Domain::Number { min, max, .. } => {
            let (low, high) = parameter.slider.unwrap_or((min, max));
            let between = if parameter.logarithmic && low > 0.0 {
                math::exp(stream.between(math::ln(low), math::ln(high)))
            } else {
                stream.between(low, high)
            };
            Value::from(math::clamp(between, min, max))
        }
        Domain::Integer { min, max, .. } => {
            let Value::Number(default) = parameter.default_on(kind) else { return None };
            let most = default.max((min as f64 + 8.0).min(max as f64));
            let low = (min as f64).max(1.0);
            let value = math::exp(stream.between(math::ln(low), math::ln(most + 1.0))).floor();
            Value::from(math::clamp(if min == 0 && stream.unit() < 0.2 { 0.0 } else { value }, min as f64, most))
        }
        Domain::Choice { options } => Value::Text(options.get(stream.below(options.len().max(1)))?.value.to_owned()),
        Domain::Subset { options, .. } => {
            let mut names = names(options);
            stream.shuffle(&mut names);
            names.truncate(1 + stream.below(names.len().clamp(1, 5)));
            Value::Text(names.join(","))
        }
        Domain::Flag { .. } => Value::Flag(stream.unit() < 0.5),
    })
}

pub fn names(options: &[Choice]) -> Vec<&'static str> {
    options.iter().map(|option| option.value).collect()
}

/// A random scene, no larger than the generator's default.
fn generate(registry: &Registry, generator: &Generator, stream: &mut Stream) -> Option<Arc<Scene>> {
    let sizes = generator.parameters.iter().copied().flatten().filter_map(|parameter| match parameter.domain {
        Domain::Integer { min, default, .. } if default > 8 => {
            Some((parameter.name, Value::from(stream.between((default / 4).max(min) as f64, (default / 2) as f64).floor())))
        }
        _ => None,
    });
    let sizes = sizes.collect();
    registry.generate(generator.name, &sizes, 1).ok().map(Arc::new)
}

/// Whether there is a step to take, within the limit.
pub fn goes_on(run: &Run) -> bool {
    run.status() == Status::Running && run.iteration() < run.limit()
}
