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
        "beads.png",
        ["pi_darts", "is π by random darts"],
        None,
        "chapters/ch03_hit_or_miss/beads.toml",
    ),
    card(
        "ch04",
        "penumbra.png",
        [
            "slope_correct",
            "is the slope of the error: four times the rays for half of it",
        ],
        None,
        "chapters/ch04_half_disk/penumbra.toml",
    ),
    card(
        "ch05",
        "lifted.png",
        [
            "gain_solid",
            "uniform rays do the work of one cosine ray in space",
        ],
        None,
        "chapters/ch05_importance_sampling/lifted.toml",
    ),
    card(
        "ch06",
        "bleeding.png",
        [
            "bleeding_red_4",
            "times as much red as green on the white wall beside the red one",
        ],
        Some([
            ["direct.png", "direct light"],
            ["all.png", "and three bounces"],
        ]),
        "chapters/ch06_gather/bleeding.toml",
    ),
    card(
        "ch07",
        "house.png",
        [
            "price_ratio",
            "rays of trees buy what one ray of paths buys",
        ],
        None,
        "chapters/ch07_one_ray/house.toml",
    ),
    card(
        "ch08",
        "shares.png",
        [
            "slab_rays",
            "rays of a path through a pane of glass, where a tree splits without end",
        ],
        Some([
            ["image.png", "the picture"],
            ["choices.png", "which ray comes first"],
        ]),
        "chapters/ch08_which_ray/shares.toml",
    ),
    card(
        "ch09",
        "lantern.png",
        [
            "gain",
            "rays by chance do the work of one ray with aiming, at a small lamp",
        ],
        Some([
            ["chance_2.png", "by chance"],
            ["aim_2.png", "aimed at the lamp"],
        ]),
        "chapters/ch09_aim_at_the_light/lantern.toml",
    ),
    card(
        "ch10",
        "steps.png",
        [
            "depths_most",
            "segments of a path where they are longest, and no depth cut",
        ],
        None,
        "chapters/ch10_roulette/steps.toml",
    ),
    card(
        "ch11",
        "plates.png",
        [
            "premium",
            "squared means of variance at most, for not knowing which technique is better",
        ],
        Some([
            ["aiming.png", "aiming alone"],
            ["balance.png", "both, weighted"],
        ]),
        "chapters/ch11_combine/plates.toml",
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
        "row.png",
        [
            "variance_sum",
            "is the variance of all six integrals, one by one",
        ],
        Some([["none.png", "no integral"], ["all.png", "all six"]]),
        "chapters/ch13_six_integrals/row.toml",
    ),
    card(
        "ch14",
        "room.png",
        [
            "spheres_words",
            "different words spell the light of a box with two spheres",
        ],
        Some([
            ["direct.png", "LDE: direct light"],
            ["whole.png", "all paths"],
        ]),
        "chapters/ch14_alphabet/room.toml",
    ),
    card(
        "ch15",
        "hall.png",
        [
            "stays_blocks",
            "% is the error of the patches, which no sample takes away",
        ],
        Some([
            ["smooth.png", "patches"],
            ["gathered.png", "one more bounce by rays"],
        ]),
        "chapters/ch15_patches/hall.toml",
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
        "balls.png",
        [
            "leaving_bounded",
            "of the rays that leave a surface start wrongly, at any scale",
        ],
        Some([
            ["acne_end.png", "no care"],
            ["acne_bounded.png", "bounded rounding"],
        ]),
        "chapters/ch17_hard_cases/balls.toml",
    ),
    card(
        "ch18",
        "pyramid.png",
        [
            "slope_path",
            "is the slope of error against rays, whoever makes the picture",
        ],
        None,
        "chapters/ch18_cost/pyramid.toml",
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
