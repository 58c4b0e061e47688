//! What came out, for other programs: SI units.

use serde_json::{Map, Value, json};
use softanvil_identify::law::MODES;
use softanvil_identify::law::fit::{Fit, Weighting};
use softanvil_identify::law::parts::{Misfit, Part};
use softanvil_identify::law::volume::Volume;
use softanvil_identify::relaxation::prony::Prony;
use softanvil_identify::relaxation::read::Load;

use super::{Identification, Relaxed};

/// The whole report.
pub fn of_identification(identification: &Identification) -> Value {
    let data = identification.curves.iter().map(|curves| {
        json!({
            "mode": curves.data.mode.name(),
            "files": curves.files,
            "specimens": curves.n_specimen,
            curves.data.mode.measured(): curves.data.points.iter().map(|point| point.0).collect::<Vec<_>>(),
            "nominal_stress": curves.data.points.iter().map(|point| point.1).collect::<Vec<_>>(),
            "notes": curves.notes,
        })
    });
    let (low, high) = identification.settings.stability_range;
    json!({
        "data": data.collect::<Vec<_>>(),
        "volume": {
            "known_by": match identification.volume {
                Volume::Assumed => "assumption",
                Volume::Stated(_) => "statement",
                Volume::OfLaw(_) => "law",
                Volume::Measured { .. } => "measurement",
            },
            "poissons_ratio": identification.volume.poissons_ratio(),
            "fitted_as": match identification.volume {
                Volume::OfLaw(_) => "foam",
                volume if volume.compressible().is_some() => "compressible",
                _ => "incompressible",
            },
        },
        "weighting": match identification.settings.weighting {
            Weighting::Absolute => "absolute",
            Weighting::Relative => "relative",
            Weighting::Tests => "tests",
        },
        "stability_range": [low, high],
        "chosen": identification.law().map(|fit| fit.law.name),
        "laws": identification.fits.iter().map(|fit| of_fit(identification, fit)).collect::<Vec<_>>(),
        "not_fitted": identification.failed,
        "caveats": identification.caveats,
        "relaxation": identification.relaxed.as_ref().map(of_relaxed),
    })
}

fn of_fit(identification: &Identification, fit: &Fit) -> Value {
    let statistics = &fit.statistics;
    let named = |values: &[f64]| -> Map<String, Value> {
        fit.law
            .parameters
            .iter()
            .zip(values)
            .map(|(parameter, value)| (parameter.name.into(), (*value).into()))
            .collect()
    };
    let correlation = statistics.correlation.row_iter().map(|row| row.iter().copied().collect::<Vec<f64>>());
    let stable: Map<String, Value> =
        MODES.iter().zip(fit.stability.0).map(|(mode, (low, high))| (mode.name().into(), json!([low, high]))).collect();
    json!({
        "law": fit.law.name,
        "parameters": named(&fit.values),
        "standard_errors": named(&statistics.standard_errors),
        "interval_factor": statistics.interval(),
        "correlation": correlation.collect::<Vec<_>>(),
        "condition": statistics.condition,
        "points": statistics.n_point,
        "residual_sum": statistics.residual_sum,
        "residual_rms": statistics.rms,
        "residual_largest": statistics.largest,
        "tests": identification.misfits(fit).into_iter().map(of_misfit).collect::<Vec<_>>(),
        "r_squared": statistics.r_squared,
        "aic": statistics.aic,
        "shear_modulus": fit.shear_modulus(),
        "degenerate": fit.degeneracy.map(|degeneracy| degeneracy.to_string()),
        "stable": fit.is_stable,
        "stable_stretches": stable,
    })
}

fn of_misfit((part, misfit): (Part, Misfit)) -> Value {
    json!({
        "test": part.name,
        "points": part.places.len(),
        "residual_rms": misfit.rms,
        "largest_stress": misfit.largest,
        "residual_rms_relative": misfit.relative(),
    })
}

fn of_relaxed(relaxed: &Relaxed) -> Value {
    json!({
        "load": match relaxed.test.load {
            Load::Stress => "nominal_stress",
            Load::Modulus => "modulus",
            Load::Force => "force",
            Load::Normalised => "normalised",
        },
        "held_stretch": relaxed.test.stretch,
        "points": relaxed.test.relaxation.times.len(),
        "notes": relaxed.test.notes,
        "chosen_terms": relaxed.choice.prony().terms.len(),
        "loading_time": relaxed.test.relaxation.loaded,
        "caveats": relaxed.choice.caveats,
        "series": relaxed.choice.series.iter().map(|prony| of_prony(prony, relaxed)).collect::<Vec<_>>(),
    })
}

fn of_prony(prony: &Prony, relaxed: &Relaxed) -> Value {
    let (ramp, hold) = prony.residuals(&relaxed.test.relaxation);
    let normalised = prony.normalised();
    json!({
        "terms": normalised.len(),
        "g": normalised.iter().map(|term| term.0).collect::<Vec<_>>(),
        "tau": normalised.iter().map(|term| term.1).collect::<Vec<_>>(),
        "g_inf": 1.0 - normalised.iter().map(|term| term.0).sum::<f64>(),
        "instantaneous": prony.instantaneous(),
        "equilibrium": prony.equilibrium,
        "standard_errors": prony.statistics.standard_errors,
        "residual_sum": prony.statistics.residual_sum,
        "residual_rms": prony.statistics.rms,
        "residual_rms_hold": hold,
        "residual_rms_ramp": ramp,
        "r_squared": prony.statistics.r_squared,
        "aic": prony.statistics.aic,
        "doubts": prony.doubts,
    })
}
