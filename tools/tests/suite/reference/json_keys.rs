//! What the keys of JSON results mean.

use serde_json::Value;
use softanvil_kernel::OUTPUTS;

use super::{code, table};

/// Keys that mean the same wherever they stand.
pub(super) const COMMON: &[(&str, &str)] = &[
    ("peak_force", "peak force, N"),
    ("max_deformation", "largest deformation, m"),
    ("impact_duration", "impact duration, s"),
    ("impulse", "impulse of the contact force, N s"),
    ("restitution", "rebound speed over impact speed"),
    ("vibration", "how much the force rises and falls beyond one rise to the peak and one fall from it, over the peak"),
    ("held_force", "mean force over the hold at the end of a press, N; none of a drop"),
    ("energy_friction", "energy dissipated by friction, J"),
    ("energy_viscous", "work done on the viscous overstress, J"),
    ("energy_slider_dissipation", "energy dissipated by the sliders, J"),
    ("elements", "triangles or tetrahedra of the mesh"),
    ("element_size", "edge length that the mesh aims at, m"),
    ("dt", "time step, s"),
    ("ending", "how the simulation ended: `complete`, `held` (a press), `in_contact` or `no_contact`"),
    ("complete", "whether the contact had ended, so that the numbers are those of the whole impact"),
    ("cut", "keys of the numbers that are cut off in contact"),
    ("simulated_time", "simulated time, s"),
    ("trace_hash", "digest of force, reaction and position at every sample"),
    ("warnings", "what makes the numbers doubtful"),
];

