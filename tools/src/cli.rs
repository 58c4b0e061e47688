//! The command line: arguments in, text and exit code out.

use std::cell::OnceCell;
use std::ffi::OsString;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Args, CommandFactory, Parser, Subcommand};

use crate::commands::{
    calibrate, fit, fmu, golden, measure, page, protect, reduction, report, run, scenario, sweep, validate,
};
use crate::failure::{Failure, INTERRUPTED};
use crate::{identity, interrupt};

/// Drop-weight impact on a soft anvil, by explicit finite elements that give the same bits everywhere.
///
/// Without a command: the three drops of the paper, its table side by side, and a report folder.
#[derive(Debug, Parser)]
#[command(name = "softanvil", version, long_version = identity::long_version(), args_conflicts_with_subcommands = true)]
#[command(
    after_help = "Exit codes: 0 done, 1 the simulation or a file failed, 2 wrong input, 130 interrupted: what was done \
                         by then is shown and written."
)]
pub struct Cli {
    #[command(flatten)]
    report: report::Options,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Run(Box<run::Options>),
    Report(Box<report::OwnOptions>),
    Page(page::Options),
    Measure(Box<measure::Options>),
    Protect(Box<protect::Options>),
    Validate(validate::Options),
    Calibrate(calibrate::Options),
    Sweep(Box<sweep::Options>),
    Reduction(Box<reduction::Options>),
    /// What `sweep` was called
    #[command(hide = true)]
    Study(Renamed),
    Scenario(scenario::Options),
    Fit(Box<fit::Options>),
    Fmu(fmu::Options),
    Golden(golden::Options),
}

/// Arguments of a command that has another name now, whatever they are.
#[derive(Debug, Args)]
struct Renamed {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    _arguments: Vec<OsString>,
}

impl Cli {
    /// Carries out the command; returns what belongs on standard output.
    ///
    /// # Errors
    /// Wrong input, or a simulation or file that failed.
    fn carry_out(&self, interrupt: &dyn Fn() -> Arc<AtomicBool>) -> Result<String, Failure> {
        match &self.command {
            None => report::carry_out(&self.report),
            Some(Command::Run(options)) => run::carry_out(options),
            Some(Command::Report(options)) => report::carry_out_own(options),
            Some(Command::Page(options)) => page::carry_out(options),
            Some(Command::Measure(options)) => measure::carry_out(options),
            Some(Command::Protect(options)) => protect::carry_out(options),
            Some(Command::Validate(options)) => validate::carry_out(options),
            Some(Command::Calibrate(options)) => calibrate::carry_out(options, &interrupt()),
            Some(Command::Sweep(options)) => sweep::carry_out(options, &interrupt()),
            Some(Command::Reduction(options)) => reduction::carry_out(options),
            Some(Command::Study(_)) => Err(Failure::Input(sweep::RENAMED.into())),
            Some(Command::Scenario(options)) => scenario::carry_out(options),
            Some(Command::Fit(options)) => fit::carry_out(options),
            Some(Command::Fmu(options)) => fmu::carry_out(options),
            Some(Command::Golden(options)) => golden::carry_out(options),
        }
    }
}

/// The command line as clap knows it, for manual pages.
pub fn program() -> clap::Command {
    Cli::command()
}

/// The options of the subcommand called `name`: their long names, with the line that explains each; none of no command.
pub fn options(name: &str) -> Option<Vec<(String, String)>> {
    let mut program = program();
    let command = program.find_subcommand_mut(name)?;
    let row = |option: &clap::Arg| {
        let long = option.get_long().or(option.get_value_names()?.first().map(|name| name.as_str()))?;
        Some((long.to_string(), option.get_help().map(ToString::to_string).unwrap_or_default()))
    };
    Some(command.get_arguments().filter_map(row).collect())
}

/// How a command ended.
///
/// ```
/// use softanvil_tools::cli::execute;
///
/// let refused = execute(["softanvil", "run", "--height", "-1"].map(Into::into));
/// assert_eq!((refused.exit_code, refused.stdout.as_str()), (2, ""));
/// let done = execute(["softanvil", "run", "--energy", "9.8", "--json"].map(Into::into));
/// assert!(done.exit_code == 0 && done.stdout.contains("\"peak_force\""));
/// ```
#[derive(Debug)]
pub struct Outcome {
    /// Text for standard output.
    pub stdout: String,
    /// Text for standard error.
    pub stderr: String,
    /// 0 done, 1 failed, 2 wrong input, 130 interrupted.
    pub exit_code: u8,
}

/// Carries out a command line, whose first argument is the name of the program.
pub fn execute(arguments: impl IntoIterator<Item = OsString>) -> Outcome {
    execute_with(arguments, &interrupt::flag)
}

/// The same in a program that has its own way to say that a search or a sweep is to end early: the flag that `interrupt` gives is
/// set then.
pub fn execute_with(arguments: impl IntoIterator<Item = OsString>, interrupt: &dyn Fn() -> Arc<AtomicBool>) -> Outcome {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return refused(&Failure::Input(usage_error(&error))),
        // Help and version.
        Err(error) => return done(error.to_string()),
    };
    let asked = OnceCell::new();
    let stop = || Arc::clone(asked.get_or_init(interrupt));
    match cli.carry_out(&stop) {
        // What was done until then is not what was asked for.
        Ok(text) if asked.get().is_some_and(|stop| stop.load(Ordering::Relaxed)) => {
            Outcome { exit_code: INTERRUPTED, ..done(text) }
        }
        Ok(text) => done(text),
        Err(failure) => refused(&failure),
    }
}

fn done(stdout: String) -> Outcome {
    Outcome { stdout, stderr: String::new(), exit_code: 0 }
}

fn refused(failure: &Failure) -> Outcome {
    // Paths and messages of the system may hold line breaks; an error is one line.
    let line = failure.to_string().replace(['\n', '\r'], " ");
    Outcome { stdout: String::new(), stderr: format!("error: {line}\n"), exit_code: failure.exit_code() }
}

/// What is wrong, in one line, without the usage and tips that clap adds in further paragraphs.
fn usage_error(error: &clap::Error) -> String {
    let text = error.to_string();
    let paragraph = text.trim_start_matches("error: ").split("\n\n").next().unwrap_or_default();
    paragraph.split_whitespace().collect::<Vec<_>>().join(" ")
}
