//! What the rows of a sweep have in common, and whether planners differ.

use std::path::{Path, PathBuf};

use serde::Serialize;

use forage::{
    Overrides, Registry,
    kernel::{Message, ReferenceOptimum, message::in_english},
    message,
    statistics::{
        Attempt, Comparison, Friedman, Group, GroupSummary, Pair, RunningTime, comparable, compare, friedman, homogeneous_groups,
        proportion,
    },
};

use super::{
    super::{
        escape::{escape, escape_lines, path_text, serialize_path},
        failure::Failure,
        plot::{self, Ranked},
        ranking::letters,
        table::{Cell, Say, Table, as_it_is, probability},
    },
    kept::Kept,
    line::RunStatistics,
    plan::Pairs,
    text::value_text,
    titles::rank_title,
};

/// With more groups than this, pairs are not tested.
pub(super) const MOST_PAIRED: usize = 30;
/// Planners with runs above this multiple of the budget are named.
const OVER: f64 = 1.1;
/// More than so many are not ranked: the time for it grows with their square.
const MOST_RANKED: usize = 1000;

/// The statistics of a sweep.
#[derive(Debug, Serialize)]
pub struct SweepStatistics {
    /// The sweep's name.
    pub name: String,
    /// Where the rows are.
    #[serde(serialize_with = "serialize_path")]
    pub rows: PathBuf,
    /// How many runs.
    pub runs: usize,
    /// How near to the exact optimum counts as reached.
    pub within: f64,
    /// Scene by scene.
    pub scenes: Vec<SceneStatistics>,
    /// Which of each scene's groups are ranked: those that draw lots.
    pub ranked: Vec<usize>,
    /// Their ranks over scenes and seeds. `None` of one, or of more than a thousand.
    pub friedman: Option<Friedman>,
}

/// What there is to say of a scene.
#[derive(Debug, Serialize)]
pub struct SceneStatistics {
    /// The scene's name.
    pub scene: String,
    /// After how many evaluations runs were stopped; `None`: after their own iterations.
    pub budget: Option<u64>,
    /// Planners and parameters.
    pub groups: Vec<GroupStatistics>,
    /// Every pair of the stochastic ones; the correction is for the scene's pairs. `None` of more than thirty groups.
    pub pairs: Option<Vec<Pair>>,
    #[serde(skip)]
    /// Whether near the optimum means a difference, and not a share of it: on functions, and where it is 0.
    by_difference: bool,
}

/// What there is to say of a planner with some parameters.
#[derive(Debug, Serialize)]
pub struct GroupStatistics {
    /// The planner's name.
    pub planner: String,
    /// The parameters that the sweep sets.
    pub parameters: Overrides,
    /// What one of the planner's evaluations is; empty: it does not say.
    pub evaluation: &'static str,
    /// How many evaluations its runs took: the median and the most.
    pub evaluations: [f64; 2],
    /// Whether it is stochastic: deterministic planners give the same run for every seed, and are not tested.
    pub draws_lots: bool,
    /// Which optimum it is measured by; `None` where there is none.
    pub exact_by: Option<ReferenceOptimum>,
    /// The share of runs that came near enough to the optimum; `None` where there is no optimum.
    pub reached: Option<f64>,
    /// The 95 % interval of that share, by Wilson; `None` where there is none or the planner is deterministic.
    pub reached_interval: Option<[f64; 2]>,
    /// The expected number of evaluations until a run comes near enough: all evaluations by all successes; `None` without a success.
    pub expected_evaluations: Option<f64>,
    /// The 95 % interval of that, by the bootstrap; its upper end is `None` where samples without a success are too frequent.
    pub expected_interval: Option<[Option<f64>; 2]>,
    /// The rest.
    #[serde(flatten)]
    pub summary: GroupSummary,
}

