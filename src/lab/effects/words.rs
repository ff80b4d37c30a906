//! How much light comes by which word: every path of a render is spelt, and its light is booked
//! under its word.

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::integrators::{Arrival, Pass, Passes, Path, PathObserver, Prepared, Splat};
use crate::materials::Event;
use crate::notation::{Letter, Word};
use crate::render::{Options, Progress, Recorded, Recorder, record};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use crate::stats::Estimate;
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
        let progress = Replicates {
            progress,
            done: replicate.into(),
            all: replicates.into(),
        };
        let Recorded {
            rendered, notes, ..
        } = record(scene, &Spelling(path), &options, &progress);
        if rendered.interrupted {
            return None;
        }
        rays += rendered.rays.total();
        total.add(rendered.film.mean().0);
        let samples = f64::from(scene.size[0]) * f64::from(scene.size[1]) * f64::from(options.spp);
        // In the order of tiles, so that the sums are the same on any number of threads.
        let mut sums = Sums::new();
        for (code, booked) in notes.into_iter().flatten() {
            let entry = sums.entry(code).or_default();
            entry.light += booked.light;
            entry.paths += booked.paths;
        }
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

/// Spells the paths of a path tracer.
struct Spelling<'a>(&'a Path);

impl Recorder for Spelling<'_> {
    type Notes = Sums;

    fn record(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        stream: &Stream,
        _: &mut [Rgb],
        sums: &mut Sums,
    ) -> Rgb {
        let mut speller = Speller {
            code: 1,
            li: Rgb::BLACK,
            sums,
        };
        self.0.trace(tracer, ray, stream, &mut speller);
        speller.li
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.0.traces_caustics(scene).then_some(self)
    }

    fn arrive(&self, _: Rgb, splats: impl Iterator<Item = Splat>, _: &mut [Rgb], sums: &mut Sums) {
        splats.for_each(|splat| book(sums, splat.path, splat.light));
    }
}

impl Passes for Spelling<'_> {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        self.0.caustics(pass, |letters| {
            let from_eye = letters.iter().skip(1).rev();
            Arrival::Kept(from_eye.fold(1, |code, letter| longer(code, *letter)))
        })
    }
}

/// Tells how many of some renders are finished.
struct Replicates<'a, P> {
    progress: &'a P,
    done: u64,
    all: u64,
}

impl<P: Progress> Progress for Replicates<'_, P> {
    fn tell(&self, done: u64, total: u64) {
        self.progress
            .tell(self.done * total + done, self.all * total);
    }

    fn stop(&self) -> bool {
        self.progress.stop()
    }
}

/// Books light under the word of its path.
struct Speller<'a> {
    /// The surfaces so far, from the eye: a one, then two bits for each.
    code: u64,
    /// The light of the path, whatever its words.
    li: Rgb,
    sums: &'a mut Sums,
}

impl Speller<'_> {
    fn book(&mut self, code: u64, li: Rgb) {
        self.li += li;
        book(self.sums, code, li);
    }
}

fn book(sums: &mut Sums, code: u64, li: Rgb) {
    if !li.is_black() {
        let booked = sums.entry(code).or_default();
        booked.light += channels(li);
        booked.paths += 1;
    }
}

impl PathObserver for Speller<'_> {
    fn scattered(&mut self, event: Event) -> bool {
        self.code = longer(self.code, event.into());
        true
    }

    fn wants(&self, _: Event) -> bool {
        true
    }

    fn aimed(&mut self, last: Event, li: Rgb) {
        self.book(longer(self.code, last.into()), li);
    }

    fn arrived(&mut self, li: Rgb, _: bool) {
        self.book(self.code, li);
    }
}

/// The code of a path with one more surface, farther from the eye.
fn longer(code: u64, surface: Letter) -> u64 {
    let bits = match surface {
        Letter::Specular => 1,
        Letter::Gloss => 2,
        Letter::Diffuse | Letter::Light | Letter::Eye => 0,
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
        let seen = [Letter::Specular, Letter::Gloss, Letter::Diffuse];
        let code = seen.into_iter().fold(1, longer);
        assert_eq!(spell(code).to_string(), "LDGSE");
        assert_eq!(spell(1).to_string(), "LE");
    }

    #[test]
    fn a_long_path_keeps_what_is_next_to_the_light() {
        let code = (0..40).fold(1, |code, _| longer(code, Letter::Specular));
        let code = longer(code, Letter::Diffuse);
        let word = spell(code).to_string();
        assert_eq!(word, format!("LD{}E", "S".repeat(30)));
    }
}
