//! What the rows of a sweep have in common, and whether planners differ.

use std::{
    fmt::Write,
    path::{Path, PathBuf},
};

use serde::Serialize;

use forage::{
    Overrides, Registry,
    kernel::ReferenceOptimum,
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
        table::{Cell, Table, p_is, probability, significant},
    },
    kept::Kept,
    line::RunStatistics,
    plan::Pairs,
    text::value_text,
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
        let told = |scene: usize, group: usize| -> Vec<RunStatistics> {
            let first = sweep.cell_of(scene, group) * sweep.seeds();
            (first..first + sweep.seeds()).filter_map(|job| kept.statistics_of(job)).collect()
        };
        let scenes = (0..sweep.scenes.len()).map(|scene| {
            let found =
                SceneStatistics::of(&sweep.registry, groups.iter().map(|&group| (sweep.group(group), told(scene, group))).collect());
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
                let of_scene: Vec<Vec<RunStatistics>> = groups.iter().map(|&group| told(scene, group)).collect();
                let values: Vec<Vec<Option<f64>>> = of_scene.iter().map(|told| told.iter().map(|told| told.value).collect()).collect();
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
        let mut title = format!("Mean ranks over {} blocks, scene × seed (Friedman)", friedman.blocks);
        if let (Some(statistic), Some(p)) = (friedman.statistic, friedman.p) {
            let _ = write!(title, ": χ² = {}, {}", significant(statistic, 4), p_is(p));
        }
        let difference = friedman.critical_difference;
        if let Some(difference) = difference {
            let _ = write!(
                title,
                "; they differ significantly from {} on (Nemenyi, 5 %); planners that share a letter do not differ",
                significant(difference, 3)
            );
        }
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

    fn heading(&self) -> String {
        format!("{}: {} runs in {}", escape(&self.name), self.runs, path_text(&self.rows))
    }

    /// For a terminal.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.heading());
        self.tables().iter().for_each(|table| text.extend(["\n", &table.text()]));
        self.notes().iter().for_each(|note| text.extend(["\n", note, "\n"]));
        text
    }

    /// For a document.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n", self.heading());
        self.tables().iter().for_each(|table| text.extend(["\n", &table.markdown()]));
        self.notes().iter().for_each(|note| text.extend(["\n", note, "\n"]));
        escape_lines(&text)
    }

    /// What an evaluation is, where it decides how long runs are.
    fn evaluations(&self) -> Option<String> {
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
            [(thing, _)] => format!("An evaluation is {thing}."),
            _ => {
                let things: Vec<_> = things.iter().map(|(thing, whose)| format!("{thing} ({})", whose.join(", "))).collect();
                format!("Evaluations are of different kinds: {}.", things.join("; "))
            }
        };
        Some(format!("{what} An iteration that was begun is finished."))
    }

    fn notes(&self) -> Vec<String> {
        let groups = self.scenes.first().map_or(0, |scene| scene.groups.len());
        let mut notes = Vec::new();
        notes.extend(self.evaluations());
        notes.extend(self.scenes.iter().filter_map(SceneStatistics::overspent));
        for scene in &self.scenes {
            let names = scene.groups.iter().filter(|group| !group.draws_lots).map(|group| group.summary.name.as_str());
            let names: Vec<&str> = names.collect();
            if !names.is_empty() {
                let all = if names.len() > MOST_PAIRED { format!("{} planners and parameters", names.len()) } else { names.join(", ") };
                notes.push(format!("{}: no tests and intervals for what is deterministic: {all}.", scene.scene));
            }
        }
        if groups > MOST_PAIRED {
            notes.push(format!("No tests between {groups} planners and parameters: pairs are tested up to {MOST_PAIRED}."));
        }
        if groups > MOST_RANKED {
            notes.push(format!("No mean ranks: {groups} are more than {MOST_RANKED}."));
        }
        notes
    }
}

impl SceneStatistics {
    fn of(registry: &Registry, told: Vec<((&str, Pairs), Vec<RunStatistics>)>) -> Self {
        let mut groups = Vec::with_capacity(told.len());
        let mut reached = Vec::with_capacity(told.len());
        let mut by_difference = false;
        let (_, common) = told.first().map_or(("", Vec::new()), |(group, _)| group.clone());
        let common: Vec<_> = common.into_iter().filter(|pair| told.iter().all(|((_, set), _)| set.contains(pair))).collect();
        for ((planner, parameters), runs) in told {
            // Parameters that all groups share are left out of their names.
            let set = parameters.iter().filter(|pair| !common.contains(pair));
            let name = set.fold(planner.to_owned(), |name, (parameter, value)| format!("{name} {parameter}={}", value_text(value)));
            let parameters: Overrides = parameters.into_iter().map(|(name, value)| (name, value.clone())).collect();
            let near = runs.iter().filter(|told| told.reached.is_some()).count();
            let measured = runs.iter().find(|told| told.measured);
            by_difference |= runs.iter().any(|told| told.zero);
            let draws_lots = runs.len() < 2 || runs.iter().any(|told| !told.deterministic);
            let times: Vec<Attempt> = runs.iter().map(|told| Attempt { hit: told.reached, spent: told.evaluations }).collect();
            let spent = forage::statistics::Summary::of(runs.iter().map(|told| told.evaluations));
            let spent = spent.map_or([0.0; 2], |spent| [spent.median, spent.max]);
            reached.push((planner.to_owned(), parameters, spent, draws_lots, measured.map(|told| (told.by, near, times))));
            groups.push(Group { name, values: runs.iter().map(|told| told.value).collect(), deterministic: !draws_lots });
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
        let number = |number: f64| value_text(&forage::Value::Number(number));
        let near = if self.by_difference {
            format!("{} of the exact optimum", number(within))
        } else {
            format!("{} % of the exact optimum", number(100.0 * within))
        };
        let mut measured = self.groups.iter().filter_map(|group| group.exact_by);
        let first = measured.next();
        let differ = measured.any(|by| Some(by) != first);
        let whose = if differ { ", which is not the same for all: see the last column" } else { "" };
        let budget =
            self.budget.map_or("each with its own iterations".to_owned(), |budget| format!("with a budget of {budget} evaluations"));
        let title = format!(
            "{}: values of the feasible runs, {budget}; evaluations: median and most; from, to: 95 % confidence; reached: within {near}{whose}",
            self.scene
        );
        let columns = if differ { &COLUMNS[..] } else { &COLUMNS[..17] };
        let mut table = Table::new(self.scene.clone(), title, columns);
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

    /// Which planners took far more evaluations than the budget has.
    fn overspent(&self) -> Option<String> {
        let budget = self.budget? as f64;
        let over = self.groups.iter().filter(|group| group.evaluations[1] > OVER * budget);
        let named: Vec<String> = over.map(|group| format!("{} (up to {:.0})", group.summary.name, group.evaluations[1])).collect();
        (!named.is_empty()).then(|| {
            format!("{}: more than the budget, in the first state or in an iteration that was begun: {}.", self.scene, named.join(", "))
        })
    }

    /// How many runs came near enough to the optimum, and how soon, if there is one.
    fn times(&self) -> Option<Table> {
        let measured: Vec<&GroupStatistics> = self.groups.iter().filter(|group| group.reached.is_some()).collect();
        if measured.is_empty() {
            return None;
        }
        let title = format!(
            "{}: runs that came near enough to the optimum, and the expected evaluations until one does; from, to: 95 % confidence",
            self.scene
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
        let title = format!("{}: Wilcoxon’s rank-sum test of every pair; corrected for {} tests (Holm)", self.scene, pairs.len());
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
