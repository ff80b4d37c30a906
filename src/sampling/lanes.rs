//! The random numbers of sixteen samples at once: those of [`Stream`], bit for bit.

use super::stream::{LAST_EVEN_PLACE, Purpose, Sampler, Stream};
use crate::numeric::lanes::{ALL_LANES, Floats, LANES, Mask, WordRow, Words, Words64, bits, words};
use fearless_simd::prelude::*;
use fearless_simd::{i32x16, u8x64};
use sobol_burley::parts::sobol_rev;

/// Bits of a sample's number that Sobol' points look at, shuffled.
const INDEX_BITS: u32 = 16;

/// The streams of sixteen samples by one sampler, none of whose numbers are fixed.
#[derive(Clone, Debug)]
pub struct Streams {
    key: [u64; LANES],
    index: WordRow,
    /// The bits of the indices in reverse.
    reversed: WordRow,
    sampler: Sampler,
    /// For each bit of the index the direction numbers of the last two of four dimensions, their bits reversed.
    directions: [[u32; 2]; INDEX_BITS as usize],
}

/// Places of sixteen streams.
#[derive(Clone, Copy, Debug)]
pub struct Places<S: Simd> {
    state: Words64<S>,
    /// Lanes whose points lie evenly there, if their sampler is Sobol'.
    early: Mask<S>,
}

impl Streams {
    /// Streams that are still to be set.
    pub fn new(sampler: Sampler) -> Self {
        let direction = |bit: usize| [2, 3].map(|d| sobol_rev(1 << (31 - bit), d));
        Streams {
            key: [0; LANES],
            index: WordRow::default(),
            reversed: WordRow::default(),
            sampler,
            directions: std::array::from_fn(direction),
        }
    }

    /// Sets that of one lane.
    pub fn set(&mut self, lane: usize, stream: &Stream) {
        debug_assert!(stream.sampler == self.sampler && stream.fixed == 0);
        self.key[lane] = stream.key;
        self.index.0[lane] = stream.index;
        self.reversed.0[lane] = stream.index.reverse_bits();
    }

    /// That of one lane.
    pub fn lane(&self, lane: usize) -> Stream {
        Stream {
            key: self.key[lane],
            index: self.index.0[lane],
            sampler: self.sampler,
            fixed: 0,
        }
    }

    /// The place of each lane: what all purposes have in common.
    #[inline(always)]
    pub fn at<S: Simd>(&self, s: S, place: Words<S>) -> Places<S> {
        let key = Words64::load(s, &self.key);
        Places {
            state: mix(key ^ Words64::from(place)),
            early: place.simd_le(words(s, LAST_EVEN_PLACE as u32)),
        }
    }

