//! `softanvil fit`: from material tests to coefficients.

use std::fmt::Write;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use softanvil_identify::data::curve::{self, Direction};
use softanvil_identify::data::cycles::Selection;
use softanvil_identify::data::repeats::Repeats;
use softanvil_identify::data::specimen::Specimen;
use softanvil_identify::export::Layer;
use softanvil_identify::law::fit::{Settings, Weighting};
use softanvil_identify::law::{FOAMS, LAWS, Law, Mode};
use softanvil_identify::relaxation::choice::TERMS;
use softanvil_identify::relaxation::read as relaxation;
use softanvil_kernel::material::Moduli;
use softanvil_records::column::Measure;
use softanvil_records::number::Decimal;
use softanvil_records::sheet::Layout;
use softanvil_records::unit::{Dimension, parse_quantity};

use super::output_files::Overwrite;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::identification::files::{Curves, Reading, Source};
use crate::identification::material::{Files, Identified, given};
use crate::identification::trial::Trial;
use crate::identification::{Identification, Request, json, table};
use crate::output::json as text_json;
use crate::plot::picture_format::PictureFormat;
use crate::text::wrap::filled;
use crate::{plot, scenario_file};

/// Fit hyperelastic laws and Prony series to material tests, and write the material
///
/// Files are tables of text or workbooks; titles tell what the columns are, with their units: strain, stretch, stress, force,
/// displacement, time, modulus. Stresses are nominal unless a title says true.
#[derive(Debug, Args)]
pub struct Options {
    /// Uniaxial tension or compression; several files are repeats
    #[arg(long, value_name = "FILE", num_args = 1..)]
    uniaxial: Vec<PathBuf>,
    /// Planar tension (pure shear)
    #[arg(long, value_name = "FILE", num_args = 1..)]
    planar: Vec<PathBuf>,
    /// Equibiaxial tension
    #[arg(long, value_name = "FILE", num_args = 1..)]
    equibiaxial: Vec<PathBuf>,
    /// Simple shear: amount of shear (or displacement) and shear stress (or force)
    #[arg(long, value_name = "FILE", num_args = 1..)]
    simple_shear: Vec<PathBuf>,
    /// Stress relaxation: time and modulus, stress or force
    #[arg(long, value_name = "FILE")]
    relaxation: Option<PathBuf>,
    /// No data: the start from the scalars that the paper prints, with their contradictions
    #[arg(long, conflicts_with_all = ["uniaxial", "planar", "equibiaxial", "simple_shear", "relaxation", "json"])]
    paper: bool,
    #[command(flatten)]
    table: TableOptions,
    #[command(flatten)]
    specimen: SpecimenOptions,
    #[command(flatten)]
    laws: LawOptions,
    #[command(flatten)]
    prony: PronyOptions,
    #[command(flatten)]
    material: MaterialOptions,
    /// Write material files and pictures to this folder, beside what is in it
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Format of the pictures in that folder
    #[arg(long, value_enum, default_value = "svg")]
    pictures: PictureFormat,
    /// Print JSON in SI units instead of the tables
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "What the files leave open")]
struct TableOptions {
    /// Titles of the curves' columns instead of the file's, such as "strain [%], stress [kPa]"; - passes a column over
    #[arg(long, value_name = "TITLES", allow_hyphen_values = true)]
    columns: Option<String>,
    /// The same for the relaxation
    #[arg(long, value_name = "TITLES", allow_hyphen_values = true)]
    relaxation_columns: Option<String>,
    /// Sheet of a workbook (XLSX, XLS, ODS) that holds more than one table
    #[arg(long, value_name = "NAME")]
    sheet: Option<String>,
    /// Decimal sign
    #[arg(long, value_enum)]
    decimal: Option<DecimalOption>,
    /// Strains whose title names no measure: change of length, logarithmic, or Green's
    #[arg(long, value_enum)]
    strain_measure: Option<MeasureOption>,
    /// Stresses whose title names no measure: nominal, Cauchy, or second Piola-Kirchhoff (green)
    #[arg(long, value_enum)]
    stress_measure: Option<MeasureOption>,
    /// Which way the specimen was loaded, where signs and words leave it open
    #[arg(long, value_enum)]
    direction: Option<DirectionOption>,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Specimens")]
struct SpecimenOptions {
    /// Cross-section at rest, such as 660mm2, for columns of force
    #[arg(long, value_name = "AREA", value_parser = area, conflicts_with = "diameter")]
    area: Option<f64>,
    /// Diameter at rest, such as 29mm
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    diameter: Option<f64>,
    /// Height or gauge length at rest, such as 12.5mm, for columns of displacement
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    height: Option<f64>,
    /// Several specimens: their median curve as in the paper, or every point
    #[arg(long, value_enum, default_value = "median")]
    repeats: RepeatsOption,
    /// Leave out the first load cycle, in which rubber softens (Mullins effect)
    #[arg(long)]
    drop_first_cycle: bool,
    /// Use unloading as well as loading
    #[arg(long)]
    unloading: bool,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Laws")]
struct LawOptions {
    /// The specimens are of a foam: fit laws that change their volume, by the stresses alone
    #[arg(long)]
    foam: bool,
    /// Law to choose instead of the stable one of lowest residual
    #[arg(long, value_name = "NAME", value_parser = law)]
    law: Option<&'static Law>,
    /// Residuals in Pa, divided by the stress (of at least 1 % of the largest), or by the largest stress of their test, so that
    /// every test counts alike [default: absolute; of a foam tests]
    #[arg(long, value_enum)]
    weighting: Option<WeightingOption>,
    /// Only Drucker-stable laws
    #[arg(long)]
    stable: bool,
    /// Stretches for stability [default: those of the data, and 0.5 to 2]
    #[arg(long, value_name = "FROM:TO", value_parser = range)]
    stable_range: Option<(f64, f64)>,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Relaxation")]
struct PronyOptions {
    /// Number of Prony terms instead of the chosen one
    #[arg(long, value_name = "N", value_parser = n_term)]
    terms: Option<usize>,
    /// Time in s in which the strain was applied; 0 for an ideal step
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = time)]
    ramp_time: Option<f64>,
    /// Reading in s of the file's clock when loading began [default: 0]
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = finite)]
    relaxation_start: Option<f64>,
    /// Held engineering strain, negative in compression, such as -0.5
    #[arg(long, value_name = "STRAIN", allow_negative_numbers = true, value_parser = strain)]
    relaxation_strain: Option<f64>,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Material files")]
