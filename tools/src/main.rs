//! The command line of Softanvil.
fn main() {}
