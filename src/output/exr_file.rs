//! OpenEXR: 32-bit floats, with errors and sample counts as further channels.

use super::state_file::{self, Facts, Summary};
use super::{OutputError, Provenance};
use crate::render::{Film, Pixel};
use exr::prelude::*;
use std::io::Cursor;

pub(super) use super::state_file::{Packed, facts, read, read_packed};

/// A film as an EXR file.
///
/// The root layer `R`, `G`, `B` holds the mean and nothing else, so that every reader finds a picture;
/// the layer `error.R`, `error.G`, `error.B` its standard error (infinite from one sample; of even
/// samples from the scatter of their runs); the layer `samples.Y` how many finite samples the pixel
/// has. A pixel without one is NaN. The provenance is the text attribute `halfdisk`: a single attribute, because the
/// order of several is not stable from run to run.
///
/// With [`Provenance::tally`] it has the exact state of the render, too: see [`state_file`]. A shard's file then shows its
/// tiles alone, one below the other, so that it takes no more than its share of room and time.
pub fn bytes(film: &Film, provenance: &Provenance) -> std::result::Result<Vec<u8>, OutputError> {
    encode(film, provenance).map_err(|e| OutputError::Encoding("EXR".to_owned(), e))
}

fn encode(film: &Film, provenance: &Provenance) -> std::result::Result<Vec<u8>, String> {
    let shard = provenance.shard.filter(|_| provenance.tally.is_some());
    let picture = shard.map(|_| [film.width(), film.height()]);
    let packed = shard.map(|shard| film.packed(shard));
    let film = packed.as_ref().unwrap_or(film);
    let channel = |name: &str, value: &dyn Fn(&Pixel) -> f64| {
        let values: Vec<f32> = film.pixels().iter().map(|p| value(p) as f32).collect();
        AnyChannel::new(name, FlatSamples::F32(values))
    };
    let mean = |i: usize| move |p: &Pixel| p.mean().map_or(f64::NAN, |m| m[i]);
    let error = |i: usize| move |p: &Pixel| p.std_errors()[i];
    let mut channels = vec![
        channel("R", &mean(0)),
        channel("G", &mean(1)),
        channel("B", &mean(2)),
        channel("error.R", &error(0)),
        channel("error.G", &error(1)),
        channel("error.B", &error(2)),
        channel("samples.Y", &|p| p.count() as f64),
    ];
    let mut facts = Facts {
        provenance: provenance.clone(),
        state: None,
    };
    if let Some(tally) = &provenance.tally {
        channels.extend(state_file::channels(film));
        facts.state = Some(Summary {
            tally: *tally,
            picture,
            checksum: state_file::checksum(film, provenance, tally, picture)?,
        });
    }
    let facts = serde_json::to_string(&facts).map_err(|e| e.to_string())?;
    let mut attributes = LayerAttributes::default();
    attributes.other.insert(
        Text::from("halfdisk"),
        exr::meta::attribute::AttributeValue::Text(Text::from(facts.as_str())),
    );
    let size = (film.width() as usize, film.height() as usize);
    let layer = Layer::new(
        size,
        attributes,
        Encoding {
            compression: Compression::ZIP16,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        AnyChannels::sort(channels.into_iter().collect()),
    );
    let mut file = Cursor::new(Vec::new());
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut file)
        .map_err(|e| e.to_string())?;
    Ok(file.into_inner())
}
