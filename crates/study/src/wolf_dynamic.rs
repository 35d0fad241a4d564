//! Drives among moving obstacles: the published case, and a thousand random scenes, [WOLF-ANT](forage#papers) §5.3 and §6.

use std::sync::{Arc, atomic::AtomicBool};

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup, Status, Value,
    kernel::{Error, Event},
    scene::{GridScene, Scene, generate},
    shipped, standard,
    statistics::Summary,
};

use super::{
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    figure::Figure,
    fingerprints::JobList,
    marks::Basis,
    options::{Options, command},
    published::{WOLF_ANT, WOLF_ANT_TURNS},
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "wolf-ant-dynamic",
    title: "drives among moving obstacles: the published case, and random scenes",
    source: "[WOLF-ANT] §5.3 and §6",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, tasks(options)?)]),
    run,
};

/// Random scenes in full.
const SCENES: u64 = 1000;
/// Seeds of the published case.
const SEEDS: u64 = 30;
/// The most obstacles of a random scene.
const MOST: u64 = 10;
/// In the order in which they are shown.
const PLANNERS: [&str; 3] = ["wolf-ant-drive", "a-star-drive", "d-star-lite-drive"];

/// A drive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Run {
    scene: String,
    planner: String,
    colony: String,
    seed: u64,
    obstacles: usize,
    border: String,
    arrived: bool,
    collisions: u64,
    /// Collisions before which nothing safe was known.
    foreseen_late: u64,
    /// Moments at which no safe motion was known.
    cornered: u64,
    /// Of the whole way, if it arrived.
    length: Option<f64>,
    /// Of the shortest way if nothing moved.
    exact: Option<f64>,
    seconds: f64,
    turns: u64,
    detours: u64,
    replans: u64,
    waits: u64,
    waited: f64,
    escapes: u64,
    smallest_distance: Option<f64>,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.scene, &self.planner, &self.colony, self.seed)
    }
}

fn key(scene: &str, planner: &str, colony: &str, seed: u64) -> String {
    format!("{scene}, {planner} {colony}, seed {seed}")
}

struct Task {
    setup: Setup,
}

