//! `forage bench`.

use std::{
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use forage::{
    Error, Overrides,
    kernel::{Message, error::one_of, message::in_english},
    message,
    scene::function::{BBOB_FUNCTIONS, BBOB_INSTANCES},
};
use forage_study::{
    bench::{
        Contender, barn, baselines, bbob, centre_bias, movingai,
        suite::{self, Suite},
        trees, tsplib,
    },
    disk, rows,
    runner::{self, Control, Job},
    sweep::Part,
};

use super::{
    args::{self, BbobArgs, BenchArgs, SuiteArgs},
    failure::{Failure, Outcome},
    files, interrupt,
    language::said,
    load::{self, read_pairs},
    output::{note, print},
    progress,
    registry::{register, registry},
    text::{listed, quoted},
};

/// What the files of rows are called, before what tells parts apart.
const ROWS: &str = "rows";
/// What the file of the table that is printed is called.
const TABLE: &str = "table.csv";
/// So many faults are shown.
const SHOWN: usize = 10;

pub(super) fn bench(args: &BenchArgs) -> Outcome {
    for peer in baselines::ALL.iter().filter(|peer| registry().planner(peer.name).is_err()) {
        register(peer);
    }
    match &args.suite {
        args::Suite::Barn(args) => run_suite(&barn::Plan::read(&args.folder, args.radius, args.every.into())?, &args.common),
        args::Suite::Bbob(args) => run_suite(&bbob_plan(args)?, &args.common),
        args::Suite::CentreBias(args) => {
            let plan = centre_bias::Plan { dimension: args.dimension, instances: args.instances, budget: args.budget };
            run_suite(&plan, &args.common)
        }
        args::Suite::Movingai(args) => {
            let plan = movingai::Plan::read(&args.folder, args.per_bucket.map(usize::from))?;
            run_suite(&plan, &args.common)
        }
        args::Suite::Trees(args) => {
            let scenes = args.scenes.iter().map(|text| load::scene(text)).collect::<Result<_, _>>()?;
            run_suite(&trees::Plan::new(registry(), scenes, args.runs, args.budget)?, &args.common)
        }
        args::Suite::Tsplib(args) => {
            let largest = args.largest.map(usize::from);
            let plan = tsplib::Plan::read(registry(), &args.folder, largest, args.budget, args.runs)?;
            run_suite(&plan, &args.common)
        }
    }
}

/// Runs a suite, or a part of it, and writes what comes of it.
fn run_suite<S: Suite>(suite: &S, args: &SuiteArgs) -> Outcome {
    let contenders = contenders::<S>(args)?;
    let part = args.shard.as_deref().map_or(Ok(Part::WHOLE), str::parse)?;
    let attempts = suite.jobs(registry(), &contenders)?;
    let folder = args.out.clone().unwrap_or_else(|| PathBuf::from(S::NAME));
    files::check_folder("--out", &folder)?;
    disk::make_folder(&folder).map_err(|error| Failure::write(&folder, error))?;
    suite.notes().iter().for_each(note);
    let rows = run_part::<S>(&attempts, part, &folder, args)?;
    if part.of > 1 {
        let (runs, all, folder) = (rows.len(), attempts.len(), quoted(&folder.to_string_lossy()));
        print(&message!("shell-runs-in", "{runs} of {all} runs are in {folder}", runs, all, folder).text())?;
    } else {
        let written = in_english(|| suite.write(&rows, &folder))?;
        let table = suite.table(&rows);
        let file = folder.join(TABLE);
        files::write(&file, table.csv().map_err(|error| Failure::write(&file, error))?)?;
        print(&table.text(&said))?;
        let shown: Vec<_> = written.iter().map(|path| quoted(&path.to_string_lossy())).collect();
        note(message!("shell-wrote", "wrote {files}", files = listed(&shown)));
    }
    let faults = suite.faults(&rows);
    faults.iter().take(SHOWN).for_each(note);
    if faults.len() > SHOWN {
        note(message!("shell-faults-more", "and {more} more", more = faults.len() - SHOWN));
    }
    Ok(ExitCode::from(u8::from(!faults.is_empty())))
}

fn bbob_plan(args: &BbobArgs) -> Result<bbob::Plan, Failure> {
    Ok(bbob::Plan {
        functions: numbers("--functions", args.functions.as_deref(), 1, BBOB_FUNCTIONS, (1..=BBOB_FUNCTIONS).collect())?,
        dimensions: dimensions(args.dimensions.as_deref())?,
        instances: numbers("--instances", args.instances.as_deref(), 1, BBOB_INSTANCES, (1..=bbob::INSTANCES).collect())?,
        budget: args.budget,
    })
}

/// Runs the part's jobs whose rows are missing, and returns the part's rows.
fn run_part<S: Suite>(attempts: &[S::Task], part: Part, folder: &Path, args: &SuiteArgs) -> Result<Vec<<S::Task as Job>::Row>, Failure> {
    let own: Vec<S::Task> = part.jobs(attempts.len()).map(|job| attempts[job].clone()).collect();
    let name = if part.of > 1 { format!("{ROWS}.{}-of-{}.csv", part.index, part.of) } else { format!("{ROWS}.csv") };
    let file = folder.join(name);
    if !args.fresh {
        repair::<S>(&file)?;
    }
    if part.of == 1 {
        let parts = parts(folder)?;
        if args.fresh {
            parts.iter().try_for_each(|part| disk::remove(part).map_err(|error| Failure::write(part, error)))?;
        } else {
            parts.iter().try_for_each(|part| repair::<S>(part))?;
            suite::merge_parts(&file, &parts, attempts, &interrupt::flag())?;
        }
    }
    let stop = interrupt::flag();
    let bar = progress::bar(S::NAME);
    let show = |done, total| progress::show(&bar, done, total);
    let control = Control { stop: &stop, progress: &show };
    let rows = runner::run(&own, &file, args.fresh, args.jobs.map(usize::from), &control);
    bar.finish_and_clear();
    Ok(rows?)
}

/// Takes damaged lines out of a file of rows, and says so.
fn repair<S: Suite>(file: &Path) -> Result<(), Failure> {
    rows::repair::<<S::Task as Job>::Row>(file)?.iter().for_each(note);
    Ok(())
}

/// The files of rows of parts that are in a folder.
fn parts(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let is_part = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.strip_prefix(ROWS).and_then(|rest| rest.strip_suffix(".csv")).is_some_and(|part| part.contains("-of-"))
    };
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let mut all: Vec<PathBuf> =
        entries.map_err(|error| Failure::read(folder, error))?.iter().map(fs::DirEntry::path).filter(is_part).collect();
    all.sort();
    Ok(all)
}

