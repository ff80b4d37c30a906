//! The random numbers that a question hands to an answer.

use crate::sampling::stream::{Numbers, Purpose, Stream};

/// The largest uniform, and the smallest.
const ENDS: [f32; 2] = [1.0 - f32::EPSILON / 2.0, 0.0];

/// The random numbers of one draw. The first draws of a question are the corners of the unit square, where formulas
/// break.
#[derive(Clone, Debug)]
pub struct Draw {
    corner: Option<[f32; 2]>,
    numbers: Numbers,
}

impl Draw {
    pub(super) fn new(seed: u64, index: u32) -> Self {
        Draw {
            corner: None,
            numbers: Stream::new(seed, index, 0).at(0, Purpose::Direction),
        }
    }

    pub(super) fn corner(seed: u64, index: u32) -> Self {
        let corner = [index & 1, index >> 1].map(|i| ENDS[i as usize & 1]);
        Draw {
            corner: Some(corner),
            ..Draw::new(seed, index)
        }
    }

    /// A uniform in `[0, 1)`.
    pub fn one(&mut self) -> f32 {
        self.corner.map_or_else(|| self.numbers.one(), |[u, _]| u)
    }

    /// Two uniforms.
    pub fn two(&mut self) -> [f32; 2] {
        self.corner.unwrap_or_else(|| self.numbers.two())
    }

    /// A uniform with 53 bits.
    pub fn fine(&mut self) -> f64 {
        match self.corner {
            Some([u, _]) if u > 0.5 => 1.0_f64.next_down(),
            Some(_) => 0.0,
            None => self.numbers.fine(),
        }
    }

    /// As many as the answer wants.
    pub fn numbers(&mut self) -> &mut Numbers {
        &mut self.numbers
    }
}
