//! Names of parameters.

use core::fmt;

/// Name of a parameter: `group.field`, or `layers[1].field` of the layer that is second from the core.
///
/// ```
/// use softanvil_kernel::Parameter;
///
/// let name = Parameter::find("layers[1].c10").unwrap().name();
/// assert_eq!(name.to_string(), "layers[1].c10");
/// assert_eq!((name.layer(), name.field()), (Some(1), "c10"));
/// assert!(name == "layers[1].c10" && name != "layers[0].c10");
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Name {
    layer: Option<u8>,
    text: &'static str,
}

impl Name {
    /// A name that is no layer's.
    pub const fn new(text: &'static str) -> Self {
        Self { layer: None, text }
    }

    /// Name of the `field` of a layer, counted from the core.
    pub const fn of_layer(layer: usize, field: &'static str) -> Self {
        Self { layer: Some(layer as u8), text: field }
    }

    /// The layer that the parameter belongs to, counted from the core; none if it belongs to no layer.
    pub fn layer(&self) -> Option<usize> {
        self.layer.map(usize::from)
    }

    /// The group, `impactor` or, of every layer, `layers`.
    pub fn group(&self) -> &'static str {
        match self.layer {
            Some(_) => LAYERS,
            None => self.text.split_once('.').map_or("", |(group, _)| group),
        }
    }

    /// The name without its group.
    pub fn field(&self) -> &'static str {
        match self.layer {
            Some(_) => self.text,
            None => self.text.split_once('.').map_or(self.text, |(_, field)| field),
        }
    }

    /// Layer and field of a `name` of the form `layers[1].field`.
    pub(crate) fn split_layer(name: &str) -> Option<(usize, &str)> {
        // By single characters: the search for a text has a path to a panic.
        let (layer, rest) = name.strip_prefix(LAYERS)?.strip_prefix('[')?.split_once(']')?;
        let field = rest.strip_prefix('.')?;
        let digits = !layer.is_empty() && layer.bytes().all(|byte| byte.is_ascii_digit());
        if digits { Some((layer.parse().ok()?, field)) } else { None }
    }
}

/// The group of the parameters of layers.
const LAYERS: &str = "layers";

impl From<&'static str> for Name {
    fn from(text: &'static str) -> Self {
        Self::new(text)
    }
}

impl PartialEq<str> for Name {
    fn eq(&self, other: &str) -> bool {
        match self.layer {
            Some(layer) => Self::split_layer(other) == Some((usize::from(layer), self.text)),
            None => self.text == other,
        }
    }
}

impl PartialEq<&str> for Name {
    fn eq(&self, other: &&str) -> bool {
        *self == **other
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.layer {
            Some(layer) => write!(f, "{LAYERS}[{layer}].{}", self.text),
            None => f.write_str(self.text),
        }
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}