/// Who takes part, with what is set of them.
fn contenders<S: Suite>(args: &SuiteArgs) -> Result<Vec<Contender>, Failure> {
    let all_planners = S::all_planners(registry());
    let known: Vec<&str> = all_planners.iter().map(|contender| contender.planner.as_str()).collect();
    let mut chosen: Vec<Contender> = Vec::new();
    for name in &args.planners {
        let found = all_planners.iter().find(|contender| contender.planner == *name);
        let found = found.ok_or_else(|| Error::refused("--planners", name.as_str(), one_of(&known)))?;
        if chosen.iter().any(|contender| contender.planner == *name) {
            return Err(Error::refused("--planners", name.as_str(), message!("shell-named-once", "named once")).into());
        }
        chosen.push(found.clone());
    }
    if chosen.is_empty() && args.code.is_empty() {
        chosen = S::default_planners(registry());
    }
    for path in &args.code {
        let name = load::register_code(path)?;
        let found = S::all_planners(registry()).into_iter().find(|contender| contender.planner == name);
        let refused = || Error::refused("--code", name, message!("shell-planner-of-suite", "a planner for the suite's kind of scene"));
        chosen.push(found.ok_or_else(refused)?);
    }
    // What is set of all comes first: what is set of one planner counts more.
    let is_own = |pair: &&String| pair.split('=').next().is_some_and(|left| left.contains('.'));
    let (own, common): (Vec<_>, Vec<_>) = args.set.iter().partition(is_own);
    for pair in common.into_iter().chain(own) {
        let Some((left, value)) = pair.split_once('=') else {
            return Err(Error::refused("--set", pair.as_str(), Message::verbatim("[PLANNER.]NAME=VALUE")).into());
        };
        let (planner, name) = left.split_once('.').map_or((None, left), |(planner, name)| (Some(planner), name));
        let mut params = Overrides::default();
        read_pairs("--set", &[format!("{name}={value}")], &mut params)?;
        let mut matched = 0;
        for contender in chosen.iter_mut().filter(|contender| planner.is_none_or(|planner| contender.planner == planner)) {
            params.iter().for_each(|(name, value)| contender.params.insert(name, value.clone()));
            matched += 1;
        }
        if matched == 0 {
            let names: Vec<&str> = chosen.iter().map(|contender| contender.planner.as_str()).collect();
            let allowed = message!("shell-of-planner-there", "of a planner that takes part: {names}", names = names.join(", "));
            return Err(Error::refused("--set", pair.as_str(), allowed).into());
        }
    }
    Ok(chosen)
}

/// The numbers of variables: those of the suite, which its tools know.
fn dimensions(given: Option<&str>) -> Result<Vec<usize>, Failure> {
    let [least, .., most] = bbob::DIMENSIONS;
    let chosen = numbers("--dimensions", given, least, most, bbob::DIMENSIONS.to_vec())?;
    match chosen.iter().find(|dimension| !bbob::DIMENSIONS.contains(dimension)) {
        Some(wrong) => Err(Error::refused("--dimensions", *wrong, message!("shell-dimensions", "one of 2, 3, 5, 10, 20 and 40")).into()),
        None => Ok(chosen),
    }
}

/// A list of numbers and ranges: `1-5,8`.
fn numbers(option: &str, given: Option<&str>, least: usize, most: usize, otherwise: Vec<usize>) -> Result<Vec<usize>, Failure> {
    let Some(text) = given else { return Ok(otherwise) };
    let refused = || {
        let allowed = message!("shell-number-list", "numbers from {least} to {most} with commas between, or ranges like 2-5", least, most);
        Failure::from(Error::refused(option, text, allowed))
    };
    let mut all = Vec::new();
    for piece in text.split(',') {
        let (from, to) = piece.split_once('-').unwrap_or((piece, piece));
        let (Ok(from), Ok(to)) = (from.parse::<usize>(), to.parse::<usize>()) else { return Err(refused()) };
        if from > to || from < least || to > most {
            return Err(refused());
        }
        all.extend(from..=to);
    }
    all.sort_unstable();
    all.dedup();
    Ok(all)
}
