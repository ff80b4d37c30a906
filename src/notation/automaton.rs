//! From a checked pattern to the smallest table that decides its words.

use super::Letter;
use super::language::{Language, Row};
use super::numbering::Numbering;
use regex_automata::dfa::{Automaton, StartKind, dense};
use regex_automata::nfa::thompson;
use regex_automata::util::primitives::StateID;
use regex_automata::util::{start, syntax};
use regex_automata::{Anchored, MatchKind};

/// The most states of an expression's automaton, so that two of them are compared in an instant.
pub(super) const MOST_STATES: usize = 512;

/// Bytes for the steps on the way to the table; a pattern that needs more is too large.
const NFA_BYTES: usize = 1 << 16;
const DFA_BYTES: usize = 1 << 16;
const DETERMINIZE_BYTES: usize = 1 << 20;

/// Which end of the pattern's words is read first.
#[derive(Clone, Copy)]
pub(super) enum Order {
    LightFirst,
    EyeFirst,
}

/// The language of a pattern of `regex-automata`; `None` where its automaton is too large.
pub(super) fn compile(pattern: &str, order: Order) -> Option<Language> {
    let steps = thompson::Config::new()
        .reverse(matches!(order, Order::EyeFirst))
        .utf8(false)
        .nfa_size_limit(Some(NFA_BYTES));
    // Every match counts, not the leftmost: a language has no preferences.
    let table = dense::Config::new()
        .match_kind(MatchKind::All)
        .start_kind(StartKind::Anchored)
        .accelerate(false)
        .dfa_size_limit(Some(DFA_BYTES))
        .determinize_size_limit(Some(DETERMINIZE_BYTES));
    // The pattern is well formed, so only its size can stop the builder.
    let dfa = dense::Builder::new()
        .configure(table)
        .thompson(steps)
        .syntax(syntax::Config::new().unicode(false).utf8(false))
        .build(pattern)
        .ok()?;
    let start = start::Config::new().anchored(Anchored::Yes);
    let (next, accepting) = explore(&dfa, dfa.start_state(&start).ok()?)?;
    Some(smallest(&next, &accepting))
}

/// Follows the five letters from `start`, in order of discovery.
fn explore(dfa: &impl Automaton, start: StateID) -> Option<(Vec<Row>, Vec<bool>)> {
    let mut found = Numbering::default();
    found.number(start);
    let (mut next, mut accepting) = (Vec::new(), Vec::new());
    while let Some(&state) = found.items.get(next.len()) {
        let step = |letter: Letter| dfa.next_state(state, letter.symbol() as u8);
        next.push(Letter::ALL.map(|letter| found.number(step(letter))));
        // This automaton tells of a match one step late: here, at the end of the word.
        accepting.push(dfa.is_match_state(dfa.next_eoi_state(state)));
        if found.items.len() > MOST_STATES {
            return None;
        }
    }
    Some((next, accepting))
}

/// Merges the states that no word tells apart.
///
/// Source: Moore, Gedanken-Experiments on Sequential Machines (Automata Studies, 1956): split by
/// acceptance, then by the parts that the letters lead to, until nothing splits.
fn smallest(next: &[Row], accepting: &[bool]) -> Language {
    let mut part: Vec<u32> = accepting.iter().map(|&a| u32::from(a)).collect();
    let mut parts = 0;
    loop {
        let mut finer = Numbering::default();
        let split = |(own, row): (&u32, &Row)| finer.number((*own, row.map(|s| part[s as usize])));
        let refined = part.iter().zip(next).map(split).collect();
        part = refined;
        if finer.items.len() == parts {
            break;
        }
        parts = finer.items.len();
    }
    // Parts are numbered as they appear, so the first state of each new number speaks for it.
    let (mut rows, mut accepts): (Vec<Row>, Vec<bool>) = (Vec::new(), Vec::new());
    for (state, &own) in part.iter().enumerate() {
        if own as usize == rows.len() {
            rows.push(next[state].map(|s| part[s as usize]));
            accepts.push(accepting[state]);
        }
    }
    Language::new(rows, accepts)
}
