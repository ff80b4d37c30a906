//! OpenEXR images: which channels of a file are its picture, and where they stand in it.

use super::{Pixels, check_size, complain, open};
use crate::color::Rgb;
use exr::image::pixel_vec::PixelVec;
use exr::meta::MetaData;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, ReadSpecificChannel, Text};
use std::fs::File;
use std::io::{BufReader, Seek};
use std::path::Path;

/// Names of the channels of a picture.
enum Channels {
    Colour([Text; 3]),
    Grey(Text),
}

/// Reads the picture of a file, black where its display window has no data.
///
/// It is made of the channels `R`, `G` and `B` of the first part that has them, or else of `Y`, or
/// else of those of its only layer.
pub(super) fn read(mut file: BufReader<File>, max_pixels: usize) -> Result<Pixels, String> {
    let headers = headers(&mut file)?;
    let (header, channels) = choose(&headers)?;
    pixels(file, header, &channels, max_pixels)
}

/// Reads a layer of a file, which has the channels `name.R`, `name.G` and `name.B`; `None` where there
/// is none.
pub fn layer(path: &Path, name: &str, max_pixels: usize) -> Result<Option<Pixels>, String> {
    let mut file = open(path)?;
    let headers = headers(&mut file)?;
    let found = headers
        .iter()
        .find_map(|h| Some((h, colour(h, &format!("{name}."))?)));
    let image = found.map(|(header, channels)| pixels(file, header, &channels, max_pixels));
    image.transpose()
}

fn headers(file: &mut BufReader<File>) -> Result<Vec<Header>, String> {
    let meta = MetaData::read_from_buffered(&mut *file, false).map_err(|e| complain(&e))?;
    file.rewind().map_err(|e| format!("cannot be read: {e}"))?;
    Ok(meta.headers.to_vec())
}

/// The part of a file and its channels that are the picture.
fn choose(headers: &[Header]) -> Result<(&Header, Channels), String> {
    let root = |of: fn(&Header, &str) -> Option<Channels>| {
        headers
            .iter()
            .find_map(|header| Some((header, of(header, "")?)))
    };
    if let Some(found) = root(colour).or_else(|| root(grey)) {
        return Ok(found);
    }
    let mut all = Vec::new();
    for header in headers {
        let mut layers: Vec<String> = names(header)
            .filter_map(|n| {
                let (layer, _) = n.rsplit_once('.')?;
                Some(format!("{layer}."))
            })
            .collect();
        layers.sort();
        layers.dedup();
        let of = |layer: &String| colour(header, layer).or_else(|| grey(header, layer));
        all.extend(layers.iter().filter_map(|layer| Some((header, of(layer)?))));
    }
    let (Some(only), true) = (all.pop(), all.is_empty()) else {
        let found: Vec<String> = headers.iter().flat_map(names).take(MOST_NAMES).collect();
        let more = headers.iter().flat_map(names).count() > MOST_NAMES;
        return Err(format!(
            "must have channels R, G and B, or Y, or only one layer of such; its channels are {}{}",
            found.join(", "),
            if more { " and more" } else { "" }
        ));
    };
    Ok(only)
}

/// So many channels are named in a complaint.
const MOST_NAMES: usize = 16;

fn names(header: &Header) -> impl Iterator<Item = String> + '_ {
    header.channels.list.iter().map(|c| c.name.to_string())
}

fn has(header: &Header, name: &str) -> Option<Text> {
    let all = header.channels.list.iter().map(|c| &c.name);
    all.into_iter().find(|n| (*n).eq(name)).cloned()
}

fn colour(header: &Header, layer: &str) -> Option<Channels> {
    let [r, g, b] = ["R", "G", "B"].map(|c| has(header, &format!("{layer}{c}")));
    Some(Channels::Colour([r?, g?, b?]))
}

/// Luminance alone, not with the differences that make it a colour.
fn grey(header: &Header, layer: &str) -> Option<Channels> {
    let [y, ry, by] = ["Y", "RY", "BY"].map(|c| has(header, &format!("{layer}{c}")));
    y.filter(|_| ry.is_none() && by.is_none())
        .map(Channels::Grey)
}

/// Reads channels of a part of a file into its display window.
fn pixels(
    file: BufReader<File>,
    header: &Header,
    channels: &Channels,
    max_pixels: usize,
) -> Result<Pixels, String> {
    let data = header.layer_size;
    let window = header.shared_attributes.display_window;
    check_size(data.width(), data.height(), max_pixels)?;
    check_size(window.size.width(), window.size.height(), max_pixels)?;
    if header.deep {
        return Err("holds deep data, which is not read; allowed are flat images".to_owned());
    }
    let whole = |c: &exr::meta::attribute::ChannelDescription| c.sampling == exr::math::Vec2(1, 1);
    if !header.channels.list.iter().all(whole) {
        return Err("has channels with fewer samples than pixels, which are not read".to_owned());
    }
    let read = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level();
    let read = read.specific_channels();
    let pixels = match channels {
        Channels::Colour([r, g, b]) => {
            let read = read
                .required(r.clone())
                .required(g.clone())
                .required(b.clone());
            let read = read.collect_pixels(
                PixelVec::<(f32, f32, f32)>::constructor,
                PixelVec::set_pixel,
            );
            let image = read.first_valid_layer().all_attributes().non_parallel();
            let image = image.from_buffered(file).map_err(|e| complain(&e))?;
            let all = image.layer_data.channel_data.pixels.pixels;
            all.into_iter()
                .map(|(r, g, b)| Rgb::new(r, g, b))
                .collect::<Vec<_>>()
        }
        Channels::Grey(y) => {
            let read = read.required(y.clone());
            let read = read.collect_pixels(PixelVec::<(f32,)>::constructor, PixelVec::set_pixel);
            let image = read.first_valid_layer().all_attributes().non_parallel();
            let image = image.from_buffered(file).map_err(|e| complain(&e))?;
            let all = image.layer_data.channel_data.pixels.pixels;
            all.into_iter().map(|(y,)| Rgb::new(y, y, y)).collect()
        }
    };
    if (data, header.own_attributes.layer_position) == (window.size, window.position) {
        return Ok((data.width(), pixels));
    }
    let at = header.own_attributes.layer_position;
    let (width, height) = (window.size.width(), window.size.height());
    let mut placed = vec![Rgb::BLACK; width * height];
    for (i, pixel) in pixels.into_iter().enumerate() {
        let inside = |p: usize, [here, there]: [i32; 2], size: usize| {
            let p = p as i64 + i64::from(here) - i64::from(there);
            usize::try_from(p).ok().filter(|p| *p < size)
        };
        let column = inside(i % data.width(), [at.x(), window.position.x()], width);
        let row = inside(i / data.width(), [at.y(), window.position.y()], height);
        if let Some((column, row)) = column.zip(row) {
            placed[row * width + column] = pixel;
        }
    }
    Ok((width, placed))
}
