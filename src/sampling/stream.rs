//! The random numbers of a picture: a pure function of seed, pixel, sample, place and purpose.
//!
//! There is no global generator and no order of drawing. A number is found by its address, so a
//! pixel can be replayed alone, any thread may render any tile, and an effect that is absent
//! shifts nobody else's numbers: each [`Purpose`] owns its dimensions at each place of a path.

use super::sobol;
use rand::RngExt;
use rand_pcg::Pcg32;
use std::ops::Range;

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
    /// Which of a surface's ways to scatter a path goes on by.
    Branch = 7,
    /// When, while the shutter is open.
    Time = 8,
    /// Whether a path goes on at all.
    Survival = 9,
    /// Which facet of a rough surface a path goes on by, where that is told from
    /// [`Purpose::Direction`].
    Facet = 10,
}

/// How the points of a pixel's samples lie to each other, dimension by dimension.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sampler {
    /// Each without regard to the others. Their scatter tells the error of their mean.
    #[default]
    Independent,
    /// Evenly, in [runs](even_run) of at most 64: Owen-scrambled Sobol' points, four dimensions for
    /// each purpose at each of the first places, scrambled on their own. The mean of a whole run is
    /// closer to the truth than its samples' scatter tells; the runs are independent of each other,
    /// so *their* scatter tells the error. What is decided later on a path depends on so many numbers
    /// before it that evenness is lost on it, and is left to independent numbers.
    ///
    /// Sources: Owen, Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences (MCQMC 1995); Burley,
    /// Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
    Sobol,
}

/// The random numbers of one camera sample.
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    pub(super) key: u64,
    /// The sample's number among points that lie evenly together.
    pub(super) index: u32,
    pub(super) sampler: Sampler,
    /// One bit for each purpose whose numbers are all 1/2.
    pub(super) fixed: u16,
}

/// The most samples that lie evenly together. Of twice as many, a picture of few smooth pixels has a
/// tenth less variance; but then fewer runs are there to tell the error.
pub const EVEN_SAMPLES: u32 = 64;
/// The last place whose points lie evenly: in a Cornell box a picture without those of later bounces
/// is as good, and takes less time.
pub(super) const LAST_EVEN_PLACE: u64 = 3;

/// The samples among which sample `sample` lies evenly: 16, 16, 32, then 64 after 64.
///
/// So that 32, 64 and 128 samples have two equal halves that are independent, and any multiple of 64
/// has that many runs.
pub fn even_run(sample: u32) -> Range<u32> {
    let start = match sample {
        0..16 => return 0..16,
        16..EVEN_SAMPLES => 1 << sample.ilog2(),
        _ => sample - sample % EVEN_SAMPLES,
    };
    start..start.saturating_add(start.min(EVEN_SAMPLES))
}

impl Stream {
    /// The numbers of sample `sample` of pixel `pixel` (row-major index) in the picture of `seed`,
    /// independent of those of all other samples.
    pub fn new(seed: u64, pixel: u32, sample: u32) -> Self {
        Self::with(Sampler::Independent, seed, pixel, sample)
    }

    /// The same by another sampler.
    pub fn with(sampler: Sampler, seed: u64, pixel: u32, sample: u32) -> Self {
        let picture = mix(seed ^ 0x68_61_6c_66_64_69_73_6b);
        let (start, index) = match sampler {
            Sampler::Independent => (sample, 0),
            Sampler::Sobol => {
                let start = even_run(sample).start;
                (start, sample - start)
            }
        };
        let address = u64::from(pixel) << 32 | u64::from(start);
        Stream {
            key: mix(picture ^ address),
            index,
            sampler,
            fixed: 0,
        }
    }

    /// The same numbers, but those for `purposes` are all 1/2, the middle of what they range over:
    /// one point where an integral was.
    #[must_use]
    pub fn fixing(self, purposes: &[Purpose]) -> Self {
        let bits = purposes.iter().fold(0, |bits, &p| bits | 1 << p as u16);
        Stream {
            fixed: self.fixed | bits,
            ..self
        }
    }

    /// The numbers for `purpose` at `place`: the bounce of a path, or the node of a ray tree.
    #[inline]
    pub fn at(&self, place: u64, purpose: Purpose) -> Numbers {
        self.at_item(place, purpose, 0)
    }

