//! All integration tests in one binary: it links once, and its last line counts them.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    clippy::print_stderr
)]

mod aiming;
mod caustics;
mod chapters;
mod checks;
mod claims;
mod cli;
mod clock;
mod contacts;
mod cost;
mod determinism;
mod effects;
mod exercises;
mod exposure;
mod figures;
mod film;
mod flatland;
mod gather;
mod hard_cases;
mod hit_or_miss;
mod interruption;
mod ladder;
mod library;
mod light_tracer;
mod lights;
mod materials;
mod mistakes;
mod motion;
mod mutations;
mod notation;
mod of_chapters;
mod pairs;
mod parts;
mod path;
mod peers;
mod photons;
mod radiosity;
mod random_scenes;
mod references;
mod resume;
mod six_integrals;
mod stopping;
mod table;
mod target;
mod textures;
mod tidy;
mod truth;
mod twins;
mod warps;
mod white_walls;
