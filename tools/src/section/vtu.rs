//! Unstructured grids as XML files of VTK (VTU). Every array is inline: base64 of its length in bytes and its numbers, both
//! little-endian (VTK file formats, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>).

use std::io;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use quick_xml::Writer;
use quick_xml::events::BytesText;

type Xml = Writer<Vec<u8>>;

/// Kind of a cell, by VTK's number.
#[derive(Clone, Copy)]
#[repr(u8)]
pub enum Cell {
    /// Two nodes.
    Line = 3,
    /// Three nodes.
    Triangle = 5,
    /// Four nodes.
    Tetrahedron = 10,
}

/// Numbers at the points or the cells of a grid.
pub struct Array {
    /// What they are.
    pub name: &'static str,
    /// How many there are at each.
    pub components: usize,
    /// All of them, one point or cell after the other.
    pub values: Vec<f64>,
}

/// Points, cells of one kind that join them, and what is known at both.
pub struct Grid {
    /// x, y and z of every point.
    pub points: Vec<f64>,
    /// The kind of every cell.
    pub kind: Cell,
    /// Numbers of each cell's points.
    pub cells: Vec<Vec<usize>>,
    /// At the points.
    pub point_data: Vec<Array>,
    /// At the cells.
    pub cell_data: Vec<Array>,
}

impl Grid {
    /// The file.
    ///
    /// # Errors
    /// What the XML library refuses.
    pub fn file(&self) -> io::Result<Vec<u8>> {
        let mut xml = Writer::new(Vec::new());
        let about = [
            ("type", "UnstructuredGrid"),
            ("version", "1.0"),
            ("byte_order", "LittleEndian"),
            ("header_type", "UInt64"),
        ];
        xml.create_element("VTKFile").with_attributes(about).write_inner_content(|xml| {
            xml.create_element("UnstructuredGrid").write_inner_content(|xml| self.piece(xml))?;
            Ok(())
        })?;
        Ok(xml.into_inner())
    }

    fn piece(&self, xml: &mut Xml) -> io::Result<()> {
        let sizes = [(self.points.len() / 3).to_string(), self.cells.len().to_string()];
        let sizes = [("NumberOfPoints", sizes[0].as_str()), ("NumberOfCells", sizes[1].as_str())];
        xml.create_element("Piece").with_attributes(sizes).write_inner_content(|xml| {
            data(xml, "PointData", &self.point_data)?;
            data(xml, "CellData", &self.cell_data)?;
            xml.create_element("Points").write_inner_content(|xml| array(xml, "Float64", "Points", 3, &self.points))?;
            xml.create_element("Cells").write_inner_content(|xml| self.topology(xml))?;
            Ok(())
        })?;
        Ok(())
    }

    fn topology(&self, xml: &mut Xml) -> io::Result<()> {
        let connectivity: Vec<u64> = self.cells.iter().flatten().map(|point| *point as u64).collect();
        let offsets: Vec<u64> = (self.cells.iter())
            .scan(0, |end, cell| {
                *end += cell.len() as u64;
                Some(*end)
            })
            .collect();
        array(xml, "UInt64", "connectivity", 1, &connectivity)?;
        array(xml, "UInt64", "offsets", 1, &offsets)?;
        array(xml, "UInt8", "types", 1, &vec![self.kind as u8; self.cells.len()])
    }
}

fn data(xml: &mut Xml, place: &str, arrays: &[Array]) -> io::Result<()> {
    xml.create_element(place).write_inner_content(|xml| {
        arrays.iter().try_for_each(|one| array(xml, "Float64", one.name, one.components, &one.values))
    })?;
    Ok(())
}

fn array<T: Number>(xml: &mut Xml, kind: &str, name: &str, components: usize, values: &[T]) -> io::Result<()> {
    let mut bytes = (size_of_val(values) as u64).to_le_bytes().to_vec();
    values.iter().for_each(|value| value.put(&mut bytes));
    let text = BASE64_STANDARD.encode(bytes);
    let mut element = xml.create_element("DataArray").with_attributes([("type", kind), ("Name", name)]);
    // Readers take an array of one component for a matrix of one column where the number stands.
    if components > 1 {
        element = element.with_attribute(("NumberOfComponents", components.to_string().as_str()));
    }
    element.with_attribute(("format", "binary")).write_text_content(BytesText::from_escaped(text))?;
    Ok(())
}

/// A number that stands in a file.
trait Number {
    /// Puts its bytes behind the others, the least first.
    fn put(&self, bytes: &mut Vec<u8>);
}

impl Number for f64 {
    fn put(&self, bytes: &mut Vec<u8>) {
        bytes.extend(self.to_le_bytes());
    }
}

impl Number for u64 {
    fn put(&self, bytes: &mut Vec<u8>) {
        bytes.extend(self.to_le_bytes());
    }
}

impl Number for u8 {
    fn put(&self, bytes: &mut Vec<u8>) {
        bytes.push(*self);
    }
}
