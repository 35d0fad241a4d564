//! The conformance suite finds what it is there for: planners that each break one promise, and one that keeps all.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/one_corner.rs"]
mod one_corner;

use std::sync::Arc;

use forage::{
    Registry,
    describe::{Case, Entry, Formula, Layer, Look, Preset, SceneKind, layers},
    kernel::SceneKindId,
    params::{Fixed, Param},
    scene::{DISCS, discs},
    shipped,
    testing::{self, CHECKS, Report, Suite},
};
use one_corner::{
    BEST, CORNER, FAULTS, ITERATIONS, Nothing, OTHER, PanicsAtLeast, Rises, SPEED, STEPS, STEPS_LEFT, TRIED, TRIES, TRIES_OF_IT, entry,
    named, start,
};

const GOOD_ENTRY: Entry = entry(start::<{ Nothing as u8 }>);
const OTHER_PARAMETER: Param<u64> = Param::integer("other", "", "Other", [1, 3, 1], "Not listed.");
const NEAR: Look = Look { near: true, ..Look::PLAIN };
static GOOD: Entry = GOOD_ENTRY;

/// Entries that say what is not so of a planner that does nothing wrong.
static ENTRIES: &[(&Entry, &str, &str)] = &[
    (&named("One corner", "Tries paths.", GOOD_ENTRY.start), "its_entry_is_complete", "lower-case letters, digits and hyphens"),
    (&named("one-corner", "", GOOD_ENTRY.start), "its_entry_is_complete", "a summary"),
    (&GOOD_ENTRY.kinds(&[]), "its_entry_is_complete", "List the kinds of scene"),
    (&GOOD_ENTRY.kinds(&[DISCS, SceneKindId("moon")]), "its_entry_is_complete", "List the kinds of scene"),
    (&GOOD_ENTRY.readings(&[TRIED]), "its_entry_is_complete", "`Group::Cost`"),
    (&GOOD_ENTRY.readings(&[BEST, BEST]), "its_entry_is_complete", "each name once"),
    (&GOOD_ENTRY.readings(&[BEST, TRIED, OTHER]), "readings_are_those_of_the_entry", "Push every reading"),
    (&GOOD_ENTRY.layers(&[layers::BEST, layers::PARTICLES, CORNER]), "what_can_be_picked_is_explained", "at least one piece"),
    (&GOOD_ENTRY.layers(&[layers::BEST, CORNER, Layer { look: &NEAR, ..CORNER }]), "its_entry_is_complete", "a lower `Look::order`"),
    (&GOOD_ENTRY.layers(&[layers::BEST.inspection(), CORNER]), "its_entry_is_complete", "after those that are drawn"),
    (
        &GOOD_ENTRY.members(&[STEPS, TRIES_OF_IT, STEPS_LEFT]),
        "members_and_events_are_those_of_the_entry",
        "for each of the entry's `members`",
    ),
    (&GOOD_ENTRY.parameters(&[&[TRIES.entry()]]), "its_entry_is_complete", "Param::integer"),
    (&GOOD_ENTRY.parameters(&[&[ITERATIONS.entry(), TRIES.default_to(0).entry()]]), "its_entry_is_complete", "a default"),
    (
        &GOOD_ENTRY.parameters(&[&[ITERATIONS.entry(), TRIES.entry(), SPEED.when(OTHER_PARAMETER, "3").entry()]]),
        "its_entry_is_complete",
        "Let `when` name a parameter",
    ),
    (&GOOD_ENTRY.formulas(&[Formula::new("l", "", "Length", "L", "@length@")]), "its_entry_is_complete", "`@name@`"),
    (
        &GOOD_ENTRY.presets(&[Preset {
            name: "same",
            title: "Same",
            help: "",
            scene: "wcpso-discs",
            values: &[("tries", Fixed::Number(5.0))],
        }]),
        "its_presets_run_and_change_something",
        "differ from the defaults",
    ),
    (&GOOD_ENTRY.cases(&[Case::new("gone", "Gone", "Nothing.", "nowhere", &[])]), "its_cases_show_something", "a shipped scene"),
    (&GOOD_ENTRY.cases(&[Case::new("mute", "", "", "wcpso-discs", &[])]), "its_cases_show_something", "a title"),
    (
        &GOOD_ENTRY.cases(&[Case::new("same", "Same", "Same.", "wcpso-discs", &[("tries", Fixed::Number(5.0))])]),
        "its_cases_show_something",
        "differ from the defaults",
    ),
    (&GOOD_ENTRY.pseudocode(&["look at @speeed@"]), "its_cases_show_something", "indent by two spaces"),
];

