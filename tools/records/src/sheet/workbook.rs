//! The tables in a workbook: XLSX, XLSB, XLS or ODS.

use softanvil_workbooks::Workbook;

use super::assembly::of_lines;
use super::table::{Layout, Sheet};
use crate::ReadError;
use crate::cells::Separator;
use crate::number::Decimal;
use crate::text::Lines;

/// The tables in the workbook `bytes`, in the sheet that `layout` names, or in the only one that has any.
///
/// # Errors
/// No workbook, no such sheet, several sheets with tables, or what [`of_lines`] refuses.
pub fn parse(bytes: &[u8], layout: &Layout) -> Result<Sheet, ReadError> {
    let mut workbook = Workbook::open(bytes).map_err(ReadError::file)?;
    let names = workbook.names();
    if let Some(name) = &layout.sheet {
        let Some(name) = names.iter().find(|known| *known == name) else {
            return Err(ReadError::file(format!("--sheet {name} is refused: expected {}", quoted(&names))));
        };
        return table(&mut workbook, name);
    }
    let mut found = Vec::new();
    let mut refused = None;
    for name in &names {
        match table(&mut workbook, name) {
            Ok(sheet) => found.push(sheet),
            Err(error) => refused = refused.or(Some((name, error))),
        }
    }
    match (found.len(), refused) {
        (1, _) => Ok(found.remove(0)),
        (0, Some((name, error))) => Err(ReadError::file(format!("sheet \"{name}\": {error}"))),
        (0, None) => Err(ReadError::file("a workbook without sheets")),
        _ => {
            let names: Vec<String> = found.iter().filter_map(|sheet| sheet.name.clone()).collect();
            Err(ReadError::file(format!("tables in the sheets {}: name one with --sheet", quoted(&names))))
        }
    }
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ")
}

/// The tables in the sheet `name`: its rows as lines, with tabs between the cells.
fn table(workbook: &mut Workbook, name: &str) -> Result<Sheet, ReadError> {
    let lines = Lines::of(workbook.text(name).map_err(ReadError::file)?, "workbook");
    let mut sheet = of_lines(lines, Some(Decimal::Point), Some(Separator::Sign(b'\t')))?;
    sheet.name = Some(name.into());
    Ok(sheet)
}