impl SweepStatistics {
    /// Of rows that are all there.
    pub fn of(kept: &Kept) -> Self {
        let sweep = kept.sweep();
        let groups: Vec<usize> = (0..sweep.groups()).collect();
        let statistics = |scene: usize, group: usize| -> Vec<RunStatistics> {
            let first = sweep.cell_of(scene, group) * sweep.seeds();
            (first..first + sweep.seeds()).filter_map(|job| kept.statistics_of(job)).collect()
        };
        let scenes = (0..sweep.scenes.len()).map(|scene| {
            let found =
                SceneStatistics::of(&sweep.registry, groups.iter().map(|&group| (sweep.group(group), statistics(scene, group))).collect());
            SceneStatistics {
                scene: sweep.scenes[scene].name().to_owned(),
                budget: sweep.allowances[scene],
                by_difference: found.by_difference || sweep.scenes[scene].minimum().is_some(),
                ..found
            }
        });
        let scenes: Vec<SceneStatistics> = scenes.collect();
        let draws = |group: &usize| scenes.iter().any(|scene| scene.groups[*group].draws_lots);
        let groups: Vec<usize> = groups.iter().copied().filter(draws).collect();
        let friedman = (2..=MOST_RANKED).contains(&groups.len()).then(|| {
            let mut blocks = Vec::with_capacity(sweep.scenes.len() * sweep.seeds());
            for scene in 0..sweep.scenes.len() {
                let of_scene: Vec<Vec<RunStatistics>> = groups.iter().map(|&group| statistics(scene, group)).collect();
                let values: Vec<Vec<Option<f64>>> =
                    of_scene.iter().map(|statistics| statistics.iter().map(|statistics| statistics.value).collect()).collect();
                let ranked = comparable(values.iter().map(|values| &values[..]));
                let block = |k: usize| ranked.iter().map(|values| values[k]).collect();
                blocks.extend((0..sweep.seeds()).map(block));
            }
            friedman(&blocks)
        });
        Self {
            name: sweep.name.clone(),
            rows: kept.path().to_owned(),
            runs: sweep.len(),
            within: sweep.within,
            scenes,
            ranked: groups,
            friedman: friedman.flatten(),
        }
    }

    /// The tables.
    pub fn tables(&self) -> Vec<Table> {
        let mut tables = Vec::new();
        for scene in &self.scenes {
            tables.push(scene.table(self.within));
            tables.extend(scene.times());
            tables.extend(scene.paired());
        }
        tables.extend(self.friedman.as_ref().map(|friedman| self.ranked(friedman)));
        tables
    }

    fn ranked(&self, friedman: &Friedman) -> Table {
        let title = rank_title(friedman);
        let difference = friedman.critical_difference;
        let groups_alike = difference.map_or(Vec::new(), |difference| homogeneous_groups(&friedman.ranks, difference));
        let mut table = Table::new("ranks", title, &["planner", "mean rank", "group"]);
        let groups = self.scenes.first().map_or(&[] as &[GroupStatistics], |scene| &scene.groups);
        let mut rows: Vec<_> = self.ranked.iter().map(|&group| &groups[group]).zip(friedman.ranks.iter().copied()).enumerate().collect();
        rows.sort_by(|a, b| a.1.1.total_cmp(&b.1.1));
        let row = |(k, (group, rank)): (usize, (&GroupStatistics, f64))| {
            vec![group.summary.name.as_str().into(), shown(rank), letters(&groups_alike, k).into()]
        };
        table.rows = rows.into_iter().map(row).collect();
        table
    }

    /// Draws the mean ranks; whether there was something to draw.
    pub(super) fn draw_ranks(&self, path: &Path) -> Result<bool, Failure> {
        let Some((friedman, difference)) = self.friedman.as_ref().and_then(|friedman| Some((friedman, friedman.critical_difference?)))
        else {
            return Ok(false);
        };
        let groups = self.scenes.first().map_or(&[] as &[GroupStatistics], |scene| &scene.groups);
        let named = self.ranked.iter().map(|&group| groups[group].summary.name.clone());
        let ranked: Vec<Ranked> = named.zip(&friedman.ranks).map(|(name, &rank)| Ranked { name, rank }).collect();
        plot::draw_ranks(path, &ranked, difference, &homogeneous_groups(&friedman.ranks, difference))?;
        Ok(true)
    }

    fn heading(&self) -> Message {
        let (name, runs, rows) = (escape(&self.name), self.runs, path_text(&self.rows));
        message!("study-sweep", "{name}: {runs} runs in {rows}", name, runs, rows)
    }

    /// For a terminal, in the language that is spoken; `say`: how words in English are said.
    pub fn text(&self, say: Say<'_>) -> String {
        let mut text = format!("{}\n", self.heading());
        self.tables().iter().for_each(|table| text.extend(["\n", &table.text(say)]));
        self.notes(say).iter().for_each(|note| text.extend(["\n", &note.text(), "\n"]));
        text
    }

