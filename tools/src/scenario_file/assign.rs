//! One value for one parameter, wherever it is written: in a scenario file, under `[fixed]` of a problem file, with --set, or
//! in the list of a sweep. All of them are read by [`number`] and given to the kernel's [`Changes`], which see to it that each
//! of them acts.

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Changes, Parameter};

use super::names;

/// A value as it is written.
#[derive(Clone, Copy, Debug)]
pub enum Written<'a> {
    /// A number, in the parameter's unit.
    Number(f64),
    /// A text, in quotation marks where the language has them: the label of a choice.
    Label(&'a str),
    /// Text of a command line, where a number looks like a label.
    Bare(&'a str),
    /// Anything else.
    Other,
}

/// The number that `written` gives to `parameter`; for a choice, its index.
///
/// # Errors
/// What is legal, if it is of the wrong kind.
pub fn number(parameter: &Parameter, written: Written) -> Result<f64, String> {
    let found = match (parameter.kind(), written) {
        (Kind::Quantity | Kind::Count, Written::Number(number)) => Some(number),
        (Kind::Quantity | Kind::Count, Written::Bare(text)) => text.parse().ok(),
        (Kind::Choice { labels }, Written::Label(text) | Written::Bare(text)) => {
            labels.iter().position(|label| *label == text).map(|index| index as f64)
        }
        _ => None,
    };
    found.ok_or_else(|| legal(parameter))
}

/// The parameters that have been given in one place, by their names there.
#[derive(Debug, Default)]
pub struct Given(Vec<(Parameter, String)>);

impl Given {
    /// Takes `parameter`, which is called `name` here.
    ///
    /// # Errors
    /// It has been given before, by the same name or another: one of the two values would have no effect.
    pub fn add(&mut self, parameter: Parameter, name: &str) -> Result<(), String> {
        match self.0.iter().find(|(other, _)| *other == parameter) {
            Some((_, before)) if before == name => Err(format!("{name} is given twice: expected one value")),
            Some((_, before)) => Err(format!("{before} and {name} state the same thing: expected one of them")),
            None => {
                self.0.push((parameter, name.into()));
                Ok(())
            }
        }
    }
}

/// What a parameter may be.
fn legal(parameter: &Parameter) -> String {
    let (min, max) = parameter.range();
    match (parameter.kind(), parameter.unit()) {
        (Kind::Count, _) => format!("a whole number, {min} to {max}"),
        (Kind::Quantity, "1") => format!("a number, {min} to {max}"),
        (Kind::Quantity, unit) => format!("a number, {min} to {max} {unit}"),
        (Kind::Choice { labels }, _) => {
            labels.iter().map(|label| format!("\"{label}\"")).collect::<Vec<_>>().join(" or ")
        }
    }
}

/// Sets what `text`, `group.field=value`, says, beside what is `given` already.
///
/// # Errors
/// A text of another form, an unknown name, a parameter that is given already, or a value that is refused.
pub fn set_text(changes: &mut Changes, given: &mut Given, text: &str) -> Result<Parameter, String> {
    let (name, value) = text.split_once('=').ok_or_else(|| {
        format!("{text} is refused: expected group.field=value, such as silicone.c10=2e5 or core.interface=bonded")
    })?;
    let parameter = names::find(changes.values(), name.trim())?;
    given.add(parameter, name.trim())?;
    set_bare(changes, parameter, value)?;
    Ok(parameter)
}

/// Sets `parameter` to what `text` says on a command line.
///
/// # Errors
/// A value that is refused.
pub fn set_bare(changes: &mut Changes, parameter: Parameter, text: &str) -> Result<(), String> {
    let text = text.trim();
    let number = number(&parameter, Written::Bare(text))
        .map_err(|legal| format!("{} = {text} is refused: expected {legal}", parameter.name()))?;
    changes.set(parameter, number).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn numbers_and_labels_of_a_command_line_are_set() {
        let (mut changes, mut given) = (Changes::of(&preset::study()), Given::default());
        for text in [
            "silicone.c10=2e5",
            "layers[0].rows=4",
            "layers.count=2",
            "layers[1].thickness=0.001",
            " impactor.mass = 4 ",
        ] {
            set_text(&mut changes, &mut given, text).unwrap();
        }
        let scenario = changes.apply().unwrap();
        assert_eq!((scenario.layers[0].material.coefficient("c10"), scenario.impactor.mass), (Some(2e5), 4.0));
        assert_eq!((scenario.layers.len(), scenario.layers[0].rows, scenario.layers[1].thickness), (2, 4, 1e-3));
    }

    #[test]
    fn a_parameter_is_given_once_by_whatever_name() {
        let (mut changes, mut given) = (Changes::of(&preset::study()), Given::default());
        let mut set = |text: &str| set_text(&mut changes, &mut given, text).map(|_| ());
        set("silicone.thickness=0.01").unwrap();
        set("silicone.c10=1e5").unwrap();
        let twice = set("layers[0].thickness=0.02").unwrap_err();
        assert_eq!(twice, "silicone.thickness and layers[0].thickness state the same thing: expected one of them");
        assert_eq!(set("silicone.c10=2e5").unwrap_err(), "silicone.c10 is given twice: expected one value");
        assert_eq!(changes.apply().unwrap().layers[0].thickness, 0.01);
    }

    #[test]
    fn what_is_refused_says_what_is_legal_and_changes_nothing() {
        for (text, message) in [
            ("silicone.c10", "silicone.c10 is refused: expected group.field=value"),
            ("silicon.c10=1", "silicon.c10 is unknown (did you mean silicone.c10?)"),
            ("impactor.mass=heavy", "impactor.mass = heavy is refused: expected a number, 0.001 to 10000 kg"),
            ("impactor.mass=-1", "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg"),
            ("impactor.mass=nan", "impactor.mass = NaN kg is refused: expected 0.001 to 10000 kg"),
            ("core.interface=glued", "core.interface = glued is refused: expected \"bonded\" or \"frictional\""),
            ("layers.count=two", "layers.count = two is refused: expected a whole number, 1 to 4"),
            ("layers.count=1.5", "layers.count = 1.5 is refused: expected 1 to 4"),
            ("geometry.layers=two", "geometry.layers is refused: expected layers.count = 2 or, in a file, a table"),
            ("geometry.silicone_thickness=0.01", "geometry.silicone_thickness is refused: expected silicone.thickness"),
            ("geometry.skin_thickness=0.001", "geometry.skin_thickness is refused: expected layers[1].thickness"),
            (
                "skin.c10=1e5",
                "skin.c10 is refused: no layer is called skin: expected layers[1].c10 or, in a file, a table",
            ),
        ] {
            let mut changes = Changes::of(&preset::study());
            let error = set_text(&mut changes, &mut Given::default(), text).err().unwrap();
            assert!(error.starts_with(message), "{error}");
            assert_eq!(changes.apply().unwrap(), preset::study());
        }
    }
}
