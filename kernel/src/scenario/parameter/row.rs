//! A row of the tables of parameters: a field of a scenario, or one that every layer has.

use crate::number::real::Real;

/// One row, of a field in a `T`.
pub(crate) struct Row<T: 'static> {
    /// Its number among the rows of its table, for ever: no other row gets it, even when this one is no more.
    pub id: u32,
    /// Structured name; of a layer's the field alone.
    pub name: &'static str,
    /// What the value is and how it is stored.
    pub access: Access<T>,
    /// Meaning, one line.
    pub description: &'static str,
}

/// What the value of a row is, and where it lives.
pub(crate) enum Access<T: 'static> {
    /// A physical quantity in an SI unit, legal from `min` to `max`.
    Quantity {
        /// SI unit.
        unit: &'static str,
        /// Smallest legal value.
        min: Real,
        /// Largest legal value.
        max: Real,
        /// The value.
        read: fn(&T) -> Real,
        /// Sets it.
        write: fn(&mut T, Real),
    },
    /// A quantity that is one of a list.
    Entry {
        /// SI unit.
        unit: &'static str,
        /// Smallest legal value.
        min: Real,
        /// Largest legal value.
        max: Real,
        /// Place in the list.
        place: usize,
        /// The value at a place.
        read: fn(&T, usize) -> Real,
        /// Sets it.
        write: fn(&mut T, usize, Real),
    },
    /// A whole number from `min` to `max`.
    Count {
        /// Smallest legal number.
        min: u32,
        /// Largest legal number.
        max: u32,
        /// The number.
        read: fn(&T) -> usize,
        /// Sets it.
        write: fn(&mut T, usize),
    },
    /// One of several named choices.
    Choice {
        /// Names of the choices.
        labels: &'static [&'static str],
        /// Index of the choice.
        read: fn(&T) -> usize,
        /// Sets the choice by its index.
        write: fn(&mut T, usize),
    },
}

impl<T> Row<T> {
    /// The value in `owner`; a choice as its index.
    pub fn get(&self, owner: &T) -> Real {
        match self.access {
            Access::Quantity { read, .. } => read(owner),
            Access::Entry { place, read, .. } => read(owner, place),
            Access::Count { read, .. } | Access::Choice { read, .. } => read(owner) as Real,
        }
    }

    /// Sets a legal value in `owner`; a choice by its index.
    pub fn set(&self, owner: &mut T, value: Real) {
        match self.access {
            Access::Quantity { write, .. } => write(owner, value),
            Access::Entry { place, write, .. } => write(owner, place, value),
            Access::Count { write, .. } | Access::Choice { write, .. } => write(owner, value as usize),
        }
    }
}

/// The row of a quantity: its number, its field, which is its name as well, or an entry of one with its number in the name; its
/// unit, legal range and meaning. `of` says what the fields are of: a layer's have names without a group.
macro_rules! real {
    ($id:literal, of layer $field:ident, $($rest:tt)+) => {
        real!([$field] $id, stringify!($field), $($rest)+)
    };
    ($id:literal, of layer $group:ident.$field:ident, $($rest:tt)+) => {
        real!([$group.$field] $id, stringify!($field), $($rest)+)
    };
    ($id:literal, of layer $group:ident.$field:ident[$i:literal] = $number:literal, $($rest:tt)+) => {
        real!([$group.$field[$i]] $id, concat!(stringify!($field), "_", $number), $($rest)+)
    };
    ($id:literal, $group:ident.$field:ident, $($rest:tt)+) => {
        real!([$group.$field] $id, concat!(stringify!($group), ".", stringify!($field)), $($rest)+)
    };
    ([$($field:tt)+] $id:literal, $name:expr, $unit:literal, $range:expr, $text:expr $(,)?) => {
        Row {
            id: $id,
            name: $name,
            access: Access::Quantity {
                unit: $unit,
                min: $range.0,
                max: $range.1,
                read: |owner| owner.$($field)+,
                write: |owner, value| owner.$($field)+ = value,
            },
            description: $text,
        }
    };
}
pub(super) use real;

/// The row of a choice, likewise, with the type of the field.
macro_rules! choice {
    ($id:literal, of layer $field:ident: $choice:ty, $text:expr $(,)?) => {
        choice!([$field] $id, stringify!($field), $choice, $text)
    };
    ($id:literal, of layer $group:ident.$field:ident: $choice:ty, $text:expr $(,)?) => {
        choice!([$group.$field] $id, stringify!($field), $choice, $text)
    };
    ($id:literal, $group:ident.$field:ident: $choice:ty, $text:expr $(,)?) => {
        choice!([$group.$field] $id, concat!(stringify!($group), ".", stringify!($field)), $choice, $text)
    };
    ([$($field:tt)+] $id:literal, $name:expr, $choice:ty, $text:expr) => {
        Row {
            id: $id,
            name: $name,
            access: Access::Choice {
                labels: <$choice as strum::VariantNames>::VARIANTS,
                read: |owner| owner.$($field)+ as usize,
                write: |owner, index| {
                    if let Some(choice) = <$choice>::from_repr(index) {
                        owner.$($field)+ = choice;
                    }
                },
            },
            description: $text,
        }
    };
}
pub(super) use choice;
