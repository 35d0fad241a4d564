//! Tasks: what a run is to reach, for lessons, and to grade what is handed in.

use std::{collections::BTreeSet, sync::Arc};

use serde_json::Value as Json;

use crate::{
    describe::{Entry, Registry},
    kernel::{Error, Message, Scene, Status, fields::Fields, fields::shown, limits},
    message,
    params::{Overrides, Value},
};

use super::{link::Link, outcome::Outcome, stepping::Run};

/// What is to be reached.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// (length − exact) / exact, at most.
    Gap(f64),
    /// The length of a path or a tour in the scene's unit, at most.
    Length(f64),
    /// What the planner minimises, at most.
    Cost(f64),
}

/// A goal, what it may cost, and what of the run is given.
///
/// ```
/// use forage::{run::Task, standard};
/// let task = Task::read(standard(), r#"{"goal": {"gap": 0.01}, "budget": {"evaluations": 5000}, "scene": "wcpso-discs"}"#)?;
/// assert_eq!(task.evaluations, Some(5000));
/// # Ok::<(), forage::Error>(())
/// ```
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Task {
    /// What is to be reached.
    pub goal: Goal,
    /// With how many evaluations at most; `None`: with as many as the run takes.
    pub evaluations: Option<u64>,
    /// The planner's name, if that is given.
    pub planner: Option<String>,
    /// The planner is one that was handed in as code.
    pub own: bool,
    /// The scene, if that is given.
    pub scene: Option<Arc<Scene>>,
    /// Parameters that are given.
    pub params: Overrides,
}

/// A run is not replayed further than so many times the budget, or without one than so many evaluations: a link may ask for days.
const FACTOR: u64 = 10;
const MOST_EVALUATIONS: u64 = 10_000_000;

/// What became of a link that was handed in.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Judgement {
    /// The goal was reached within the budget, by a run that is as it is given.
    pub reached: bool,
    /// How many evaluations it took; where it was not reached, as many as the run has at the link's iteration.
    pub evaluations: u64,
    /// The link's hash came out again.
    pub verified: bool,
    /// What is not as it must be, sentence by sentence.
    pub reasons: Vec<Message>,
    /// The result at the link's iteration.
    pub outcome: Outcome,
}

impl Task {
    /// Reads a task as JSON: `{"goal": {"gap": 0.01}, "budget": {"evaluations": 5000}, "planner"?, "own"?, "scene"?, "params"?}`. The scene is a
    /// shipped one's name, or a scene's file in place. A lesson's file is read for the task in it.
    ///
    /// # Errors
    /// The field, what it holds and what is allowed.
    pub fn read(registry: &Registry, text: &str) -> Result<Self, Error> {
        let json: Json = crate::kernel::json::parse("task", text)?;
        let json = if json["format"] == "forage-lesson" { task_of(json) } else { json };
        let mut fields = Fields::of("task", json, message!("task-object", "an object with goal, budget and what is given"))?;
        let goal = goal(&fields.take("goal"))?;
        let evaluations = budget(fields.take("budget"))?;
        let planner = fields.optional_text("planner")?;
        if let Some(planner) = &planner {
            registry.planner(planner)?;
        }
        let own = own(fields.take("own"), planner.as_deref())?;
        let scene = match fields.take("scene") {
            Json::Null => None,
            Json::String(name) => Some(registry.scene(&name)?),
            whole => Some(Arc::new(registry.read_scene(&whole.to_string())?)),
        };
        let params = params(fields.take("params"))?;
        check(registry, planner.as_deref(), &params)?;
        fields.end()?;
        Ok(Self { goal, evaluations, planner, own, scene, params })
    }

