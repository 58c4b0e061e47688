//! The FMI functions: what both versions share (the pointers that C hands over, status, log, session), and each version.

mod fmi2;
mod fmi3;
mod foreign;
mod log;
mod session;
mod status;
mod updates;