struct MaterialOptions {
    /// Whether the curves were slow (long-term moduli) or fast (instantaneous moduli) against the relaxation
    #[arg(long, value_enum, default_value = "long-term")]
    moduli: ModuliOption,
    /// Layer of the stack: its name, its place from the core, 0 to 3, or both, as in pad=0 [default: silicone; of a foam pad]
    #[arg(long, value_name = "NAME|PLACE", value_parser = Layer::parse)]
    layer: Option<Layer>,
    /// Density in kg/m3 [default: that of the layer in the preset study; of a foam 50]
    #[arg(long, value_name = "KG_PER_M3", allow_negative_numbers = true)]
    density: Option<f64>,
    /// Poisson's ratio; below 0.45 the laws are fitted to a specimen that changes its volume so [default: as lateral strains
    /// in the files say, else that of the layer in the preset study beside laws fitted as to a constant volume; of a foam fitted
    /// with the others]
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true)]
    poissons_ratio: Option<f64>,
}

/// An option whose values are those of a type of the library.
macro_rules! choice {
    ($name:ident => $target:ty { $($variant:ident => $value:expr),+ $(,)? }) => {
        #[derive(Clone, Copy, Debug, ValueEnum)]
        enum $name { $($variant),+ }

        impl From<$name> for $target {
            fn from(choice: $name) -> Self {
                match choice { $($name::$variant => $value),+ }
            }
        }
    };
}

choice!(DecimalOption => Decimal { Point => Decimal::Point, Comma => Decimal::Comma });
choice!(MeasureOption => Measure {
    Engineering => Measure::Engineering,
    True => Measure::True,
    Green => Measure::Lagrange,
});
choice!(DirectionOption => Direction { Tension => Direction::Tension, Compression => Direction::Compression });
choice!(RepeatsOption => Repeats { Median => Repeats::Median, All => Repeats::All });
choice!(WeightingOption => Weighting { Absolute => Weighting::Absolute, Relative => Weighting::Relative, Tests => Weighting::Tests });
choice!(ModuliOption => Moduli { LongTerm => Moduli::LongTerm, Instantaneous => Moduli::Instantaneous });

