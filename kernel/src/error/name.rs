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
            None => split_dot(self.text).map_or("", |(group, _)| group),
        }
    }

    /// The name without its group.
    pub fn field(&self) -> &'static str {
        match self.layer {
            Some(_) => self.text,
            None => split_dot(self.text).map_or(self.text, |(_, field)| field),
        }
    }

    /// Layer and field of a `name` of the form `layers[1].field`.
    pub(crate) fn split_layer(name: &str) -> Option<(usize, &str)> {
        let rest = name.strip_prefix(LAYERS)?.strip_prefix('[')?;
        let digit = rest.bytes().next().filter(u8::is_ascii_digit)?;
        let field = rest.get(1..)?.strip_prefix("].")?;
        Some((usize::from(digit - b'0'), field))
    }
}

/// What stands before the first dot and behind it. The searches of the standard library are not free of panics.
pub(crate) fn split_dot(text: &str) -> Option<(&str, &str)> {
    let dot = text.bytes().position(|byte| byte == b'.')?;
    Some((text.get(..dot)?, text.get(dot + 1..)?))
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

#[cfg(test)]
mod tests {
    use super::Name;

    #[test]
    fn a_name_has_a_group_and_a_field() {
        let parts = |name: Name| (name.layer(), name.group(), name.field());
        assert_eq!(parts(Name::new("impactor.mass")), (None, "impactor", "mass"));
        assert_eq!(parts(Name::new("time")), (None, "", "time"));
        assert_eq!(parts(Name::of_layer(1, "c10")), (Some(1), "layers", "c10"));
    }
}
