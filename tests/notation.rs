//! Words and expressions, against answers by hand and against a matcher that is slow and obvious.

use halfdisk::notation::{Expression, Language, Letter, Word};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn expression(text: &str) -> Expression {
    Expression::parse(text).unwrap_or_else(|e| panic!("{e}"))
}

fn word(text: &str) -> Word {
    Word::read(text).unwrap()
}

fn spelled(language: &Language, limit: usize) -> Vec<String> {
    let words = language.shortest(limit);
    words.iter().map(Word::to_string).collect()
}

/// Every word of up to `longest` letters, in order.
fn all_words(longest: usize) -> Vec<Word> {
    let mut words = vec![Word::default()];
    let mut start = 0;
    for _ in 0..longest {
        let end = words.len();
        for i in start..end {
            for letter in Letter::ALL {
                let mut longer = words[i].clone();
                longer.0.push(letter);
                words.push(longer);
            }
        }
        start = end;
    }
    words
}

/// An expression as a tree, and what it means by definition.
#[derive(Clone, Debug)]
enum Tree {
    Letter(Letter),
    Chain(Vec<Tree>),
    Either(Vec<Tree>),
    Repeat(Box<Tree>, u32, Option<u32>),
}

impl Tree {
    fn text(&self) -> String {
        let join = |parts: &[Tree], by| parts.iter().map(Tree::text).collect::<Vec<_>>().join(by);
        match self {
            Tree::Letter(l) => l.symbol().to_string(),
            Tree::Chain(parts) => format!("({})", join(parts, " ")),
            Tree::Either(parts) => format!("({})", join(parts, "|")),
            Tree::Repeat(part, low, high) => {
                let count = match (low, high) {
                    (0, None) => "*".to_owned(),
                    (1, None) => "+".to_owned(),
                    (0, Some(1)) => "?".to_owned(),
                    (low, None) => format!("{{{low},}}"),
                    (low, Some(high)) if low == high => format!("{{{low}}}"),
                    (low, Some(high)) => format!("{{{low},{high}}}"),
                };
                format!("({}){count}", part.text())
            }
        }
    }

    /// Where a match may end (bit k: after k letters) that begins at one of the `starts`.
    fn ends(&self, word: &[Letter], starts: u32) -> u32 {
        match self {
            Tree::Letter(l) => (0..word.len())
                .filter(|&k| starts >> k & 1 == 1 && word[k] == *l)
                .fold(0, |ends, k| ends | 2 << k),
            Tree::Chain(parts) => parts.iter().fold(starts, |at, p| p.ends(word, at)),
            Tree::Either(parts) => parts.iter().fold(0, |all, p| all | p.ends(word, starts)),
            Tree::Repeat(part, low, high) => {
                let mut at = (0..*low).fold(starts, |at, _| part.ends(word, at));
                let mut all = at;
                // Without an upper count, more turns than letters reach nothing new.
                for _ in 0..high.map_or(word.len() as u32 + 1, |high| high - low) {
                    at = part.ends(word, at);
                    all |= at;
                }
                all
            }
        }
    }

    fn matches(&self, word: &Word) -> bool {
        self.ends(&word.0, 1) >> word.0.len() & 1 == 1
    }
}

fn trees() -> impl Strategy<Value = Tree> {
    let leaf = proptest::sample::select(Letter::ALL.to_vec()).prop_map(Tree::Letter);
    leaf.prop_recursive(3, 12, 3, |inner| {
        let parts = || prop::collection::vec(inner.clone(), 1..4);
        let more = prop::option::of(0..3_u32);
        prop_oneof![
            parts().prop_map(Tree::Chain),
            parts().prop_map(Tree::Either),
            (inner.clone(), 0..3_u32, more).prop_map(|(t, low, more)| Tree::Repeat(
                Box::new(t),
                low,
                more.map(|m| low + m)
            )),
        ]
    })
}

#[test]
fn words_by_hand() {
    for (text, accepted, rejected) in [
        (
            "LD?S*E",
            "LE LDE LSE LDSE LSSE LDSSSE",
            "LDDE LSDE LDGE LD EDL",
        ),
        ("L(S|D)*E", "LE LDSDE LSSDDE", "LGE LDLE LDEE SDE"),
        ("LS+DE", "LSDE LSSSDE", "LDE LSE LSDDE LDSE"),
        ("LDD+E", "LDDE LDDDDE", "LDE LE LDDSE"),
        ("L(D|S|G)*E", "LE LGE LDSGSDE", "LGLE GE LG"),
        ("LD{2,3}E", "LDDE LDDDE", "LE LDE LDDDDE"),
        ("LD{2}E", "LDDE", "LDE LDDDE"),
        ("LD{2,}E", "LDDE LDDDDDDE", "LDE LE"),
        ("LD{0}E", "LE", "LDE"),
        ("L[DG]S?E", "LDE LGSE", "LE LSE LDGE"),
        (" L .* E ", "LE LLE LESGDE", "E L LD"),
        ("LDE|LS(SD)*E", "LDE LSE LSSDE LSSDSDE", "LDSE LSSE LSDE"),
    ] {
        let e = expression(text);
        for (words, expected) in [(accepted, true), (rejected, false)] {
            for w in words.split(' ').map(word) {
                assert_eq!(e.light_first().accepts(&w.0), expected, "{w} in {text}");
                assert_eq!(
                    e.eye_first().accepts(&w.reversed().0),
                    expected,
                    "{w} in {text}"
                );
            }
        }
    }
}