    /// The same for one of many items, such as the light numbered `item`.
    #[inline]
    pub fn at_item(&self, place: u64, purpose: Purpose, item: u32) -> Numbers {
        let what = u64::from(item) << 8 | purpose as u64;
        let state = mix(mix(self.key ^ place) ^ what.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let rest = Pcg32::new(state ^ u64::from(self.index), 0);
        if self.fixed & 1 << purpose as u16 != 0 {
            return Numbers(Kind::Middle);
        }
        Numbers(match self.sampler {
            Sampler::Independent => Kind::Independent(rest),
            Sampler::Sobol if place > LAST_EVEN_PLACE => Kind::Independent(rest),
            Sampler::Sobol => Kind::Even {
                point: sobol::point(self.index, state as u32),
                drawn: 0,
                rest,
            },
        })
    }
}

/// A run of uniforms in `[0, 1)`, each a multiple of 2^-24: never 1.
#[derive(Clone, Debug)]
pub struct Numbers(Kind);

#[derive(Clone, Debug)]
enum Kind {
    Independent(Pcg32),
    /// Four dimensions, and independent numbers for whoever wants more.
    Even {
        point: [f32; 4],
        drawn: usize,
        rest: Pcg32,
    },
    Middle,
}

impl Numbers {
    /// The next uniform.
    #[inline]
    pub fn one(&mut self) -> f32 {
        match &mut self.0 {
            Kind::Independent(numbers) => numbers.random(),
            Kind::Even { point, drawn, rest } => match point.get(*drawn) {
                Some(&u) => {
                    *drawn += 1;
                    u
                }
                None => rest.random(),
            },
            Kind::Middle => 0.5,
        }
    }

    /// The next uniform with 53 bits, to choose one of many: its first 24 are those of
    /// [`Numbers::one`].
    #[inline]
    pub fn fine(&mut self) -> f64 {
        let coarse = f64::from(self.one());
        let below: f64 = match &mut self.0 {
            Kind::Independent(numbers) => numbers.random::<u32>().into(),
            Kind::Even { rest, .. } => rest.random::<u32>().into(),
            Kind::Middle => return coarse,
        };
        // 2^-24 is the step of the coarse one; 29 bits are left of the 53.
        coarse + (below / 8.0).floor() * f64::EPSILON / 2.0
    }

    /// The next two uniforms, in order.
    #[inline]
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
    fn every_bit_of_the_address_matters() {
        let first = |seed, pixel, sample, place, item| {
            let mut numbers = Stream::new(seed, pixel, sample).at_item(place, Purpose::Pixel, item);
            numbers.two().map(f32::to_bits)
        };
        let mut all = vec![first(0, 0, 0, 0, 0)];
        all.extend((0..64).map(|k| first(1 << k, 0, 0, 0, 0)));
        all.extend((0..64).map(|k| first(0, 0, 0, 1 << k, 0)));
        for k in 0..32 {
            all.push(first(0, 1 << k, 0, 0, 0));
            all.push(first(0, 0, 1 << k, 0, 0));
            all.push(first(0, 0, 0, 0, 1 << k));
        }
        let distinct: std::collections::BTreeSet<[u32; 2]> = all.iter().copied().collect();
        assert_eq!(distinct.len(), all.len());
        for sampler in [Sampler::Independent, Sampler::Sobol] {
            let of = |seed| {
                Stream::with(sampler, seed, 0, 0)
                    .at(0, Purpose::Pixel)
                    .two()
            };
            for k in 32..64 {
                assert_ne!(of(7), of(7 ^ 1 << k), "{sampler:?}, bit {k} of the seed");
            }
        }
    }

    #[test]
    fn no_uniform_reaches_one() {
        let check = |u: f32| {
            assert!((0.0..1.0).contains(&u));
            assert_eq!((u * 16_777_216.0).fract(), 0.0, "24 bits");
        };
        let mut numbers = Stream::new(0, 0, 0).at(0, Purpose::Pixel);
        (0..1_000_000).for_each(|_| check(numbers.one()));
        for sample in 0..100_000 {
            let stream = Stream::with(Sampler::Sobol, 3, 0, sample);
            let mut numbers = stream.at(1, Purpose::Direction);
            (0..6).for_each(|_| check(numbers.one()));
        }
    }