    /// For a document, in English.
    pub fn markdown(&self) -> String {
        in_english(|| {
            let mut text = format!("# {}\n", self.heading());
            self.tables().iter().for_each(|table| text.extend(["\n", &table.markdown()]));
            self.notes(&as_it_is).iter().for_each(|note| text.extend(["\n", &note.text(), "\n"]));
            escape_lines(&text)
        })
    }

    /// What an evaluation is, where it decides how long runs are.
    fn evaluations(&self, say: Say<'_>) -> Option<Message> {
        let scene = self.scenes.iter().find(|scene| scene.budget.is_some())?;
        let mut things: Vec<(&str, Vec<&str>)> = Vec::new();
        for GroupStatistics { planner, evaluation, .. } in scene.groups.iter().filter(|group| !group.evaluation.is_empty()) {
            match things.iter_mut().find(|(thing, _)| thing == evaluation) {
                Some((_, whose)) if whose.contains(&planner.as_str()) => {}
                Some((_, whose)) => whose.push(planner),
                None => things.push((evaluation, vec![planner])),
            }
        }
        let what = match &things[..] {
            [] => return None,
            [(thing, _)] => message!("study-evaluation", "An evaluation is {thing}.", thing = say(thing)),
            _ => {
                let thing = |(thing, whose): &(&str, Vec<&str>)| {
                    message!("study-evaluation-of", "{thing} ({planners})", thing = say(thing), planners = whose.join(", "))
                };
                let joined = |first: Message, second: Message| message!("study-and-then", "{first}; {second}", first, second);
                let things = things.iter().map(thing).reduce(joined).unwrap_or_default();
                message!("study-evaluations", "Evaluations are of different kinds: {things}.", things)
            }
        };
        Some(what.then(message!("study-finished", "An iteration that was begun is finished.")))
    }

    fn notes(&self, say: Say<'_>) -> Vec<Message> {
        let groups = self.scenes.first().map_or(0, |scene| scene.groups.len());
        let mut notes = Vec::new();
        notes.extend(self.evaluations(say));
        notes.extend(self.scenes.iter().filter_map(SceneStatistics::overspent));
        for scene in &self.scenes {
            let names = scene.groups.iter().filter(|group| !group.draws_lots).map(|group| group.summary.name.as_str());
            let names: Vec<&str> = names.collect();
            if !names.is_empty() {
                let n = names.len();
                let many = || message!("study-planners-and-parameters", "{n} planners and parameters", n);
                let names = if n > MOST_PAIRED { many() } else { Message::verbatim(names.join(", ")) };
                let scene = &scene.scene;
                notes.push(message!(
                    "study-deterministic",
                    "{scene}: no tests and intervals for what is deterministic: {names}.",
                    scene,
                    names
                ));
            }
        }
        if groups > MOST_PAIRED {
            notes.push(message!(
                "study-no-tests",
                "No tests between {groups} planners and parameters: pairs are tested up to {most}.",
                groups,
                most = MOST_PAIRED
            ));
        }
        if groups > MOST_RANKED {
            notes.push(message!("study-no-ranks", "No mean ranks: {groups} are more than {most}.", groups, most = MOST_RANKED));
        }
        notes
    }
}

