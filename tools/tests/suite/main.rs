//! The program as its users meet it.

mod calibrate;
mod common;
mod documentation;
mod fit;
mod fuzz;
mod golden;
mod measure;
mod measured_data;
mod pictures;
mod protect;
mod protocols;
mod quasi_static;
mod recovery;
mod reduction;
mod reference;
mod report;
mod run;
mod series;
mod sweep;
mod tutorial;
mod uncertainty;
mod wrong_input;
