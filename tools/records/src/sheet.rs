//! The tables of numbers in a file: separator and decimal sign, titles, and rows with their lines.

mod assembly;
mod head;
mod notation;
mod table;
#[cfg(feature = "workbooks")]
mod workbook;

use super::ReadError;
use super::text::Lines;
use assembly::of_lines;
pub use table::{Body, Layout, Row, Sheet};

/// The tables in `bytes`, by `layout` where the file leaves it open.
///
/// # Errors
/// No table, or a line in it that is no row of numbers.
pub fn parse(bytes: &[u8], layout: &Layout) -> Result<Sheet, ReadError> {
    #[cfg(feature = "workbooks")]
    if softanvil_workbooks::is_workbook(bytes) {
        return workbook::parse(bytes, layout);
    }
    if let Some(sheet) = &layout.sheet {
        return Err(ReadError::file(format!("--sheet {sheet} is refused: this is text, not a workbook")));
    }
    of_lines(Lines::new(bytes)?, layout.decimal, None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{self, Cell};

    fn sheet(text: &str) -> Sheet {
        parse(text.as_bytes(), &Layout::default()).unwrap()
    }

    fn titles(text: &str) -> Vec<String> {
        sheet(text).tables[0].titles.clone()
    }

    fn numbers(sheet: &Sheet) -> Vec<Vec<f64>> {
        let read = |cell: &str| match number::read(cell, sheet.decimal) {
            Cell::Number(number) => number,
            _ => f64::NAN,
        };
        sheet.tables[0].blocks.iter().flatten().map(|row| sheet.cells(*row).map(read).collect()).collect()
    }

    #[test]
    fn every_separator_and_decimal_sign_is_found() {
        for text in [
            "strain,stress\n0.1,0.2\n0.3,0.4\n",
            "strain;stress\n0,1;0,2\n0,3;0,4\n",
            "strain;stress\n0.1;0.2\n0.3;0.4\n",
            "strain\tstress\n0,1\t0,2\n0,3\t0,4\n",
            "strain stress\n0.1 0.2\n0.3 0.4\n",
            "strain stress\n0,1 0,2\n0,3 0,4\n",
            "  strain    stress\n   0.1     0.2\n   0.3     0.4\n",
            "strain|stress\n0.1|0.2\n0.3|0.4\n",
            "strain, stress\n0.1, 0.2\n0.3, 0.4\n",
            "strain,stress\n\"0,1\",\"0,2\"\n\"0,3\",\"0,4\"\n",
            "# note\r\nstrain;stress\r\n0.1;0.2\r\n\r\n0.3;0.4",
            "# strain stress\n0.1 0.2\n0.3 0.4\n",
            "strain,stress\n0.1,0.2\n0.3,0.4\nMax,0.4\nend of test\n",
            "strain,stress\n0.1,0.2\n0.3,0.4\nMean,0.2,0.3\n",
        ] {
            let sheet = sheet(text);
            assert_eq!(sheet.tables[0].titles, ["strain", "stress"], "{text}");
            assert_eq!(numbers(&sheet), [[0.1, 0.2], [0.3, 0.4]], "{text}");
        }
    }

    #[test]
    fn a_head_of_a_test_machine_is_passed_over() {
        let text =
            "Test;Compression;;\nSpecimen Length (mm);33;;\n\nTime;Strain;Stress\n(s);(%);(MPa)\n0;0,5;1\n1;0,7;2\n";
        let sheet = sheet(text);
        assert_eq!(sheet.tables[0].titles, ["Time [s]", "Strain [%]", "Stress [MPa]"]);
        assert_eq!(numbers(&sheet), [[0.0, 0.5, 1.0], [1.0, 0.7, 2.0]]);
        assert!(sheet.words().contains("Compression"));
    }

    #[test]
    fn rows_of_missing_values_above_the_table_are_no_titles() {
        assert_eq!(titles("a;b\nnan;nan\n0.1;nan\n1;2\n3;4\n"), ["a", "b"]);
        assert_eq!(titles("a;b\n-;MPa\n1;2\n3;4\n"), ["a [-]", "b [MPa]"]);
        assert_eq!(titles("t,E,T\ns,MPa,°C\n1,2,3\n3,4,5\n"), ["t [s]", "E [MPa]", "T [°C]"]);
    }

    #[test]
    fn a_unit_that_is_not_known_leaves_the_row_one_of_units() {
        let expected = ["Time [s]", "Load [N]", "Tenacity [N/tex2]"];
        assert_eq!(titles("Time,Load,Tenacity\n(s),(N),(N/tex2)\n1,2,3\n3,4,5\n"), expected);
        assert_eq!(titles("Time,Load,Tenacity\ns,N,N/tex2\n1,2,3\n3,4,5\n"), expected);
    }

    #[test]
    fn titles_may_have_fewer_or_more_cells_than_rows() {
        assert_eq!(titles("a;b\n1;2;\n3;4;\n"), ["a", "b"]);
        assert_eq!(titles("a\tb\tComment\n1\t2\n3\t4\n"), ["a", "b", "Comment"]);
        assert!(sheet("a;b\n1;2;3\n3;4;5\n").tables[0].titles.is_empty());
        assert_eq!(titles("Time (s) Force (N)\n1 2\n3 4\n"), ["Time (s)", "Force (N)"]);
    }

    #[test]
    fn a_comment_for_each_column_is_its_title() {
        let text = "% made by a program\n% column 1: Time [s]\n% column 2: True Strain\n%\n1 2\n3 4\n";
        assert_eq!(titles(text), ["Time [s]", "True Strain"]);
    }

    #[test]
    fn titles_again_begin_another_block() {
        for text in ["a,b\n1,2\n3,4\na,b\n5,6\n", "a,b\n1,2\n3,4\n\nSpecimen 2\nA,B\n5,6\n"] {
            let sheet = sheet(text);
            assert_eq!(sheet.tables[0].blocks.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1]);
        }
    }

    #[test]
    fn other_titles_begin_another_table() {
        let sheet = sheet("Specimen,Peak\n1,2\n2,4\n\ntime,load,strain\n1,2,3\n5,6,7\n");
        assert_eq!(sheet.tables.iter().map(Body::len).collect::<Vec<_>>(), [2, 2]);
        assert_eq!(sheet.tables[1].titles, ["time", "load", "strain"]);
    }

    #[test]
    fn a_line_that_is_no_row_is_refused_by_its_number() {
        let error = parse(b"a,b\n1,2\n3,4\npause\n5,6\n7,8\n", &Layout::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 4: \"pause\" is refused"), "{error}");
        let text = b"a,b\n1,2\n3,4\ntrigger,start\n5,6\n7,8\n9,1\n2,3\n";
        let error = parse(text, &Layout::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 4: \"trigger,start\" is refused"), "{error}");
        let error = parse(b"a,b\n1,2\n3,4\n5,6,7\n", &Layout::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 4: 3 cells in a table of 2 columns"), "{error}");
        for empty in ["", "strain,stress\n", "hello\nworld\n", "# only a comment"] {
            assert!(parse(empty.as_bytes(), &Layout::default()).is_err(), "{empty}");
        }
    }

    #[test]
    fn names_dates_and_missing_values_stand_beside_numbers() {
        let sheet =
            sheet("date;by;a;b\n2024-01-02 10:00:00;me;1,5;2\n02.01.2024;me;nan;-\n-;-;-;-\n3.1.2024;you;2;3\n");
        assert_eq!(sheet.tables[0].titles, ["date", "by", "a", "b"]);
        assert_eq!((sheet.tables[0].blocks[0].len(), sheet.missing), (2, 2));
    }

    #[test]
    fn a_blank_is_no_group_of_thousands_beside_a_decimal_comma() {
        assert_eq!(numbers(&sheet("a b\n10 200,5\n20 300,5\n")), [[10.0, 200.5], [20.0, 300.5]]);
        assert_eq!(numbers(&sheet("a;b\n1;1 200,5\n2;1 300,5\n")), [[1.0, 1200.5], [2.0, 1300.5]]);
    }

    #[test]
    fn groups_of_thousands_are_told_apart_from_fractions() {
        for text in [
            "a,b\n1,\"54,711\"\n2,\"101,111\"\n",
            "a;b\n1;54,711\n2.5;101,111\n",
            "a\tb\n0.1\t54,711\n0.2\t101,111\n",
            "a;b\n0,1;54.711\n0,2;101.111\n",
        ] {
            let read = numbers(&sheet(text));
            assert_eq!([read[0][1], read[1][1]], [54711.0, 101111.0], "{text}");
        }
        assert_eq!(numbers(&sheet("a,b\n1,54.711\n2,10.111\n")), [[1.0, 54.711], [2.0, 10.111]]);
        let text = "a;b\n1;54,711\n2;101,111\n";
        let error = parse(text.as_bytes(), &Layout::default()).unwrap_err().to_string();
        assert!(error.starts_with("line 2: \"54,711\" is 54711 with a decimal point and 54.711 with"), "{error}");
        assert!(error.contains("expected --decimal point or --decimal comma"), "{error}");
        for (decimal, number) in [(number::Decimal::Point, 54711.0), (number::Decimal::Comma, 54.711)] {
            let layout = Layout { decimal: Some(decimal), ..Layout::default() };
            assert_eq!(numbers(&parse(text.as_bytes(), &layout).unwrap())[0][1], number);
        }
    }

    #[test]
    fn what_is_no_table_is_refused_at_its_first_line_of_digits() {
        let error = parse(b"strain;stress\n10 %;0.2 MPa\n", &Layout::default()).unwrap_err().to_string();
        assert!(error.starts_with("line 2: \"10 %;0.2 MPa\" is no row"), "{error}");
    }

    #[test]
    fn numbers_without_titles_have_none() {
        assert!(titles("1.0 2.0\n3.0 4.0\n").is_empty());
    }

    #[test]
    fn one_number_in_a_line_is_a_column() {
        let sheet = sheet("Rate: 20 kHz\nForce [N]\n0.5\n1.5\n2.5\n3.5\n");
        assert_eq!((sheet.tables[0].titles[0].as_str(), sheet.tables[0].len()), ("Force [N]", 4));
    }
}