/// Further keys, by the end of their path.
const MEANINGS: &[(&str, &str)] = &[
    // The drop.
    ("drop.preset", "preset"),
    ("drop.scenario_file", "scenario file, or null"),
    ("drop.material_file", "material file, or null"),
    ("drop.set", "what `--set` gave"),
    ("drop.impactor.motion", "`drop`, or `prescribed` with its speed and depth"),
    ("drop.impactor.mass", "mass, kg"),
    ("drop.impactor.energy", "kinetic energy at the start, J"),
    ("drop.impactor.speed", "speed at the start, m/s"),
    ("drop.impactor.height", "height of a free fall to that speed, m; null without gravity"),
    ("drop.layer_thickness", "thickness of all layers, m"),
    ("drop.layers[].name", "name of the layer, from the core to the surface"),
    ("drop.layers[].thickness", "thickness, m"),
    ("drop.layers[].density", "density, kg/m3"),
    ("drop.layers[].shear_modulus_at_once", "shear modulus before anything has relaxed, Pa"),
    ("drop.layers[].shear_modulus_in_the_end", "shear modulus of the long-term law, Pa"),
    ("drop.layers[].bulk_modulus", "bulk modulus, Pa"),
    ("drop.layers[].poissons_ratio_at_once", "Poisson's ratio before anything has relaxed"),
    ("drop.layers[].poissons_ratio_in_the_end", "Poisson's ratio of the long-term law"),
    // How a file was read.
    ("trace.file.name", "name of the file"),
    ("trace.file.encoding", "encoding of a text"),
    ("trace.file.sheet", "sheet of a workbook, or null"),
    ("trace.file.separator", "what separates the cells"),
    ("trace.file.notes", "how the table was read"),
    ("trace.time.column", "number of the column of the time, from 1"),
    ("trace.time.title", "its title"),
    ("trace.time.unit", "its unit"),
    ("trace.time.factor", "that unit in s"),
    ("trace.interval", "time between samples, s"),
    ("trace.force.column", "number of the column of the force, from 1"),
    ("trace.force.title", "its title"),
    ("trace.force.unit", "its unit"),
    ("trace.force.factor", "that unit in N"),
    ("trace.sign", "1 where a push is positive, else -1"),
    ("trace.offset.force", "force that was taken off, N"),
    ("trace.offset.samples", "samples before contact whose median that is"),
    ("trace.offset.noise", "standard deviation before contact, N"),
    ("trace.impact.chosen", "which impact of the record was read, from 1"),
    ("trace.impact.impacts[].time", "time of each impact of the record, s"),
    ("trace.impact.impacts[].peak_force", "its peak, N"),
    ("trace.warnings", "what is unlikely about the record"),
    // run
    ("steps", "time steps"),
    ("mesh_quality.smallest", "smallest mean ratio of an element at rest: 1 is regular, 0 is flat"),
    ("mesh_quality.mean", "mean of all mean ratios"),
    ("design_stretch", "smallest principal stretch that the step was chosen for"),
    // measure
    ("force", "which force was read: `contact` or `core`"),
    ("channel_class", "class of the filter on it, Hz, or null"),
    ("threshold", "force from which on the impact lasts, N"),
    ("comparison.threshold", "the same for both, N"),
    ("threshold_asked_for", "threshold that noise left no use of, N, or null"),
    ("alignment.by", "how both were aligned"),
    ("alignment.lag", "shift of the measured trace, s"),
    ("alignment.beyond_flanks", "how far that is from the shift by the rising flanks, s"),
    (
        "numbers.<number>.measured",
        "peak force, duration, impulse and, if there is one, deformation of the measured trace",
    ),
    ("numbers.<number>.simulated", "the same of the simulation"),
    ("numbers.<number>.error_percent", "error of the simulation, %"),
    ("r_squared", "coefficient of determination"),
    ("root_mean_square_difference", "root mean square of the difference, over the measured peak"),
    ("cora.rating", "cross-correlation rating of CORA: mean of the next three"),
    ("cora.phase", "its rating of the shift"),
    ("cora.size", "its rating of the size"),
    ("cora.progression", "its rating of the shape"),
    // validate
    ("preset", "preset"),
    ("formulation", "formulation of the scenario"),
    ("source", "where the measured numbers or the limits come from"),
    ("reading", "how the force was read"),
    ("fitted.parameters", "parameters that were fitted to the table"),
    ("fitted.numbers", "numbers of the table that they were fitted to"),
    ("mean_error_percent", "mean of the absolute errors of all numbers, %; null of traces alone"),
    ("peak_force_mean_error_percent", "the same of the peak forces, %"),
    ("energy", "impact energy, J"),
    ("error_percent.<number>", "error of each of the four numbers, %"),
    ("experiment.<number>", "the number as it was measured"),
    ("ls_dyna.<number>", "the number of the paper's simulation by LS-DYNA"),
    ("ls_dyna_error_percent.<number>", "its error, %"),
    ("energy_residual", "energy that the balance leaves unexplained, J"),
    // reduction
    (
        "effective_length",
        "`geometry.length` of the section that bears what the solid does, m, or null; over the cases: their mean",
    ),
    (
        "largest_difference_percent",
        "largest difference of the force of a section of that mean from that of its solid, %",
    ),
    ("section_difference_percent", "difference of the force of the section from that of the solid, %"),
    ("settings.<parameter>", "the value of each axis"),
    // protect
    ("standard.preset", "preset of the standard's set-up"),
    ("standard.name", "name of the standard"),
    ("standard.quantity", "what is judged"),
    ("standard.limits[].level", "level of performance"),
    ("standard.limits[].below", "the mean of several impacts has to be below this, N or g"),
    ("standard.limits[].single", "no single impact may be above this, N or g, or null"),
    ("standard.assumed", "what of the set-up has no source"),
    ("peak_transmitted_force", "peak of the reaction of the core, N"),
    ("peak_acceleration_g", "peak of the contact force over the mass of the impactor, in g of 9.80665 m/s2"),
    ("impact_energy", "kinetic energy at the first contact, J"),
    ("absorbed_energy", "the part of it that the impactor has not got back, J"),
    ("layers[].name", "name of the layer"),
    ("layers[].pad", "whether it belongs to the pad"),
    ("layers[].max_compression", "largest compression, as a part of its thickness"),
    ("layers[].max_stretch", "largest principal stretch"),
    ("layers[].tear_stretch", "stretch at which it begins to tear, or null"),
    ("layers[].torn", "whether it has begun to tear; null of what does not tear"),
    (
        "verdict.verdict",
        "`pass`, `fail`, or why there is none: `no_limit_known`, `other_test`, `cut_off`, `no_standard`",
    ),
    ("verdict.level", "level of the standard that the verdict is of, or null"),
    ("verdict.changed", "what differs from the standard's test"),
    ("pads[].name", "name of the pad"),
    ("pads[].thickness", "its thickness, m"),
    ("bare", "the anvil without the pad, as `pads[]`; null of a rigid one"),
    // sweep
    ("sweep", "name of the sweep"),
    ("missing", "simulations that were not made"),
    ("contrasts", "the changes that a file asks for first"),
    ("notes", "what there is to know of the table"),
    ("low", "lower end of a 90 % band, in the unit of the number"),
    ("median", "its middle: half of the cases lie below"),
    ("high", "its upper end"),
    ("cases[].<parameter>", "the value of each axis"),
    // calibrate
    ("score", "score of the best values"),
    ("evaluations", "evaluations made"),
    ("convergence.converged", "whether the search has converged"),
    (
        "convergence.patience_per_parameter",
        "evaluations for each parameter after which a descent without improvement ends",
    ),
    ("convergence.improvement", "points of score that are one"),
    ("convergence.alike.points", "points of score within which two descents are alike"),
    ("convergence.alike.part", "the same as a part of the best score"),
    ("descents[].best_score", "best score of each descent"),
    ("descents[].evaluations", "its evaluations"),
    ("descents[].ended", "whether it ended by itself"),
    ("equally_good", "evaluations that score about as well as the best"),
    ("parameters.<name>.value", "best value of what was searched for"),
    ("parameters.<name>.unit", "its unit"),
    ("parameters.<name>.min", "smallest value of its range"),
    ("parameters.<name>.max", "largest value of its range"),
    ("parameters.<name>.bound", "bound of the range that the best value lies on, or null"),
    ("spread.min", "smallest value among those that score about as well; null before convergence"),
    ("spread.median", "their median"),
    ("spread.max", "their largest value"),
    ("spread.part", "from smallest to largest, as a part of the range"),
    ("parameters.<name>.determined", "whether the data determine it: `yes`, `partly`, `no`; null before convergence"),
    ("material_tests[].name", "name of a test of the material"),
    ("material_tests[].layer", "layer that it is of, or null for the one next to the core"),
    ("material_tests[].load", "`compression` or `tension`"),
    ("material_tests[].quantity", "what was read"),
    ("material_tests[].strain", "nominal strain"),
    ("material_tests[].rate", "rate of nominal strain, 1/s, or null for a relaxed test"),
    ("material_tests[].hold", "time of the hold, s"),
    ("material_tests[].measured", "what was measured, Pa"),
    ("material_tests[].standard_deviation", "its standard deviation, Pa"),
    ("material_tests[].model", "the same of the best values, Pa"),
    ("material_tests[].distance", "ln(model / measured) in standard deviations"),
    ("material_tests[].counts", "whether it counts"),
    ("impacts[].<number>.value", "each of the four numbers as simulated"),
    ("impacts[].<number>.measured", "as measured, or null"),
    ("impacts[].<number>.error_percent", "error, %"),
    ("impacts[].<number>.counts", "whether it counts"),
    ("impacts[].curve.r_squared", "coefficient of determination of a trace"),
    // fit
    ("data[].mode", "kind of test"),
    ("data[].files", "its files"),
    ("data[].specimens", "specimens in them"),
    ("data[].stretch", "stretches of the points"),
    ("data[].nominal_stress", "their nominal stresses, Pa"),
    ("data[].notes", "how the files were read"),
    ("volume.known_by", "how the volume of the specimens is known"),
    ("volume.poissons_ratio", "Poisson's ratio by which it changes, or null"),
    ("volume.fitted_as", "`incompressible`, `compressible` or `foam`"),
    ("weighting", "weights of the residuals"),
    ("stability_range", "stretches over which a law has to be stable"),
    ("chosen", "law that was chosen, or null"),
    ("laws[].law", "law, from the best to the worst"),
    ("laws[].parameters.<name>", "coefficient, in its unit"),
    ("laws[].standard_errors.<name>", "its standard error"),
    ("laws[].interval_factor", "standard errors in half of the 95 % interval"),
    ("laws[].correlation", "correlation of the coefficients"),
    ("laws[].condition", "condition of the scaled matrix"),
    ("laws[].points", "points that were fitted"),
    ("laws[].residual_sum", "sum of the squares of the residuals, Pa2"),
    ("laws[].residual_rms", "root mean square of the residuals, Pa"),
    ("laws[].residual_largest", "largest residual, Pa"),
    ("tests[].test", "kind of test"),
    ("tests[].points", "its points"),
    ("tests[].residual_rms", "root mean square of its residuals, Pa"),
    ("tests[].largest_stress", "its largest stress, Pa"),
    ("tests[].residual_rms_relative", "one over the other"),
    ("laws[].aic", "Akaike's information criterion"),
    ("laws[].shear_modulus", "shear modulus at rest, Pa"),
    ("laws[].degenerate", "why the fit degenerates, or null"),
    ("laws[].stable", "whether it is stable over the stretches above"),
    ("laws[].stable_stretches.<name>", "stretches over which it is stable in each mode"),
    ("not_fitted", "laws that were left out, with why"),
    ("caveats", "what to beware of"),
    ("relaxation.load", "what was measured over time"),
    ("relaxation.held_stretch", "stretch that was held, or null"),
    ("relaxation.points", "points that were read"),
    ("relaxation.notes", "how the file was read"),
    ("relaxation.chosen_terms", "number of Prony terms that was chosen"),
    ("relaxation.loading_time", "time of loading, s"),
    ("relaxation.caveats", "what to beware of"),
    ("series[].terms", "number of terms of each series"),
    ("series[].g", "g of each term"),
    ("series[].tau", "relaxation time of each term, s"),
    ("series[].g_inf", "what remains in the end"),
    ("series[].instantaneous", "modulus at once, in the unit of the load"),
    ("series[].equilibrium", "modulus in the end"),
    ("series[].standard_errors", "standard errors of the coefficients"),
    ("series[].residual_sum", "sum of the squares of the residuals"),
    ("series[].residual_rms", "root mean square of the residuals"),
    ("series[].residual_rms_hold", "the same of the hold alone"),
    ("series[].residual_rms_ramp", "the same of the ramp alone, or null"),
    ("series[].doubts", "what the data do not determine"),
    ("series[].aic", "Akaike's information criterion"),
];

