//! The same material in another time: every relaxation time is multiplied by one factor.

use softanvil_kernel::Scenario;

/// Shortest and longest relaxation time of the kernel's table, s. A term beyond either end has long relaxed within a
/// step, or does not relax within a test, and so has it at the end itself.
const LEGAL: [f64; 2] = [1e-7, 1e6];

/// `scenario` with the relaxation times of its layers multiplied by `factor`.
pub fn scaled(scenario: &Scenario, factor: f64) -> Scenario {
    let mut scaled = scenario.clone();
    for material in scaled.layers.iter_mut().map(|layer| &mut layer.material) {
        for tau in &mut material.prony_tau {
            *tau = (*tau * factor).clamp(LEGAL[0], LEGAL[1]);
        }
        for beta in &mut material.maxwell_beta {
            *beta = 1.0 / (factor / *beta).clamp(LEGAL[0], LEGAL[1]);
        }
    }
    scaled
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn scaled_scenarios_are_legal_at_both_ends() {
        for factor in [1e-12, 1e-3, 1.0, 1e9] {
            let mut scenario = preset::study();
            scenario.layers[0].material.maxwell_g[0] = 1e5;
            scenario.layers[0].material.maxwell_beta[0] = 3.0;
            scaled(&scenario, factor).validate().unwrap();
        }
    }

    #[test]
    fn both_kinds_of_term_follow_the_same_factor() {
        let mut scenario = preset::study();
        scenario.layers[0].material.maxwell_beta[0] = 2.0;
        let scaled = scaled(&scenario, 0.25);
        assert_eq!(scaled.layers[0].material.prony_tau[1], 0.25 * scenario.layers[0].material.prony_tau[1]);
        assert_eq!(scaled.layers[0].material.maxwell_beta[0], 8.0);
    }
}