impl SceneStatistics {
    fn of(registry: &Registry, groups_of_runs: Vec<((&str, Pairs), Vec<RunStatistics>)>) -> Self {
        let mut groups = Vec::with_capacity(groups_of_runs.len());
        let mut reached = Vec::with_capacity(groups_of_runs.len());
        let mut by_difference = false;
        let (_, common) = groups_of_runs.first().map_or(("", Vec::new()), |(group, _)| group.clone());
        let common: Vec<_> = common.into_iter().filter(|pair| groups_of_runs.iter().all(|((_, set), _)| set.contains(pair))).collect();
        for ((planner, parameters), runs) in groups_of_runs {
            // Parameters that all groups share are left out of their names.
            let set = parameters.iter().filter(|pair| !common.contains(pair));
            let name = set.fold(planner.to_owned(), |name, (parameter, value)| format!("{name} {parameter}={}", value_text(value)));
            let parameters: Overrides = parameters.into_iter().map(|(name, value)| (name, value.clone())).collect();
            let near = runs.iter().filter(|run| run.reached.is_some()).count();
            let measured = runs.iter().find(|run| run.measured);
            by_difference |= runs.iter().any(|run| run.zero);
            let draws_lots = runs.len() < 2 || runs.iter().any(|run| !run.deterministic);
            let times: Vec<Attempt> = runs.iter().map(|run| Attempt { hit: run.reached, spent: run.evaluations }).collect();
            let spent = forage::statistics::Summary::of(runs.iter().map(|run| run.evaluations));
            let spent = spent.map_or([0.0; 2], |spent| [spent.median, spent.max]);
            reached.push((planner.to_owned(), parameters, spent, draws_lots, measured.map(|run| (run.by, near, times))));
            groups.push(Group { name, values: runs.iter().map(|run| run.value).collect(), deterministic: !draws_lots });
        }
        let (summaries, pairs) = if groups.len() <= MOST_PAIRED {
            let Comparison { groups, pairs, .. } = compare(&groups);
            (groups, Some(pairs.into_iter().filter(|pair| pair.p.is_some()).collect()))
        } else {
            (groups.chunks(1).flat_map(|group| compare(group).groups).collect(), None)
        };
        let groups = reached.into_iter().zip(summaries).map(|((planner, parameters, evaluations, draws_lots, measured), summary)| {
            let time = measured.as_ref().and_then(|(_, _, runs)| RunningTime::of(runs.clone()));
            GroupStatistics {
                evaluations,
                evaluation: registry.planner(&planner).map_or("", |entry| entry.evaluation),
                planner,
                parameters,
                draws_lots,
                exact_by: measured.as_ref().map(|(by, ..)| *by),
                reached: measured.as_ref().map(|(_, near, runs)| *near as f64 / runs.len() as f64),
                reached_interval: measured.as_ref().filter(|_| draws_lots).and_then(|(_, near, runs)| proportion(*near, runs.len())),
                expected_evaluations: time.as_ref().map(|time| time.expected),
                expected_interval: time.filter(|_| draws_lots).and_then(|time| time.interval),
                summary,
            }
        });
        Self { scene: String::new(), budget: None, groups: groups.collect(), pairs, by_difference }
    }

    fn table(&self, within: f64) -> Table {
        const COLUMNS: [&str; 18] = [
            "planner",
            "runs",
            "evaluations",
            "most",
            "feasible %",
            "from",
            "to",
            "mean",
            "from",
            "to",
            "std",
            "best",
            "lower quartile",
            "median",
            "upper quartile",
            "worst",
            "reached %",
            "optimum",
        ];
        let mut measured = self.groups.iter().filter_map(|group| group.exact_by);
        let first = measured.next();
        let differ = measured.any(|by| Some(by) != first);
        let columns = if differ { &COLUMNS[..] } else { &COLUMNS[..17] };
        let mut table = Table::new(self.scene.clone(), self.title(within, differ), columns);
        for group in &self.groups {
            let GroupSummary { runs, rate, rate_interval, summary, .. } = &group.summary;
            let of = |number: Option<f64>| number.map_or(Cell::Empty, shown);
            let lots = group.draws_lots;
            let interval = summary.and_then(|summary| summary.interval).filter(|_| lots);
            let share = |at: usize| if lots { Cell::Number(100.0 * rate_interval[at], 1) } else { Cell::Empty };
            let mut row = vec![
                group.summary.name.as_str().into(),
                Cell::whole(*runs as u64),
                Cell::Number(group.evaluations[0], 0),
                Cell::Number(group.evaluations[1], 0),
                Cell::Number(100.0 * rate, 1),
                share(0),
                share(1),
                of(summary.map(|summary| summary.mean)),
                of(interval.map(|interval| interval[0])),
                of(interval.map(|interval| interval[1])),
                of(summary.and_then(|summary| summary.std)),
                of(summary.map(|summary| summary.min)),
                of(summary.map(|summary| summary.lower)),
                of(summary.map(|summary| summary.median)),
                of(summary.map(|summary| summary.upper)),
                of(summary.map(|summary| summary.max)),
                Cell::maybe(group.reached.map(|share| 100.0 * share), 1),
            ];
            if differ {
                row.push(group.exact_by.map_or(Cell::Empty, |by| reference(by).into()));
            }
            table.rows.push(row);
        }
        table
    }

