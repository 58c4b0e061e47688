//! What is known of the volume of the specimens, and where data and laws do not belong together.

use softanvil_identify::law::Mode;
use softanvil_identify::law::volume::{NEARLY_INCOMPRESSIBLE, Volume, collapse, porous};
use softanvil_kernel::Parameter;

use super::files::Curves;
use crate::failure::Failure;

/// Difference of Poisson's ratios that are not the same.
const DIFFERENT: f64 = 0.05;

/// Of a foam, whose law says what its volume does: Poisson's ratio of every term, where it is stated or measured, or where the
/// data tell nothing of it, as one kind of test does not; and what a reader should know of that.
///
/// # Errors
/// A ratio that the kernel does not take.
pub fn of_foam(curves: &[Curves], stated: Option<f64>) -> Result<(Volume, Vec<String>), Failure> {
    let measured = measured(curves).and_then(Volume::poissons_ratio);
    let alike = curves.iter().all(|curves| curves.data.mode == Mode::Uniaxial);
    let (ratio, caveats) = match (stated, measured) {
        (Some(ratio), _) => (Some(ratio), Vec::new()),
        (None, Some(ratio)) => (Some(ratio), Vec::new()),
        (None, None) if alike => {
            let text = "uniaxial tests alone do not tell Poisson's ratio: it is taken as 0, as of a foam whose cells buckle; \
                        --simple-shear, a column of lateral strains or --poissons-ratio says more";
            (Some(0.0), vec![text.to_string()])
        }
        (None, None) => (None, Vec::new()),
    };
    let parameter = Parameter::find("layers[0].foam_nu_1");
    if let Some((ratio, parameter)) = ratio.zip(parameter) {
        let source = if stated.is_some() { "--poissons-ratio" } else { "the lateral strains" };
        parameter.check(ratio).map_err(|error| Failure::Input(format!("{source}: {error}")))?;
    }
    Ok((Volume::OfLaw(ratio), caveats))
}

/// What the user states, or else what the files say of their uniaxial tests.
///
/// # Errors
/// A ratio that the kernel does not take, or a planar test of a compressible specimen.
pub fn of(curves: &[Curves], stated: Option<f64>) -> Result<Volume, Failure> {
    let volume = stated.map(Volume::Stated).or_else(|| measured(curves)).unwrap_or(Volume::Assumed);
    if let (Some(ratio), Some(parameter)) = (volume.poissons_ratio(), Parameter::find("layers[0].poissons_ratio")) {
        let source = if stated.is_some() { "--poissons-ratio" } else { "the lateral strains" };
        parameter.check(ratio).map_err(|error| Failure::Input(format!("{source}: {error}")))?;
    }
    if volume.compressible().is_some() && curves.iter().any(|curves| curves.data.mode == Mode::Planar) {
        return Err(Failure::Input(format!(
            "--planar is refused: one direction is held, so that no law of constant volume has the isochoric part of the test; \
             legal with a Poisson's ratio below {NEARLY_INCOMPRESSIBLE} is --uniaxial and --equibiaxial"
        )));
    }
    Ok(volume)
}

fn measured(curves: &[Curves]) -> Option<Volume> {
    let uniaxial = curves.iter().filter(|curves| curves.data.mode == Mode::Uniaxial);
    Volume::measured(&uniaxial.flat_map(|curves| curves.volumes.iter().copied()).collect::<Vec<_>>())
}

/// What was assumed or found, in a line.
pub fn text(volume: Volume) -> String {
    let fitted = match volume.compressible() {
        Some(_) => {
            "the laws are fitted to the isochoric part of the curves, of which stretches and residuals below are"
        }
        None => "the laws are fitted as to a constant volume",
    };
    match volume {
        Volume::Assumed => {
            "volume: nothing tells it (lateral strain, volume change, --poissons-ratio), so it is taken as \
                            constant, as that of a solid rubber"
                .into()
        }
        Volume::OfLaw(None) => "volume: the law's, with the free sides of every state without stress".into(),
        Volume::OfLaw(Some(ratio)) => format!(
            "volume: the law's, with the free sides of every state without stress and Poisson's ratio {ratio:.3} of every term, as \
             stated, measured or taken"
        ),
        Volume::Stated(ratio) => format!("volume: Poisson's ratio {ratio} as stated; {fitted}"),
        Volume::Measured { poissons_ratio, range } => format!(
            "volume: Poisson's ratio {poissons_ratio:.3} from the files ({:.3} to {:.3} over their states, of logarithmic \
             strains); {fitted}",
            range.0, range.1
        ),
    }
}

/// Where data and laws do not belong together.
pub fn caveats(curves: &[Curves], volume: Volume) -> Vec<String> {
    let mut caveats = Vec::new();
    if let (Volume::Stated(stated), Some(Volume::Measured { poissons_ratio, .. })) = (volume, measured(curves))
        && (stated - poissons_ratio).abs() > DIFFERENT
    {
        caveats.push(format!("the files say Poisson's ratio {poissons_ratio:.3}, not {stated} as stated"));
    }
    if let Volume::Measured { poissons_ratio, range } = volume
        && range.1 - range.0 > 2.0 * DIFFERENT
    {
        caveats.push(format!(
            "Poisson's ratio is not one number: {:.3} to {:.3} over the states, taken as {poissons_ratio:.3}",
            range.0, range.1
        ));
    }
    if volume.compressible().is_none() && !matches!(volume, Volume::OfLaw(_)) {
        caveats.extend(curves.iter().filter_map(foam));
    }
    caveats
}

/// That a specimen of these curves can hardly have kept its volume.
fn foam(curves: &Curves) -> Option<String> {
    const DECIDES: &str = "no incompressible law is for it: a column of lateral strain or volume change, or --poissons-ratio, \
                           tells how it changes its volume, and --foam fits a law that does so itself";
    if let Some(word) = porous(&curves.words) {
        return Some(format!(
            "\"{word}\" stands in {}: a porous solid is compressible, and {DECIDES}",
            curves.files.join(", ")
        ));
    }
    let part = collapse(&curves.data.points).filter(|_| curves.data.mode == Mode::Uniaxial)?;
    Some(format!(
        "under large compression the reduced stress P / (l - l^-2) falls to {:.0} % of that at small strains, as in an open foam, \
         whose cross-section does not grow; if it is one, {DECIDES}",
        100.0 * part
    ))
}
