//! All integration tests in one binary: it links once, and its last line counts them.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod aiming;
mod chapters;
mod checks;
mod cli;
mod determinism;
mod film;
mod flatland;
mod gather;
mod hard_cases;
mod hit_or_miss;
mod ladder;
mod lights;
mod materials;
mod mistakes;
mod motion;
mod mutations;
mod notation;
mod path;
mod peers;
mod six_integrals;
mod table;
mod tidy;
mod truth;
mod twins;
mod warps;
