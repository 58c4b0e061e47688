//! [`Parameter`]: one value of a scenario, by a row of the tables and the layer that it is of.

use super::general::{LAYER_COUNT, NUMERICS, TEST};
use super::layer;
use super::row::{Access, Row};
use crate::error::{Name, NoEffect, ParameterError, Says, ScenarioError, split_dot};
use crate::number::real::Real;
use crate::scenario::preset::spare_layer;
use crate::scenario::{Layer, MAX_LAYERS, Scenario};

/// One parameter: a number or a choice that a scenario holds, with its name, unit, legal range and meaning.
///
/// ```
/// use softanvil_kernel::parameter::Kind;
/// use softanvil_kernel::{Parameter, preset};
///
/// let mut scenario = preset::study();
/// let mass = Parameter::find("impactor.mass").unwrap();
/// assert_eq!((mass.get(&scenario), mass.unit(), mass.range()), (5.0, "kg", (1e-3, 1e4)));
/// mass.set(&mut scenario, 6.0)?;
/// assert_eq!(scenario.impactor.mass, 6.0);
///
/// // Those of a layer go by its place from the core.
/// Parameter::find("layers[0].thickness").unwrap().set(&mut scenario, 12e-3)?;
/// assert_eq!(scenario.thickness(), 12e-3);
///
/// // A choice goes by the number of its label.
/// let motion = Parameter::find("impactor.motion").unwrap();
/// let Kind::Choice { labels } = motion.kind() else { panic!("no choice") };
/// assert_eq!(labels[motion.get(&scenario) as usize], "drop");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Parameter {
    pub(super) place: Place,
}

/// Where the value of a parameter lives.
#[derive(Clone, Copy)]
pub(super) enum Place {
    /// In the scenario itself.
    Test(&'static Row<Scenario>),
    /// The number of layers.
    LayerCount(&'static Row<usize>),
    /// In a layer, counted from the core.
    Layer(usize, &'static Row<Layer>),
}

/// What a parameter's value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A physical quantity in an SI unit; "1" for a ratio.
    Quantity,
    /// A whole number.
    Count,
    /// One of several named choices, numbered from 0 in this order.
    Choice {
        /// Names of the choices.
        labels: &'static [&'static str],
    },
}

/// Evaluates an expression with the row of a parameter, whatever that is of.
macro_rules! with_row {
    ($parameter:expr, $row:ident => $value:expr) => {
        match $parameter.place {
            Place::Test($row) => $value,
            Place::LayerCount($row) => $value,
            Place::Layer(_, $row) => $value,
        }
    };
}

impl Parameter {
    /// How many there are.
    pub const COUNT: usize = TEST.len() + 1 + MAX_LAYERS * layer::COUNT + NUMERICS.len();

    /// Every parameter, in the order in which users meet them: those of every layer that there can be follow the number of layers.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::with_layers(MAX_LAYERS)
    }

    /// The parameters of the layers and of all else that `scenario` has.
    pub fn of(scenario: &Scenario) -> impl Iterator<Item = Self> + use<> {
        Self::with_layers(scenario.layers.len())
    }

    pub(super) fn with_layers(layers: usize) -> impl Iterator<Item = Self> + Clone {
        let count = TEST.len() + 1 + layers * layer::COUNT + NUMERICS.len();
        (0..count).filter_map(move |place| Self::at(place, layers))
    }

    /// The parameter at a place among those of `layers` layers and of all else. Apart, so that a walk over parameters, of which
    /// there are many, is little code.
    #[inline(never)]
    fn at(place: usize, layers: usize) -> Option<Self> {
        if let Some(row) = TEST.get(place) {
            return Some(Self { place: Place::Test(row) });
        }
        let Some(place) = place.checked_sub(TEST.len() + 1) else {
            return Some(Self { place: Place::LayerCount(&LAYER_COUNT) });
        };
        match place.checked_sub(layers * layer::COUNT) {
            None => Self::in_layer(place / layer::COUNT, place % layer::COUNT),
            Some(place) => NUMERICS.get(place).map(|row| Self { place: Place::Test(row) }),
        }
    }

    /// The parameter at a place among those of a layer.
    #[inline(never)]
    fn in_layer(layer: usize, place: usize) -> Option<Self> {
        let row = layer::row(place)?;
        if layer < MAX_LAYERS { Some(Self { place: Place::Layer(layer, row) }) } else { None }
    }

    /// Those of a layer, counted from the core; none of one that there cannot be.
    pub fn of_layer(layer: usize) -> impl Iterator<Item = Self> + Clone {
        (0..layer::COUNT).filter_map(move |place| Self::in_layer(layer, place))
    }

    /// Those of the material of a layer: all of the layer's but those that say how it is cut, meshed and laid.
    pub fn of_material(layer: usize) -> impl Iterator<Item = Self> {
        const OTHERS: [&str; 6] = ["thickness", "rows", "width", "interface", "friction_coefficient", "gap"];
        Self::of_layer(layer).filter(|parameter| !OTHERS.contains(&parameter.name().field()))
    }

    /// The parameter called `name`, such as `impactor.mass` or `layers[1].c10`.
    pub fn find(name: &str) -> Option<Self> {
        match Name::split_layer(name) {
            Some((layer, field)) => Self::find_in_layer(layer, field),
            None => Self::with_layers(0).find(|parameter| parameter.name() == name),
        }
    }