impl Task {
    fn text(&self, name: &str) -> String {
        self.setup.params.get(name).map_or(String::new(), ToString::to_string)
    }
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.setup.scene.name(), &self.setup.planner, &self.text("colony"), self.setup.seed)
    }

    /// A colony plans before it drives.
    fn weight(&self) -> u64 {
        if self.setup.planner == PLANNERS[0] { 10 } else { 1 }
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let mut run = forage::Run::with_keyframes(standard(), self.setup.clone(), 0)?;
        while run.step(1000) == Status::Running {
            if stop.load(std::sync::atomic::Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let outcome = run.outcome();
        let number = |name: &str| outcome.readings.iter().find(|(n, _)| *n == name).map_or(f64::NAN, |(_, value)| *value);
        let count = |name: &str| number(name) as u64;
        let events = |kind: &str| outcome.events.iter().filter(|event| event.kind == kind).count() as u64;
        Ok(Some(Run {
            scene: self.setup.scene.name().to_owned(),
            planner: self.setup.planner.clone(),
            colony: self.text("colony"),
            seed: self.setup.seed,
            obstacles: self.setup.scene.get::<GridScene>()?.moving.len(),
            border: self.text("border"),
            arrived: outcome.status == Status::Solved,
            collisions: count("collisions"),
            foreseen_late: foreseen_late(&outcome.events),
            cornered: events("cornered"),
            length: outcome.length,
            exact: outcome.exact,
            seconds: number("time"),
            turns: count("turns"),
            detours: count("detours"),
            replans: count("replans"),
            waits: count("waits"),
            waited: number("waited"),
            escapes: count("escapes"),
            smallest_distance: Some(number("smallest_distance")).filter(|distance| distance.is_finite()),
        }))
    }
}

/// Collisions before which the robot knew of nothing safe: since the last time that it was in no danger it was cornered.
fn foreseen_late(events: &[Event]) -> u64 {
    let (mut cornered, mut count) = (false, 0);
    for event in events {
        match event.kind {
            "cornered" => cornered = true,
            "collision" => count += u64::from(cornered),
            // A plan that is safe as far as it looks ahead.
            "detour" | "replan" | "wait" | "evade" | "squeeze" | "go-on" => cornered = false,
            _ => {}
        }
    }
    count
}

const FILE: &str = "wolf-ant-dynamic-runs.csv";

fn tasks(options: &Options) -> Result<Vec<Task>, Error> {
    let scenes = options.runs_or(SCENES)?;
    let setups = published(SEEDS.min(scenes))?.into_iter().chain(random(scenes)?);
    Ok(setups.map(|setup| Task { setup }).collect())
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let scenes = options.runs_or(SCENES)?;
    let seeds = SEEDS.min(scenes);
    let published = published(seeds)?;
    let path = options.out.join(FILE);
    let rows = runner::run(&tasks(options)?, &path, options.fresh, options.threads, control)?;
    let (case, among) = rows.split_at(published.len());

    let mut report = REPRODUCTION.report(scenes, SCENES);
    report.shortened = (scenes != SCENES).then(|| format!("{scenes} random scenes instead of {SCENES}"));
    report.files.push(path);
    report.figures = figures(case, &published);
    report.tables = vec![beside(case, seeds), shares(among), by_number(among)];
    report.notes = notes(among);
    let first = |planner: &str| published.iter().find(|setup| setup.planner == planner);
    report.commands = PLANNERS.into_iter().filter_map(first).map(command).collect();
    report.commands.push(format!("{}; forage run a-star-drive --scene s.json --set border={}", make(1), border(1)));
    report.write(options)?;
    Ok(report)
}

/// The published case: the paper's three, and D* Lite.
fn published(seeds: u64) -> Result<Vec<Setup>, Error> {
    let scene = shipped("wolf-ant-20")?;
    let setup = |planner: &str, colony: Option<&str>, seed| {
        let params = colony.map(|colony| ("colony", Value::from(colony))).into_iter().collect();
        Setup { planner: planner.to_owned(), scene: Arc::clone(&scene), params, seed }
    };
    let mut setups = vec![setup("a-star-drive", None, 1), setup("d-star-lite-drive", None, 1)];
    for colony in ["aco", "aco-wolf"] {
        setups.extend((1..=seeds).map(|seed| setup("wolf-ant-drive", Some(colony), seed)));
    }
    Ok(setups)
}

/// Scene by scene 1 to [`MOST`] obstacles; every second ten of them bounce off the border.
fn random(scenes: u64) -> Result<Vec<Setup>, Error> {
    let mut setups = Vec::new();
    for k in 1..=scenes {
        let scene = Arc::new(one(k)?);
        for planner in PLANNERS {
            let mut params = Overrides::new();
            params.insert("border", Value::from(border(k)));
            if planner == PLANNERS[0] {
                params.insert("colony", Value::from("aco-wolf"));
            }
            setups.push(Setup { planner: planner.to_owned(), scene: Arc::clone(&scene), params, seed: k });
        }
    }
    Ok(setups)
}

fn one(k: u64) -> Result<Scene, Error> {
    let given = settings(k).into_iter().collect();
    standard().generate(generate::RANDOM.name, &given, k)
}

/// Grids like the published one, a quarter blocked.
fn settings(k: u64) -> [(&'static str, Value); 4] {
    [("columns", 20.0), ("rows", 20.0), ("share", 0.25), ("moving", (1 + (k - 1) % MOST) as f64)]
        .map(|(name, number)| (name, Value::from(number)))
}

fn make(k: u64) -> String {
    let set = settings(k).map(|(name, value)| format!("--set {name}={value}")).join(" ");
    format!("forage generate {} {set} --seed {k} --out s.json", generate::RANDOM.name)
}

fn border(k: u64) -> &'static str {
    if ((k - 1) / MOST).is_multiple_of(2) { "leave" } else { "bounce" }
}

/// What of a drive is measured.
type Of = fn(&Run) -> Option<f64>;

/// Table 2, driven and the computed ones.
fn figures(case: &[Run], setups: &[Setup]) -> Vec<ComparedFigure> {
    let open = "the paper prints neither the layout of the obstacles nor the way that the robot drives";
    let mut figures = Vec::new();
    for (row, planner, colony, [px, seconds]) in [
        ("A*", "a-star-drive", "", WOLF_ANT[0]),
        ("traditional ants", "wolf-ant-drive", "aco", WOLF_ANT[1]),
        ("improved ants", "wolf-ant-drive", "aco-wolf", WOLF_ANT[2]),
    ] {
        let is_first =
            |setup: &&Setup| setup.planner == planner && setup.params.get("colony").is_none_or(|value| value.to_string() == colony);
        let measures: [(&str, Figure, Of); 3] = [
            ("length, px", px, |run| run.length),
            ("time, s", seconds, |run| Some(run.seconds)),
            ("turns", WOLF_ANT_TURNS, |run| Some(run.turns as f64)),
        ];
        for (measure, figure, of) in measures {
            let runs = case.iter().filter(|run| run.planner == planner && run.colony == colony && run.arrived);
            figures.push(ComparedFigure {
                table: "Table 2, driven among the moving obstacle".to_owned(),
                group: String::new(),
                row: row.to_owned(),
                measure: measure.to_owned(),
                lower_is_better: true,
                published: Published::figure(figure),
                computed: Computed::runs(runs.filter_map(of)),
                basis: Basis::Reconstruction(open),
                source: None,
                command: setups.iter().find(is_first).map(command).unwrap_or_default(),
            });
        }
    }
    figures
}

/// The published figures and the computed ones.
fn beside(case: &[Run], seeds: u64) -> Table {
    let columns =
        ["planner", "published px", "mean", "best", "published s", "mean", "best", "published turns", "mean", "best", "collisions"];
    let title =
        format!("The published case: a disc of radius 5 px goes up at 20 px/s; seeds 1 to {seeds} of the ants, lengths in px, times in s");
    let mut table = Table::new("published", title, &columns);
    for (label, planner, colony, figures) in [
        ("A*", "a-star-drive", "", Some(WOLF_ANT[0])),
        ("D* Lite", "d-star-lite-drive", "", None),
        ("traditional ants (colony=aco)", "wolf-ant-drive", "aco", Some(WOLF_ANT[1])),
        ("improved ants", "wolf-ant-drive", "aco-wolf", Some(WOLF_ANT[2])),
    ] {
        let runs = || case.iter().filter(|run| run.planner == planner && run.colony == colony && run.arrived);
        let of = |of: &dyn Fn(&Run) -> f64| Summary::of(runs().map(of));
        let (length, seconds) = (of(&|run| run.length.unwrap_or(f64::NAN)), of(&|run| run.seconds));
        let turns = of(&|run| run.turns as f64);
        let mut row = vec![Cell::from(label)];
        for (k, summary, digits) in [(0, length, 4), (1, seconds, 4), (2, turns, 2)] {
            let printed = if k < 2 { figures.map(|figures| figures[k].value) } else { figures.map(|_| WOLF_ANT_TURNS.value) };
            row.push(Cell::maybe(printed, if k < 2 { 4 } else { 0 }));
            row.extend([Cell::maybe(summary.map(|s| s.mean), digits), Cell::maybe(summary.map(|s| s.min), if k < 2 { digits } else { 0 })]);
        }
        row.push(Cell::whole(runs().map(|run| run.collisions).sum()));
        table.rows.push(row);
    }
    table
}

/// Over the shortest way there would be if nothing moved, in percent.
fn detour(run: &Run) -> Option<f64> {
    Some(100.0 * (run.length? / run.exact.filter(|&exact| exact > 0.0)? - 1.0))
}

fn shares(among: &[Run]) -> Table {
    let columns = [
        "planner",
        "scenes",
        "arrived",
        "of them without collision",
        "collisions",
        "scenes with one",
        "nothing safe known before",
        "mean detour %",
        "median detour %",
        "mean s",
        "detours",
        "new plans",
        "waits",
        "mean s waited",
        "escapes",
    ];
    let scenes = among.len() / PLANNERS.len();
    let title =
        format!("{scenes} random scenes of 20 × 20 cells with 1 to {MOST} moving obstacles, as fast as the robot at most; a run each");
    let mut table = Table::new("random", title, &columns);
    for planner in PLANNERS {
        let runs: Vec<&Run> = among.iter().filter(|run| run.planner == planner).collect();
        let count = |of: &dyn Fn(&Run) -> bool| Cell::whole(runs.iter().filter(|run| of(run)).count() as u64);
        let sum = |of: &dyn Fn(&Run) -> u64| Cell::whole(runs.iter().map(|run| of(run)).sum());
        let mean = |of: &dyn Fn(&Run) -> f64| Summary::of(runs.iter().filter(|run| run.arrived).map(|run| of(run))).map(|s| s.mean);
        let detours = Summary::of(runs.iter().filter_map(|run| detour(run)));
        table.rows.push(vec![
            planner.into(),
            Cell::whole(runs.len() as u64),
            count(&|run| run.arrived),
            count(&|run| run.arrived && run.collisions == 0),
            sum(&|run| run.collisions),
            count(&|run| run.collisions > 0),
            sum(&|run| run.foreseen_late),
            Cell::maybe(detours.map(|s| s.mean), 2),
            Cell::maybe(detours.map(|s| s.median), 2),
            Cell::maybe(mean(&|run| run.seconds), 2),
            sum(&|run| run.detours),
            sum(&|run| run.replans),
            sum(&|run| run.waits),
            Cell::maybe(mean(&|run| run.waited), 2),
            sum(&|run| run.escapes),
        ]);
    }
    table
}

fn by_number(among: &[Run]) -> Table {
    let mut columns = vec!["obstacles".to_owned(), "scenes".to_owned()];
    for planner in PLANNERS {
        columns.extend(["safe", "collisions", "detour %"].map(|column| format!("{planner}: {column}")));
    }
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let mut table = Table::new("obstacles", "By the number of obstacles: arrived without collision, collisions, mean detour", &columns);
    for n in 1..=MOST as usize {
        let of = |planner: &str| among.iter().filter(|run| run.planner == planner && run.obstacles == n).collect::<Vec<_>>();
        let mut row = vec![Cell::whole(n as u64), Cell::whole(of(PLANNERS[0]).len() as u64)];
        for planner in PLANNERS {
            let runs = of(planner);
            row.push(Cell::whole(runs.iter().filter(|run| run.arrived && run.collisions == 0).count() as u64));
            row.push(Cell::whole(runs.iter().map(|run| run.collisions).sum()));
            row.push(Cell::maybe(Summary::of(runs.iter().filter_map(|run| detour(run))).map(|s| s.mean), 2));
        }
        table.rows.push(row);
    }
    table
}

fn notes(among: &[Run]) -> Vec<String> {
    let mut notes = vec![
        "Published times are length / speed + turns × the time of a turn. The shortest ways of the published scene are many, with 6 to 14 turns; which one a colony finds decides the time, and whether it comes near the obstacle at all. A* here is exact, so it is not longer than the ants, whatever is printed.".to_owned(),
        "Robot: radius and margin half a cell, sensor 8 cells, 6 s ahead (our reading; the paper’s robot is a point and would never foresee anything in its own case).".to_owned(),
        format!("Random scenes: `{}` and so on; obstacles leave at the border in the first ten of every twenty scenes and bounce in the others. Walls do not stop them: they may come out of one.", make(1)),
        "A collision counts as known too late if the robot was cornered before: a search over places, headings, waits and time found no motion that keeps the bodies apart as far as it looks ahead. It stands a second for every turn, and obstacles are as fast as it is: one that comes into the sensor’s reach while it is in a passage cannot always be outrun.".to_owned(),
    ];
    let late: Vec<_> = among.iter().filter(|run| !run.arrived).take(5).map(|run| format!("{} on {}", run.planner, run.scene)).collect();
    if !late.is_empty() {
        notes.push(format!("Not arrived in time, among others: {}.", late.join(", ")));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collision_is_late_only_after_a_moment_without_a_safe_motion() {
        let events = |kinds: &[&'static str]| {
            let event = |&kind: &&'static str| Event {
                iteration: 0,
                time: 0.0,
                place: [0.0; 2],
                kind,
                obstacle: None,
                reason: forage::kernel::Message::default(),
            };
            kinds.iter().map(event).collect::<Vec<_>>()
        };
        assert_eq!(foreseen_late(&events(&["foreseen", "cornered", "collision", "collision"])), 2);
        assert_eq!(foreseen_late(&events(&["foreseen", "cornered", "evade", "collision"])), 0);
        assert_eq!(foreseen_late(&events(&["collision"])), 0);
    }

    #[test]
    fn scenes_have_one_to_ten_obstacles_and_either_border() {
        let counts: Vec<_> = (1..=20).map(|k| one(k).unwrap().get::<GridScene>().unwrap().moving.len()).collect();
        assert_eq!(counts, (1..=10).chain(1..=10).collect::<Vec<_>>());
        assert_eq!([1, 10, 11, 20, 21].map(border), ["leave", "leave", "bounce", "bounce", "leave"]);
    }
}
