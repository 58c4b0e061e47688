//! Random plausible drops, one after the other on an anvil, on a stack and on a pad of foam alone, each with the step that the kernel chooses for it: how many are refused, what the energy leaves
//! unexplained, and how many steps were too many.
//!
//!     cargo run --release -p softanvil-verification --bin plausible-drops -- [COUNT [SEED]]

use std::process::ExitCode;

use softanvil_verification::deformation::Samples;
use softanvil_verification::plausible::{foam, outcome, scenario, stack, summary};
use softanvil_verification::tolerance::{LAYER_PENETRATION, PLAUSIBLE_RESIDUAL, STEPS_OVER_HINDSIGHT};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>());
    let (Ok(count), Ok(seed)) = (arguments.next().unwrap_or(Ok(300)), arguments.next().unwrap_or(Ok(1))) else {
        eprintln!("COUNT and SEED are whole numbers above 0");
        return ExitCode::FAILURE;
    };
    let mut samples = Samples::new(seed.max(1));
    let (mut refused, mut worst, mut deepest, mut ratios) = (0, 0.0_f64, 0.0_f64, Vec::new());
    for index in 0..count {
        let scenario = match index % 3 {
            0 => scenario(&mut samples),
            1 => stack(&mut samples),
            _ => foam(&mut samples),
        };
        match outcome(&scenario) {
            Ok(outcome) => {
                if outcome.residual > worst || outcome.penetration > deepest {
                    let (residual, depth) = (outcome.residual, outcome.penetration);
                    println!("{index}: residual {residual:.1e}, penetration {depth:.1e} ({})", summary(&scenario));
                }
                worst = worst.max(outcome.residual);
                deepest = deepest.max(outcome.penetration);
                ratios.push(outcome.steps_over_hindsight);
            }
            Err(error) => {
                refused += 1;
                println!("{index}: {error} ({})", summary(&scenario));
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN);
    println!(
        "{refused} of {count} refused; largest residual {worst:.1e} of the energy; deepest penetration {deepest:.1e} of a cell; \
         median of steps over hindsight {median:.2}"
    );
    if refused == 0 && worst < PLAUSIBLE_RESIDUAL && deepest < LAYER_PENETRATION && median <= STEPS_OVER_HINDSIGHT {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