/// File of the scenario that holds the material and goes through.
const SCENARIO: &str = "scenario.toml";

/// Fits; returns the report.
///
/// # Errors
/// Files or options that are refused, a fit that failed, or files that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let foam = options.laws.foam()?;
    let default = if foam { PAD } else { SILICONE };
    let layer = options.material.layer.clone().map_or_else(|| Layer::parse(default), Ok).map_err(Failure::Input)?;
    if options.paper {
        let identified = Identified::of_study(layer)?;
        let mut text = identified.comment.clone() + "\n";
        if options.out.is_some() {
            text += &options.write(&identified, identified.files()?)?;
        }
        return Ok(text);
    }
    let identification = options.identify(foam)?;
    let material = &options.material;
    let given = given(material.moduli.into(), material.density, material.poissons_ratio, layer, foam);
    let mut report = json::of_identification(&identification);
    let mut text = String::new();
    if options.out.is_some() {
        let identified = Identified::new(&identification, &given)?;
        let mut files = identified.files()?;
        for (name, svg) in plot::identification(&identification)? {
            files.written.push((format!("{name}.{}", options.pictures.extension()), options.pictures.file(svg)?));
        }
        files.written.push(("fit.json".into(), text_json::text(&report).into_bytes()));
        let refused = files.refused.clone();
        text = options.write(&identified, files)?;
        report["not_written"] = refused.into_iter().collect();
    }
    Ok(match options.json {
        true => text_json::text(&report),
        false => table::of_identification(&identification) + &text,
    })
}

/// Layers that a material is for where no option says otherwise.
const SILICONE: &str = "silicone";
/// See [`SILICONE`].
const PAD: &str = "pad";

impl LawOptions {
    /// Whether the laws are those of foams.
    fn foam(&self) -> Result<bool, Failure> {
        let chosen = self.law.map(|law| law.is_compressible());
        match (self.foam, self.law) {
            (true, Some(law)) if !law.is_compressible() => {
                let legal = FOAMS.iter().map(|law| law.name).collect::<Vec<_>>().join(", ");
                Err(Failure::Input(format!("--law {} is refused beside --foam: expected {legal}", law.name)))
            }
            _ => Ok(self.foam || chosen == Some(true)),
        }
    }
}

impl Options {
    fn identify(&self, foam: bool) -> Result<Identification, Failure> {
        let (table, specimen) = (&self.table, &self.specimen);
        let area = specimen.area.or(specimen.diameter.map(|d| 0.25 * std::f64::consts::PI * d * d));
        let size = Specimen { area, height: specimen.height };
        let layout = Layout { decimal: table.decimal.map(Into::into), sheet: table.sheet.clone() };
        let reading = Reading {
            curve: curve::Options {
                columns: table.columns.as_deref().map(titles),
                layout: layout.clone(),
                specimen: size,
                strain_measure: table.strain_measure.map(Into::into),
                stress_measure: table.stress_measure.map(Into::into),
                direction: table.direction.map(Into::into),
                shear: false,
            },
            selection: Selection { drop_first_cycle: specimen.drop_first_cycle, unloading: specimen.unloading },
            repeats: specimen.repeats.into(),
        };
        let tests = [
            (Mode::Uniaxial, &self.uniaxial),
            (Mode::Planar, &self.planar),
            (Mode::Equibiaxial, &self.equibiaxial),
            (Mode::SimpleShear, &self.simple_shear),
        ];
        let curves = tests.into_iter().filter(|(_, paths)| !paths.is_empty());
        let curves = curves.map(|(mode, paths)| Curves::read(mode, paths, &reading)).collect::<Result<Vec<_>, _>>()?;
        if curves.is_empty() && self.relaxation.is_none() {
            let legal =
                "expected --uniaxial, --planar, --equibiaxial, --simple-shear or --relaxation with a file, or --paper";
            return Err(Failure::Input(format!("there is nothing to fit: {legal}")));
        }
        let relaxation = relaxation::Options {
            columns: table.relaxation_columns.as_deref().map(titles),
            layout,
            specimen: size,
            strain_measure: table.strain_measure.map(Into::into),
            stress_measure: table.stress_measure.map(Into::into),
            ramp_time: self.prony.ramp_time,
            start: self.prony.relaxation_start,
            strain: self.prony.relaxation_strain,
        };
        let source = self.relaxation.as_deref().map(Source::read).transpose()?;
        let request = Request {
            stability_range: self.laws.stable_range,
            settings: Settings {
                weighting: match self.laws.weighting {
                    Some(weighting) => weighting.into(),
                    None if foam => Weighting::Tests,
                    None => Weighting::Absolute,
                },
                stability_range: self.laws.stable_range.unwrap_or((1.0, 1.0)),
                demand_stability: self.laws.stable,
                poissons_ratio: None,
            },
            law: self.laws.law,
            foam,
            n_term: self.prony.terms,
            poissons_ratio: self.material.poissons_ratio,
        };
        Identification::new(curves, source.as_ref().map(|source| (source, &relaxation)), &request)
    }

