//! The solid: its element, its limit of the step, what it has in common with the section, and problems with a known answer.

mod block;
mod checkerboard;
mod cook;
mod edge;
mod element;
mod interfaces;
mod lame;
mod limits;
mod press;
mod reduction;
mod section;
mod state;
mod swing;
