//! The numbers behind the live figures of the book.
//!
//! Each figure has one handle. Its module turns the place of that handle, and for what is random a seed, into a list
//! of numbers, by the same functions that the chapters call. A page runs this crate as WebAssembly; what is drawn from
//! the numbers is said in `book/figures/web`, one script a figure.
//!
//! `law` gives closed forms, which the page draws as curves. `run` gives what random numbers make of them.
//! Handles outside of their range are moved into it, and what is no number counts as the lower end.

mod exports;
mod of_chapters;

pub mod darts;
pub mod half_disk;
pub mod inversion;
pub mod lamp;
pub mod path;
pub mod roulette;
pub mod window;

/// A handle within its range.
fn within(handle: f64, [low, high]: [f64; 2]) -> f64 {
    // In this order, because the larger of a number and of none is the number.
    handle.max(low).min(high)
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn handles_stay_within_their_range() {
        let range = [0.25, 2.0];
        let moved = [f64::NAN, f64::NEG_INFINITY, 1.0, 7.0].map(|x| within(x, range));
        assert_eq!(moved, [0.25, 0.25, 1.0, 2.0]);
    }
}
