//! The options that say how a measured trace is read where its file leaves it open.

use clap::Args;
use softanvil_records::number::Decimal;
use softanvil_records::sheet::Layout;
use softanvil_records::trace::{self, Choice};

/// How the measured trace is read, where its file leaves it open.
#[derive(Debug, Args)]
#[command(next_help_heading = "What the measured trace leaves open")]
pub struct TraceOptions {
    /// Column of the time: its title or number, and its unit if the file does not state it: "t [ms]", "1 [s]"
    #[arg(long, value_name = "COLUMN [UNIT]", requires = "trace")]
    time: Option<Choice>,
    /// Column of the force, such as "Fz [kN]", "2 [lbf]", or "CH1 [250 N/V]" for a sensor of 250 N/V
    #[arg(long, value_name = "COLUMN [UNIT]", requires = "trace")]
    force_column: Option<Choice>,
    /// Column of the acceleration, such as "a [g]", which times the mass is the force
    #[arg(long, value_name = "COLUMN [UNIT]", requires = "trace", conflicts_with = "force_column")]
    acceleration: Option<Choice>,
    /// Column of the impactor's displacement, such as "x [mm]"
    #[arg(long, value_name = "COLUMN [UNIT]", requires = "trace")]
    displacement: Option<Choice>,
    /// Mass that falls in the test, such as 5kg, for an acceleration
    #[arg(long, value_name = "MASS", requires = "trace", value_parser = trace::mass)]
    mass: Option<f64>,
    /// Samples in a second, such as 20kHz, instead of a column of time
    #[arg(long, value_name = "RATE", requires = "trace", value_parser = trace::rate)]
    rate: Option<f64>,
    /// Force in N that the file shows without contact, to be taken off [default: that before contact]
    #[arg(long, value_name = "N", requires = "trace", allow_negative_numbers = true)]
    offset: Option<f64>,
    /// Which side of the record a push is on [default: that of the largest value]
    #[arg(long, value_name = "+|-", requires = "trace", allow_hyphen_values = true, value_parser = trace::sign)]
    sign: Option<f64>,
    /// Which impact of the record, from 1 [default: the first]
    #[arg(long, value_name = "N", requires = "trace", value_parser = clap::value_parser!(u32).range(1..))]
    impact: Option<u32>,
    /// Sheet of a workbook (XLSX, XLS, ODS) that holds more than one table
    #[arg(long, value_name = "NAME", requires = "trace")]
    sheet: Option<String>,
    /// Decimal sign of the file: point or comma
    #[arg(long, value_name = "SIGN", requires = "trace")]
    decimal: Option<Decimal>,
}

impl TraceOptions {
    /// The same for the reader.
    pub fn options(&self) -> trace::Options {
        trace::Options {
            layout: Layout { decimal: self.decimal, sheet: self.sheet.clone() },
            time: self.time.clone(),
            force: self.force_column.clone(),
            acceleration: self.acceleration.clone(),
            displacement: self.displacement.clone(),
            mass: self.mass,
            rate: self.rate,
            offset: self.offset,
            sign: self.sign,
            impact: self.impact.map(|impact| impact as usize),
        }
    }
}
