//! Exercises that are graded by what they read.
//!
//! A learner writes a function or two; the grader asks them for numbers whose right values are known in closed form,
//! and compares the readings with a table of hypotheses: the right answer, and each mistake that people make. A
//! mistake is a whole answer with one thing wrong, read by the same code with other random numbers. So a wrong answer
//! is told what it forgot, and not just that it is wrong.
//!
//! The question's noise decides what can be told: a reading is wrong beyond 4.4 standard errors, and every two
//! hypotheses lie farther apart than that in one question at least, which a test asserts. Where no hypothesis fits, the
//! products of two are tried, then a common factor; then the grader says what it saw.
//!
//! Each exercise has one source, `examples/exercises/exNN_name.rs`: what stands between `// BEGIN SOLUTION` and
//! `// END SOLUTION` is cut out for the learner.
//!
//! ```
//! use halfdisk::glam::Vec2;
//! use halfdisk::lab::exercises::samplers::FlatSampler;
//! use halfdisk::lab::exercises::{Verdict, half_disk};
//!
//! // The density of the whole circle.
//! let answer = FlatSampler {
//!     sample: |u| Vec2::from_angle(std::f32::consts::PI * u),
//!     pdf: |w| if w.y >= 0.0 { 0.5 * std::f32::consts::FRAC_1_PI } else { 0.0 },
//! };
//! let report = half_disk::exam().grade(&answer, 1);
//! assert_eq!(report.verdict, Verdict::Named);
//! assert_eq!(report.mistakes, ["density of the whole circle"]);
//! ```

mod constants;
mod draw;
mod entry;
mod exam;
mod question;
mod report;
mod run;
mod words;

pub mod choose;
pub mod compensated;
pub mod cosine;
pub mod edge;
pub mod form_factor;
pub mod gather;
pub mod half_disk;
pub mod malley;
pub mod mis;
pub mod next_event;
pub mod open;
pub mod paths;
pub mod roulette;
pub mod samplers;
pub mod sphere_lamp;
pub mod turn;

pub use draw::Draw;
pub use entry::{Entry, LADDER, of_number};
pub use exam::{Exam, Finding, Mistake};
pub use question::{Question, Reading};
pub use report::{Check, Report, Results, Verdict};
pub use run::{guarded, main};
