//! All integration tests in one binary: it links once, and its last line counts them.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod chapters;
mod hard_cases;
mod tidy;
mod truth;
mod warps;
