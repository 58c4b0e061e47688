//! What came out, for people.

use std::fmt::Write;

use softanvil_identify::law::fit::{Fit, Weighting};
use softanvil_identify::relaxation::prony::Prony;
use softanvil_identify::relaxation::read::Load;

use super::{Identification, Relaxed, volume};
use crate::text::table::{FIXED_BLANK, align_right, new_plain_table, text as text_of};

/// The whole report.
pub fn of_identification(identification: &Identification) -> String {
    let mut text = String::new();
    for curves in &identification.curves {
        let specimens =
            if curves.n_specimen == 1 { "1 specimen".into() } else { format!("{} specimens", curves.n_specimen) };
        let (n, mode) = (curves.data.points.len(), curves.data.mode.name());
        let _ = writeln!(text, "{mode}: {n} points, {specimens}, {}", curves.files.join(", "));
        curves.notes.iter().for_each(|note| push(&mut text, "  ", note));
    }
    if let Some(fit) = identification.law() {
        push(&mut text, "", &volume::text(identification.volume));
        text += "\n";
        text += &ranking(identification);
        text += "\n";
        text += &coefficients(fit);
        text += "\n";
        text += &misfits(identification, fit);
        identification.caveats.iter().for_each(|caveat| push(&mut text, "! ", caveat));
    }
    if let Some(relaxed) = &identification.relaxed {
        if !text.is_empty() {
            text += "\n";
        }
        text += &relaxation(relaxed);
    }
    text
}

/// A note as a paragraph of its own, 80 characters wide.
fn push(text: &mut String, indent: &str, note: &str) {
    let mut line = indent.to_string();
    for word in note.split(' ') {
        if line.len() + word.len() > 80 {
            let _ = writeln!(text, "{}", line.trim_end());
            line = " ".repeat(indent.len().max(2));
        }
        line += word;
        line += " ";
    }
    let _ = writeln!(text, "{}", line.trim_end());
}

fn ranking(identification: &Identification) -> String {
    let mut table =
        new_plain_table(&["law", "residual rms", "R2", "AIC", "shear modulus", "condition", "stable in all modes"]);
    for (index, fit) in identification.fits.iter().enumerate() {
        let mark = if index == identification.chosen { "> " } else { "  " };
        let statistics = &fit.statistics;
        table.add_row([
            format!("{mark}{}", fit.law.label).replace(' ', &FIXED_BLANK.to_string()),
            format!("{} kPa", digits(statistics.rms * 1e-3)),
            format!("{:.5}", statistics.r_squared),
            format!("{:.1}", statistics.aic),
            format!("{} kPa", digits(fit.shear_modulus() * 1e-3)),
            format!("{:.1e}", statistics.condition),
            fit.degeneracy.map_or_else(|| stable(fit), |_| "degenerate".into()),
        ]);
    }
    align_right(&mut table, 1..6);
    let (low, high) = identification.settings.stability_range;
    let weighting = match identification.settings.weighting {
        Weighting::Absolute => "absolute residuals",
        Weighting::Relative => "relative residuals",
        Weighting::Tests => "residuals in parts of the largest stress of their test, every test alike",
    };
    let mut text = format!("{}\n", text_of(&mut table));
    let _ = writeln!(
        text,
        "Order: lowest residual of each family, then the others; > marks the chosen one.\n\
         Stability is asked from {low:.2} to {high:.2}.\n\
         Fitted by {weighting}."
    );
    identification.failed.iter().for_each(|reason| push(&mut text, "", reason));
    text
}

/// The stretches of stability common to the modes, with a mark if they suffice.
fn stable(fit: &Fit) -> String {
    let (low, high) = fit.stability.0.iter().fold((0.0_f64, f64::MAX), |(l, h), mode| (l.max(mode.0), h.min(mode.1)));
    format!("{} {low:.2} to {high:.2}", if fit.is_stable { "yes," } else { "no, " })
}

fn coefficients(fit: &Fit) -> String {
    let mut table = new_plain_table(&["parameter", "value", "standard error", "95 % interval", "unit"]);
    let factor = fit.statistics.interval();
    for (index, (parameter, value)) in fit.law.parameters.iter().zip(&fit.values).enumerate() {
        let error = fit.statistics.standard_errors[index];
        let (low, high) = (value - factor * error, value + factor * error);
        let interval = if error.is_finite() { format!("{} to {}", digits(low), digits(high)) } else { "none".into() };
        let error = if error.is_finite() { digits(error) } else { "none".into() };
        table.add_row([parameter.name, &digits(*value), &error, &interval, parameter.unit]);
    }
    align_right(&mut table, 1..4);
    format!("{}\n", text_of(&mut table))
}

