//! Drucker-stable stretches against those that felupe's energies give by automatic differentiation.

use std::path::Path;

use softanvil_identify::law::stability::{STEP, Stability};
use softanvil_identify::law::{Law, MODES};
use softanvil_kernel::material::Elastic;

/// Source: tests/identify/stability.csv, written by tests/identify/stability.py with felupe.
#[test]
fn stable_stretches_are_those_of_another_program() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/identify/stability.csv");
    let text = std::fs::read_to_string(file).unwrap();
    let mut limited = 0;
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let law = Law::find(cells[0]).unwrap();
        let si = |(index, cell): (usize, &str)| {
            cell.parse::<f64>().unwrap() * if law.parameters[index].is_modulus() { 1e6 } else { 1.0 }
        };
        let values: Vec<f64> = cells[1].split(' ').enumerate().map(si).collect();
        let mode = MODES.iter().position(|mode| mode.name() == cells[2]).unwrap();
        let expected: [f64; 2] = [cells[3].parse().unwrap(), cells[4].parse().unwrap()];
        let found = Stability::new(&Elastic::new(&law.material(&values))).0[mode];
        // A range ends at the last stretch of the scan that is stable.
        assert!(found.0 >= expected[0] - 1e-6 && found.0 < expected[0] + 1.1 * STEP, "{line}: {found:?}");
        assert!(found.1 <= expected[1] + 1e-6 && found.1 > expected[1] - 1.1 * STEP, "{line}: {found:?}");
        limited += usize::from(expected[0] > 0.1) + usize::from(expected[1] < 10.0);
    }
    // Not only laws that are stable everywhere.
    assert!(limited > 20, "{limited}");
}
