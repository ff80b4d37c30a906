//! What commands let choose: integrators and samplers by name, sizes of pictures.

use crate::integrators::{self, Entry, OTHERS, VIEWS, WALKS};
use crate::scene::build::film_size;
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// The samplers by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Points {
    /// Each sample without regard to the others; their scatter tells the error of their mean
    Independent,
    /// Owen-scrambled Sobol' points in runs of up to 64: evenly spread, so the error is smaller; the
    /// scatter of the runs tells it; best with 16, 32 or a multiple of 64 samples per pixel
    Sobol,
}

/// Reads the name of an integrator.
pub(super) fn by_name() -> impl TypedValueParser<Value = Entry> {
    let all = WALKS.iter().rev().chain(&OTHERS).chain(&VIEWS);
    let values = all.map(|entry| PossibleValue::new(entry.name).help(entry.help));
    PossibleValuesParser::new(values)
        .try_map(|name| integrators::find(&name).ok_or("there is no such integrator"))
}

/// Reads the size of a picture, such as `640x480`.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let (width, height) = text.split_once(['x', 'X']).unwrap_or_default();
    let (Ok(width), Ok(height)) = (width.parse(), height.parse()) else {
        return Err("a size is two whole numbers, such as 640x480".to_owned());
    };
    // The same bounds as for a scene file, but it is not the file that is wrong here.
    film_size([width, height]).map_err(|problem| problem.what)
}
