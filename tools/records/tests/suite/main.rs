//! Files as instruments and people write them, each made here from one impact or one material.

mod common;
mod fuzz;
mod large;
mod round_trip;
mod traces;
mod workbooks;
