//! Pictures of a sweep's statistics, next to its report.

use std::{
    fmt::Write as _,
    path::{Path, PathBuf},
};

use plotters::chart::SeriesLabelPosition;

use super::{
    super::{
        escape::escape,
        failure::Failure,
        plot::{self, Axis, Curve},
        ranking::Ranking,
    },
    kept::Kept,
    summary::{MOST_PAIRED, SweepStatistics},
};

/// More curves than these look alike.
const MOST_DRAWN: usize = MOST_PAIRED;

/// The pictures: names, and what they show.
const PICTURES: [(&str, &str); 3] = [
    ("reached", "Share of runs that came near the exact optimum, over evaluations"),
    ("profile", "Share of scenes and seeds on which a planner needs at most so many times the least evaluations"),
    ("ranks", "Mean ranks, with bars over those that do not differ"),
];

/// Where the pictures of a report are: next to it, with its name.
pub fn paths_of(report: &Path) -> [PathBuf; 3] {
    PICTURES.map(|(name, _)| report.with_extension(format!("{name}.svg")))
}

/// Whether there can be pictures next to a report: it is a file.
pub fn has_pictures(report: &Path) -> bool {
    report.metadata().map_or(true, |metadata| metadata.is_file())
}

/// Draws what there is to draw of a sweep whose rows are all there, and returns Markdown that shows it. Next to a device, such as standard
/// output, there are no pictures.
///
/// # Errors
/// A file that cannot be written.
pub fn draw(kept: &Kept, summary: &SweepStatistics, report: &Path) -> Result<String, Failure> {
    if !has_pictures(report) {
        return Ok(String::new());
    }
    let [reached, profile, ranks] = paths_of(report);
    let sweep = kept.sweep();
    let mut drawn = [false; 3];
    [&reached, &profile, &ranks].into_iter().try_for_each(|path| plot::remove(path))?;
    if sweep.groups() <= MOST_DRAWN {
        let names: Vec<String> =
            summary.scenes.first().map_or(&[] as &[_], |scene| &scene.groups).iter().map(|group| group.summary.name.clone()).collect();
        // Where there is no optimum nothing can be near it.
        let measured = |scene: &usize| summary.scenes[*scene].groups.iter().any(|group| group.exact_by.is_some());
        let cells = (0..sweep.scenes.len()).filter(measured).flat_map(|scene| (0..sweep.seeds()).map(move |seed| (scene, seed)));
        let hit = |scene, seed, group| kept.statistics_of(sweep.cell_of(scene, group) * sweep.seeds() + seed).and_then(|run| run.reached);
        let costs: Vec<Vec<Option<f64>>> =
            cells.map(|(scene, seed)| (0..sweep.groups()).map(|group| hit(scene, seed, group)).collect()).collect();
        let times = Ranking { planners: names, costs };
        if times.costs.iter().flatten().any(Option::is_some) {
            let most = summary.scenes.iter().flat_map(|scene| &scene.groups).map(|group| group.evaluations[1]).fold(1.0, f64::max);
            draw_reached(&times, most, &reached)?;
            drawn[0] = true;
        }
        if sweep.groups() > 1 && drawn[0] {
            times.draw_profile(&profile, "times the least evaluations")?;
            drawn[1] = true;
        }
        drawn[2] = summary.draw_ranks(&ranks)?;
    }
    let mut text = String::new();
    for ((_, title), path) in PICTURES.iter().zip(paths_of(report)).zip(drawn).filter_map(|(picture, drawn)| drawn.then_some(picture)) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        // Writing to a text cannot fail.
        let _ = writeln!(text, "\n![{title}](<{}>)", escape(&name));
    }
    Ok(text)
}

/// Which share of each planner's runs came near the optimum after so many evaluations.
fn draw_reached(times: &Ranking, most: f64, path: &Path) -> Result<(), Failure> {
    let of = |group: usize| {
        let mut hits: Vec<f64> = times.costs.iter().filter_map(|costs| costs[group]).collect();
        hits.sort_by(f64::total_cmp);
        hits
    };
    let hits: Vec<Vec<f64>> = (0..times.planners.len()).map(of).collect();
    let x = Axis::log("evaluations", hits.iter().flatten().copied().chain([most]));
    let ends = [x.range.start, x.range.end];
    let curves: Vec<Curve> =
        times.planners.iter().zip(&hits).map(|(name, hits)| Curve::ecdf(name, hits, times.costs.len(), ends)).collect();
    let y = Axis { title: "share of runs", range: 0.0..1.02, log: false };
    plot::draw(path, &x, &y, &curves, SeriesLabelPosition::UpperLeft)
}
