//! The random numbers of a picture: a pure function of seed, pixel, sample, place and purpose.
//!
//! There is no global generator and no order of drawing. A number is found by its address, so a
//! pixel can be replayed alone, any thread may render any tile, and an effect that is absent
//! shifts nobody else's numbers: each [`Purpose`] owns its dimensions at each place of a path.

use rand::RngExt;
use rand_pcg::Pcg32;

/// What a random number decides. Every purpose draws from dimensions of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Purpose {
    /// Where in its pixel a camera ray passes.
    Pixel = 1,
    /// Which point of an area light a shadow ray aims at; one set of dimensions for each light.
    LightPoint = 2,
    /// The direction in which a path goes on.
    Direction = 3,
    /// Where a path that starts at a light leaves it.
    Emission = 4,
    /// Where a camera ray passes the pupil.
    Lens = 5,
    /// Where an integrand without any light is evaluated.
    Integrand = 6,
    /// Which of a surface's specular directions a path goes on in.
    Branch = 7,
}

/// The random numbers of one camera sample.
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    key: u64,
}

impl Stream {
    /// The numbers of sample `sample` of pixel `pixel` (row-major index) in the picture of `seed`.
    pub fn new(seed: u64, pixel: u32, sample: u32) -> Self {
        let picture = mix(seed ^ 0x68_61_6c_66_64_69_73_6b);
        let address = u64::from(pixel) << 32 | u64::from(sample);
        Stream {
            key: mix(picture ^ address),
        }
    }

    /// The numbers for `purpose` at `place`: the bounce of a path, or the node of a ray tree.
    pub fn at(&self, place: u64, purpose: Purpose) -> Numbers {
        self.at_item(place, purpose, 0)
    }

    /// The same for one of many items, such as the light numbered `item`.
    pub fn at_item(&self, place: u64, purpose: Purpose, item: u32) -> Numbers {
        let what = u64::from(item) << 8 | purpose as u64;
        let state = mix(mix(self.key ^ place) ^ what.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        Numbers(Pcg32::new(state, 0))
    }
}

/// A run of uniforms in `[0, 1)`, each a multiple of 2^-24: never 1.
#[derive(Clone, Debug)]
pub struct Numbers(Pcg32);

impl Numbers {
    /// The next uniform.
    pub fn one(&mut self) -> f32 {
        self.0.random()
    }

    /// The next two uniforms, in order.
    pub fn two(&mut self) -> [f32; 2] {
        [self.one(), self.one()]
    }
}

/// A bijection of the 64-bit words in which each input bit changes each output bit with
/// probability one half.
///
/// Source: Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators (OOPSLA 2014), with
/// the constants of their `mix64variant13`.
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_found_by_its_address_alone() {
        let draw = || Stream::new(7, 11, 13).at(2, Purpose::Direction).two();
        assert_eq!(draw(), draw());
    }

    #[test]
    fn every_part_of_the_address_matters() {
        let first = |seed, pixel, sample, place, purpose, item| {
            Stream::new(seed, pixel, sample)
                .at_item(place, purpose, item)
                .one()
                .to_bits()
        };
        use Purpose::*;
        let all = [
            first(0, 0, 0, 0, Pixel, 0),
            first(1, 0, 0, 0, Pixel, 0),
            first(0, 1, 0, 0, Pixel, 0),
            first(0, 0, 1, 0, Pixel, 0),
            first(0, 0, 0, 1, Pixel, 0),
            first(0, 0, 0, 0, Direction, 0),
            first(0, 0, 0, 0, Branch, 0),
            first(0, 0, 0, 0, Pixel, 1),
        ];
        let distinct: std::collections::BTreeSet<u32> = all.into_iter().collect();
        assert_eq!(distinct.len(), all.len());
    }

    #[test]
    fn no_uniform_reaches_one() {
        let mut numbers = Stream::new(0, 0, 0).at(0, Purpose::Pixel);
        for _ in 0..1_000_000 {
            let u = numbers.one();
            assert!((0.0..1.0).contains(&u));
            assert_eq!((u * 16_777_216.0).fract(), 0.0, "24 bits");
        }
    }
}
