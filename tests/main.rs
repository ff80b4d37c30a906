//! All integration tests in one binary: it links once, and its last line counts them.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod chapters;
mod cli;
mod determinism;
mod film;
mod flatland;
mod hard_cases;
mod mutations;
mod tidy;
mod truth;
mod warps;
