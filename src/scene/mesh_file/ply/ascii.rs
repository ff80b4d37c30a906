//! Rows of ascii PLY files.

use super::{CORNER_UVS, CORNERS, Row, improper};
use crate::scene::mesh_file::start;
use ply_rs_bw::parser::Reader;
use ply_rs_bw::ply::{ElementDef, PropertyAccess, PropertyType};
use std::io::BufRead;

/// The lines after the header of an ascii file, one for each row.
///
/// Not left to the parser: what is said in decimals is a number, whatever type the header calls it,
/// so that a coordinate keeps all its digits.
pub(super) struct Lines<'a> {
    pub(super) rest: &'a [u8],
    line: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn after(reader: &mut Reader<&'a [u8]>) -> Self {
        Lines {
            rest: reader.get_ref(),
            line: reader.line().saturating_sub(1),
        }
    }

    /// The next line that is not empty, as text.
    fn next(&mut self, element: &str) -> Result<String, String> {
        loop {
            let mut line = Vec::new();
            self.line += 1;
            match self.rest.read_until(b'\n', &mut line) {
                Ok(0) => {
                    let what = format!("end of file where a row of `{element}` should be");
                    return Err(improper(&what));
                }
                Ok(_) if line.iter().all(u8::is_ascii_whitespace) => {}
                Ok(_) => return Ok(String::from_utf8_lossy(&line).into_owned()),
                Err(e) => return Err(format!("cannot be read: {e}")),
            }
        }
    }

    pub(super) fn row(&mut self, element: &ElementDef) -> Result<Row, String> {
        let text = self.next(&element.name)?;
        let line = self.line;
        let complain = |what: String| improper(&format!("Line {line}: {what}"));
        let mut words = text.split_whitespace();
        let mut next = |name: &str| {
            let lacks = || complain(format!("`{name}` of element `{}` is missing", element.name));
            words.next().ok_or_else(lacks)
        };
        let real = |word: &str| {
            let value = word.parse::<f64>().ok();
            value.ok_or_else(|| complain(format!("{:?} is not a number", start(word))))
        };
        let whole = |word: &str| {
            let value = word.parse::<i64>().ok();
            value.ok_or_else(|| complain(format!("{:?} is not a whole number", start(word))))
        };
        let mut row = Row::new();
        for (name, property) in &element.properties {
            match property.data_type {
                PropertyType::Scalar(_) => {
                    let value = real(next(name)?)?;
                    if let Some(coordinate) = row.coordinate(name) {
                        *coordinate = value;
                    }
                }
                PropertyType::List(..) => {
                    let count = whole(next(name)?)?;
                    let is_corners = CORNERS.contains(&name.as_str());
                    let is_uvs = name == CORNER_UVS;
                    for _ in 0..count {
                        let word = next(name)?;
                        if is_corners {
                            row.corners.push(whole(word)?);
                        } else {
                            let value = real(word)?;
                            row.corner_uvs.extend(is_uvs.then_some(value));
                        }
                    }
                    if count < 0 {
                        return Err(complain(format!("a list of {count} numbers")));
                    }
                }
            }
        }
        match words.next() {
            None => Ok(row),
            Some(_) => Err(complain(format!(
                "a row of `{}` has more numbers than the header says",
                element.name
            ))),
        }
    }
}
