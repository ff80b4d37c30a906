//! The exact state of a render in an EXR file, beside its picture.
//!
//! Each `f64` is two channels of whole numbers, its upper and lower 32 bits: halves and floats would round it. All
//! are in layers `state...`, so that what reads pictures finds `R`, `G` and `B` as in any other file. A checksum
//! over them and over the facts stands in the text attribute, for the compression of the format notices only some
//! changes.

use super::{OutputError, Provenance};
use crate::render::{Film, Pixel, State, Tally};
use crate::stats::Estimate;
use exr::meta::MetaData;
use exr::meta::attribute::AttributeValue;
use exr::prelude::*;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::Cursor;
use std::path::Path;
use std::result::Result;

/// What the text attribute says.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Facts {
    /// What made the picture.
    #[serde(flatten)]
    pub provenance: Provenance,
    /// What is known of all its pixels together, where the file has the state of each.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub state: Option<Summary>,
}

/// The state but for that of each pixel.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Summary {
    #[serde(flatten)]
    pub tally: Tally,
    /// The size of the picture, where the file has the tiles of a shard, one below the other.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub picture: Option<[u32; 2]>,
    /// SHA-256 of all of it, as hexadecimal digits.
    pub checksum: String,
}

/// The numbers of a pixel: those of all samples, and of its runs where samples lie evenly.
const ALL: usize = 28;
const WITHOUT_RUNS: usize = ALL / 2;

/// The names of the channels that hold them.
fn names() -> [String; ALL] {
    let mut all = Vec::with_capacity(ALL);
    for (layer, counts) in [
        ("state", ["taken", "count"]),
        ("state.runs", ["taken", "count"]),
    ] {
        all.extend(counts.map(|count| format!("{layer}.{count}")));
        for channel in ["R", "G", "B"] {
            for part in ["mean.high", "mean.low", "m2.high", "m2.low"] {
                all.push(format!("{layer}.{channel}.{part}"));
            }
        }
    }
    std::array::from_fn(|i| std::mem::take(&mut all[i]))
}

/// A pixel as whole numbers.
fn numbers(pixel: &Pixel) -> [u32; ALL] {
    let mut all = [0; ALL];
    let halves = [
        (u64::from(pixel.taken), &pixel.channels),
        (pixel.in_runs, &pixel.runs),
    ];
    for (half, (taken, estimates)) in all.chunks_exact_mut(WITHOUT_RUNS).zip(halves) {
        half[0] = taken as u32;
        half[1] = estimates[0].count() as u32;
        for (four, estimate) in half[2..].chunks_exact_mut(4).zip(estimates) {
            let (_, mean, m2) = estimate.parts();
            let [mean, m2] = [mean, m2].map(f64::to_bits);
            four.copy_from_slice(&[
                (mean >> 32) as u32,
                mean as u32,
                (m2 >> 32) as u32,
                m2 as u32,
            ]);
        }
    }
    all
}

/// The pixel of whole numbers.
fn pixel(all: &[u32; ALL]) -> Pixel {
    let estimates = |half: &[u32]| {
        let number =
            |at: usize| f64::from_bits(u64::from(half[at]) << 32 | u64::from(half[at + 1]));
        [2, 6, 10].map(|at| Estimate::from_parts(half[1].into(), number(at), number(at + 2)))
    };
    let (samples, runs) = all.split_at(WITHOUT_RUNS);
    Pixel {
        taken: samples[0],
        channels: estimates(samples),
        in_runs: runs[0].into(),
        runs: estimates(runs),
    }
}

/// The channels of the state of a film.
pub(super) fn channels(film: &Film) -> Vec<AnyChannel<FlatSamples>> {
    let mut columns = [const { Vec::new() }; ALL];
    for pixel in film.pixels() {
        columns
            .iter_mut()
            .zip(numbers(pixel))
            .for_each(|(column, x)| column.push(x));
    }
    let has_runs = film.pixels().iter().any(|pixel| pixel.in_runs > 0);
    let used = if has_runs { ALL } else { WITHOUT_RUNS };
    let named = names().into_iter().zip(columns).take(used);
    named
        .map(|(name, column)| AnyChannel::new(name.as_str(), FlatSamples::U32(column)))
        .collect()
}