    /// What the table shows; `differ`: planners are measured by different optima.
    fn title(&self, within: f64, differ: bool) -> Message {
        let number = |number: f64| value_text(&forage::Value::Number(number));
        let near = if self.by_difference {
            message!("study-near", "{near} of the exact optimum", near = number(within))
        } else {
            message!("study-near-percent", "{near} % of the exact optimum", near = number(100.0 * within))
        };
        let near =
            if differ { message!("study-near-differs", "{near}, which is not the same for all: see the last column", near) } else { near };
        let budget = match self.budget {
            None => message!("study-own-iterations", "each with its own iterations"),
            Some(budget) => message!("study-with-budget", "with a budget of {budget} evaluations", budget),
        };
        let scene = &self.scene;
        message!(
            "study-values",
            "{scene}: values of the feasible runs, {budget}; evaluations: median and most; from, to: 95 % confidence; reached: within {near}",
            scene,
            budget,
            near
        )
    }

    /// Which planners took far more evaluations than the budget has.
    fn overspent(&self) -> Option<Message> {
        let budget = self.budget? as f64;
        let over = self.groups.iter().filter(|group| group.evaluations[1] > OVER * budget);
        let named = over.map(|group| {
            let (name, most) = (&group.summary.name, group.evaluations[1]);
            message!("study-up-to", "{name} (up to {most:.0})", name, most).to_string()
        });
        let (names, scene) = (named.collect::<Vec<_>>().join(", "), &self.scene);
        let said = || {
            message!(
                "study-overspent",
                "{scene}: more than the budget, in the first state or in an iteration that was begun: {names}.",
                scene,
                names
            )
        };
        (!names.is_empty()).then(said)
    }

    /// How many runs came near enough to the optimum, and how soon, if there is one.
    fn times(&self) -> Option<Table> {
        let measured: Vec<&GroupStatistics> = self.groups.iter().filter(|group| group.reached.is_some()).collect();
        if measured.is_empty() {
            return None;
        }
        let title = message!(
            "study-times",
            "{scene}: runs that came near enough to the optimum, and the expected evaluations until one does; from, to: 95 % confidence",
            scene = self.scene
        );
        let columns = ["planner", "reached %", "from", "to", "evaluations", "from", "to"];
        let mut table = Table::new(format!("{}-times", self.scene), title, &columns);
        for group in measured {
            let share = |at: usize| Cell::maybe(group.reached_interval.map(|interval| 100.0 * interval[at]), 1);
            let time = |at: usize| match group.expected_interval {
                Some(interval) => interval[at].map_or(Cell::Text("∞".to_owned()), |time| Cell::Number(time, 0)),
                None => Cell::Empty,
            };
            table.rows.push(vec![
                group.summary.name.as_str().into(),
                Cell::maybe(group.reached.map(|share| 100.0 * share), 1),
                share(0),
                share(1),
                Cell::maybe(group.expected_evaluations, 0),
                time(0),
                time(1),
            ]);
        }
        Some(table)
    }

    /// The tests, if there are two to test.
    fn paired(&self) -> Option<Table> {
        let pairs = self.pairs.as_ref().filter(|pairs| !pairs.is_empty())?;
        let title = message!(
            "study-pairs",
            "{scene}: Wilcoxon’s rank-sum test of every pair; corrected for {tests} tests (Holm)",
            scene = self.scene,
            tests = pairs.len()
        );
        let mut table = Table::new(format!("{}-tests", self.scene), title, &["first", "second", "U", "p", "corrected p", "first better %"]);
        for Pair { first, second, u, p, corrected, better } in pairs {
            table.rows.push(vec![
                Cell::Text(self.groups[*first].summary.name.clone()),
                Cell::Text(self.groups[*second].summary.name.clone()),
                Cell::maybe(*u, 1),
                p.map_or(Cell::Empty, |p| Cell::Text(probability(p))),
                corrected.map_or(Cell::Empty, |p| Cell::Text(probability(p))),
                Cell::Number(100.0 * better, 1),
            ]);
        }
        Some(table)
    }
}

fn reference(by: ReferenceOptimum) -> &'static str {
    match by {
        ReferenceOptimum::AnyAngle => "any angle",
        ReferenceOptimum::Cells => "cells",
        ReferenceOptimum::Matrix => "matrix",
        ReferenceOptimum::Stored => "stored",
        ReferenceOptimum::Refuted => "refuted",
    }
}

/// Four significant digits.
fn shown(number: f64) -> Cell {
    Cell::Significant(number, 4)
}
