//! The progress bar of an experiment.

use std::time::Duration;

use forage::message;
use indicatif::{ProgressBar, ProgressStyle};

use super::text::shorten;

/// A bar on standard error, shown only on a terminal.
pub(super) fn bar(name: &str) -> ProgressBar {
    let bar = ProgressBar::no_length().with_message(shorten(name, 30));
    let template = message!(
        "shell-progress",
        "{name} {bar} {percent} %, {time} left",
        name = "{msg}",
        bar = "{wide_bar}",
        percent = "{percent}",
        time = "{eta}"
    );
    if let Ok(style) = ProgressStyle::with_template(&template.text()) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}

/// Shows how much of all work is done.
pub(super) fn show(bar: &ProgressBar, done: u64, total: u64) {
    if bar.length() != Some(total) {
        // Rows that were kept from an earlier call do not say how long the rest takes.
        bar.set_length(total);
        bar.set_position(done);
        bar.reset_eta();
    }
    bar.set_position(done);
}
