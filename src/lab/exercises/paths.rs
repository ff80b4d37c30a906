//! Exercise 11: light paths as expressions.

use super::exam::mistake;
use super::{Entry, Exam, Question};
use crate::notation::{Expression, Letter, Word};

/// Two sets of light paths, each as an expression in Heckbert's letters.
#[derive(Clone, Copy, Debug)]
pub struct Paths {
    /// What Whitted's ray tracing finds.
    pub whitted: fn() -> &'static str,
    /// Caustics on a diffuse surface that is seen in mirrors or glass.
    pub mirrored_caustic: fn() -> &'static str,
}

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 11,
    name: "paths",
    title: "write two sets of light paths as expressions",
    page: "ch14-alphabet",
    points: 5,
    hints: &[
        "Read an expression from the light to the eye: L first, E last. S+ is one mirror or more, S* any number of them, D? at most one diffuse surface.",
        "Whitted's tree follows mirrors from the eye, and ends with a shadow ray at the first diffuse surface. A caustic has a mirror between the light and its first diffuse surface.",
    ],
    source: include_str!("../../../examples/exercises/ex11_paths.rs"),
};

/// What is right.
const RIGHT: [&str; 2] = ["LD?S*E", "LS+DS+E"];

/// The most surfaces of the words that are compared.
const SURFACES: u32 = 6;

/// The words of a light, some diffuse and specular surfaces, and the eye.
fn words() -> Vec<Vec<Letter>> {
    let of = |n: u32| {
        (0..1_u32 << n).map(move |bits| {
            let surface = |i| match bits >> i & 1 {
                0 => Letter::Diffuse,
                _ => Letter::Specular,
            };
            let middle = (0..n).map(surface);
            [Letter::Light]
                .into_iter()
                .chain(middle)
                .chain([Letter::Eye])
                .collect()
        })
    };
    (0..=SURFACES).flat_map(of).collect()
}

/// So many words are in the first expression and not in the second; NaN where one is no expression.
fn surplus(has: &str, lacks: &str) -> f64 {
    let (Ok(has), Ok(lacks)) = (Expression::parse(has), Expression::parse(lacks)) else {
        return f64::NAN;
    };
    let differs =
        |word: &&Vec<Letter>| has.light_first().accepts(word) && !lacks.light_first().accepts(word);
    words().iter().filter(differs).count() as f64
}

/// 1 where a word is in an expression, 0 where it is not; NaN where that is none.
fn accepts(expression: &str, word: &str) -> f64 {
    let (Ok(expression), Some(word)) = (Expression::parse(expression), Word::read(word)) else {
        return f64::NAN;
    };
    f64::from(u8::from(expression.light_first().accepts(&word.0)))
}

/// The shortest word that is in the first expression and not in the second, or why there is none.
fn for_instance(has: &str, lacks: &str) -> String {
    match (Expression::parse(has), Expression::parse(lacks)) {
        (Ok(has), Ok(lacks)) => {
            let differs = has.light_first().difference(lacks.light_first());
            let word = differs.shortest(1).first().map(ToString::to_string);
            word.map_or_else(String::new, |word| format!(" The shortest is {word}."))
        }
        (Err(error), _) | (_, Err(error)) => format!(" It is no expression: {error}."),
    }
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Paths> {
    let lacking = |what, part: fn(&Paths) -> &'static str, right: &'static str| {
        Question::exact(what, 0.0, move |a: &Paths| surplus(right, part(a)))
            .noted(move |a| for_instance(right, part(a)))
    };
    let surplus = |what, part: fn(&Paths) -> &'static str, right: &'static str| {
        Question::exact(what, 0.0, move |a: &Paths| surplus(part(a), right))
            .noted(move |a| for_instance(part(a), right))
    };
    let has = |what, part: fn(&Paths) -> &'static str| {
        Question::exact(what, 0.0, move |a: &Paths| accepts(part(a), "LSDE"))
    };
    let [whitted, caustic] = RIGHT;
    let right = Paths {
        whitted: || RIGHT[0],
        mirrored_caustic: || RIGHT[1],
    };
    let first = |name, forgot, whitted| mistake(name, forgot, Paths { whitted, ..right });
    let second = |name, forgot, mirrored_caustic| {
        mistake(
            name,
            forgot,
            Paths {
                mirrored_caustic,
                ..right
            },
        )
    };
    Exam::new(
        &ENTRY,
        vec![
            lacking(
                "the number of words with at most six surfaces that Whitted's tree finds and your expression lacks",
                |a| (a.whitted)(),
                whitted,
            ),
            surplus(
                "the number of words with at most six surfaces that your expression has and Whitted's tree does not find",
                |a| (a.whitted)(),
                whitted,
            ),
            has("the word LSDE in your first expression (1 or 0)", |a| {
                (a.whitted)()
            }),
            lacking(
                "the number of caustics in mirrors, with at most six surfaces, that your expression lacks",
                |a| (a.mirrored_caustic)(),
                caustic,
            ),
            surplus(
                "the number of words with at most six surfaces that your expression has and that are no caustics in mirrors",
                |a| (a.mirrored_caustic)(),
                caustic,
            ),
            has("the word LSDE in your second expression (1 or 0)", |a| {
                (a.mirrored_caustic)()
            }),
        ],
        vec![
            first(
                "everything",
                "that Whitted's tree has one diffuse surface at most",
                || "L(D|S)*E",
            ),
            first(
                "diffuse surface needed",
                "the lamp that is seen itself, or in a mirror: D is optional",
                || "LDS*E",
            ),
            first(
                "mirrors needed",
                "surfaces that are seen without any mirror: S* and not S+",
                || "LD?S+E",
            ),
            first(
                "one mirror",
                "that mirrors may follow mirrors: S* and not S?",
                || "LD?S?E",
            ),
            first(
                "mirrors at the light",
                "that the tree starts at the eye: mirrors come between the eye and the diffuse surface, not between that and the light",
                || "LS*D?E",
            ),
            first(
                "mirrors on both sides",
                "that no shadow ray goes by a mirror: what comes from the light by mirrors is missed",
                || "LS*D?S*E",
            ),
            first(
                "diffuse surfaces without end",
                "that the tree ends at the first diffuse surface",
                || "LD*S*E",
            ),
            second(
                "caustic seen directly",
                "the mirror in which it is seen: it stands before the eye",
                || "LS+DE",
            ),
            second(
                "no mirror at the light",
                "that a caustic is light which comes by a mirror: S+ after the light",
                || "LDS+E",
            ),
            second(
                "mirrors optional at the light",
                "that direct light is no caustic: S+ and not S* after the light",
                || "LS*DS+E",
            ),
            second(
                "mirrors optional at the eye",
                "that it shall be seen in a mirror: S+ and not S* before the eye",
                || "LS+DS*E",
            ),
            second(
                "one mirror each",
                "that mirrors may follow mirrors: S+ and not S",
                || "LSDSE",
            ),
            second(
                "several diffuse surfaces",
                "that a caustic lies on the first diffuse surface, and is seen from there: D and not D+",
                || "LS+D+S+E",
            ),
            second(
                "any order",
                "the order: from the light by mirrors to a diffuse surface, and by mirrors to the eye",
                || "L(D|S)+E",
            ),
        ],
    )
}
