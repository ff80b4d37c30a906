//! How much light comes by which word: every path of a render is spelt, and its light is booked
//! under its word.

use crate::color::Rgb;
use crate::integrators::{Follow, Path};
use crate::materials::Event;
use crate::notation::{Letter, Word};
use crate::render::{Options, Progress, camera_sample};
use crate::scene::{Scene, Tracer};
use crate::stats::Estimate;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The light of one word in a picture.
#[derive(Clone, Copy, Debug, Default)]
pub struct Share {
    /// Its part of the picture's mean over pixels and channels; one value for each replicate.
    pub light: Estimate,
    /// Paths that brought some.
    pub paths: u64,
}

/// A picture's light by words.
#[derive(Clone, Debug)]
pub struct Words {
    /// The words that brought light, shortest first.
    pub shares: BTreeMap<Word, Share>,
    /// The mean of the picture, from the same samples.
    pub total: Estimate,
    /// The rays it took.
    pub rays: u64,
}

/// Surfaces a word may have and still be told apart: two bits each.
const LONGEST: u32 = 31;

/// A picture's light by words; see [`words_watched`].
pub fn words(scene: &Scene, path: &Path, options: &Options, replicates: u32) -> Words {
    match words_watched(scene, path, options, replicates, &()) {
        Some(words) => words,
        None => unreachable!("nobody asked it to stop"),
    }
}

/// Spells every path of `replicates` renders of a scene by `path`, with seeds from `options.seed`
/// on. `None` where it was asked to stop before the last of them.
///
/// Paths of more than 31 surfaces count as their last 31, at the light's end.
pub fn words_watched(
    scene: &Scene,
    path: &Path,
    options: &Options,
    replicates: u32,
    progress: &impl Progress,
) -> Option<Words> {
    let mut shares: BTreeMap<Word, Share> = BTreeMap::new();
    let mut total = Estimate::new();
    let mut rays = 0;
    for replicate in 0..replicates {
        let options = Options {
            seed: options.seed + u64::from(replicate),
            ..*options
        };
        let (sums, sum, traced) = one_render(scene, path, &options, progress)?;
        progress.tell(u64::from(replicate) + 1, u64::from(replicates));
        rays += traced;
        let samples = f64::from(scene.size[0]) * f64::from(scene.size[1]) * f64::from(options.spp);
        total.add(sum / (3.0 * samples));
        for (code, booked) in sums {
            let share = shares.entry(spell(code)).or_default();
            // Replicates before in which the word did not occur count as 0.
            while share.light.count() < u64::from(replicate) {
                share.light.add(0.0);
            }
            share.light.add(booked.light / (3.0 * samples));
            share.paths += booked.paths;
        }
    }
    for share in shares.values_mut() {
        while share.light.count() < u64::from(replicates) {
            share.light.add(0.0);
        }
    }
    Some(Words {
        shares,
        total,
        rays,
    })
}

/// The light booked under a word: the sum over channels.
#[derive(Clone, Copy, Debug, Default)]
struct Booked {
    light: f64,
    paths: u64,
}

type Sums = BTreeMap<u64, Booked>;

fn one_render(
    scene: &Scene,
    path: &Path,
    options: &Options,
    progress: &impl Progress,
) -> Option<(Sums, f64, u64)> {
    let [width, height] = scene.size;
    let rows: Option<Vec<(Sums, f64, u64)>> = (0..height)
        .into_par_iter()
        .map(|y| {
            let mut tracer = Tracer::new(scene);
            let mut speller = Speller::default();
            let mut sum = 0.0;
            for x in 0..width {
                for sample in 0..options.spp {
                    if progress.stop() {
                        return None;
                    }
                    let (ray, stream) = camera_sample(&mut tracer, options, [x, y], sample);
                    speller.code = 1;
                    speller.li = Rgb::BLACK;
                    path.trace(&mut tracer, &ray, &stream, &mut speller);
                    sum += channels(speller.li);
                }
            }
            Some((speller.sums, sum, tracer.counts().total()))
        })
        .collect();
    // In the order of rows, so that the sums are the same on any number of threads.
    let mut all = Sums::new();
    let (mut total, mut rays) = (0.0, 0);
    for (sums, sum, traced) in rows? {
        total += sum;
        rays += traced;
        for (code, booked) in sums {
            let entry = all.entry(code).or_default();
            entry.light += booked.light;
            entry.paths += booked.paths;
        }
    }
    Some((all, total, rays))
}

/// Books light under the word of its path.
#[derive(Default)]
struct Speller {
    /// The surfaces so far, from the eye: a one, then two bits for each.
    code: u64,
    /// The light of the path, whatever its words.
    li: Rgb,
    sums: Sums,
}

impl Speller {
    fn book(&mut self, code: u64, li: Rgb) {
        if !li.is_black() {
            self.li += li;
            let booked = self.sums.entry(code).or_default();
            booked.light += channels(li);
            booked.paths += 1;
        }
    }
}

impl Follow for Speller {
    fn scattered(&mut self, event: Event) -> bool {
        self.code = longer(self.code, event);
        true
    }

    fn wants(&self, _: Event) -> bool {
        true
    }

    fn aimed(&mut self, last: Event, li: Rgb) {
        self.book(longer(self.code, last), li);
    }

    fn arrived(&mut self, li: Rgb) {
        self.book(self.code, li);
    }
}

fn longer(code: u64, event: Event) -> u64 {
    let bits = match event {
        Event::Diffuse => 0,
        Event::Specular => 1,
        Event::Gloss => 2,
    };
    if code >> (2 * LONGEST) == 0 {
        code << 2 | bits
    } else {
        let top = 1 << (2 * LONGEST);
        top | (code << 2 | bits) & (top - 1)
    }
}

/// From the light to the eye: the surfaces met last come first.
fn spell(mut code: u64) -> Word {
    let mut letters = vec![Letter::Light];
    while code > 1 {
        letters.push(match code & 3 {
            0 => Letter::Diffuse,
            1 => Letter::Specular,
            _ => Letter::Gloss,
        });
        code >>= 2;
    }
    letters.push(Letter::Eye);
    Word(letters)
}

fn channels(rgb: Rgb) -> f64 {
    rgb.channels().map(f64::from).iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_from_the_eye_is_spelt_from_the_light() {
        let seen = [Event::Specular, Event::Gloss, Event::Diffuse];
        let code = seen.into_iter().fold(1, longer);
        assert_eq!(spell(code).to_string(), "LDGSE");
        assert_eq!(spell(1).to_string(), "LE");
    }

    #[test]
    fn a_long_path_keeps_what_is_next_to_the_light() {
        let code = (0..40).fold(1, |code, _| longer(code, Event::Specular));
        let code = longer(code, Event::Diffuse);
        let word = spell(code).to_string();
        assert_eq!(word, format!("LD{}E", "S".repeat(30)));
    }
}
