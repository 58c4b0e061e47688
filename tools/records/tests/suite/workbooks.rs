//! Workbooks: XLSX and ODS as spreadsheets write them, and what is none.

use std::io::{Cursor, Write};

use softanvil_records::column::Kind;
use softanvil_records::number::Decimal;
use softanvil_records::series::Table;
use softanvil_records::sheet::{self, Layout};
use softanvil_records::trace::{self, Options};
use zip::write::{SimpleFileOptions, ZipWriter};

use crate::common::{EXPECTED, assert_impact, impact};

type Rows<'a> = &'a [Vec<&'a str>];

fn archive(files: &[(&str, String)]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in files {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(content.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// A workbook with `sheets`; cells that are numbers are written as such.
pub fn xlsx(sheets: &[(&str, Rows)]) -> Vec<u8> {
    let cell = |row: usize, column: usize, text: &str| {
        let name = format!("{}{}", char::from(b'A' + column as u8), row + 1);
        match text.parse::<f64>() {
            Ok(_) => format!("<c r=\"{name}\"><v>{text}</v></c>"),
            Err(_) => format!("<c r=\"{name}\" t=\"inlineStr\"><is><t>{text}</t></is></c>"),
        }
    };
    let row = |(number, cells): (usize, &Vec<&str>)| {
        let cells: String = cells.iter().enumerate().map(|(column, text)| cell(number, column, text)).collect();
        format!("<row r=\"{}\">{cells}</row>", number + 1)
    };
    let data: Vec<String> = sheets.iter().map(|(_, rows)| rows.iter().enumerate().map(row).collect()).collect();
    let names: Vec<&str> = sheets.iter().map(|sheet| sheet.0).collect();
    of_xml(&names, &data)
}

/// A workbook of sheets with `data` as XML.
fn of_xml(names: &[&str], data: &[String]) -> Vec<u8> {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let relations = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let package = "http://schemas.openxmlformats.org/package/2006";
    let (mut list, mut links, mut types) = (String::new(), String::new(), String::new());
    for (index, name) in names.iter().enumerate() {
        let id = index + 1;
        list += &format!("<sheet name=\"{name}\" sheetId=\"{id}\" r:id=\"rId{id}\"/>");
        links += &format!(
            "<Relationship Id=\"rId{id}\" Type=\"{relations}/worksheet\" Target=\"worksheets/sheet{id}.xml\"/>"
        );
        types += &format!(
            "<Override PartName=\"/xl/worksheets/sheet{id}.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml\"/>"
        );
    }
    let head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
    let mut files = vec![
        (
            "[Content_Types].xml",
            format!(
                "{head}<Types xmlns=\"{package}/content-types\"><Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Override PartName=\"/xl/workbook.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml\"/>{types}</Types>"
            ),
        ),
        (
            "_rels/.rels",
            format!(
                "{head}<Relationships xmlns=\"{package}/relationships\"><Relationship Id=\"rId1\" Type=\"{relations}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
            ),
        ),
        (
            "xl/workbook.xml",
            format!("{head}<workbook xmlns=\"{main}\" xmlns:r=\"{relations}\"><sheets>{list}</sheets></workbook>"),
        ),
        (
            "xl/_rels/workbook.xml.rels",
            format!("{head}<Relationships xmlns=\"{package}/relationships\">{links}</Relationships>"),
        ),
    ];
    // Styles 1 to 3: a clock, a percentage, a duration.
    let styles = ["0", "164", "10", "46"].map(|id| format!("<xf numFmtId=\"{id}\" applyNumberFormat=\"1\"/>")).concat();
    files.push((
        "xl/styles.xml",
        format!(
            "{head}<styleSheet xmlns=\"{main}\"><numFmts count=\"1\"><numFmt numFmtId=\"164\" formatCode=\"mm:ss.000\"/></numFmts><cellXfs count=\"4\">{styles}</cellXfs></styleSheet>"
        ),
    ));
    let paths: Vec<String> = (1..=data.len()).map(|id| format!("xl/worksheets/sheet{id}.xml")).collect();
    for (path, data) in paths.iter().zip(data) {
        files.push((path, format!("{head}<worksheet xmlns=\"{main}\"><sheetData>{data}</sheetData></worksheet>")));
    }
    archive(&files)
}

/// An OpenDocument spreadsheet with one sheet.
pub fn ods(rows: Rows) -> Vec<u8> {
    let percentage = |text: &str| {
        let part = text.strip_suffix('%')?.parse::<f64>().ok()? / 100.0;
        Some(format!(
            "<table:table-cell table:formula=\"of:=IF([.A1]>0;1;0)\" office:value=\"{part}\" \
             office:value-type=\"percentage\"><text:p>{text}</text:p></table:table-cell>"
        ))
    };
    let plain = |text: &&str| match text.parse::<f64>() {
        Ok(_) => format!(
            "<table:table-cell office:value-type=\"float\" office:value=\"{text}\"><text:p>{text}</text:p></table:table-cell>"
        ),
        Err(_) => format!("<table:table-cell office:value-type=\"string\"><text:p>{text}</text:p></table:table-cell>"),
    };
    let cell = |text: &&str| percentage(text).unwrap_or_else(|| plain(text));
    let row = |cells: &Vec<&str>| {
        format!("<table:table-row>{}</table:table-row>", cells.iter().map(cell).collect::<String>())
    };
    let rows: String = rows.iter().map(row).collect();
    let urn = "urn:oasis:names:tc:opendocument:xmlns";
    let content = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><office:document-content xmlns:office=\"{urn}:office:1.0\" xmlns:table=\"{urn}:table:1.0\" \
         xmlns:text=\"{urn}:text:1.0\" office:version=\"1.2\"><office:body><office:spreadsheet><table:table table:name=\"Drop\">{rows}\
         </table:table></office:spreadsheet></office:body></office:document-content>"
    );
    let kind = "application/vnd.oasis.opendocument.spreadsheet";
    let manifest = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><manifest:manifest xmlns:manifest=\"{urn}:manifest:1.0\"><manifest:file-entry manifest:full-path=\"/\" manifest:media-type=\"{kind}\"/></manifest:manifest>"
    );
    archive(&[("mimetype", kind.into()), ("META-INF/manifest.xml", manifest), ("content.xml", content)])
}

fn cells() -> Vec<Vec<String>> {
    let mut rows = vec![vec!["Drop 3".to_string(), String::new()], vec!["Mass".into(), "5 kg".into()]];
    rows.push(vec!["Time".into(), "Acceleration".into()]);
    rows.push(vec!["ms".into(), "g".into()]);
    let number = |(time, force): (f64, f64)| vec![(1e3 * time).to_string(), (force / 5.0 / 9.80665).to_string()];
    rows.extend(impact().into_iter().map(number));
    rows
}

#[test]
fn workbooks_are_read_like_text() {
    let cells = cells();
    let rows: Vec<Vec<&str>> = cells.iter().map(|row| row.iter().map(String::as_str).collect()).collect();
    let parameters = vec![vec!["Parameter", "Value"], vec!["Operator", "me"]];
    let mut remarked = rows.clone();
    remarked[4].push("begin of the record");
    for (name, bytes) in [
        ("XLSX", xlsx(&[("Drop", &rows)])),
        ("XLSX with a sheet of words", xlsx(&[("Parameters", &parameters), ("Drop", &rows)])),
        ("XLSX with a remark", xlsx(&[("Drop", &remarked)])),
        ("ODS", ods(&rows)),
    ] {
        let trace = trace::read("drop", &bytes, &Options::default(), Some(&EXPECTED))
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_impact(&trace, 1e-6, name);
        assert_eq!(trace.understood.get("file").unwrap()["sheet"], "Drop");
    }
}

#[test]
fn columns_of_a_workbook_are_those_of_text() {
    let rows = vec![vec!["Dehnung", "Spannung"], vec!["%", "MPa"], vec!["10", "0.5"], vec!["20", "1.25e-3"]];
    let sheet = sheet::parse(&xlsx(&[("Probe", &rows)]), &Layout::default()).unwrap();
    let table = Table::new(sheet, None).unwrap();
    let stress = table.of(Kind::Stress).next().unwrap();
    assert_eq!((stress.si, stress.title.as_str()), (Some(1e6), "Spannung [MPa]"));
    let values: Vec<_> = table.series[0].rows.iter().map(|row| table.value(stress, row).unwrap()).collect();
    assert_eq!(values, [Some(0.5), Some(1.25e-3)]);
}

/// Rows of cells in XML under a row of titles.
fn titled(titles: &[&str], rows: impl Iterator<Item = [String; 2]>) -> Vec<u8> {
    let text = |text: &str| format!("<c t=\"inlineStr\"><is><t>{text}</t></is></c>");
    let head = format!("<row>{}</row>", titles.iter().map(|title| text(title)).collect::<String>());
    let rows: String = rows.map(|cells| format!("<row>{}</row>", cells.concat())).collect();
    of_xml(&["Drop"], &[head + &rows])
}

#[test]
fn times_and_durations_are_seconds() {
    for style in [1, 3] {
        for (title, si) in [("Time", "s"), ("time [s]", "s"), ("time [ms]", "ms")] {
            let row = |(time, force): (f64, f64)| {
                [format!("<c s=\"{style}\"><v>{}</v></c>", time / 86_400.0), format!("<c><v>{force}</v></c>")]
            };
            let bytes = titled(&[title, "force [N]"], impact().into_iter().map(row));
            let trace = trace::read("drop", &bytes, &Options::default(), Some(&EXPECTED))
                .unwrap_or_else(|error| panic!("{title}, {style}: {error}"));
            assert_impact(&trace, 1e-6, si);
        }
    }
}

#[test]
fn a_percentage_keeps_its_meaning() {
    for title in ["strain", "strain [%]", "strain [-]"] {
        let row = |strain: &f64| [format!("<c s=\"2\"><v>{strain}</v></c>"), "<c><v>5</v></c>".to_string()];
        let xlsx = titled(&[title, "stress [kPa]"], [0.1, 0.2].iter().map(row));
        let rows = [vec![title, "stress [kPa]"], vec!["10%", "5"], vec!["20%", "5"]];
        for (kind, bytes) in [("XLSX", xlsx), ("ODS", ods(&rows))] {
            let table = Table::new(sheet::parse(&bytes, &Layout::default()).unwrap(), None).unwrap();
            let strain = table.of(Kind::Strain).next().unwrap();
            let rows = &table.series[0].rows;
            let values: Vec<f64> =
                rows.iter().map(|row| table.value(strain, row).unwrap().unwrap() * strain.si.unwrap()).collect();
            assert_eq!(values.len(), 2, "{kind}");
            for (value, expected) in values.into_iter().zip([0.1, 0.2]) {
                assert!((value - expected).abs() < 1e-12, "{kind}, {title}: {value}");
            }
        }
    }
}

#[test]
fn numbers_typed_as_text_have_their_decimal_sign() {
    let typed = |text: String| format!("<c t=\"inlineStr\"><is><t>{text}</t></is></c>");
    let bytes = |number: &dyn Fn(f64) -> String| {
        let row = |(time, force): (f64, f64)| [typed(number(time)), typed(number(force))];
        titled(&["time [s]", "force [N]"], impact().into_iter().map(row))
    };
    let read = |bytes: &[u8], decimal| {
        let options = Options { layout: Layout { decimal, ..Layout::default() }, ..Options::default() };
        trace::read("drop", bytes, &options, Some(&EXPECTED))
    };
    let comma = bytes(&|number| format!("{number:.6}").replace('.', ","));
    for decimal in [None, Some(Decimal::Comma)] {
        assert_impact(&read(&comma, decimal).unwrap(), 1e-5, "typed with commas");
    }
    assert!(read(&comma, Some(Decimal::Point)).is_err());
    assert_impact(&read(&bytes(&|number| format!("{number:.6}")), None).unwrap(), 1e-5, "typed with points");
    // Every number as 54,711.
    let row = |i: u32| [typed(format!("{i},000")), typed(format!("{},711", 50 + i))];
    let two = titled(&["strain [%]", "stress [kPa]"], (1..5).map(row));
    let error = sheet::parse(&two, &Layout::default()).unwrap_err().to_string();
    assert!(error.contains("\"1,000\", typed as text, has two meanings: expected --decimal"), "{error}");
    let layout = Layout { decimal: Some(Decimal::Comma), ..Layout::default() };
    let table = Table::new(sheet::parse(&two, &layout).unwrap(), None).unwrap();
    let stress = table.of(Kind::Stress).next().unwrap();
    assert_eq!(table.value(stress, &table.series[0].rows[0]).unwrap(), Some(51.711));
}

#[test]
fn one_of_several_sheets_has_to_be_named() {
    let cells = cells();
    let rows: Vec<Vec<&str>> = cells.iter().map(|row| row.iter().map(String::as_str).collect()).collect();
    let bytes = xlsx(&[("Probe 1", &rows), ("Probe 2", &rows)]);
    let read = |sheet: Option<&str>| {
        let layout = Layout { sheet: sheet.map(String::from), ..Layout::default() };
        trace::read("drop", &bytes, &Options { layout, ..Options::default() }, Some(&EXPECTED))
    };
    let error = read(None).unwrap_err().to_string();
    assert!(error.contains("tables in the sheets \"Probe 1\", \"Probe 2\": name one with --sheet"), "{error}");
    assert_impact(&read(Some("Probe 2")).unwrap(), 1e-6, "named");
    assert!(read(Some("Probe 3")).unwrap_err().to_string().contains("expected \"Probe 1\", \"Probe 2\""));
    let layout = Layout { sheet: Some("x".into()), ..Layout::default() };
    let text = trace::read("x", b"t [s],F [N]\n0,1\n1,2\n", &Options { layout, ..Options::default() }, None);
    assert!(text.unwrap_err().to_string().contains("this is text, not a workbook"));
}

#[test]
fn what_is_no_workbook_or_claims_too_much_is_refused() {
    let far = "<row r=\"1\"><c r=\"A1\"><v>1</v></c></row><row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row>";
    let wide: String = (1..3000).map(|row| format!("<row r=\"{row}\"><c r=\"XFD{row}\"><v>1</v></c></row>")).collect();
    let turned = "<row r=\"3\"><c r=\"A3\"><v>1</v></c></row><row r=\"2\"><c r=\"A2\"><v>2</v></c></row>";
    for (bytes, message) in [
        (of_xml(&["a"], &[far.into()]), "sheet \"a\": "),
        (of_xml(&["a"], &[turned.into()]), "row 2 stands after row 3: expected cells in their order"),
        (of_xml(&["a"], &[wide]), "more than 30000000 cells"),
        (b"PK\x03\x04 and nothing else".to_vec(), "this is no workbook that can be read"),
        (archive(&[("word/document.xml", "<a/>".into())]), "this is no workbook that can be read"),
        (vec![0xd0, 0xcf, 0x11, 0xe0, 0xa1, 0xb1, 0x1a, 0xe1, 0, 0, 0], "this is no workbook that can be read"),
    ] {
        let error = trace::read("x", &bytes, &Options::default(), None).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}
