//! A long record: `SOFTANVIL_MEGABYTES=200 cargo test --release -p softanvil-records --test suite large -- --nocapture`.

use std::fmt::Write;

use softanvil_records::trace::{self, Options};

use crate::common::{EXPECTED, half_sine};

#[test]
fn a_long_record_is_read_whole() {
    let megabytes = std::env::var("SOFTANVIL_MEGABYTES").ok().and_then(|text| text.parse().ok()).unwrap_or(2_usize);
    let mut text = String::from("time [s],force [N]\n");
    let mut count = 0;
    while text.len() < 1_000_000 * megabytes {
        let time = 1e-6 * count as f64;
        let _ = writeln!(text, "{time:.6},{:.3}", half_sine(time - 3e-3));
        count += 1;
    }
    let start = std::time::Instant::now();
    let trace = trace::read("x", text.as_bytes(), &Options::default(), Some(&EXPECTED)).unwrap();
    println!("{megabytes} MB, {count} samples: {:.2} s", start.elapsed().as_secs_f64());
    assert_eq!(trace.times.len(), count);
    assert!((trace.forces.iter().copied().fold(0.0, f64::max) - 4e3).abs() < 1e-3);
}
