//! EXR pictures without the feature `programs`: there are none.

use super::{OutputError, Provenance};
use crate::render::Film;

pub(super) fn bytes(_: &Film, _: &Provenance) -> Result<Vec<u8>, OutputError> {
    let why = "halfdisk was built without its feature `programs`".to_owned();
    Err(OutputError::Encoding("EXR".to_owned(), why))
}
