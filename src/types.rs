//! The TypeScript types of all that crosses to JavaScript as data. Those that derive `TS` tell theirs; here is where they begin,
//! and what scene files hold.

#![expect(dead_code, reason = "some are only described: what they hold is written field by field")]

use std::{any::TypeId, collections::BTreeMap};

use ts_rs::{Config, TS, TypeVisitor};

use crate::{
    arm::{self, ArmScene},
    describe::{Catalogue, Suggestion, catalogue::FollowerView},
    follow::{drive::DriveOutcome, motion::MotionOutcome},
    kernel::{Event, Exact, Header, Inspection, Item, Stage, Status, Subtask, SubtaskResult, inspection::Table},
    run::{Outcome, link::Contents, trial::Record},
    scene::{discs::DiscsScene, function::Function, grid::GridScene, tour::TourScene},
    statistics::{Bands, Comparison, Group, Reached},
};

/// Those who follow a path, as the catalogue lists them.
#[derive(TS)]
struct Followers {
    /// How a robot drives along what a planner found.
    drive: FollowerView,
    /// How an arm follows what a planner found.
    motion: FollowerView,
}

/// All that ships: planners, scenes, generators.
#[derive(TS)]
#[ts(rename = "Catalogue")]
struct WholeCatalogue {
    #[ts(flatten)]
    catalogue: Catalogue<'static>,
    #[ts(flatten)]
    followers: Followers,
}

/// How the scene's robot or arm follows the best path, with the default parameters.
#[derive(TS)]
#[ts(optional_fields)]
struct Followed {
    /// How the scene's robot drives along it. Scenes with a robot that has an outline only.
    drive: Option<DriveOutcome>,
    /// How the arm follows it. Arms only.
    motion: Option<MotionOutcome>,
}

/// The result of a run so far: what was found, whether it is feasible, and what it cost. What does not apply is left out.
#[derive(TS)]
#[ts(rename = "Outcome")]
struct WholeOutcome {
    #[ts(flatten)]
    outcome: Outcome,
    #[ts(flatten)]
    followed: Followed,
}

/// A scene file of this kind.
macro_rules! file {
    ($name:ident, $renamed:literal, $kind:literal, $body:ty) => {
        #[derive(TS)]
        #[ts(rename = $renamed)]
        struct $name {
            #[ts(type = "'forage-scene'")]
            format: (),
            #[ts(type = "1")]
            version: (),
            #[ts(type = $kind)]
            kind: (),
            #[ts(flatten)]
            header: Header,
            #[ts(flatten)]
            body: $body,
        }
    };
}

/// A test function by its name.
#[derive(TS)]
#[ts(optional_fields)]
struct NamedFunction {
    /// The function.
    function: Function,
    /// The number of variables.
    dimension: usize,
    /// The position of the function's origin, a number for each variable; left out: at 0.
    shift: Option<Vec<f64>>,
}

/// A function of the suite `bbob`.
#[derive(TS)]
#[ts(optional_fields)]
struct SuiteFunction {
    /// Which: `bbob-1` to `bbob-24`.
    #[ts(type = "`bbob-${number}`")]
    function: String,
    /// Which instance, from 1; left out: 1.
    instance: Option<u32>,
    /// The number of variables, from 2 to 40.
    dimension: usize,
}

/// A function by formula.
#[derive(TS)]
#[ts(optional_fields)]
struct FormulaFunction {
    /// The formula, at most 4096 bytes: `sum(x[i]^2)`.
    expression: String,
    /// The number of variables.
    dimension: usize,
    /// Where the minimum is searched.
    bounds: Sides,
    /// The minimum, if it is known, with its position or without.
    #[ts(optional, type = "number | { value: number; position?: number[] }")]
    optimum: Option<f64>,
}

/// The sides of a search box: a number for all of them, or one for each variable.
#[derive(TS)]
#[ts(rename = "SearchBounds")]
struct Sides {
    /// The least values.
    #[ts(type = "number | number[]")]
    min: f64,
    /// The greatest values.
    #[ts(type = "number | number[]")]
    max: f64,
}

