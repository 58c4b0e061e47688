//! Lines of text, no longer than a screen is wide.

/// Characters of a line where no terminal says how many it has.
pub(super) const WIDTH: u16 = 80;

/// `text` with line breaks at blanks, so that no line is longer than `WIDTH` where that is possible.
pub fn filled(text: &str) -> String {
    let mut filled = String::new();
    for line in text.lines() {
        let mut length = 0;
        for word in line.split(' ') {
            let width = word.chars().count();
            if length > 0 && length + 1 + width > usize::from(WIDTH) {
                filled.push('\n');
                length = 0;
            } else if length > 0 {
                filled.push(' ');
                length += 1;
            }
            filled += word;
            length += width;
        }
        filled.push('\n');
    }
    filled
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_broken_at_blanks_and_short_ones_stay() {
        let long = format!("{} {}", "a".repeat(50), "b".repeat(40));
        assert_eq!(filled(&long), format!("{}\n{}\n", "a".repeat(50), "b".repeat(40)));
        assert_eq!(filled("a  b\n\nc"), "a  b\n\nc\n");
        let word = "x".repeat(90);
        assert_eq!(filled(&word), format!("{word}\n"));
    }
}