#[test]
fn what_whitted_misses_by_hand() {
    let (whitted, all) = (expression("LD?S*E"), expression("L(D|S)*E"));
    let (whitted, all) = (whitted.light_first(), all.light_first());
    assert!(all.includes(whitted) && !whitted.includes(all));
    let missing = [
        "LDDE", "LSDE", "LDDDE", "LDDSE", "LDSDE", "LSDDE", "LSDSE", "LSSDE", "LDDDDE",
    ];
    assert_eq!(spelled(&all.difference(whitted), 9), missing);

    let caustics = expression("LS+DE");
    let caustics = caustics.light_first();
    assert!(!whitted.includes(caustics) && all.includes(caustics));
    assert_eq!(spelled(&caustics.difference(whitted), 2), ["LSDE", "LSSDE"]);
    assert!(whitted.intersection(caustics).is_empty());
    assert!(whitted.intersection(caustics).shortest(3).is_empty());
    assert_eq!(spelled(&whitted.intersection(all), 3), ["LE", "LDE", "LSE"]);
    assert_eq!(spelled(whitted, 0).len(), 0);
}

#[test]
fn different_spellings_are_equal_languages_with_the_fewest_states() {
    let languages = [
        "L(D|S)*E",
        "L[DS]*E",
        "L(D*S*)*E",
        "L((D|S)+)?E",
        "L(S*D)*S*E",
    ];
    for text in languages {
        let e = expression(text);
        assert_eq!(
            e.light_first(),
            expression(languages[0]).light_first(),
            "{text}"
        );
        // Before L, after it, after E, and lost.
        assert_eq!(
            (e.light_first().states(), e.eye_first().states()),
            (4, 4),
            "{text}"
        );
    }
    assert_ne!(
        expression("LD*E").light_first(),
        expression("LD+E").light_first()
    );
    assert_eq!(expression("LD?S*E").light_first().states(), 5);
    assert_eq!(
        spelled(expression("D{2}|E|SL").light_first(), 9),
        ["E", "DD", "SL"]
    );
}

#[test]
fn a_state_gives_up_as_soon_as_no_word_can_follow() {
    let words = all_words(7);
    for text in [
        "LD?S*E",
        "L(S|D)*E",
        "LS+DE",
        "LDD+E",
        "L(D|S|G)*E",
        "LD{2,3}E",
        "LDE|LS(SD)*E",
    ] {
        let e = expression(text);
        for language in [e.light_first(), e.eye_first()] {
            let accepted: Vec<&Word> = words.iter().filter(|w| language.accepts(&w.0)).collect();
            // From anywhere, these expressions are at most four letters from a word.
            for start in words.iter().filter(|w| w.0.len() <= 3) {
                let state = start.0.iter().fold(language.start(), |s, &l| s.next(l));
                let follows = accepted.iter().any(|w| w.0.starts_with(&start.0));
                assert_eq!(state.can_still_accept(), follows, "{start} in {text}");
            }
        }
    }
}

#[test]
fn an_error_points_at_its_character() {
    for (text, position, what) in [
        (
            "L(D|S*E",
            Some(2),
            "L(D|S*E: the group opened at character 2 is never closed",
        ),
        (
            "",
            Some(1),
            "an expression of nothing: character 1 is missing; allowed are L, D, S, G, E, `.`, `[` or `(`",
        ),
        (
            "LDE)",
            Some(4),
            "LDE): character 4 is `)`, but no group is open",
        ),
        (
            "L(|D)E",
            Some(3),
            "L(|D)E: character 3 is `|` after nothing; allowed are L, D, S, G, E, `.`, `[` or `(`",
        ),
        (
            "*E",
            Some(1),
            "*E: character 1 is `*` with nothing to repeat; allowed are L, D, S, G, E, `.`, `[` or `(`",
        ),
        (
            "LD+?E",
            Some(4),
            "LD+?E: character 4 is `?` on a repeat; put what it repeats in `(...)`",
        ),
        (
            "L D|",
            Some(5),
            "L D|: character 5 is missing; allowed are L, D, S, G, E, `.`, `[` or `(`",
        ),
        (
            "L[^D]E",
            Some(3),
            "L[^D]E: character 3 is `^`; between `[` and `]` stand L, D, S, G, E",
        ),
        (
            "L[]E",
            Some(3),
            "L[]E: character 3 is `]`; between `[` and `]` stand L, D, S, G, E",
        ),
        (
            "L[DS",
            Some(2),
            "L[DS: the `[` at character 2 is never closed",
        ),
        (
            "LD{3,2}E",
            Some(3),
            "LD{3,2}E: character 3 asks for 3 to 2; the larger count is second",
        ),
        (
            "LD{}E",
            Some(4),
            "LD{}E: character 4 is `}`; counts are written {2}, {2,} or {2,3}",
        ),
        (
            "LD{1 2}E",
            Some(6),
            "LD{1 2}E: character 6 is `2`; counts are written {2}, {2,} or {2,3}",
        ),
        (
            "LD{65}E",
            Some(5),
            "LD{65}E: character 5 makes a count of 65; the most is 64",
        ),
        (
            "LD{2",
            Some(3),
            "LD{2: the `{` at character 3 is never closed; counts are written {2}, {2,} or {2,3}",
        ),
        (
            "(.*D.{12}){64}",
            None,
            "(.*D.{12}){64}: needs more than 512 states; lower its counts",
        ),
    ] {
        let error = Expression::parse(text).expect_err(text);
        assert_eq!(
            (error.position, error.to_string().as_str()),
            (position, what)
        );
    }
    for foreign in [
        "^LE", "L\\dE", "lDE", "LXE", "L-E", "LE$", "Lé", "(?i)LE", "L\0E", "L\u{1b}E",
    ] {
        let error = Expression::parse(foreign).expect_err(foreign).to_string();
        assert!(
            error.contains(": character ") && !error.contains(char::is_control),
            "{error}"
        );
    }
}

