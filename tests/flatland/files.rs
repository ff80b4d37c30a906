//! Files of the flat world: the gallery, and what a wrong file is told.

use halfdisk::flatland::{Shape, gallery, load};
use halfdisk::scene::read::Source;

/// A proper world, one line for each thing that can be wrong.
const GOOD: &str = r#"name = "good"
background = 0.5
[probe]
at = [0, 0]
normal = [0, 1]
[window]
min = [-2, -1]
max = [2, 3]
[materials.wall]
albedo = 0.7
[[objects]]
material = "wall"
segment = { from = [-1, 0], to = [1, 0] }
[[objects]]
emits = [1, 2, 3]
circle = { center = [0, 2], radius = 0.5 }
[[objects]]
albedo = 0.2
polyline = { points = [[0, 0], [1, 0], [1, 1]], closed = true }
[[lamps]]
point = { position = [3, 3], power = 10 }
"#;

fn complaint(text: &str) -> String {
    let file = "yard.toml";
    match gallery::from_text(Source { file, text }) {
        Ok(world) => panic!("accepted: {world:?}\n{text}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn a_wrong_file_is_told_line_and_field() {
    let file = "good.toml";
    assert!(gallery::from_text(Source { file, text: GOOD }).is_ok());
    let cases = [
        (
            "at = [0, 0]",
            "at = [0, 0.01]",
            ":4: `probe.at` must lie on the surface of an object",
        ),
        (
            "normal = [0, 1]",
            "normal = [1, 1]",
            ":5: `probe.normal` must be at right angles",
        ),
        (
            "background = 0.5",
            "background = -1",
            ":2: `background` must be 0 or more",
        ),
        (
            "background = 0.5",
            "sky = 1",
            ":2: `sky` is not a field here",
        ),
        ("at = [0, 0]", "at = [0, nan]", ":4: `probe.at"),
        (
            "at = [0, 0]",
            "at = [0, 0, 0]",
            ":4: `probe.at` must be 2 numbers in brackets, not 3",
        ),
        (
            "normal = [0, 1]",
            "normal = [0, 0]",
            ":5: `probe.normal` must not be [0, 0]",
        ),
        (
            "max = [2, 3]",
            "max = [2, -3]",
            ":8: `window.max` must be above",
        ),
        (
            "albedo = 0.7",
            "albedo = 1.2",
            ":10: `materials.wall.albedo` must be between 0 and 1",
        ),
        (
            r#""wall""#,
            r#""roof""#,
            r#":12: `objects[0].material` names "roof"; defined are wall"#,
        ),
        (
            r#"material = "wall""#,
            "",
            "`objects[0]` needs an `albedo`, a `material`, a `mirror`, `glass`, or `emits`",
        ),
        (
            r#"material = "wall""#,
            "material = \"wall\"\nalbedo = 0.5",
            "`objects[0]` has both `material` and `albedo`",
        ),
        (
            "to = [1, 0] }",
            "to = [-1, 0] }",
            ":13: `objects[0].segment.to` must be another point",
        ),
        (
            "to = [1, 0] }",
            "to = [1e39, 0] }",
            ":13: `objects[0].segment.to",
        ),
        (
            "to = [1, 0] }",
            "}",
            ":13: `objects[0].segment.to` is missing",
        ),
        (
            "emits = [1, 2, 3]",
            "emits = 0",
            ":15: `objects[1].emits` gives no light at all",
        ),
        (
            "radius = 0.5",
            "radius = -0.5",
            ":16: `objects[1].circle.radius` must be greater than 0",
        ),
        (
            "circle =",
            "segment = { from = [0, 0], to = [1, 1] }\ncircle =",
            "`objects[1]` has both segment and circle, but takes only one shape",
        ),
        (
            "circle = { center = [0, 2], radius = 0.5 }",
            "",
            "`objects[1]` needs a shape: one of",
        ),
        (
            "[1, 0], [1, 1]]",
            "[0, 0], [1, 1]]",
            "`objects[2].polyline.points[1]` must be another",
        ),
        (
            "[1, 0], [1, 1]]",
            "[1, 0], [0, 0]]",
            ".points[2]` must be another point than the first",
        ),
        (
            "[1, 0], [1, 1]]",
            "[1, 0]]",
            "`objects[2].polyline.points` must be 3 points or more",
        ),
        (
            "closed = true",
            "closed = 1",
            ":19: `objects[2].polyline.closed`",
        ),
        (
            "power = 10",
            "power = [1, 1, inf]",
            ":21: `lamps[0].point.power` must be 0 or more",
        ),
        (
            "point = {",
            "sun = {",
            ":21: `lamps[0].sun` is not a field here",
        ),
        (
            "[[lamps]]\npoint",
            "[[lamps]]\n#",
            ":20: `lamps[0]` needs a kind of lamp",
        ),
        ("name = \"good\"\n", "", "`name` is missing"),
    ];
    for (right, wrong, expected) in cases {
        let text = GOOD.replacen(right, wrong, 1);
        assert_ne!(text, GOOD, "{right} is not in the file");
        let complaint = complaint(&text);
        println!("{complaint}");
        assert!(complaint.starts_with("yard.toml:"), "{complaint}");
        assert!(
            complaint.contains(expected),
            "{complaint}\n  is not\n{expected}"
        );
    }
}

#[test]
fn the_gallery_loads_and_other_names_are_refused() {
    for (name, _) in gallery::GALLERY {
        let world = load(name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(world.name, *name);
        assert!(!world.about.is_empty());
        let p = world.probe.expect("a probe").surface;
        let down = world.first_hit(p.p + p.n * 1e-3, -p.n).expect("ground");
        assert!((down.t - 1e-3).abs() < 1e-6, "{name}: {}", down.t);
    }
    let names = "(furnace, lamp, plates, room, yard)";
    assert!(load("roof").unwrap_err().to_string().contains(names));
    assert!(
        load("no/such.toml")
            .unwrap_err()
            .to_string()
            .contains("cannot be read")
    );
}

#[test]
fn the_probe_faces_the_side_it_wants() {
    let file = "sides.toml";
    let emission = |y: f32| {
        let text = GOOD.replace("normal = [0, 1]", &format!("normal = [0, {y:?}]"));
        let text = text.replace("material = \"wall\"", "material = \"wall\"\nemits = 2");
        let world = gallery::from_text(Source { file, text: &text }).unwrap();
        let probe = world.probe.unwrap();
        assert_eq!((probe.object, probe.albedo.g), (0, 0.7));
        assert_eq!(probe.surface.n.y, y);
        probe.emitted(probe.surface.n).g
    };
    assert_eq!((emission(1.0), emission(-1.0)), (2.0, 0.0));
}

#[test]
fn a_polyline_turns_in_or_out_by_its_direction() {
    let file = "turn.toml";
    let faces = |points: &str| {
        let shape = format!("polyline = {{ points = {points}, closed = true }}");
        let text = format!("name = \"turn\"\n[[objects]]\nalbedo = 1\n{shape}");
        let world = gallery::from_text(Source { file, text: &text }).unwrap();
        let inwards = |shape: &Shape| match shape {
            Shape::Segment(s) => {
                let middle = s.surface_at(0.5);
                middle.n.dot(glam::Vec2::splat(0.5) - middle.p) > 0.0
            }
            Shape::Circle(_) | Shape::Ellipse(_) => false,
        };
        world
            .parts()
            .iter()
            .map(|p| inwards(&p.shape))
            .collect::<Vec<_>>()
    };
    assert_eq!(faces("[[0, 0], [1, 0], [1, 1], [0, 1]]"), [true; 4]);
    assert_eq!(faces("[[0, 0], [0, 1], [1, 1], [1, 0]]"), [false; 4]);
}
