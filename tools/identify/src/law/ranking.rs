//! Which law: the lowest residual within each family, then across, as in the study; and what to think of before
//! believing it.

use softanvil_kernel::material::ElasticLaw;

use super::fit::{Fit, Settings};
use super::interval::Interval;
use super::{DataSet, Mode, profile};

/// Fits in the order of the study: the best of each family by residual, then the others by residual. Laws that no simulation
/// can use, because their shear modulus at rest is not positive or their coefficients degenerate, come last.
pub fn rank(mut fits: Vec<Fit>) -> Vec<Fit> {
    let order = |fit: &Fit| (!fit.is_usable(), fit.statistics.residual_sum);
    fits.sort_by(|a, b| {
        let (a, b) = (order(a), order(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let mut families: Vec<ElasticLaw> = Vec::new();
    let (mut winners, mut others) = (Vec::new(), Vec::new());
    for fit in fits {
        if families.contains(&fit.law.family) {
            others.push(fit);
        } else {
            families.push(fit.law.family);
            winners.push(fit);
        }
    }
    winners.append(&mut others);
    winners
}

/// Index of the law to use, unless the user says otherwise: of lowest residual among those that are stable over the stretches
/// asked for, in whatever family, or the first of all if none is. One that degenerates is not chosen. Of foams it is that
/// of fewest terms whose AIC is as low as any but for `AIC_ALIKE`: a further term never fits worse.
pub fn choose(ranked: &[Fit]) -> usize {
    let stable = ranked.iter().enumerate().filter(|(_, fit)| fit.is_stable && fit.is_usable());
    let lowest = stable.clone().map(|(_, fit)| fit.statistics.aic).fold(f64::INFINITY, f64::min);
    let measure = |fit: &Fit| match fit.law.is_compressible() {
        true if fit.statistics.aic <= lowest + AIC_ALIKE => fit.values.len() as f64,
        true => f64::INFINITY,
        false => fit.statistics.residual_sum,
    };
    stable.min_by(|a, b| measure(a.1).total_cmp(&measure(b.1))).map_or(0, |(index, _)| index)
}

/// Difference of Akaike's criterion below which two laws describe the data as well (Burnham and Anderson, Model Selection and
/// Multimodel Inference, 2002).
const AIC_ALIKE: f64 = 2.0;

/// Correlation of two parameters above which their values mean little apart.
const CORRELATED: f64 = 0.99;
/// Condition of the scaled problem above which a small error of the data is a large one of the coefficients.
const ILL_CONDITIONED: f64 = 1e3;
/// Parts of the way between the bounds of a shape where it is not held by them.
const WITHIN: std::ops::RangeInclusive<f64> = 0.025..=0.975;
/// Points a parameter should have, at least.
const POINTS_PER_PARAMETER: usize = 5;

/// What a user of `chosen` should know, most important first.
pub fn caveats(chosen: &Fit, all: &[Fit], data: &[DataSet], settings: &Settings) -> Vec<String> {
    let mut caveats = Vec::new();
    let label = chosen.law.label;
    if chosen.shear_modulus() <= 0.0 {
        caveats.push(format!(
            "{label} has the shear modulus {:.4} MPa at rest; the simulation refuses it",
            chosen.shear_modulus() * 1e-6
        ));
    }
    if !chosen.is_stable {
        caveats.push(format!(
            "{label} is unstable {}: --stable demands a stable law",
            unstable(chosen, settings.stability_range)
        ));
    }
    if let Some(degeneracy) = chosen.degeneracy {
        caveats.push(format!("the coefficients of {label} are not to be used: {degeneracy}"));
    }
    caveats.extend(coverage(data));
    caveats.extend(determination(chosen));
    caveats.extend(intervals(chosen, data, settings));
    caveats.extend(alternatives(chosen, all));
    caveats
}

/// Where within `range` the law is unstable.
fn unstable(fit: &Fit, range: (f64, f64)) -> String {
    let mut places = Vec::new();
    for (mode, stable) in super::MODES.iter().zip(&fit.stability.0) {
        if stable.0 > range.0 {
            places.push(format!("in {} compression below stretch {:.2}", mode.name(), stable.0));
        }
        if stable.1 < range.1 {
            places.push(format!("in {} tension above stretch {:.2}", mode.name(), stable.1));
        }
    }
    places.join(", ")
}

fn coverage(data: &[DataSet]) -> Vec<String> {
    let mut caveats = Vec::new();
    let ranges = data.iter().map(DataSet::stretches);
    let (low, high) = ranges.fold((f64::MAX, f64::MIN), |(low, high), (l, h)| (low.min(l), high.max(h)));
    let modes: Vec<Mode> = data.iter().map(|set| set.mode).collect();
    if modes.iter().all(|mode| *mode == Mode::Uniaxial) {
        let reach = if low < 0.95 && high > 1.05 { "tension and compression" } else { "one way" };
        caveats.push(format!(
            "only uniaxial data, {reach}: terms of I1 and I2 are hardly told apart, and other states of strain are a guess"
        ));
    }
    // Equibiaxial tension is uniaxial compression, l_c = l^-2.
    let compressed = data.iter().any(|set| set.points.iter().any(|p| p.0 < 0.95 || set.mode == Mode::Equibiaxial));
    if !compressed {
        caveats.push("no compression in the data, which a drop test is: compression is extrapolated".into());
    }
    caveats.push(format!("outside the stretches of the data, {low:.2} to {high:.2}, every law is a guess"));
    caveats
}

fn determination(fit: &Fit) -> Vec<String> {
    let (statistics, law) = (&fit.statistics, fit.law);
    let (n, k) = (statistics.n_point, statistics.n_parameter);
    let mut caveats = Vec::new();
    if n < POINTS_PER_PARAMETER * k {
        caveats.push(format!("{n} points for {k} parameters of {} are few", law.label));
    }
    if statistics.condition > ILL_CONDITIONED {
        caveats.push(format!("the data determine the coefficients badly: condition {:.1e}", statistics.condition));
    }
    let pairs = (0..law.parameters.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
    let mut correlated: Vec<_> =
        pairs.map(|(j, i)| (statistics.correlation[(i, j)], j, i)).filter(|pair| pair.0.abs() > CORRELATED).collect();
    correlated.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    if let Some(&(correlation, j, i)) = correlated.first() {
        let (a, b) = (law.parameters[j].name, law.parameters[i].name);
        let others = match correlated.len() - 1 {
            0 => String::new(),
            1 => ", nor another pair".into(),
            n => format!(", nor {n} other pairs"),
        };
        caveats.push(format!("{a} and {b} cannot be told apart (correlation {correlation:.4}){others}"));
    }
    for (place, (parameter, value)) in law.parameters.iter().zip(&fit.values).enumerate() {
        let known = statistics.standard_errors[place] == 0.0;
        if !parameter.is_modulus() && !known && !WITHIN.contains(&Interval::of(parameter).part(*value)) {
            caveats.push(format!("{} is at its bound: {value:.4}", parameter.name));
        }
    }
    caveats
}

/// Of which parameters the straight-line intervals are wrong.
fn intervals(fit: &Fit, data: &[DataSet], settings: &Settings) -> Option<String> {
    // Bounds that hold the fit back make no straight lines either.
    if settings.demand_stability {
        return None;
    }
    let ends = profile::ends(fit, data, settings);
    let wrong: Vec<_> = ends.iter().filter(|end| !end.is_believed()).collect();
    let worst = wrong.iter().max_by(|a, b| a.distance().total_cmp(&b.distance()))?;
    let mut names: Vec<&str> = wrong.iter().map(|end| fit.law.parameters[end.parameter].name).collect();
    names.dedup();
    Some(format!(
        "the intervals of {} are not to be believed: at an end of that of {} the residual sum rises {} what it should; the curve \
         is determined better than its parameters",
        names.join(", "),
        fit.law.parameters[worst.parameter].name,
        if worst.ratio.is_finite() { format!("by {:.2} times", worst.ratio) } else { "beyond".into() }
    ))
}

fn alternatives(chosen: &Fit, all: &[Fit]) -> Vec<String> {
    let others = all.iter().filter(|fit| fit.law != chosen.law);
    let not_chosen = |fit: &Fit| Some(format!("{} is not chosen: {}", fit.law.label, fit.degeneracy?));
    let mut caveats: Vec<String> = others.filter_map(not_chosen).collect();
    let better = all.iter().filter(|fit| fit.is_usable()).min_by(|a, b| a.statistics.aic.total_cmp(&b.statistics.aic));
    if let Some(better) = better.filter(|better| better.statistics.aic < chosen.statistics.aic - AIC_ALIKE) {
        caveats.push(format!(
            "{} has the lower AIC ({:.1} against {:.1}): the parameters that it saves are worth more than the residual",
            better.law.label, better.statistics.aic, chosen.statistics.aic
        ));
    }
    if let Some(first) = all.first().filter(|first| first.law != chosen.law) {
        let ratio = (chosen.statistics.residual_sum / first.statistics.residual_sum).sqrt();
        let why = if first.is_stable { "" } else { " and is unstable" };
        caveats.push(format!(
            "{} has the lowest residual{why}; the root of the residual sum of {} is {ratio:.2} times that",
            first.law.label, chosen.law.label
        ));
    }
    if !chosen.is_stable
        && let Some(stable) = all.get(choose(all)).filter(|fit| fit.is_stable && fit.is_usable())
    {
        let ratio = (stable.statistics.residual_sum / chosen.statistics.residual_sum).sqrt();
        caveats.push(format!("{} is stable, with {ratio:.2} times the root of the residual sum", stable.law.label));
    }
    caveats
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::LAWS;

    /// A tension curve that stiffens late: the best of each family but neo-Hooke may be unstable in compression.
    #[test]
    fn the_chosen_law_is_the_nearest_of_all_stable_ones() {
        let stress = |l: f64| 0.1e6 * (l - 1.0) + 0.04e6 * (l - 1.0).powi(2) - 3e3 * (l - 1.0).powi(3);
        let points = (1..60).map(|k| 1.0 + 0.1 * f64::from(k)).map(|l| (l, stress(l))).collect();
        let data = [DataSet { mode: Mode::Uniaxial, points }];
        let settings = Settings::plain((0.5, 7.0));
        let ranked = rank(LAWS.iter().filter_map(|law| Fit::new(law, &data, &settings)).collect());
        let chosen = &ranked[choose(&ranked)];
        let nearer = |fit: &&Fit| fit.is_stable && fit.statistics.residual_sum < chosen.statistics.residual_sum;
        assert!(chosen.is_stable && !ranked.iter().any(|fit| nearer(&fit)), "{}", chosen.law.name);
        assert!(!ranked[0].is_stable, "{}", ranked[0].law.name);
    }

    /// The derivative of one term by its exponent is the limit of two terms that cancel, and of no others: two terms fit it the
    /// better the nearer their exponents and the larger their moduli.
    #[test]
    fn a_law_whose_terms_cancel_is_not_chosen() {
        let derivative = |l: f64| 2e4 * (l.powf(1.0) + 0.5 * l.powf(-2.0)) * l.ln();
        let points = (1..40).map(|k| 1.0 + 0.05 * f64::from(k)).map(|l| (l, derivative(l))).collect();
        let data = [DataSet { mode: Mode::Uniaxial, points }];
        let settings = Settings::plain((0.9, 3.0));
        let ranked = rank(LAWS.iter().filter_map(|law| Fit::new(law, &data, &settings)).collect());
        let fit = |name: &str| ranked.iter().find(|fit| fit.law.name == name).unwrap();
        let (two, chosen) = (fit("ogden_2"), &ranked[choose(&ranked)]);
        assert!(two.values[0] * two.values[2] < -1e12 && two.degeneracy.is_some(), "{:?}", two.values);
        assert!(two.statistics.residual_sum < chosen.statistics.residual_sum, "{:?}", chosen.law);
        assert!(chosen.degeneracy.is_none() && fit("yeoh_3").degeneracy.is_none());
        let caveats = caveats(chosen, &ranked, &data, &settings).join("\n");
        assert!(caveats.contains("Ogden 2 is not chosen: "), "{caveats}");
    }
}