    /// The parameter with this name.
    pub(super) fn named(name: Name) -> Option<Self> {
        match name.layer() {
            Some(layer) => Self::find_in_layer(layer, name.field()),
            None => Self::with_layers(0).find(|parameter| parameter.name() == name),
        }
    }

    /// The parameter of a layer whose name is `field` within it.
    #[inline(never)]
    fn find_in_layer(layer: usize, field: &str) -> Option<Self> {
        Self::of_layer(layer).find(|parameter| parameter.name().field() == field)
    }

    /// The parameter that `name` means in `scenario`: its name, or that of a layer and a field of it, such as `skin.c10`.
    pub fn find_in(scenario: &Scenario, name: &str) -> Option<Self> {
        Self::find(name).or_else(|| {
            let (layer, field) = split_dot(name)?;
            let place = scenario.layers.iter().position(|known| !layer.is_empty() && known.name == layer)?;
            Self::find_in_layer(place, field)
        })
    }

    /// Structured name, `group.field` or `layers[1].field`.
    pub fn name(&self) -> Name {
        match self.place {
            Place::Layer(layer, row) => Name::of_layer(layer, row.name),
            Place::Test(Row { name, .. }) | Place::LayerCount(Row { name, .. }) => (*name).into(),
        }
    }

    /// Its number among the parameters of the same layer, or among those of no layer; see [`Parameter::number`].
    pub fn id(&self) -> u32 {
        with_row!(self, row => row.id)
    }

    /// The layer that it belongs to, counted from the core; none if it belongs to no layer.
    pub fn layer(&self) -> Option<usize> {
        match self.place {
            Place::Layer(layer, _) => Some(layer),
            Place::Test(_) | Place::LayerCount(_) => None,
        }
    }

    /// Meaning, one line.
    pub fn description(&self) -> &'static str {
        with_row!(self, row => row.description)
    }

    /// What its value is.
    pub fn kind(&self) -> Kind {
        with_row!(self, row => match row.access {
            Access::Quantity { .. } | Access::Entry { .. } => Kind::Quantity,
            Access::Count { .. } => Kind::Count,
            Access::Choice { labels, .. } => Kind::Choice { labels },
        })
    }

    /// Names of the choices; none for a number.
    pub fn labels(&self) -> &'static [&'static str] {
        match self.kind() {
            Kind::Choice { labels } => labels,
            Kind::Quantity | Kind::Count => &[],
        }
    }

    /// Unit of the value; "1" for ratios, counts and choices.
    pub fn unit(&self) -> &'static str {
        with_row!(self, row => match row.access {
            Access::Quantity { unit, .. } | Access::Entry { unit, .. } => unit,
            Access::Count { .. } | Access::Choice { .. } => "1",
        })
    }

    /// Smallest and largest legal value, both included.
    pub fn range(&self) -> (Real, Real) {
        with_row!(self, row => match row.access {
            Access::Quantity { min, max, .. } | Access::Entry { min, max, .. } => (min, max),
            Access::Count { min, max, .. } => (min as Real, max as Real),
            Access::Choice { labels, .. } => (0.0, labels.len() as Real - 1.0),
        })
    }

    /// The value in `scenario`; a choice as its index. Of a layer that it does not have, that of a spare one.
    pub fn get(&self, scenario: &Scenario) -> Real {
        match self.place {
            Place::Test(row) => row.get(scenario),
            Place::LayerCount(row) => row.get(&scenario.layers.len()),
            Place::Layer(layer, row) => match scenario.layers.get(layer) {
                Some(layer) => row.get(layer),
                None => row.get(&spare_layer()),
            },
        }
    }

    /// Sets the value in `scenario`; a choice by its index.
    ///
    /// # Errors
    /// A value that is not legal, or that is one of a layer that `scenario` does not have, is refused and changes nothing.
    pub fn set(&self, scenario: &mut Scenario, value: Real) -> Result<(), ScenarioError> {
        self.check(value)?;
        match self.place {
            Place::Test(row) => row.set(scenario, value),
            Place::LayerCount(_) => scenario.set_layer_count(value as usize),
            Place::Layer(layer, row) => match scenario.layers.get_mut(layer) {
                Some(layer) => row.set(layer, value),
                None => return Err(ScenarioError::NoEffect(self.of_absent_layer(value, scenario.layers.len()))),
            },
        }
        Ok(())
    }

    /// Why `value` has no effect among so many `layers`, which do not have this one.
    pub(super) fn of_absent_layer(&self, value: Real, layers: usize) -> NoEffect {
        let (by, says) = (LAYER_COUNT.name.into(), Says::Number(layers as Real));
        NoEffect { name: self.name(), value, unit: self.unit(), by, says }
    }

    /// Whether `value` is legal: finite, in range, and whole for a count or a choice.
    ///
    /// # Errors
    /// The name, value, unit and legal range of a refused value.
    pub fn check(&self, value: Real) -> Result<(), ParameterError> {
        let (min, max) = self.range();
        let in_range = value >= min && value <= max;
        let whole = match self.kind() {
            Kind::Quantity => true,
            Kind::Count | Kind::Choice { .. } => in_range && value as usize as Real == value,
        };
        if in_range && whole {
            return Ok(());
        }
        Err(ParameterError { name: self.name(), value, unit: self.unit(), min, max })
    }
}

impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        self.number() == other.number()
    }
}

impl core::fmt::Debug for Parameter {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.name().fmt(f)
    }
}
