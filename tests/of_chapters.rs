//! The algorithms that chapters own, as the tests use them.
#![allow(dead_code, reason = "a chapter uses what no test asks for")]

#[path = "../chapters/ch01_from_the_eye/two_ways.rs"]
pub mod two_ways;

#[path = "../chapters/ch12_the_path_tracer/left_out.rs"]
pub mod left_out;

#[path = "../chapters/ch13_six_integrals/profiles.rs"]
pub mod profiles;

#[path = "../chapters/ch07_one_ray/split.rs"]
pub mod split;

#[path = "../chapters/ch08_which_ray/mixed_furnace.rs"]
pub mod mixed_furnace;

#[path = "../chapters/ch10_roulette/survival.rs"]
pub mod survival;

#[path = "../chapters/ch09_aim_at_the_light/pick_one.rs"]
pub mod pick_one;

#[path = "../chapters/ch09_aim_at_the_light/shrinking_lamp.rs"]
pub mod shrinking_lamp;

#[path = "../chapters/ch18_cost/noise.rs"]
pub mod noise;

#[path = "../chapters/ch17_hard_cases/spacing.rs"]
pub mod spacing;