#[test]
fn garbage_stays_small() {
    let deep = format!("{}D{}", "(".repeat(33), ")".repeat(33));
    let grown = (0..30).fold("D".to_owned(), |inner, _| format!("({inner}){{64}}"));
    let void = (0..30).fold("D{0}".to_owned(), |inner, _| format!("({inner}){{64}}"));
    for text in [
        deep,
        grown,
        "D".repeat(257),
        "[DS]*D.{60}".to_owned(),
        ".{60}D[DS]*".to_owned(),
    ] {
        assert!(Expression::parse(&text).is_err(), "{text}");
    }
    // Nothing, 64 to the 30th times, is still nothing.
    if let Ok(e) = Expression::parse(&void) {
        assert_eq!(spelled(e.light_first(), 9), [""]);
    }
    // The largest products, and many words that share their beginnings.
    let (a, b) = (expression("(D{61})*"), expression("(D{64})*"));
    let both = a.light_first().intersection(b.light_first());
    assert_eq!(both.shortest(2)[1].0.len(), 61 * 64);
    let long = expression("L(D|S|G){64}E").light_first().shortest(3);
    assert!(long.iter().all(|w| w.0.len() == 66) && long.is_sorted());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, rng_seed: RngSeed::Fixed(3), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn languages_agree_with_the_definition(a in trees(), b in trees()) {
        let (ea, eb) = (expression(&a.text()), expression(&b.text()));
        let (la, lb) = (ea.light_first(), eb.light_first());
        let (minus, both) = (la.difference(lb), la.intersection(lb));
        let mut missing = Vec::new();
        for w in all_words(7) {
            let (in_a, in_b) = (a.matches(&w), b.matches(&w));
            prop_assert_eq!(la.accepts(&w.0), in_a, "{} in {}", w, a.text());
            prop_assert_eq!(ea.eye_first().accepts(&w.reversed().0), in_a, "{} in {}", w, a.text());
            prop_assert_eq!(both.accepts(&w.0), in_a && in_b);
            prop_assert_eq!(minus.accepts(&w.0), in_a && !in_b);
            if in_a {
                let starts = (0..=w.0.len()).map(|k| w.0[..k].iter().fold(la.start(), |s, &l| s.next(l)));
                prop_assert!(starts.into_iter().all(|s| s.can_still_accept()));
            }
            if in_a && !in_b {
                missing.push(w);
            }
        }
        let first = minus.shortest(20);
        let short: Vec<Word> = first.iter().filter(|w| w.0.len() <= 7).cloned().collect();
        prop_assert_eq!(&short[..], &missing[..missing.len().min(20)]);
        prop_assert!(first.is_sorted());
        prop_assert!(first.iter().all(|w| a.matches(w) && !b.matches(w)) || first.iter().any(|w| w.0.len() > 30));
        prop_assert_eq!(lb.includes(la), first.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, rng_seed: RngSeed::Fixed(3), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_read_or_refused_in_one_line(
        text in prop_oneof!["[LDSGE.|()*+?{},0-9 \\[\\]]{0,24}", "\\PC{0,40}", any::<String>()]
    ) {
        match Expression::parse(&text) {
            Ok(e) => prop_assert_eq!(e.to_string(), text),
            Err(e) => {
                let line = e.to_string();
                prop_assert!(!line.contains(char::is_control) && line.len() < 600, "{line:?}");
                prop_assert!(e.position.is_none_or(|p| (1..=text.chars().count() + 1).contains(&p)));
            }
        }
    }
}