fn registry(entry: &'static Entry) -> Arc<Registry> {
    Arc::new(Registry::new().with(&discs::KIND).with(entry))
}

/// The finding of this check has the planner's name and this remedy, and where a run shows it the link of one.
fn finds(entry: &'static Entry, report: &Report, check: &str, remedy: &str) {
    let finding = report.findings.iter().find(|finding| finding.check == check && finding.remedy.contains(remedy));
    let finding = finding.unwrap_or_else(|| panic!("{check}: {remedy}: {report}"));
    assert_eq!(finding.planner, entry.name);
    assert_eq!(finding.setup.is_empty(), finding.link.is_empty());
    let text = report.to_string();
    assert!(text.contains(entry.name) && text.contains(check) && text.contains(remedy), "{text}");
}

#[test]
fn a_planner_that_keeps_its_promises_conforms() {
    testing::assert_conforms(&registry(&GOOD), "one-corner");
    let report = testing::check(&registry(&GOOD), "one-corner");
    assert_eq!((report.checks, report.conforms()), (CHECKS.len(), true));
    assert_eq!(report.to_string(), format!("one-corner conforms: {} checks", CHECKS.len()));
}

#[test]
fn every_broken_promise_is_found_by_its_check_with_a_remedy() {
    for (wrong, entry, check, remedy) in FAULTS {
        let report = Suite::new(&registry(entry), entry.name).run();
        assert!(!report.conforms(), "{wrong:?} is not found");
        finds(entry, &report, check, remedy);
    }
}

#[test]
fn every_mistake_in_an_entry_is_found_by_its_check_with_a_remedy() {
    for (entry, check, remedy) in ENTRIES {
        let report = Suite::new(&registry(entry), entry.name).run();
        finds(entry, &report, check, remedy);
    }
}

/// What shows it can be opened: the same planner, scene, parameters and seed.
#[test]
fn a_finding_has_the_link_of_a_run_that_shows_it() {
    let (_, entry, check, _) = FAULTS.iter().find(|fault| fault.0 == PanicsAtLeast).unwrap();
    let registry = registry(entry);
    let report = testing::check(&registry, "one-corner");
    let finding = report.findings.iter().find(|finding| finding.check == *check).unwrap();
    let link = forage::Link::parse(&registry, &finding.link).unwrap();
    assert_eq!(link.setup.params.get("tries"), Some(&1.0.into()));
    assert!(finding.setup.contains("tries=1") && finding.found.contains("too few tries"), "{finding}");
}

#[test]
fn a_suite_finds_the_same_every_time() {
    let (_, entry, ..) = FAULTS.iter().find(|fault| fault.0 == Rises).unwrap();
    let check = || testing::check(&registry(entry), "one-corner");
    assert_eq!(check(), check());
}

#[test]
fn a_planner_that_is_not_listed_is_a_finding() {
    let report = testing::check(&registry(&GOOD), "two-corners");
    assert_eq!(report.findings.len(), 1);
    assert!(report.to_string().contains("two-corners") && report.to_string().contains("Registry::standard().with"), "{report}");
}

#[test]
#[should_panic(expected = "one-corner does not conform")]
fn assert_conforms_panics_with_the_report() {
    let (_, entry, ..) = FAULTS[0];
    testing::assert_conforms(&registry(entry), "one-corner");
}

/// A value that is kept is kept, and a scene that is given is used.
#[test]
fn a_suite_keeps_to_the_values_and_scenes_that_it_is_given() {
    let (_, entry, ..) = FAULTS.iter().find(|fault| fault.0 == PanicsAtLeast).unwrap();
    let report = Suite::new(&registry(entry), "one-corner").set("tries", 3.0).run();
    assert!(report.conforms(), "{report}");
    let bare: SceneKind = SceneKind { shipped: &[], ..discs::KIND };
    let registry = Arc::new(Registry::new().with(Box::leak(Box::new(bare))).with(&GOOD));
    finds(&GOOD, &testing::check(&registry, "one-corner"), "its_entry_is_complete", "Suite::with_scene");
    let report = Suite::new(&registry, "one-corner").with_scene(shipped("wcpso-discs").unwrap()).random_runs(1).run();
    assert!(report.conforms(), "{report}");
}
