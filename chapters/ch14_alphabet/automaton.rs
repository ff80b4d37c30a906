//! The automaton of Whitted's tree on paper, and a check that it is the one in use.

use glam::DVec2;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::StrokeKind;
use halfdisk::lab::figures::sketch::{Sketch, toward};
use halfdisk::notation::{Expression, Letter};
use std::f64::consts::{FRAC_PI_2, PI};

/// The letters of the drawing, in the order of the table's columns.
const LETTERS: [Letter; 4] = [
    Letter::Light,
    Letter::Diffuse,
    Letter::Specular,
    Letter::Eye,
];

// ANCHOR: table
/// Where each letter leads from each state of `LD?S*E`: the start, after `L`, after `D` or `S`,
/// after `E`, and the one that no word leaves.
const NEXT: [[usize; 4]; 5] = [
    // L, D, S, E
    [1, 4, 4, 4],
    [4, 2, 2, 3],
    [4, 4, 2, 3],
    [4, 4, 4, 4],
    [4, 4, 4, 4],
];
/// The state in which a word is found.
const FOUND: usize = 3;

/// True for the words of `LD?S*E`.
fn is_found(word: &[usize]) -> bool {
    word.iter().fold(0, |state, &letter| NEXT[state][letter]) == FOUND
}
// ANCHOR_END: table

/// Letters of the longest words that are compared.
const LONGEST: u32 = 7;

/// Compares the table with the language of the expression, word by word.
fn compare(desk: &mut Desk) -> Result<(), DeskError> {
    let expression: Expression = "LD?S*E"
        .parse()
        .map_err(|e| DeskError::Missing(format!("LD?S*E: {e}")))?;
    let language = expression.light_first();
    let states = language.states() as f64;
    desk.known(
        "states",
        "states of the automaton of LD?S*E",
        states,
        NEXT.len() as f64,
    );
    let (mut words, mut alike) = (0_u32, 0_u32);
    for length in 0..=LONGEST {
        for number in 0..4_usize.pow(length) {
            let word: Vec<usize> = (0..length).map(|i| number >> (2 * i) & 3).collect();
            let letters: Vec<Letter> = word.iter().map(|&i| LETTERS[i]).collect();
            words += 1;
            alike += u32::from(is_found(&word) == language.accepts(&letters));
        }
    }
    let says = "words of up to seven letters, decided alike by the drawing";
    desk.known("alike", says, f64::from(alike), f64::from(words));
    Ok(())
}

/// Radius of a state.
const STATE: f64 = 0.34;

/// The states as circles, and an arrow for each letter.
pub fn drawing(desk: &mut Desk) -> Result<(), DeskError> {
    compare(desk)?;
    let mut sketch = Sketch::new("The automaton of LD?S*E", [-1.0, -2.55], [6.3, 1.65]);
    let at = DVec2::new;
    let places = [
        at(0.0, 0.0),
        at(1.8, 0.0),
        at(3.6, 0.0),
        at(5.4, 0.0),
        at(2.7, -1.8),
    ];
    let arrow = |sketch: &mut Sketch, kind, from: DVec2, to: DVec2| {
        let way = (to - from).normalize() * STATE;
        sketch.arrow(kind, from + way, to - way);
    };
    for place in places {
        sketch.circle(StrokeKind::Outline, place, STATE);
    }
    sketch.circle(StrokeKind::Outline, places[FOUND], STATE - 0.06);
    let found = StrokeKind::Camera;
    sketch.arrow(found, at(-0.9, 0.0), at(-STATE, 0.0));
    for (from, to, letters) in [(0, 1, "L"), (1, 2, "D or S"), (2, 3, "E")] {
        let (from, to) = (places[from], places[to]);
        arrow(&mut sketch, found, from, to);
        sketch.word(0.5 * (from + to) + at(0.0, 0.17), letters);
    }
    // From after L straight to the end, over the top.
    let (middle, radius) = (0.5 * (places[1] + places[3]), 1.8);
    let arch = |angle: f64| middle + toward(angle) * at(radius, 1.15);
    let angles = (0..=24).map(|i| PI - 0.3 - (PI - 0.6) * f64::from(i) / 24.0);
    let ways: Vec<DVec2> = angles.map(arch).collect();
    sketch.curve(found, ways.iter().copied());
    if let [.., from, to] = ways[..] {
        sketch.arrow(found, from, to);
    }
    sketch.word(middle + at(0.0, 1.32), "E");
    // S again and again.
    let (center, turn) = (places[2] + at(0.0, STATE + 0.17), 1.6 * PI);
    sketch.arc(found, center, 0.2, -FRAC_PI_2 + 0.2 * PI, turn);
    sketch.word(center + at(0.0, 0.33), "S");
    for place in &places[..4] {
        arrow(&mut sketch, StrokeKind::Lost, *place, places[4]);
    }
    for (place, word) in [
        (places[0], "0"),
        (places[1], "1"),
        (places[2], "2"),
        (places[FOUND], "3"),
        (places[4], "4"),
        (places[0] - at(0.25, 0.5), "start"),
        (places[FOUND] + at(0.3, -0.5), "found"),
        (places[4] - at(0.0, 0.5), "lost"),
        (at(0.75, -1.25), "any other letter"),
    ] {
        sketch.word(place, word);
    }
    desk.figure(
        "automaton.svg",
        "The five states of LD?S*E. Read a word letter by letter, and follow the arrows. A word is found if it ends in the \
         double circle. Grey arrows stand for all letters that have no arrow of their own; nothing leaves the state \
         they lead to, so a walk that comes there may stop.",
        sketch.to_svg()?,
    )
}
