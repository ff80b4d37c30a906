//! A share of a picture's tiles, to be rendered by itself.

use std::fmt::{self, Display, Formatter};
use std::ops::Range;
use std::str::FromStr;

/// Every n-th tile of a picture, of `n` shards. Pixels are independent, so the pictures of all shards put together are the
/// picture, bit for bit.
///
/// Written as `I/N`, with `I` from 1 to `N`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Shard {
    /// Its number, 1 for the first.
    pub index: u32,
    /// How many there are.
    pub count: u32,
}

impl Shard {
    /// Side of the square tiles that are dealt out, in pixels.
    pub const TILE: u32 = 16;
    /// The most shards of a picture.
    pub const MOST: u32 = 1 << 16;

    /// True where it has tile `number`, row by row.
    pub(super) fn has(self, number: usize) -> bool {
        number as u64 % u64::from(self.count) == u64::from(self.index - 1)
    }

    /// The pixels of a picture of this size that it has, as columns and rows of its tiles.
    pub(super) fn tiles(self, size: [u32; 2]) -> impl Iterator<Item = [Range<u32>; 2]> {
        let all = tiles(size, Shard::TILE).enumerate();
        all.filter(move |(number, _)| self.has(*number))
            .map(|(_, tile)| tile)
    }

    /// Its pixels, by column and row: in a picture of this size, and where its tiles stand one below the other.
    pub(super) fn places(self, size: [u32; 2]) -> impl Iterator<Item = [[u32; 2]; 2]> {
        let tiles = self.tiles(size).zip((0..).step_by(Shard::TILE as usize));
        tiles.flat_map(|([x, y], row)| {
            let (left, top) = (x.start, y.start);
            y.flat_map(move |y| x.clone().map(move |x| [[x, y], [x - left, row + y - top]]))
        })
    }
}

/// The columns and rows of the tiles of a picture, row by row.
pub(super) fn tiles([width, height]: [u32; 2], side: u32) -> impl Iterator<Item = [Range<u32>; 2]> {
    let starts = move |end: u32| (0..end).step_by(side as usize);
    let range = move |start: u32, end: u32| start..end.min(start.saturating_add(side));
    starts(height)
        .flat_map(move |y| starts(width).map(move |x| [range(x, width), range(y, height)]))
}

impl Display for Shard {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let numbers = parts.map(|(index, count)| (index.parse(), count.parse()));
        match numbers {
            Some((Ok(index), Ok(count)))
                if (1..=count).contains(&index) && count <= Shard::MOST =>
            {
                Ok(Shard { index, count })
            }
            _ => Err(format!(
                "a shard is its number and how many there are, from 1/1 to {0}/{0}",
                Shard::MOST
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_share_out_all_pixels_and_each_once() {
        for (size, count) in [
            ([33, 47], 1),
            ([33, 47], 2),
            ([33, 47], 7),
            ([5, 5], 3),
            ([200, 100], 64),
        ] {
            let mut seen = vec![0; (size[0] * size[1]) as usize];
            for index in 1..=count {
                for [x, y] in (Shard { index, count }).tiles(size) {
                    y.for_each(|y| {
                        x.clone()
                            .for_each(|x| seen[(y * size[0] + x) as usize] += 1)
                    });
                }
            }
            assert!(seen.iter().all(|&n| n == 1), "{size:?} {count}");
        }
    }

    #[test]
    fn a_shard_is_written_as_one_of_so_many() {
        assert_eq!("3/8".parse(), Ok(Shard { index: 3, count: 8 }));
        for wrong in [
            "", "3", "0/8", "9/8", "1/0", "a/b", "1/2/3", "-1/2", "1/65537",
        ] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
