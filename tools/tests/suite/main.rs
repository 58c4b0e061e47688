//! The program as its users meet it.

mod common;
mod fit;
mod report;
mod run;
mod wrong_input;
