//! How far the simulation is, on standard error if that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};

/// A bar over `steps` time steps, which vanishes when it is dropped; hidden if standard error is no terminal.
pub fn bar(steps: u64) -> ProgressBar {
    let style = ProgressStyle::with_template(
        "{msg:>8} [{bar:40}] {percent:>3} %  {human_pos} of {human_len} steps, {eta} left",
    )
    .unwrap_or_else(|_| ProgressStyle::default_bar())
    .progress_chars("=> ");
    let bar = ProgressBar::new(steps).with_style(style).with_finish(ProgressFinish::AndClear);
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}

/// Does `work`, which makes a model ready and chooses its step, and says meanwhile what takes the time; hidden if standard error is
/// no terminal.
pub fn set_up<R>(work: impl FnOnce() -> R) -> R {
    let style = ProgressStyle::with_template("{spinner} choosing the time step, {elapsed}");
    let spinner = ProgressBar::new_spinner()
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
        .with_finish(ProgressFinish::AndClear);
    spinner.enable_steady_tick(Duration::from_millis(100));
    work()
}

/// A bar over the evaluations of a search; hidden if standard error is no terminal.
pub fn evaluations(count: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("[{bar:30}] {pos} of {len} evaluations, {eta} left; {msg}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    let bar = ProgressBar::new(count).with_style(style).with_finish(ProgressFinish::AndClear);
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}

/// A bar over the work of many simulations, in updates of elements; hidden if standard error is no terminal.
pub fn sweep(work: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{prefix}: {msg} [{bar:30}] {percent:>3} %, {eta} left")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    let bar = ProgressBar::new(work).with_style(style).with_finish(ProgressFinish::AndClear);
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}
