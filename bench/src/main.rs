//! The study's drop for instruments outside of the program: `softanvil-bench drop INSTRUCTION_SET SAMPLES`.

fn main() {}