    /// Puts `files` into the folder asked for, and the scenario of a drop on the paper's anvil that goes through with the
    /// material; says so, what was left out, and what the drop needs.
    fn write(&self, identified: &Identified, mut files: Files) -> Result<String, Failure> {
        let Some(path) = &self.out else { return Ok(String::new()) };
        let mut folder = Folder::new(path, self.overwrite.overwrite);
        let names = files.written.iter().map(|(name, _)| name).chain(files.refused.iter().map(|(name, _)| name));
        folder.check(names.map(String::as_str).chain([SCENARIO]))?;
        let tried = match Trial::new(&identified.scenario()) {
            Ok(trial) => {
                let text = scenario_file::to_toml(&trial.scenario);
                let read = identified.read_toml(&text);
                files.add(identified, SCENARIO, text, read);
                trial.text(&path.join(SCENARIO).display().to_string())
            }
            Err(error) => format!(
                "! No drop on the paper's anvil goes through with this material, not even a small one: {error}. Look at the \
                 law's stability (--stable, --law), or at the units of the data.\n"
            ),
        };
        // One of an earlier fit would be taken for one of this.
        folder.remove(files.refused.iter().map(|(name, _)| name.as_str()))?;
        folder.write(&files.written)?;
        let mut text = String::from("\n");
        for (name, _) in &files.written {
            let _ = writeln!(text, "written: {}", path.join(name).display());
        }
        for (name, reason) in &files.refused {
            text += &filled(&format!("! not written: {}: {reason}\n", path.join(name).display()));
        }
        Ok(text + &tried)
    }
}

fn titles(text: &str) -> Vec<String> {
    // A comma within brackets belongs to a title.
    let (mut titles, mut depth) = (vec![String::new()], 0);
    for c in text.chars() {
        depth += i32::from(matches!(c, '[' | '(')) - i32::from(matches!(c, ']' | ')'));
        match titles.last_mut() {
            Some(title) if !(depth == 0 && matches!(c, ',' | ';')) => title.push(c),
            _ => titles.push(String::new()),
        }
    }
    titles.iter().map(|title| title.trim().to_string()).collect()
}

fn area(text: &str) -> Result<f64, String> {
    parse_quantity(text, Dimension::Area)
}

fn length(text: &str) -> Result<f64, String> {
    parse_quantity(text, Dimension::Length)
}

fn law(name: &str) -> Result<&'static Law, String> {
    let names = || LAWS.iter().chain(FOAMS.iter()).map(|law| law.name).collect::<Vec<_>>().join(", ");
    Law::find(name).ok_or_else(|| format!("expected {}", names()))
}

fn range(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = softanvil_identify::law::stability::SCAN;
    let numbers = text.split_once(':').and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
    match numbers {
        Some((from, to)) if low <= from && from < 1.0 && 1.0 < to && to <= high => Ok((from, to)),
        _ => Err(format!("expected two stretches around 1, {low} to {high}, such as 0.5:2")),
    }
}

fn n_term(text: &str) -> Result<usize, String> {
    let (low, high) = (TERMS.start(), TERMS.end());
    text.parse().ok().filter(|n| TERMS.contains(n)).ok_or_else(|| format!("expected {low} to {high}"))
}

fn finite(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| "expected a number".into())
}

fn time(text: &str) -> Result<f64, String> {
    finite(text).ok().filter(|time| *time >= 0.0).ok_or_else(|| "expected 0 or more, in s".into())
}

fn strain(text: &str) -> Result<f64, String> {
    let legal = || "expected a ratio above -1 and not 0".to_string();
    finite(text).ok().filter(|strain| *strain > -1.0 && *strain != 0.0 && *strain <= 10.0).ok_or_else(legal)
}
