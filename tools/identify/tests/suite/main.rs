//! Identification against numbers that others published, and against truths that were made up.

mod closed_loop;
mod documentation;
mod drucker;
mod leap;
mod published;
mod recovery;
mod tolerance;
mod treloar;
