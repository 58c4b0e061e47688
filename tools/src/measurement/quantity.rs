//! The four numbers of a drop test that the paper's table compares.

use softanvil_kernel::Output;

use crate::run::Run;

/// One of the four numbers.
#[derive(Debug)]
pub struct Quantity {
    /// Name in machine-readable results, where the value is in SI.
    pub key: &'static str,
    /// Name of the kernel's output.
    pub output: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Unit for people.
    pub display_unit: &'static str,
    /// Display units in one SI unit.
    pub display_scale: f64,
    /// Digits after the point of a simulated value, in the display unit.
    pub decimals: usize,
}

impl Quantity {
    /// SI unit.
    pub fn unit(&self) -> &'static str {
        Output::find(self.output).map_or("1", |output| output.unit)
    }
}

/// How many quantities there are.
pub const COUNT: usize = 4;

/// The four numbers, in the order of the paper's table.
pub static QUANTITIES: [Quantity; COUNT] = [
    Quantity {
        key: "peak_force",
        output: "result.peak_force",
        label: "peak force",
        display_unit: "N",
        display_scale: 1.0,
        decimals: 0,
    },
    Quantity {
        key: "max_deformation",
        output: "result.max_deformation",
        label: "max deformation",
        display_unit: "mm",
        display_scale: 1e3,
        decimals: 2,
    },
    Quantity {
        key: "impact_duration",
        output: "result.impact_duration",
        label: "impact duration",
        display_unit: "ms",
        display_scale: 1e3,
        decimals: 2,
    },
    Quantity {
        key: "impulse",
        output: "result.impulse",
        label: "impulse",
        display_unit: "N s",
        display_scale: 1.0,
        decimals: 2,
    },
];

/// Index of the peak force in [`QUANTITIES`].
pub const PEAK_FORCE: usize = 0;
/// Index of the largest deformation in [`QUANTITIES`].
pub const MAX_DEFORMATION: usize = 1;

/// The four numbers of a run, in SI and in the order of [`QUANTITIES`].
pub fn measure(run: &Run) -> [f64; COUNT] {
    std::array::from_fn(|i| Output::find(QUANTITIES[i].output).map_or(f64::NAN, |output| run.result(output)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_is_an_output_of_the_kernel_under_its_key() {
        for quantity in &QUANTITIES {
            let output = Output::find(quantity.output).unwrap();
            assert_eq!(output.name.split('.').next_back(), Some(quantity.key));
        }
        assert_eq!(QUANTITIES[PEAK_FORCE].key, "peak_force");
        assert_eq!(QUANTITIES[MAX_DEFORMATION].key, "max_deformation");
    }
}
