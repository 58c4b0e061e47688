//! The program as its users meet it.

mod common;
mod report;
mod run;
mod wrong_input;