/// Names that stand for any: by the path of what holds them.
const ANY: [(&str, &str); 13] = [
    ("channels", "<channel>"),
    ("parameters", "<name>"),
    ("laws[].parameters", "<name>"),
    ("laws[].standard_errors", "<name>"),
    ("laws[].stable_stretches", "<name>"),
    ("comparison.numbers", "<number>"),
    ("cases[].error_percent", "<number>"),
    ("cases[].bands.parameters", "<number>"),
    ("cases[].bands.measured", "<number>"),
    ("cases[].experiment", "<number>"),
    ("cases[].ls_dyna", "<number>"),
    ("cases[].ls_dyna_error_percent", "<number>"),
    ("series[].parameters", "<name>"),
];

/// A table for each command, and before them those of what they share.
pub(super) fn json_table(tables: &[(&str, &str, Value)]) -> String {
    let mut shared = String::new();
    for (title, about, key) in
        [("`drop`", "What was simulated.", "drop"), ("`trace`", "How a measured trace was read.", "trace")]
    {
        let (_, _, value) = tables.iter().find(|(_, _, value)| value.get(key).is_some()).unwrap();
        let keys = of(&value[key], key);
        shared += &format!("### {title}\n{about}\n\n{}", table(&["key", "meaning"], keys.iter().map(|key| row(key))));
    }
    for (title, about, value) in tables {
        let keys = of(value, "").into_iter().filter(|key| !key.contains("drop.") && !key.contains("trace."));
        let mut rows: Vec<Vec<String>> = keys.map(|key| row(&key)).collect();
        for (key, meaning) in [("drop", "see `drop` above"), ("trace", "see `trace` above")] {
            if value.get(key).is_some() {
                rows.insert(0, vec![code(key), meaning.into()]);
            }
        }
        let about = if about.is_empty() { String::new() } else { format!("{about}\n\n") };
        shared += &format!("### {title}\n{about}{}", table(&["key", "meaning"], rows));
    }
    shared
}