    /// The first four numbers for `purpose` at the place of each lane: [`Stream::at`].
    #[inline(always)]
    pub fn four<S: Simd>(&self, s: S, at: &Places<S>, purpose: Purpose) -> [Floats<S>; 4] {
        let what = (purpose as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let state = mix(at.state ^ Words64::splat(s, what));
        let index = self.index.get(s);
        let even = match self.sampler {
            Sampler::Independent => 0,
            Sampler::Sobol => bits(at.early),
        };
        if even == 0 {
            return independent(s, state ^ Words64::from(index));
        }
        let points = self.sobol(s, state.low());
        if even == ALL_LANES {
            return points;
        }
        let others = independent(s, state ^ Words64::from(index));
        let mut numbers = points;
        for (number, other) in numbers.iter_mut().zip(others) {
            *number = at.early.select(*number, other);
        }
        numbers
    }

    /// `sobol_burley::sample_4d` of dimensions 0 to 3.
    ///
    /// Source: Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
    #[inline(always)]
    fn sobol<S: Simd>(&self, s: S, seed: Words<S>) -> [Floats<S>; 4] {
        let by = hash(s, seed ^ words(s, 0x79c6_8e4a));
        let shuffled = owen_scramble(s, self.reversed.get(s), by);
        let index = reverse_bits(s, shuffled) & words(s, (1 << INDEX_BITS) - 1);
        let [mut third, mut fourth] = [words(s, 0); 2];
        for (bit, directions) in self.directions.iter().enumerate() {
            // All ones where the index has the bit.
            let top: i32x16<S> = (shuffled << bit as u32).bitcast();
            let has: Words<S> = (top >> 31).bitcast();
            third ^= has & words(s, directions[0]);
            fourth ^= has & words(s, directions[1]);
        }
        let sobol = [index, pascal(s, index), third, fourth];
        let seed = seed * words(s, 0x9c8f_2d3b);
        let salts = [0x912f_69ba, 0x174f_18ab, 0x691e_72ca, 0xb40c_c1b8];
        let mut point = [Floats::splat(s, 0.0); 4];
        for ((u, x), salt) in point.iter_mut().zip(sobol).zip(salts) {
            let x = owen_scramble(s, x, hash(s, seed ^ words(s, salt)));
            *u = (reverse_bits(s, x) >> 9).to_float::<Floats<S>>() * (1.0 / 8_388_608.0);
        }
        point
    }
}

/// The second dimension of the Sobol' sequence from the first, both with their bits reversed.
///
/// Its matrix is Pascal's triangle modulo 2. For twice as many bits it is made of four blocks: three such triangles, and
/// zeros. So it takes a step for each doubling.
///
/// Source: Sobol', On the Distribution of Points in a Cube and the Approximate Evaluation of Integrals (USSR
/// Computational Mathematics and Mathematical Physics 7(4), 1967).
#[inline(always)]
fn pascal<S: Simd>(s: S, x: Words<S>) -> Words<S> {
    let x = x ^ ((x >> 1) & words(s, 0x5555));
    let x = x ^ ((x >> 2) & words(s, 0x3333));
    let x = x ^ ((x >> 4) & words(s, 0x0f0f));
    x ^ ((x >> 8) & words(s, 0x00ff))
}

/// `stream::mix`.
#[inline(always)]
fn mix<S: Simd>(z: Words64<S>) -> Words64<S> {
    let z = (z ^ (z >> 30)) * 0xbf58_476d_1ce4_e5b9;
    let z = (z ^ (z >> 27)) * 0x94d0_49bb_1331_11eb;
    z ^ (z >> 31)
}

/// Four numbers of `Pcg32::new(state, 0)`.
///
/// Source: O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
/// Generation (Harvey Mudd College HMC-CS-2014-0905, 2014).
#[inline(always)]
fn independent<S: Simd>(s: S, state: Words64<S>) -> [Floats<S>; 4] {
    let mut state = step(state + 1);
    let mut numbers = [Floats::splat(s, 0.0); 4];
    for number in &mut numbers {
        let x = ((state >> 18) ^ state) >> 27;
        let turn = (state >> 59).low();
        // Rotated to the right. By none it is itself, for a shift to the left by 32 is one by 0 here.
        let back = (words(s, 32) - turn) & words(s, 31);
        let x = (x.low() >> turn) | (x.low() << back);
        *number = (x >> 8).to_float::<Floats<S>>() * (1.0 / 16_777_216.0);
        state = step(state);
    }
    numbers
}

#[inline(always)]
fn step<S: Simd>(state: Words64<S>) -> Words64<S> {
    state * 6_364_136_223_846_793_005 + 1
}

/// `sobol_burley::parts::owen_scramble_rev`.
#[inline(always)]
fn owen_scramble<S: Simd>(s: S, n: Words<S>, by: Words<S>) -> Words<S> {
    let n = n ^ (n * words(s, 0x3d20_adea));
    let n = (n + by) * ((by >> 16) | words(s, 1));
    let n = n ^ (n * words(s, 0x0552_6c56));
    n ^ (n * words(s, 0x53a2_2864))
}

/// `sobol_burley::parts::hash`.
#[inline(always)]
fn hash<S: Simd>(s: S, n: Words<S>) -> Words<S> {
    let n = n ^ words(s, 0xe6fe_3beb);
    let n = (n ^ (n >> 16)) * words(s, 0x7feb_352d);
    let n = (n ^ (n >> 15)) * words(s, 0x846c_a68b);
    n ^ (n >> 16)
}

/// `u32::reverse_bits`: of each byte the halves by a table, and then the bytes.
#[inline(always)]
fn reverse_bits<S: Simd>(s: S, x: Words<S>) -> Words<S> {
    let low = x & words(s, 0x0f0f_0f0f);
    let high = (x >> 4) & words(s, 0x0f0f_0f0f);
    let table = u8x64::from_slice(s, &REVERSED_HALVES);
    let x = (table.swizzle_dyn_within_blocks(low.to_bytes()) << 4)
        | table.swizzle_dyn_within_blocks(high.to_bytes());
    let bytes = u8x64::from_slice(s, &LAST_BYTE_FIRST);
    Words::from_bytes(x.swizzle_dyn_within_blocks(bytes))
}

/// The numbers below 16 with their four bits reversed, four times.
const REVERSED_HALVES: [u8; 64] = reversed_halves();
/// The places of the bytes of words within sixteen bytes, the last of each word first, four times.
const LAST_BYTE_FIRST: [u8; 64] = last_byte_first();

const fn reversed_halves() -> [u8; 64] {
    let mut table = [0; 64];
    let mut i = 0;
    while i < 64 {
        table[i] = (i as u8 % 16).reverse_bits() >> 4;
        i += 1;
    }
    table
}

const fn last_byte_first() -> [u8; 64] {
    let mut table = [0; 64];
    let mut i = 0;
    while i < 64 {
        table[i] = (i as u8 % 16) ^ 3;
        i += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::{Row, levels};
    use fearless_simd::dispatch;

    #[test]
    fn numbers_are_those_of_the_plain_streams() {
        for (sampler, level) in [Sampler::Independent, Sampler::Sobol]
            .into_iter()
            .flat_map(|sampler| levels().into_iter().map(move |level| (sampler, level)))
        {
            for round in 0..200 {
                let mut streams = Streams::new(sampler);
                let plain: [Stream; LANES] = std::array::from_fn(|lane| {
                    Stream::with(
                        sampler,
                        7 << (round % 60),
                        round * 31 + lane as u32,
                        round * 5 + lane as u32,
                    )
                });
                for (lane, stream) in plain.iter().enumerate() {
                    streams.set(lane, stream);
                    assert_eq!(
                        streams.lane(lane).at(1, Purpose::Lens).one(),
                        stream.at(1, Purpose::Lens).one()
                    );
                }
                // Early places, late ones, and both side by side.
                let places = WordRow(std::array::from_fn(|lane| match round % 3 {
                    0 => 1,
                    1 => 9,
                    _ => lane as u32 % 7,
                }));
                for purpose in [Purpose::Pixel, Purpose::LightPoint, Purpose::Direction] {
                    let rows = dispatch!(level, s => {
                        streams.four(s, &streams.at(s, places.get(s)), purpose).map(Row::from)
                    });
                    for (lane, stream) in plain.iter().enumerate() {
                        let mut numbers = stream.at(u64::from(places.0[lane]), purpose);
                        for row in &rows {
                            assert_eq!(
                                row.0[lane],
                                numbers.one(),
                                "{sampler:?} {level:?} {purpose:?}"
                            );
                        }
                    }
                }
            }
        }
    }
}