file!(NamedFile, "NamedFunctionScene", "'function'", NamedFunction);
file!(SuiteFile, "SuiteFunctionScene", "'function'", SuiteFunction);
file!(FormulaFile, "FormulaScene", "'function'", FormulaFunction);

/// A scene with a function to minimise.
#[derive(TS)]
#[ts(rename = "FunctionScene", untagged)]
enum FunctionFile {
    Named(NamedFile),
    Suite(SuiteFile),
    Formula(FormulaFile),
}

file!(DiscsFile, "DiscsScene", "'discs'", DiscsScene);
file!(GridFile, "GridScene", "'grid'", GridScene);
file!(TourFile, "TourScene", "'tour'", TourScene);
file!(ArmFile, "ArmScene", "'arm'", ArmScene);

/// The content of a scene file.
#[derive(TS)]
#[ts(rename = "Scene", untagged)]
#[expect(clippy::large_enum_variant, reason = "none is ever made")]
enum SceneFile {
    Function(FunctionFile),
    Discs(DiscsFile),
    Grid(GridFile),
    Tour(TourFile),
    Arm(ArmFile),
}

/// All declarations with their documentation, by name; `more` adds those of other crates.
///
/// # Panics
/// If two types have one name: one of them would be missing.
pub fn declarations(more: impl FnOnce(&mut Declarations)) -> String {
    let mut found = Declarations { config: Config::new().with_large_int("number"), seen: Vec::new(), text: BTreeMap::new() };
    more(&mut found);
    found.visit::<SceneFile>();
    found.visit::<WholeCatalogue>();
    found.visit::<WholeOutcome>();
    found.visit::<Status>();
    found.visit::<Stage>();
    found.visit::<Event>();
    found.visit::<Suggestion>();
    found.visit::<Exact>();
    found.visit::<Contents>();
    found.visit::<Item>();
    found.visit::<Inspection>();
    found.visit::<Table>();
    found.visit::<Subtask>();
    found.visit::<SubtaskResult>();
    found.visit::<Record>();
    found.visit::<Group>();
    found.visit::<Bands>();
    found.visit::<Comparison>();
    found.visit::<Reached>();
    found.visit::<arm::Pose>();
    found.visit::<arm::Answer>();
    found.text.into_values().collect()
}

/// The declarations so far.
pub struct Declarations {
    config: Config,
    seen: Vec<TypeId>,
    /// By name: the order in which types are visited is arbitrary.
    text: BTreeMap<String, String>,
}

impl Declarations {
    /// Adds a type, and those that it is made of.
    pub fn with<T: TS + 'static>(&mut self) {
        self.visit::<T>();
    }

    fn add(&mut self, name: String, text: String) {
        let known = self.text.get(&name);
        assert!(known.is_none_or(|known| *known == text), "two types are called {name}");
        self.text.insert(name, text);
    }
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        if self.seen.contains(&TypeId::of::<T>()) {
            return;
        }
        self.seen.push(TypeId::of::<T>());
        // What has no place for a file of its own is a type of TypeScript itself.
        if T::output_path().is_some() {
            let text = format!("{}export {}\n\n", T::docs().unwrap_or_default(), T::decl(&self.config));
            self.add(T::name(&self.config), text);
        }
        T::visit_dependencies(self);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[should_panic(expected = "two types are called Pair")]
    fn a_second_type_of_one_name_is_refused() {
        let mut found = Declarations { config: Config::new(), seen: Vec::new(), text: BTreeMap::new() };
        found.add("Pair".to_owned(), "export type Pair = [number, number]".to_owned());
        found.add("Pair".to_owned(), "export type Pair = [string, string]".to_owned());
    }

    #[test]
    fn all_types_are_declared_once() {
        assert_eq!(declarations(|_| ()).matches("export type Friedman").count(), 1);
    }
}