    #[test]
    fn even_points_fill_every_elementary_interval_once() {
        for purpose in [Purpose::Pixel, Purpose::Direction] {
            let points: Vec<[f32; 2]> = even_run(64)
                .map(|i| Stream::with(Sampler::Sobol, 7, 5, i).at(2, purpose).two())
                .collect();
            for k in 0..=6 {
                let (columns, rows) = (1 << k, 64 >> k);
                let mut seen = [false; 64];
                for [x, y] in &points {
                    let cell = (x * columns as f32) as usize * rows + (y * rows as f32) as usize;
                    assert!(!seen[cell], "{columns} x {rows}");
                    seen[cell] = true;
                }
            }
        }
    }

    #[test]
    fn independent_points_do_not() {
        let mut seen = std::collections::BTreeSet::new();
        for i in 0..256 {
            let [x, y] = Stream::new(7, 5, i).at(2, Purpose::Pixel).two();
            seen.insert(((x * 16.0) as u32, (y * 16.0) as u32));
        }
        assert!(seen.len() < 200, "{}", seen.len());
    }

    #[test]
    fn late_places_have_independent_numbers() {
        let of = |sampler, place| {
            Stream::with(sampler, 7, 5, 9)
                .at(place, Purpose::Direction)
                .two()
        };
        assert_ne!(of(Sampler::Sobol, 4), of(Sampler::Sobol, 5));
        let mut seen = std::collections::BTreeSet::new();
        for i in 0..256 {
            let [x, y] = Stream::with(Sampler::Sobol, 7, 5, i)
                .at(4, Purpose::Pixel)
                .two();
            seen.insert(((x * 16.0) as u32, (y * 16.0) as u32));
        }
        assert!(seen.len() < 200, "{}", seen.len());
    }

    #[test]
    fn pixels_and_purposes_have_points_of_their_own() {
        let of = |pixel, purpose| -> Vec<f32> {
            let point = |i| {
                Stream::with(Sampler::Sobol, 1, pixel, i)
                    .at(0, purpose)
                    .one()
            };
            (0..256).map(point).collect()
        };
        let correlation = |a: &[f32], b: &[f32]| {
            let centred = |x: f32| f64::from(x) - 0.5;
            let products = a.iter().zip(b).map(|(&a, &b)| centred(a) * centred(b));
            products.sum::<f64>() / 256.0 * 12.0
        };
        let mut worst = 0.0_f64;
        for pixel in 0..32 {
            let here = of(pixel, Purpose::Pixel);
            for other in [of(pixel, Purpose::Lens), of(pixel + 1, Purpose::Pixel)] {
                worst = worst.max(correlation(&here, &other).abs());
            }
        }
        assert!(worst < 0.3, "4.4 standard errors are 0.275: {worst}");
        assert!(correlation(&of(0, Purpose::Pixel), &of(0, Purpose::Pixel)) > 0.99);
    }

    #[test]
    fn runs_follow_each_other_and_share_no_scrambling() {
        let runs = [0..16, 16..32, 32..64, 64..128, 128..192, 192..256];
        for run in &runs {
            assert!(run.clone().all(|i| even_run(i) == *run), "{run:?}");
        }
        assert_eq!(even_run(u32::MAX).end, u32::MAX);
        let at = |i| {
            Stream::with(Sampler::Sobol, 1, 0, i)
                .at(0, Purpose::Pixel)
                .two()
        };
        for (a, b) in runs.iter().zip(&runs[1..]) {
            assert_ne!(at(a.start), at(b.start));
        }
        assert_ne!(at(1), at(u32::MAX));
    }

    #[test]
    fn what_is_fixed_is_one_half_and_shifts_nothing_else() {
        let free = Stream::new(7, 11, 13);
        let fixed = free.fixing(&[Purpose::Lens]).fixing(&[Purpose::Time]);
        assert_eq!(fixed.at(0, Purpose::Lens).two(), [0.5; 2]);
        assert_eq!(fixed.at(9, Purpose::Time).one(), 0.5);
        for purpose in [Purpose::Pixel, Purpose::Direction] {
            assert_eq!(fixed.at(2, purpose).two(), free.at(2, purpose).two());
        }
    }
}
