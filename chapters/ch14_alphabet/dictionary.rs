//! What expressions say without a ray: the words that a tree misses, and thirty answered by hand.

use halfdisk::integrators::Whitted;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::effects::language::{Class, of_lamps};
use halfdisk::notation::{Expression, ExpressionError, Word};

use Class::{Bleeding, Caustic, Direct, DirectSpecular, Seen, SeenSpecular};

// ANCHOR: words
/// A word, the class it is in (none where it is no path from a light to the eye), and whether
/// Whitted's tree finds it.
const BY_HAND: [(&str, Option<Class>, bool); 30] = [
    ("LE", Some(Seen), true),
    ("LSE", Some(SeenSpecular), true),
    ("LSSE", Some(SeenSpecular), true),
    ("LSSSSSSE", Some(SeenSpecular), true),
    ("LDE", Some(Direct), true),
    ("LGE", Some(Direct), true),
    ("LDSE", Some(DirectSpecular), true),
    ("LDSSE", Some(DirectSpecular), true),
    ("LGSSE", Some(DirectSpecular), true),
    ("LDDE", Some(Bleeding), false),
    ("LDDDDE", Some(Bleeding), false),
    ("LDGE", Some(Bleeding), false),
    ("LGDE", Some(Bleeding), false),
    ("LDDSE", Some(Bleeding), false),
    ("LDSDE", Some(Bleeding), false),
    ("LGSSGE", Some(Bleeding), false),
    ("LDSDSSDE", Some(Bleeding), false),
    ("LSDE", Some(Caustic), false),
    ("LSSDE", Some(Caustic), false),
    ("LSGE", Some(Caustic), false),
    ("LSDSE", Some(Caustic), false),
    ("LSSDDE", Some(Caustic), false),
    ("LSSGDSE", Some(Caustic), false),
    ("", None, false),
    ("L", None, false),
    ("DE", None, false),
    ("LD", None, false),
    ("EDL", None, false),
    ("LLDE", None, false),
    ("LDEE", None, false),
];
// ANCHOR_END: words

/// Asks the expressions about each word.
pub fn ask(desk: &mut Desk) {
    let whitted = of_lamps(&Whitted::ENTRY);
    let mut right = 0;
    for (text, class, found) in BY_HAND {
        let Some(word) = Word::read(text) else {
            continue;
        };
        let among = |c: &Class| c.expression().light_first().accepts(&word.0);
        let classes: Vec<Class> = Class::ALL.into_iter().filter(among).collect();
        let tree = whitted
            .as_ref()
            .is_some_and(|w| w.light_first().accepts(&word.0));
        right += u32::from(classes == class.as_slice() && tree == found);
        let name = class.map_or("no light path", Class::name);
        let answer = if tree { "found" } else { "missed" };
        desk.say(&format!("{text:<9} {name:<35} {answer}"));
    }
    let says = "words answered as by hand, of thirty";
    desk.known("by_hand", says, f64::from(right), BY_HAND.len() as f64);
}

/// The words of the light that Whitted's tree misses.
pub fn missing(desk: &mut Desk) -> Result<(), DeskError> {
    let words = shortest_missing(36).map_err(|e| DeskError::Missing(e.to_string()))?;
    let first: Vec<String> = words.iter().take(6).map(Word::to_string).collect();
    desk.say(&format!("Whitted's tree misses {} …", first.join(", ")));
    for surfaces in 1..=4 {
        let with = words.iter().filter(|word| word.0.len() == surfaces + 2);
        let says = format!("words with {surfaces} surfaces that Whitted's tree misses");
        // Of 2^n words with n surfaces it has two: S alone, and D first.
        let exact = f64::from((1 << surfaces) - 2);
        desk.known(
            &format!("missing_{surfaces}"),
            &says,
            with.count() as f64,
            exact,
        );
    }
    Ok(())
}

// ANCHOR: missing
/// The first words of path tracing that are none of Whitted's tree.
fn shortest_missing(count: usize) -> Result<Vec<Word>, ExpressionError> {
    let whitted: Expression = "LD?S*E".parse()?;
    let everything: Expression = "L(D|S)*E".parse()?;
    let missing = everything.light_first().difference(whitted.light_first());
    Ok(missing.shortest(count))
}
// ANCHOR_END: missing
