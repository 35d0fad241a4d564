//! How far an experiment is.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// A bar on standard error, which shows it only on a terminal.
pub(super) fn bar(name: impl Into<std::borrow::Cow<'static, str>>) -> ProgressBar {
    let bar = ProgressBar::no_length().with_message(name);
    if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent} %, {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}

/// So much of all work is done.
pub(super) fn show(bar: &ProgressBar, done: u64, total: u64) {
    if bar.length() != Some(total) {
        // What was there before says nothing about how long the rest takes.
        bar.set_length(total);
        bar.set_position(done);
        bar.reset_eta();
    }
    bar.set_position(done);
}
