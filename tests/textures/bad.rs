//! Textures that are none: told with their place.

use super::{four_colors, parse};

#[test]
fn bad_textures_are_told_with_their_place() {
    let folder = four_colors();
    std::fs::write(folder.path().join("no.png"), b"no image").unwrap();
    let camera = "[camera]\nfrom = [0, 0, 4]\nto = [0, 0, 0]\nfov = 40\n";
    let quad = "quad = { corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] }\n";
    for (albedo, field, what) in [
        (
            "{}",
            "albedo",
            "needs a kind of texture: one of checker, image",
        ),
        (
            "{ wood = 1 }",
            "albedo.wood",
            "is not a field here; allowed: `checker` or `image`",
        ),
        (
            "{ checker = { even = 1 } }",
            "albedo.checker.odd",
            "is missing",
        ),
        (
            "{ checker = { even = 2, odd = 0 } }",
            "albedo.checker.even",
            "must be between 0 and 1 in each channel",
        ),
        (
            "{ checker = { even = 0, odd = 1, fields = 0 } }",
            "albedo.checker.fields",
            "must be greater than 0 along u",
        ),
        (
            "{ checker = { even = 0, odd = 1, fields = [1, 2, 3] } }",
            "albedo.checker.fields",
            "2 numbers in brackets, or one number for both",
        ),
        (
            "{ checker = { even = 0, odd = 1, field = 1 } }",
            "albedo.checker.field",
            "`fields`",
        ),
        ("{ image = 'four.png' }", "albedo.image", "must be a table"),
        (
            "{ image = { file = 'none.png' } }",
            "albedo.image.file",
            "cannot be opened",
        ),
        (
            "{ image = { file = 'no.png' } }",
            "albedo.image.file",
            "is not a proper image",
        ),
        (
            "{ image = { file = 'four.png', scale = 2 } }",
            "albedo.image.file",
            "has a pixel in column 0 of row 0 that must be between 0 and 1",
        ),
        (
            "{ image = { file = 'four.png', repeat = -1 } }",
            "albedo.image.repeat",
            "must be greater than 0",
        ),
        (
            "{ checker = { even = 0, odd = 1 }, image = { file = 'four.png' } }",
            "albedo",
            "has both checker and image",
        ),
        (
            "'red'",
            "albedo",
            "3 numbers in brackets, or one number for all three",
        ),
    ] {
        let text = format!(
            "{camera}[materials.m]\nlambert = {{ albedo = {albedo} }}\n[[objects]]\nmaterial = 'm'\n{quad}"
        );
        let said = parse(&text, Some(folder.path())).unwrap_err().to_string();
        assert!(
            said.contains(&format!("materials.m.lambert.{field}")),
            "{albedo}: {said}"
        );
        assert!(said.contains(what), "{albedo}: {said}");
        assert!(said.starts_with("t.toml:9:"), "{albedo}: {said}");
    }
    let emits = |emits: &str| {
        let text = format!("{camera}[[objects]]\nemits = {emits}\n{quad}");
        parse(&text, Some(folder.path())).unwrap_err().to_string()
    };
    let said = emits("{ checker = { even = 0, odd = 0 } }");
    assert!(
        said.contains("objects[0].emits") && said.contains("gives no light at all"),
        "{said}"
    );
    let said = emits("{ checker = { even = -1, odd = 1 } }");
    assert!(
        said.contains("emits.checker.even") && said.contains("must be 0 or more"),
        "{said}"
    );
    // Shares that make light together are told as for plain colours.
    let text = format!(
        "{camera}[materials.m]\nmixture = {{ kd = {{ checker = {{ even = 0.1, odd = 0.8 }} }}, ks = 0.3, kt = 0 }}\n\
         [[objects]]\nmaterial = 'm'\n{quad}"
    );
    let said = parse(&text, None).unwrap_err().to_string();
    assert!(said.contains("at most 1 in each channel"), "{said}");
    // Scenes that come with the program name no files.
    let text = format!(
        "{camera}[materials.m]\nlambert = {{ albedo = {{ image = {{ file = 'four.png' }} }} }}\n"
    );
    let said = parse(&text, None).unwrap_err().to_string();
    assert!(
        said.contains("only possible in a scene file of its own"),
        "{said}"
    );
}