/// The checksum of a state, and of what made it.
pub(super) fn checksum(
    film: &Film,
    provenance: &Provenance,
    tally: &Tally,
    picture: Option<[u32; 2]>,
) -> Result<String, String> {
    let facts = serde_json::to_vec(&(provenance, tally)).map_err(|e| e.to_string())?;
    let mut hash = Sha256::new();
    hash.update(film.width().to_le_bytes());
    hash.update((facts.len() as u64).to_le_bytes());
    hash.update(facts);
    let size = picture.into_iter().flatten();
    size.for_each(|n| hash.update(n.to_le_bytes()));
    for pixel in film.pixels() {
        numbers(pixel)
            .iter()
            .for_each(|x| hash.update(x.to_le_bytes()));
    }
    Ok(hash
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect())
}

/// A state, with the size of the picture where it has the film of a shard.
pub(super) type Packed = (State, Option<[u32; 2]>);

/// What the text attribute of a layer says.
fn said(attributes: &LayerAttributes) -> Result<Facts, String> {
    let Some(AttributeValue::Text(text)) = attributes.other.get(&Text::from("halfdisk")) else {
        return Err("was not written by halfdisk".to_owned());
    };
    serde_json::from_str(&text.to_string())
        .map_err(|e| format!("was written by another version of halfdisk: {e}"))
}

/// What the head of an EXR file says made its picture, and the size of this, where it has the state of the render. Nothing
/// is compared with the checksum, which takes all of the file.
pub(super) fn facts(path: &Path) -> Result<(Provenance, Option<[u32; 2]>), OutputError> {
    let name = || path.display().to_string();
    let file = File::open(path).map_err(|e| OutputError::File(name(), e))?;
    let head = || {
        let data = MetaData::read_from_unbuffered(file, false)
            .map_err(|e| format!("is no EXR picture that can be read: {e}"))?;
        let header = data.headers.first().ok_or("has no layer")?;
        let facts = said(&header.own_attributes)?;
        let Vec2(width, height) = header.layer_size;
        let own = [width as u32, height as u32];
        let size = facts.state.map(|state| state.picture.unwrap_or(own));
        Ok((facts.provenance, size))
    };
    head().map_err(|what| OutputError::Reading(name(), what))
}

/// What made the picture of an EXR file, and the exact state of its render, where the file has one.
pub(super) fn read(bytes: &[u8]) -> Result<(Provenance, Option<State>), String> {
    let (facts, packed) = read_packed(bytes)?;
    let whole = |(mut state, picture): Packed| {
        if let (Some(shard), Some(size)) = (facts.shard, picture) {
            let mut film = Film::empty(size);
            film.unpack(&state.film, shard);
            state.film = film;
        }
        state
    };
    let state = packed.map(whole);
    Ok((facts, state))
}

/// The same with the film of a shard as it is in the file, [packed](Film::packed), and the size of its picture.
pub(super) fn read_packed(bytes: &[u8]) -> Result<(Provenance, Option<Packed>), String> {
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(|e| format!("is no EXR picture that can be read: {e}"))?;
    let layer = image.layer_data;
    let facts = said(&layer.attributes)?;
    let Some(Summary {
        tally,
        picture,
        checksum: expected,
    }) = facts.state
    else {
        return Ok((facts.provenance, None));
    };
    let names = names();
    let find = |name: &String| {
        let mut all = layer.channel_data.list.iter();
        all.find(|channel| channel.name.eq(name.as_str()))
            .map(|channel| &channel.sample_data)
    };
    let size = layer.size;
    let mut pixels = vec![[0; ALL]; size.area()];
    for (i, name) in names.iter().enumerate() {
        match find(name) {
            Some(FlatSamples::U32(column)) => {
                pixels
                    .iter_mut()
                    .zip(column)
                    .for_each(|(pixel, x)| pixel[i] = *x);
            }
            None if i >= WITHOUT_RUNS => {}
            _ => {
                return Err(format!(
                    "is damaged: it has no channel {name} of whole numbers"
                ));
            }
        }
    }
    let film = Film::new(size.width() as u32, pixels.iter().map(pixel).collect());
    let own = [film.width(), film.height()];
    let fits = match (facts.provenance.shard, picture) {
        (Some(shard), Some(size)) => own == Film::packed_size(shard, size),
        (None, None) => true,
        _ => false,
    };
    match fits && checksum(&film, &facts.provenance, &tally, picture)? == expected {
        true => Ok((facts.provenance, Some((State { film, tally }, picture)))),
        false => Err("is damaged: what it says of its render does not fit its checksum".to_owned()),
    }
}
