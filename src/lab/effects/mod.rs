//! Only what the scene calls for: which effects a scene has, which light paths follow from them,
//! what leaving one out would save and lose.
//!
//! * [`mod@plan`]: what is simulated and what is not, with reasons, from the scene alone;
//! * [`language`]: the light paths of a scene, of an integrator, of a class, as expressions;
//! * [`by_class`](mod@by_class): the light of a picture by the classes of its paths;
//! * [`missed`](mod@missed): light that an integrator cannot find;
//! * [`black`]: why a picture is black;
//! * [`without`]: an effect left out on purpose;
//! * [`words`]: how much light comes by which word;
//! * [`measure`]: what an effect costs in time, and what it changes in the picture.

pub mod black;
pub mod by_class;
pub mod language;
pub mod measure;
pub mod missed;
pub mod plan;
pub mod without;
pub mod words;

pub use plan::{Line, Plan, plan};
