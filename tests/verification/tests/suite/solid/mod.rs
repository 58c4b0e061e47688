//! The solid: its element, its limit of the step, and what it has in common with the section.

mod edge;
mod element;
mod limits;
mod press;
mod reduction;
mod section;
mod state;
