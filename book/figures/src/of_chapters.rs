//! The algorithms that chapters own, as the figures use them.
#![allow(dead_code, reason = "a chapter uses what no figure asks for")]

#[path = "../../../chapters/ch10_roulette/survival.rs"]
pub mod survival;

#[path = "../../../chapters/ch16_photons/window.rs"]
pub mod window;
