//! The verification problems that the table lists, one file each.

mod bar_wave;
mod bonded_strip;
mod checkerboard;
mod contact_convergence;
mod cook;
mod coulomb_block;
mod cylinder;
mod hertz;
mod indentation;
mod interface;
mod lame;
mod patch_distorted;
mod swinging_plate;
mod table;