    /// Carries out the run of a link up to its iteration, and judges it. One that goes far beyond the budget is given up on the way, and is
    /// not verified then.
    ///
    /// # Errors
    /// Where the run cannot begin.
    pub fn judge(&self, registry: &Arc<Registry>, link: &Link) -> Result<Judgement, Error> {
        let mut run = Run::with_keyframes(registry, link.setup.clone(), 0)?;
        let mut reasons = self.not_as_given(link, &run);
        let as_given = reasons.is_empty();
        let (mut reached, mut best) = (None, f64::INFINITY);
        loop {
            let cost = run.best().map_or(f64::INFINITY, |best| best.cost);
            let beyond = run.evaluations() > self.most_replayed();
            let over = run.iteration() >= link.iteration || run.status() != Status::Running || beyond;
            // A result is only judged when there is another one.
            if reached.is_none() && self.affords(run.evaluations()) && (cost < best || over) && self.goal.is_met(&run.outcome()) {
                reached = Some(run.evaluations());
            }
            best = cost;
            if over {
                break;
            }
            run.step(1);
        }
        let outcome = run.outcome();
        let problem = if run.evaluations() > self.most_replayed() && run.iteration() < link.iteration {
            Some(message!(
                "task-far-beyond",
                "The run goes on beyond {most} evaluations: it is not replayed to the end, and its hash is not checked.",
                most = self.most_replayed()
            ))
        } else {
            differs(link, &outcome)
        };
        let verified = problem.is_none();
        reasons.extend(problem);
        if reached.is_none() {
            reasons.push(self.missed(&outcome));
        }
        let evaluations = reached.unwrap_or(outcome.evaluations);
        Ok(Judgement { reached: reached.is_some() && as_given, evaluations, verified, reasons, outcome })
    }

    /// How many evaluations a run is replayed for.
    fn most_replayed(&self) -> u64 {
        self.evaluations.map_or(MOST_EVALUATIONS, |most| most.saturating_mul(FACTOR))
    }

    fn affords(&self, evaluations: u64) -> bool {
        self.evaluations.is_none_or(|most| evaluations <= most)
    }

    /// What of a run is not what the task gives.
    fn not_as_given(&self, link: &Link, run: &Run) -> Vec<Message> {
        let mut reasons = Vec::new();
        if let Some(given) = self.planner.as_ref().filter(|&given| *given != link.setup.planner) {
            reasons.push(message!(
                "task-other-planner",
                "The planner is {planner}, not {given}.",
                planner = link.setup.planner.as_str(),
                given = given.as_str()
            ));
        }
        if self.own && run.entry().family != Entry::OWN {
            reasons.push(message!(
                "task-not-own",
                "A planner of your own is asked for; the link's is {planner}.",
                planner = link.setup.planner.as_str()
            ));
        }
        if let Some(given) = self.scene.as_ref().filter(|given| given.as_ref() != link.setup.scene.as_ref()) {
            reasons.push(message!(
                "task-other-scene",
                "The scene is {scene}, not {given} as it is given.",
                scene = link.setup.scene.name(),
                given = given.name()
            ));
        }
        for (name, given) in self.params.iter() {
            let value = run.parameters().all().iter().find(|(known, _)| *known == name).map(|(_, value)| value);
            if value != Some(given) {
                let value = value.map_or_else(|| "not there".to_owned(), ToString::to_string);
                reasons.push(message!(
                    "task-other-parameter",
                    "{name} is {value}, not {given}.",
                    name = name,
                    value = value,
                    given = given.to_string()
                ));
            }
        }
        reasons
    }

    /// Why the goal was not reached.
    fn missed(&self, outcome: &Outcome) -> Message {
        let at = outcome.iterations;
        if !outcome.feasible {
            return message!("task-nothing-found", "There is no valid result up to iteration {at}.", at);
        }
        let Some(is) = self.goal.of(outcome) else {
            return message!("task-not-measured", "This scene has no exact optimum, so there is no gap.");
        };
        if self.goal.is_met(outcome) {
            let most = self.evaluations.unwrap_or(u64::MAX);
            return message!("task-too-late", "The goal is reached after more than {most} evaluations.", most);
        }
        let most = self.goal.most();
        match self.goal {
            Goal::Gap(_) => message!("task-gap", "The gap is {is:.6}; at most {most} is asked.", is, most),
            Goal::Length(_) => message!("task-length", "The length is {is:.6}; at most {most} is asked.", is, most),
            Goal::Cost(_) => message!("task-cost", "The cost is {is:.6}; at most {most} is asked.", is, most),
        }
    }
}

/// The task in a lesson; its words are for the reader.
fn task_of(mut lesson: Json) -> Json {
    let mut task = lesson["task"].take();
    if let Some(fields) = task.as_object_mut() {
        fields.remove("text");
    }
    task
}

impl Goal {
    /// What is measured.
    fn of(self, outcome: &Outcome) -> Option<f64> {
        match self {
            Self::Gap(_) => outcome.gap,
            Self::Length(_) => outcome.length,
            Self::Cost(_) => outcome.cost,
        }
    }

