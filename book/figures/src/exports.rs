//! What a page calls: a function for each list of numbers, which returns its length, and one that reads the list.
//!
//! Numbers are read one by one, so nobody needs an address in this program's memory.

#![expect(
    unsafe_code,
    reason = "a name that a page can call might be another function's, too, which only the linker sees"
)]

use crate::{darts, half_disk, inversion, lamp, path, roulette, window};
use std::cell::RefCell;

thread_local! {
    /// The last list.
    static NUMBERS: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

fn keep(numbers: Vec<f64>) -> u32 {
    let length = numbers.len() as u32;
    NUMBERS.set(numbers);
    length
}

/// The number at a place of the last list; no number beyond its end.
#[unsafe(no_mangle)]
pub extern "C" fn number(index: u32) -> f64 {
    NUMBERS.with_borrow(|all| all.get(index as usize).copied().unwrap_or(f64::NAN))
}

macro_rules! export {
    ($($name:ident: $numbers:expr;)*) => {$(
        #[unsafe(no_mangle)]
        #[doc = concat!("`", stringify!($numbers), "`: keeps the list and returns its length.")]
        pub extern "C" fn $name(handle: f64, seed: u32) -> u32 {
            let numbers: fn(f64, u32) -> Vec<f64> = $numbers;
            keep(numbers(handle, seed))
        }
    )*};
}

export! {
    half_disk: half_disk::run;
    inversion: |handle, _| inversion::law(handle);
    path: path::run;
    lamp_law: |handle, _| lamp::law(handle);
    lamp: lamp::run;
    roulette_law: |handle, _| roulette::law(handle);
    roulette: roulette::run;
    window_law: |handle, _| window::law(handle);
    window: window::run;
    darts: darts::run;
    board: darts::board;
}
