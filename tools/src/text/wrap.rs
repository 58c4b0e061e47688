//! Lines of text, no longer than a screen is wide.

use textwrap::{WordSeparator, WordSplitter, WrapAlgorithm};

/// Characters of a line where no terminal says how many it has.
pub(super) const WIDTH: u16 = 80;

/// `text` with line breaks at blanks, so that no line is longer than `WIDTH` where that is possible.
pub fn filled(text: &str) -> String {
    // Blanks as they are, in order, and no word cut.
    let options = textwrap::Options::new(usize::from(WIDTH))
        .break_words(false)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit);
    text.lines().map(|line| textwrap::fill(line, &options) + "\n").collect()
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