    /// How much it may be.
    fn most(self) -> f64 {
        let (Self::Gap(most) | Self::Length(most) | Self::Cost(most)) = self;
        most
    }

    fn is_met(self, outcome: &Outcome) -> bool {
        outcome.feasible && self.of(outcome).is_some_and(|is| is <= self.most())
    }
}

/// What is not as a link says.
fn differs(link: &Link, outcome: &Outcome) -> Option<Message> {
    let here = outcome.iterations;
    let Some(hash) = &link.hash else {
        return Some(message!("task-no-hash", "The link has no hash."));
    };
    if here != link.iteration {
        let there = link.iteration;
        return Some(message!("task-ended", "The run ends at iteration {here}; the link is of iteration {there}.", here, there));
    }
    (outcome.hash != *hash).then(|| {
        message!(
            "task-other-hash",
            "Planner, parameters, scene, seed and iteration give the hash {is}, not {said}.",
            is = outcome.hash.as_str(),
            said = hash.chars().take(32).collect::<String>()
        )
    })
}

fn goal(found: &Json) -> Result<Goal, Error> {
    let refused = || {
        Error::refused(
            "goal",
            shown(found),
            message!("task-goal", "an object with gap, length or cost and how much that may be at most, such as 0.01"),
        )
    };
    let Json::Object(fields) = found else { return Err(refused()) };
    let mut named = fields.iter();
    let (Some((name, value)), None) = (named.next(), named.next()) else { return Err(refused()) };
    let most = value.as_f64().filter(|most| *most >= 0.0 || name == "cost").ok_or_else(refused)?;
    match name.as_str() {
        "gap" => Ok(Goal::Gap(most)),
        "length" => Ok(Goal::Length(most)),
        "cost" => Ok(Goal::Cost(most)),
        _ => Err(refused()),
    }
}

/// Whether the planner is to be one that is handed in: then none can be given.
fn own(found: Json, planner: Option<&str>) -> Result<bool, Error> {
    match found {
        Json::Null | Json::Bool(false) => Ok(false),
        Json::Bool(true) if planner.is_none() => Ok(true),
        found => Err(Error::refused("own", shown(&found), message!("task-own", "true or false; true only without planner"))),
    }
}

fn budget(found: Json) -> Result<Option<u64>, Error> {
    if found.is_null() {
        return Ok(None);
    }
    let mut fields = Fields::of("budget", found, message!("task-budget", "an object with evaluations: a whole number"))?;
    let found = fields.take("evaluations");
    let evaluations = found.as_u64().filter(|&evaluations| evaluations > 0 && limits::check_whole("evaluations", evaluations).is_ok());
    let evaluations =
        evaluations.ok_or_else(|| fields.refuse("evaluations", &found, message!("task-evaluations", "a whole number from 1 on")))?;
    fields.end()?;
    Ok(Some(evaluations))
}

fn params(found: Json) -> Result<Overrides, Error> {
    let allowed = || message!("task-params", "an object of parameters with numbers, texts or true and false");
    let Json::Object(fields) = found else {
        return if found.is_null() { Ok(Overrides::new()) } else { Err(Error::refused("params", shown(&found), allowed())) };
    };
    let mut params = Overrides::new();
    for (name, value) in &fields {
        let value = match value {
            Json::Bool(flag) => Value::Flag(*flag),
            Json::String(text) => Value::Text(text.clone()),
            Json::Number(number) if number.as_f64().is_some() => Value::Number(number.as_f64().unwrap_or_default()),
            other => return Err(Error::refused(format!("params.{name}"), shown(other), allowed())),
        };
        params.insert(name, value);
    }
    Ok(params)
}

/// Refuses parameters that the planner does not have, or that none has.
fn check(registry: &Registry, planner: Option<&str>, params: &Overrides) -> Result<(), Error> {
    let planners: Vec<_> = registry.planners().iter().filter(|entry| planner.is_none_or(|name| name == entry.name)).collect();
    for (name, value) in params.iter() {
        let checked: Vec<_> = planners.iter().filter_map(|entry| entry.parameter(name)).map(|parameter| parameter.check(value)).collect();
        let Some(checked) = checked.into_iter().reduce(Result::or) else {
            let known: BTreeSet<_> = planners.iter().flat_map(|entry| entry.all_parameters()).map(|parameter| parameter.name).collect();
            return Err(Error::unknown("params", name, known));
        };
        checked?;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
