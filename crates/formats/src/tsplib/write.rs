//! Writing a `.tsp`, with a `.tour` where the shortest one is known.

use std::fmt::Write;

use forage::{
    exact::{Distances, Metric},
    kernel::{Error, ReferenceOptimum, TourEnds, digits::Digits},
    message,
    scene::{Scene, TourScene},
};

use super::{
    super::{
        file::NamedFile,
        report::{Exported, not_kept},
    },
    tour_file,
};

/// A scene of stops, and its shortest tour.
pub(in super::super) fn export(scene: &Scene, stem: &str) -> Result<Exported, Error> {
    let tour = scene.get::<TourScene>()?;
    let header = scene.header();
    let mut notes = Vec::new();
    let comment = header.note.as_ref().unwrap_or(&header.title);
    let comment: String = comment.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let n = tour.len();
    let mut text = format!("NAME : {stem}\nTYPE : TSP\nCOMMENT : {}\nDIMENSION : {n}\n", comment.trim());
    let rounded = tour.matrix.is_none() && tour.metric == Metric::Euclidean;
    if let Some(distances) = &tour.matrix {
        matrix(tour, distances, &mut text);
        if distances.rows().flatten().any(|d| d.fract() != 0.0) {
            notes.push(message!(
                "files-not-whole",
                "Some distances are no whole numbers; TSPLIB’s are, and other programs may not read them."
            ));
        }
    } else {
        let name = match tour.metric {
            Metric::Euclidean | Metric::Euc2d => "EUC_2D",
            Metric::Ceil2d => "CEIL_2D",
            Metric::Att => "ATT",
            Metric::Geo => "GEO",
        };
        let _ = writeln!(text, "EDGE_WEIGHT_TYPE : {name}\nNODE_COORD_SECTION");
        // Latitude first.
        points(tour, tour.metric == Metric::Geo, &mut text);
        if rounded {
            notes.push(message!(
                "files-rounded",
                "EUC_2D rounds each distance to a whole number; the scene’s are not rounded, and lengths differ."
            ));
        }
    }
    if !tour.fixed.is_empty() {
        text.push_str("FIXED_EDGES_SECTION\n");
        for [a, b] in &tour.fixed {
            let _ = writeln!(text, "{} {}", a + 1, b + 1);
        }
        text.push_str("-1\n");
    }
    text.push_str("EOF\n");
    let mut files = vec![NamedFile::new(format!("{stem}.tsp"), text)];
    if !tour.closed {
        not_kept(&message!("files-open", "that tours are open"), &mut notes);
    } else if let Some(exact) = scene.exact_tour(ReferenceOptimum::default(), TourEnds::Closed).filter(|exact| !exact.order.is_empty()) {
        // What is the shortest tour before rounding need not be it afterwards.
        let ending = if rounded { "tour" } else { "opt.tour" };
        files.push(tour_file(&format!("{stem}.{ending}"), &exact.order));
    }
    Ok(Exported { files, notes })
}

fn matrix(tour: &TourScene, distances: &Distances, text: &mut String) {
    let display = if tour.points.is_empty() { "NO_DISPLAY" } else { "TWOD_DISPLAY" };
    // Writing to a string cannot fail.
    let _ =
        writeln!(text, "EDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT : FULL_MATRIX\nDISPLAY_DATA_TYPE : {display}\nEDGE_WEIGHT_SECTION");
    for row in distances.rows() {
        for (j, d) in row.iter().enumerate() {
            let between = if j > 0 { " " } else { "" };
            let _ = write!(text, "{between}{}", Digits(*d));
        }
        text.push('\n');
    }
    if !tour.points.is_empty() {
        text.push_str("DISPLAY_DATA_SECTION\n");
        points(tour, false, text);
    }
}

fn points(tour: &TourScene, swap: bool, text: &mut String) {
    for (i, &[x, y]) in tour.points.iter().enumerate() {
        let [a, b] = if swap { [y, x] } else { [x, y] };
        let _ = writeln!(text, "{} {} {}", i + 1, Digits(a), Digits(b));
    }
}
