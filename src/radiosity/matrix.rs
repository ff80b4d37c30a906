//! A square matrix of form factors.

/// Form factors, row by row: entry `(i, j)` is the share of the light leaving patch `i` that reaches
/// patch `j`, which by reciprocity also says how much of `i`'s view `j` takes up.
///
/// `f32` for pictures, `f64` where digits are counted.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix<T = f32> {
    size: usize,
    entries: Vec<T>,
}

impl<T: Copy + Into<f64>> Matrix<T> {
    /// The matrix of rows that follow each other.
    ///
    /// # Panics
    ///
    /// Where the entries are not those of a square.
    pub fn new(size: usize, entries: Vec<T>) -> Self {
        assert_eq!(entries.len(), size * size, "a square of side {size}");
        Matrix { size, entries }
    }

    /// Rows, and columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// One row.
    pub fn row(&self, i: usize) -> &[T] {
        &self.entries[i * self.size..(i + 1) * self.size]
    }

    /// One entry.
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.entries[i * self.size + j].into()
    }

    /// The sum of a row: 1 where a patch sees other patches everywhere.
    pub fn row_sum(&self, i: usize) -> f64 {
        self.row(i).iter().map(|&f| f.into()).sum()
    }
}
