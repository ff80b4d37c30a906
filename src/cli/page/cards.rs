//! What the gallery page shows of each chapter before all else: its best picture, one number, and where to
//! read on.

/// A chapter's card. What its run lacks, the page leaves out.
pub(super) struct Card {
    /// The chapter's short name.
    pub id: &'static str,
    /// The file of its best picture or chart.
    pub picture: &'static str,
    /// The name of its one number, and the words after it.
    pub number: [&'static str; 2],
    /// Two pictures of one view, to slide from the first to the second, with a word for each; those of another
    /// chapter with its folder.
    pub compare: Option<[[&'static str; 2]; 2]>,
    /// The scene of the picture, as a file of the repository.
    pub scene: &'static str,
}

const fn card(
    id: &'static str,
    picture: &'static str,
    number: [&'static str; 2],
    compare: Option<[[&'static str; 2]; 2]>,
    scene: &'static str,
) -> Card {
    Card {
        id,
        picture,
        number,
        compare,
        scene,
    }
}

/// The card of a chapter.
pub(super) fn of(id: &str) -> Option<&'static Card> {
    CARDS.iter().find(|card| card.id == id)
}

const CARDS: &[Card] = &[
    card(
        "ch01",
        "courtyard.png",
        [
            "wasted",
            "rays from the lamp are wasted for each one that enters the eye",
        ],
        Some([
            ["light.png", "from the lamp"],
            ["image.png", "from the eye"],
        ]),
        "examples/scenes/courtyard.toml",
    ),
    card(
        "ch02",
        "image.png",
        [
            "rays_14",
            "rays from one, after fourteen surfaces that split it",
        ],
        None,
        "examples/scenes/whitted.toml",
    ),
    card(
        "ch03",
        "darts.svg",
        ["pi_darts", "is π by random darts"],
        None,
        "",
    ),
    card(
        "ch04",
        "fan.svg",
        [
            "slope_correct",
            "is the slope of the error: four times the rays for half of it",
        ],
        None,
        "examples/flatland/lamp.toml",
    ),
    card(
        "ch05",
        "malley.svg",
        [
            "gain_solid",
            "uniform rays do the work of one cosine ray in space",
        ],
        None,
        "",
    ),
    card(
        "ch06",
        "all.png",
        [
            "bleeding_red_4",
            "times as much red as green on the white wall beside the red one",
        ],
        Some([
            ["direct.png", "direct light"],
            ["all.png", "and three bounces"],
        ]),
        "examples/scenes/cornell.toml",
    ),
    card(
        "ch07",
        "forty.png",
        [
            "price_ratio",
            "rays of trees buy what one ray of paths buys",
        ],
        None,
        "examples/scenes/cornell.toml",
    ),
    card(
        "ch08",
        "image.png",
        [
            "slab_rays",
            "rays of a path through a pane of glass, where a tree splits without end",
        ],
        Some([
            ["image.png", "the picture"],
            ["choices.png", "which ray comes first"],
        ]),
        "examples/scenes/mixture.toml",
    ),
    card(
        "ch09",
        "aim_2.png",
        [
            "gain",
            "rays by chance do the work of one ray with aiming, at a small lamp",
        ],
        Some([
            ["chance_2.png", "by chance"],
            ["aim_2.png", "aimed at the lamp"],
        ]),
        "examples/scenes/cornell.toml",
    ),
    card(
        "ch10",
        "wall.svg",
        [
            "depths_most",
            "segments of a path where they are longest, and no depth cut",
        ],
        None,
        "examples/scenes/cornell.toml",
    ),
    card(
        "ch11",
        "balance.png",
        [
            "premium",
            "squared means of variance at most, for not knowing which technique is better",
        ],
        Some([
            ["aiming.png", "aiming alone"],
            ["balance.png", "both, weighted"],
        ]),
        "examples/scenes/veach.toml",
    ),
    card(
        "ch12",
        "final.png",
        [
            "box_aiming_price",
            "rays without shadow rays do the work of one ray of the path tracer",
        ],
        Some([["chance.png", "by chance"], ["path.png", "the path tracer"]]),
        "examples/scenes/final.toml",
    ),
    card(
        "ch13",
        "all.png",
        [
            "variance_sum",
            "is the variance of all six integrals, one by one",
        ],
        Some([["none.png", "no integral"], ["all.png", "all six"]]),
        "examples/scenes/six.toml",
    ),
    card(
        "ch14",
        "whole.png",
        [
            "spheres_words",
            "different words spell the light of a box with two spheres",
        ],
        Some([
            ["direct.png", "LDE: direct light"],
            ["whole.png", "all paths"],
        ]),
        "examples/scenes/spheres.toml",
    ),
    card(
        "ch15",
        "gathered.png",
        [
            "stays_blocks",
            "% is the error of the patches, which no sample takes away",
        ],
        Some([
            ["smooth.png", "patches"],
            ["gathered.png", "one more bounce by rays"],
        ]),
        "examples/scenes/cornell.toml",
    ),
    card(
        "ch16",
        "evening.png",
        [
            "ratio_caustic",
            "times the error of photons has path tracing on a caustic, at 16 samples",
        ],
        Some([
            ["time_combine.png", "from the eye"],
            ["time_light_tracer.png", "from the lamp"],
        ]),
        "chapters/ch16_photons/evening.toml",
    ),
    card(
        "ch17",
        "acne_bounded.png",
        [
            "leaving_bounded",
            "of the rays that leave a surface start wrongly, at any scale",
        ],
        Some([
            ["acne_end.png", "no care"],
            ["acne_bounded.png", "bounded rounding"],
        ]),
        "chapters/ch17_hard_cases/acne.toml",
    ),
    card(
        "ch18",
        "required.svg",
        [
            "slope_path",
            "is the slope of error against rays, whoever makes the picture",
        ],
        None,
        "examples/scenes/cornell.toml",
    ),
    card(
        "ch19",
        "courtyard.png",
        [
            "asks",
            "of ten effects are simulated in a room that calls for no more",
        ],
        Some([
            ["ch01/courtyard.png", "chapter 1: direct light"],
            ["ch19/courtyard.png", "chapter 19: all light"],
        ]),
        "examples/scenes/courtyard.toml",
    ),
    card(
        "scenes",
        "sun.png",
        ["pictures", "pictures of materials, lights and recipes"],
        None,
        "examples/recipes/sun.toml",
    ),
];
