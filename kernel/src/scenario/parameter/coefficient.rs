//! The rows of the coefficients of the elastic laws, made of what the laws say of them.

use super::row::{Kind, Parameter};
use crate::material::{COEFFICIENTS, N_COEFFICIENT};
use crate::number::real::Real;
use crate::scenario::Scenario;

/// A name that the compiler has put together, and its length.
pub(super) type Name = ([u8; LONGEST_NAME], usize);

/// Bytes of the longest name of a parameter.
const LONGEST_NAME: usize = 48;

/// The names of the coefficients behind `prefix`.
pub(super) const fn names(prefix: &str) -> [Name; N_COEFFICIENT] {
    let mut names = [([0; LONGEST_NAME], 0); N_COEFFICIENT];
    let mut i = 0;
    while i < N_COEFFICIENT {
        append(&mut names[i], prefix);
        append(&mut names[i], COEFFICIENTS[i].name);
        i += 1;
    }
    names
}

const fn append((bytes, length): &mut Name, text: &str) {
    let text = text.as_bytes();
    let mut i = 0;
    while i < text.len() {
        bytes[*length] = text[i];
        *length += 1;
        i += 1;
    }
}

const fn text((bytes, length): &'static Name) -> &'static str {
    match core::str::from_utf8(bytes.split_at(*length).0) {
        Ok(text) => text,
        Err(_) => panic!("a name is cut within a character"),
    }
}

/// A row for each coefficient, from its name, and what reads and writes it.
pub(super) const fn rows(
    names: &'static [Name; N_COEFFICIENT],
    read: &[fn(&Scenario) -> Real; MOST],
    write: &[fn(&mut Scenario, Real); MOST],
) -> [Parameter; N_COEFFICIENT] {
    let mut rows = [row(&names[0], 0, read[0], write[0]); N_COEFFICIENT];
    let mut i = 1;
    while i < N_COEFFICIENT {
        rows[i] = row(&names[i], i, read[i], write[i]);
        i += 1;
    }
    rows
}

const fn row(
    name: &'static Name,
    place: usize,
    read: fn(&Scenario) -> Real,
    write: fn(&mut Scenario, Real),
) -> Parameter {
    let coefficient = &COEFFICIENTS[place];
    Parameter {
        name: text(name),
        kind: Kind::Real { unit: coefficient.unit, min: coefficient.min, max: coefficient.max, read, write },
        description: coefficient.description,
    }
}

/// Most coefficients that all laws together may have: those that [`for_each_place`] counts.
pub(super) const MOST: usize = 32;

/// A function that is generic over a place, for each place.
macro_rules! for_each_place {
    ($function:ident) => {
        for_each_place!($function: 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31)
    };
    ($function:ident: $($place:literal)+) => {
        [$($function::<$place>),+]
    };
}
pub(super) use for_each_place;