/// How far the chosen law is from each test, and what that means.
fn misfits(identification: &Identification, fit: &Fit) -> String {
    let mut table = new_plain_table(&["test", "points", "residual rms", "of the largest stress"]);
    for (part, misfit) in identification.misfits(fit) {
        let points = part.places.len().to_string();
        let relative = format!("{:.1}{FIXED_BLANK}%", 100.0 * misfit.relative());
        let rms = format!("{}{FIXED_BLANK}kPa", digits(misfit.rms * 1e-3));
        table.add_row([part.name.replace(' ', &FIXED_BLANK.to_string()), points, rms, relative]);
    }
    align_right(&mut table, 1..4);
    let mut text = format!("{}\n", text_of(&mut table));
    if fit.law.is_compressible() {
        let meaning = "Every modulus is positive, which is more than Drucker's condition needs: the law is stable at all stretches. \
                       The residual is what no law of these terms has: cells that buckle in compression and straighten in tension \
                       stiffen differently, and it is no scatter of the test.";
        push(&mut text, "", meaning);
    }
    text
}

fn relaxation(relaxed: &Relaxed) -> String {
    let mut text = format!("relaxation: {} points\n", relaxed.test.relaxation.times.len());
    relaxed.test.notes.iter().for_each(|note| push(&mut text, "  ", note));
    text += "\n";
    let unit = match relaxed.test.load {
        Load::Force => " N",
        Load::Normalised => "",
        Load::Stress | Load::Modulus => " Pa",
    };
    let header = ["terms", "hold rms", "ramp rms", "R2", "AIC", "g at tau (s)", "g_inf"];
    let mut table = new_plain_table(&header);
    for (index, prony) in relaxed.choice.series.iter().enumerate() {
        let mark = if index == relaxed.choice.chosen { "> " } else { "  " };
        let (ramp, hold) = prony.residuals(&relaxed.test.relaxation);
        let terms = prony
            .normalised()
            .iter()
            .map(|(g, tau)| format!("{g:.4} at {tau:.3e}").replace(' ', &FIXED_BLANK.to_string()))
            .collect::<Vec<_>>();
        table.add_row([
            format!("{mark}{}", prony.terms.len()),
            format!("{}{unit}", digits(hold)),
            ramp.map_or("-".into(), |ramp| format!("{}{unit}", digits(ramp))),
            format!("{:.5}", prony.statistics.r_squared),
            format!("{:.1}", prony.statistics.aic),
            terms.join("\n"),
            format!("{:.4}", 1.0 - prony.normalised().iter().map(|term| term.0).sum::<f64>()),
        ]);
    }
    align_right(&mut table, 1..5);
    let _ = writeln!(text, "{}", text_of(&mut table));
    text += &moduli(relaxed, relaxed.choice.prony());
    relaxed.choice.caveats.iter().for_each(|caveat| push(&mut text, "! ", caveat));
    for prony in relaxed.choice.series.iter().filter(|prony| !prony.doubts.is_empty()) {
        push(&mut text, "! ", &format!("{} terms: {}", prony.terms.len(), prony.doubts.join("; ")));
    }
    text
}

/// Instantaneous and equilibrium load, and what moduli they are.
fn moduli(relaxed: &Relaxed, prony: &Prony) -> String {
    let (whole, rest) = (prony.instantaneous(), prony.equilibrium);
    let mut text = match relaxed.test.load {
        Load::Normalised => format!("load {} instantaneous, {} in equilibrium", digits(whole), digits(rest)),
        Load::Force => format!("force {} N instantaneous, {} N in equilibrium", digits(whole), digits(rest)),
        Load::Stress => {
            format!("stress {} kPa instantaneous, {} kPa in equilibrium", digits(whole * 1e-3), digits(rest * 1e-3))
        }
        Load::Modulus => {
            format!("modulus {} kPa instantaneous, {} kPa in equilibrium", digits(whole * 1e-3), digits(rest * 1e-3))
        }
    };
    if let (Load::Stress, Some(stretch)) = (relaxed.test.load, relaxed.test.stretch) {
        let strain = (stretch - 1.0).abs();
        let (whole, rest) = (digits(whole / strain * 1e-3), digits(rest / strain * 1e-3));
        let _ = write!(text, "; secant moduli {whole} and {rest} kPa at {:.1} % strain", 100.0 * strain);
    }
    text + "\n"
}

/// Five significant digits.
fn digits(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if !(1e-2..1e6).contains(&magnitude) {
        return format!("{value:.4e}");
    }
    let power = magnitude.log10().floor() as i32;
    format!("{value:.*}", usize::try_from(4 - power).unwrap_or_default())
}
