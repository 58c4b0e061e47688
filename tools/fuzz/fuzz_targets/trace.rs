#![no_main]

#[path = "../../tests/fuzz/mod.rs"]
#[allow(dead_code, reason = "each program is one target of the module")]
mod fuzz;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzz::trace(data));