fn row(path: &str) -> Vec<String> {
    vec![code(path), meaning(path)]
}

/// What the longest known end of the path means; or the output whose name it is.
fn meaning(path: &str) -> String {
    let ends = |known: &str| path == known || path.ends_with(&format!(".{known}"));
    let known = COMMON.iter().chain(MEANINGS).filter(|(known, _)| ends(known)).max_by_key(|(known, _)| known.len());
    if let Some((_, meaning)) = known {
        return (*meaning).into();
    }
    let key = path.rsplit('.').next().unwrap();
    let output = OUTPUTS
        .iter()
        .find(|output| output.name.strip_prefix("result.") == Some(key) || output.name.replace('.', "_") == key);
    let output = output.unwrap_or_else(|| panic!("no meaning of {path}"));
    let unit = if output.unit == "1" { String::new() } else { format!(", {}", output.unit) };
    format!("{}{unit}", output.description)
}

/// Paths of everything in `value`, each once.
fn of(value: &Value, path: &str) -> Vec<String> {
    let mut paths = Vec::new();
    walk(value, path, &mut paths);
    paths
}

fn walk(value: &Value, path: &str, paths: &mut Vec<String>) {
    match value {
        Value::Object(object) if !object.is_empty() => {
            let any = ANY.iter().find(|(holder, _)| *holder == path).map(|(_, any)| *any);
            for (key, value) in object {
                let numbers = ["value", "measured", "error_percent", "counts"];
                let of_number = path == "impacts[]" && numbers.iter().all(|key| value.get(key).is_some());
                let key = match any {
                    Some(any) => any,
                    None if of_number => "<number>",
                    None if key.contains('[') => "<parameter>",
                    None => key,
                };
                walk(value, &if path.is_empty() { key.into() } else { format!("{path}.{key}") }, paths);
            }
        }
        Value::Array(list) if list.iter().any(Value::is_object) => {
            list.iter().for_each(|value| walk(value, &format!("{path}[]"), paths));
        }
        _ if !paths.iter().any(|known| known == path) => paths.push(path.into()),
        _ => {}
    }
}
