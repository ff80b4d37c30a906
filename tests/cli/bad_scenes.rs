//! Scene files with one mistake each: the sentence names file, line and field, and what is right.

use super::{SCENE, folder, refused, scene_refused};

/// Tries mistakes, one on each line: what stands in [`SCENE`], what is put there instead, the field
/// and the words that the sentence must name; ⏎ is a line break. The guilty line is the one that
/// carries `# <-`, or else the one where the change begins.
fn check(mistakes: &str) {
    let folder = folder();
    for mistake in mistakes.trim().lines() {
        let mistake = mistake.replace('⏎', "\n");
        let parts: Vec<&str> = mistake.split(" | ").collect();
        let [right, wrong, field, words] = parts[..] else {
            panic!("four parts: {mistake}");
        };
        let at = SCENE.find(right).expect(right);
        let text = SCENE.replacen(right, wrong, 1);
        let marked = text.lines().position(|l| l.contains("# <-"));
        let line = 1 + marked.unwrap_or_else(|| SCENE[..at].matches('\n').count());
        scene_refused(folder.path(), text.as_bytes(), line, field, &[words]);
    }
}

#[test]
fn numbers_out_of_range() {
    check(
        r#"
[0.5, 0.4, 0.3] | [1.2, 0, 0] | materials.dull.lambert.albedo | between 0 and 1
[0.5, 0.4, 0.3] | [0, nan, 0] | materials.dull.lambert.albedo | green is NaN
[0.5, 0.4, 0.3] | -0.1 | materials.dull.lambert.albedo | between 0 and 1
reflectance = 0.9 | reflectance = 1.01 | materials.shiny.mirror.reflectance | 1.01
ior = 1.5 | ior = 0 | materials.clear.glass.ior | between 0.1 and 10
ior = 1.5 | ior = nan | materials.clear.glass.ior | between 0.1 and 10
ior = 1.5 | ior = 11 | materials.clear.glass.ior | between 0.1 and 10, not 11
mirror = { reflectance = 0.9 } | glossy = { reflectance = 1.1, roughness = 0.2 } | materials.shiny.glossy.reflectance | between 0 and 1
mirror = { reflectance = 0.9 } | glossy = { reflectance = 0.9, roughness = 0 } | materials.shiny.glossy.roughness | greater than 0 and at most 1, not 0; perfectly smooth surfaces are `mirror` and `glass`
mirror = { reflectance = 0.9 } | glossy = { reflectance = 0.9, roughness = -0.1 } | materials.shiny.glossy.roughness | not -0.1
mirror = { reflectance = 0.9 } | glossy = { reflectance = 0.9, roughness = 1.01 } | materials.shiny.glossy.roughness | at most 1, not 1.01
mirror = { reflectance = 0.9 } | glossy = { reflectance = 0.9,⏎roughness = nan } # <- | materials.shiny.glossy.roughness | not NaN
glass = { ior = 1.5 } | rough_glass = { ior = 0, roughness = 0.2 } | materials.clear.rough_glass.ior | between 0.1 and 10
glass = { ior = 1.5 } | rough_glass = { ior = 1.5, roughness = inf } | materials.clear.rough_glass.roughness | not inf
lambert = { albedo = [0.5, 0.4, 0.3] } | mixture = { kd = 0.7, ks = [0.1, 0.7, 0.1], kt = 0 } | materials.dull.mixture | kd + ks + kt at most 1 in each channel, or it would make light, but in green they add up to 1.4
lambert = { albedo = [0.5, 0.4, 0.3] } | mixture = { kd = 0.5, ks = 0.3, kt = -0.1 } | materials.dull.mixture.kt | between 0 and 1
lambert = { albedo = [0.5, 0.4, 0.3] } | mixture = { kd = nan, ks = 0.3, kt = 0.1 } | materials.dull.mixture.kd | red is NaN
lambert = { albedo = [0.5, 0.4, 0.3] } | mixture = { kd = 0, ks = 0, kt = 1, ior = -1.5 } | materials.dull.mixture.ior | between 0.1 and 10
background = 0.5 | background = [0, 0, -1] | background | 0 or more
background = 0.5 | background = 1e39 | background | 0 or more
background = 0.5 | background = 0.5⏎environment = { radiance = 1 } # <- | environment | beside `background`
background = 0.5 | environment = { radiance = -1 } | environment.radiance | 0 or more
background = 0.5 | environment = {} | environment | one of radiance, image
background = 0.5 | environment = { radiance = 1, image = "a.hdr" } | environment | both radiance and image
background = 0.5 | environment = { radiance = 1, scale = 2 } | environment.scale | with an `image`
background = 0.5 | environment = { radiance = 1, rotate = 2 } | environment.rotate | with an `image`
background = 0.5 | environment = { image = "a.hdr", scale = 0 } | environment.scale | greater than 0
background = 0.5 | environment = { image = "a.hdr", rotate = nan } | environment.rotate | finite
background = 0.5 | environment = { image = "a.jpg" } | environment.image | .exr, .hdr and .png
background = 0.5 | environment = { image = "none.hdr" } | environment.image | cannot be opened
background = 0.5 | environment = { picture = "a.hdr" } | environment.picture | `radiance`, `image`
radius = 0.5 | radius = -1 | objects[1].sphere.radius | greater than 0, not -1
radius = 0.5 | radius = 0 | objects[1].sphere.radius | greater than 0
radius = 0.5 | radius = -0.0 | objects[1].sphere.radius | greater than 0
radius = 0.5 | radius = 1e-46 | objects[1].sphere.radius | greater than 0
radius = 0.5 | radius = inf | objects[1].sphere.radius | finite
radius = 0.5 | radius = 3e38 | objects[1].sphere.radius | 3.4e38
radius = 0.3 | radius = 0 | objects[4].bumpy_sphere.radius | greater than 0
columns = 8 | columns = 2 | objects[4].bumpy_sphere.columns | from 3 to 4096
rows = 6 | rows = 5000 | objects[4].bumpy_sphere.rows | from 2 to 4096
fov = 40 | fov = nan | camera.fov | between 0 and 180
fov = 40 | fov = 0 | camera.fov | between 0 and 180
fov = 40 | fov = 180 | camera.fov | between 0 and 180
fov = 40 | fov = -20.0 | camera.fov | not -20
fov = 40 | lens_radius = -1⏎fov = 40 | camera.lens_radius | must be 0 or more, not -1
fov = 40 | lens_radius = nan⏎fov = 40 | camera.lens_radius | finite
fov = 40 | lens_radius = 1e39⏎fov = 40 | camera.lens_radius | finite
fov = 40 | focus = 0⏎fov = 40 | camera.focus | greater than 0
fov = 40 | focus = nan⏎fov = 40 | camera.focus | finite
fov = 40 | focus = -3⏎fov = 40 | camera.focus | greater than 0, not -3
fov = 40 | shutter = [0, nan]⏎fov = 40 | camera.shutter[1] | finite
fov = 40 | shutter = [-inf, 1]⏎fov = 40 | camera.shutter[0] | not -inf
fov = 40 | shutter = [1, 0.5]⏎fov = 40 | camera.shutter | must not close before it opens, but opens at 1 and closes at 0.5
radius = 0.5 | radius = 0.5 }⏎motion = [0, nan, 0 ] # <-⏎#{ | objects[1].motion[1] | finite
radius = 0.5 | radius = 0.5 }⏎motion = [1e39, 0, 0] # <-⏎#{ | objects[1].motion[0] | finite
radius = 0.5 | radius = 0.5 }⏎motion = [1, 0] # <-⏎#{ | objects[1].motion | 3 numbers in brackets
[12, 8] | [0, 8] | film.size[0] | from 1 to 65536, not 0
[12, 8] | [12, -8] | film.size[1] | from 1 to 65536, not -8
[12, 8] | [1000000000, 8] | film.size[0] | not 1000000000
[12, 8] | [60000, 60000] | film.size | 33554432 pixels in all
max_depth = 4 | max_depth = 0 | render.max_depth | from 1 to 100000
spp = 1 | spp = -1 | render.spp | from 1 to 16777216
"#,
    );
}

#[test]
fn coordinates_that_are_no_place() {
    check(
        r#"
from = [0, 1, 6] | from = [0, 1e39, 6] | camera.from[1] | finite number
from = [0, 1, 6] | from = [0,⏎1,⏎-inf] # <- | camera.from[2] | not -inf
center = [1, 0.5, 0] | center = [inf, 0.5, 0] | objects[1].sphere.center[0] | not inf
center = [1, 0.5, 0] | center = [3e38, 0, 0] | objects[1].sphere.center | 3.4e38
u = [6, 0, 0] | u = [nan, 0, 0] | objects[0].quad.u[0] | not NaN
c = [0, 1, 0] | c = [0, 1e39, 0] | objects[2].triangle.c[1] | finite
max = [-1, 1, 0] | max = [-1, inf, 0] | objects[3].box.max[1] | finite
position = [1, 4, 2] | position = [1, 4, nan] | lights[0].point.position[2] | finite
translate = [0, 0.1, 0] | translate = [1e39, 0, 0] | objects[1].transform.translate[0] | finite
degrees = 30 | degrees = inf | objects[1].transform.rotate.degrees | finite
axis = [0, 1, 0] | axis = [0, 0, 0] | objects[1].transform.rotate.axis | direction
[0, -1, -1] | [0, 0, 0.0] | lights[1].directional.direction | must not be [0, 0, 0]
up = [0, 1, 0] | up = [0, 0, 0] | camera.up | must not be [0, 0, 0]
up = [0, 1, 0] | up = [0, 0.5, 6] | camera.up | parallel
up = [0, 1, 0] | up = [0, -0.5, -6] | camera.up | parallel
to = [0, 0.5, 0] | to = [0, 1, 6] | camera.to | another point than `camera.from`
to = [0, 0.5, 0] | to = [1e-200, 1, 6] | camera.to | another point
scale = 1.5 | scale = [1, 0, 1] | objects[1].transform.scale | must not be 0
scale = 1.5 | scale = 1e-46 | objects[1].transform.scale | must not be 0
radius = 0.5 }⏎transform = { scale = 1.5 | radius = 0.5 }⏎transform = { scale = [1, 2, 1] | objects[1].sphere | differently along different axes
u = [6, 0, 0] | u = [0, 0, 3] | objects[0].quad | no area
u = [6, 0, 0] | u = [0, 0, 0] | objects[0].quad | no area
u = [6, 0, 0] | u = [3e38, 0, 0] | objects[0].quad | no area: its edges are parallel, zero or too large
c = [0, 1, 0] | c = [1, 0, 0] | objects[2].triangle | no area
c = [0, 1, 0] | c = [0, 0, 0] | objects[2].triangle | no area
max = [-1, 1, 0] | max = [-1, 0, 0] | objects[3].box | `min` below that of `max`
"#,
    );
}

#[test]
fn lights_that_give_no_light() {
    check(
        r#"
intensity = 9 | intensity = 0 | lights[0].point.intensity | no light at all
intensity = 9 | intensity = [1, 1, -1] | lights[0].point.intensity | 0 or more
[0.1, 0.2, 0.3] | inf | lights[1].directional.irradiance | red is inf
[0.1, 0.2, 0.3] | [0.0, 1e-46, 0] | lights[1].directional.irradiance | no light
emits = [2, 2, 2] | emits = [0, 0, 0] | objects[5].emits | no light at all
emits = [2, 2, 2] | emits = [-1, 2, 2] | objects[5].emits | red is -1
u = [2, 0, 0], v = [0, 0, 2] | u = [1e-25, 0, 0], v = [0, 0, 1e-25] | objects[5].quad | area
[[lights]]⏎point = { | [[lights]]⏎directional = { direction = [0, 1, 0], irradiance = 1 }⏎point = { | lights[0] | both point and directional
[[lights]]⏎point | [[lights]]⏎[[lights]]⏎point | lights[0] | one of point, directional
"#,
    );
}

#[test]
fn fields_that_are_misspelt_or_missing() {
    check(
        r#"
about = | abuot = | abuot | is not a field here; allowed: `name`, `about`
max_depth = 4 | maxdepth = 4 | render.maxdepth | allowed: `max_depth` or `spp`
fov = 40 | fow = 40 | camera.fow | allowed: `from`, `to`, `up`, `fov`, `lens_radius`, `focus`, `shutter`
size = [12, 8] | sizes = [12, 8] | film.sizes | allowed: `size`
lambert = | lambret = | materials.dull.lambret | `lambert`, `mirror`, `glass`
albedo = | color = | materials.dull.lambert.color | allowed: `albedo`
reflectance = | r = | materials.shiny.mirror.r | allowed: `reflectance`
ior = | n = | materials.clear.glass.n | allowed: `ior`
mirror = { reflectance = 0.9 } | glossy = { reflectance = 0.9 } | materials.shiny.glossy.roughness | is missing
mirror = { reflectance = 0.9 } | mixture = { kd = 1 } | materials.shiny.mixture.ks | is missing
mirror = { reflectance = 0.9 } | glossy = { reflectance = 0.9, alpha = 1 } | materials.shiny.glossy.alpha | allowed: `reflectance` or `roughness`
point = | spot = | lights[0].spot | allowed: `point` or `directional`
intensity = | power = | lights[0].point.power | `position` or `intensity`
irradiance = | power = | lights[1].directional.power | `irradiance`
sphere = | ball = | objects[1].ball | `sphere`, `quad`
radius = 0.5 | r = 0.5 | objects[1].sphere.r | `center`, `radius`, `inward`
v = [0, 0, -6] | w = [0, 0, -6] | objects[0].quad.w | `corner`, `u`, `v`
c = [0, 1, 0] | d = [0, 1, 0] | objects[2].triangle.d | `a`, `b`, `c`
max = [-1, 1, 0] | top = [-1, 1, 0] | objects[3].box.top | `min` or `max`
rows = | lines = | objects[4].bumpy_sphere.lines | `rows`
translate = | shift = | objects[1].transform.shift | `scale`, `rotate`, `translate`
axis = | about = | objects[1].transform.rotate.about | `axis` or `degrees`
background = 0.5 | "a\nb" = 0.5 | "a\nb" | is not a field here
name = "sample" |  | name | is missing
[camera]⏎from = [0, 1, 6]⏎to = [0, 0.5, 0]⏎up = [0, 1, 0]⏎fov = 40 | [camera]⏎from = [0, 1, 6]⏎to = [0, 0.5, 0] | camera.fov | is missing
[camera]⏎from = [0, 1, 6]⏎ | [camera] # <-⏎ | camera.from | is missing
[film]⏎size = [12, 8] | [film] | film.size | is missing
{ albedo = [0.5, 0.4, 0.3] } | {} | materials.dull.lambert.albedo | is missing
, radius = 0.5 |  | objects[1].sphere.radius | is missing
, v = [0, 0, -6] |  | objects[0].quad.v | is missing
, degrees = 30 |  | objects[1].transform.rotate.degrees | is missing
sphere = { center = [1, 0.5, 0], radius = 0.5 }⏎transform = { scale = 1.5, rotate = { axis = [0, 1, 0], degrees = 30 }, translate = [0, 0.1, 0] } | [objects.transform]⏎scale = 1⏎[objects.sphere] # <-⏎center = [1, 0.5, 0] | objects[1].sphere.radius | is missing
sphere = { center = [1, 0.5, 0], radius = 0.5 }⏎transform | sphere.center = [1, 0.5, 0]⏎sphere.radius = "big" # <-⏎transform | objects[1].sphere.radius | must be a number
"#,
    );
}

#[test]
fn values_of_another_kind() {
    check(
        r#"
name = "sample" | name = 3 | name | must be a string, not the integer `3`
name = "sample" | name = " " | name | must not be empty
fov = 40 | fov = "wide" | camera.fov | must be a number, not the string "wide"
fov = 40 | fov = [40] | camera.fov | must be a number, not a list
fov = 40 | fov = { degrees = 40 } | camera.fov | must be a number, not a table
fov = 40 | fov = 1e400 | camera.fov | overflow
lambert = { albedo = [0.5, 0.4, 0.3] } | lambert = 1e400 | materials.dull.lambert | overflows: no number is larger than 1.8e308
fov = 40 | fov = 1979-05-27 | camera.fov | must be a number, not the date
fov = 40 | fov = 99999999999999999999 | camera.fov | must be a number, not the integer `99999999999999999999`
fov = 40 | fov = 0xfffffffffffffffffffffffffffffffffffff | camera.fov | overflows
radius = 0.5 } | radius = 0.5 }⏎two_sided = true # <- | objects[1].two_sided | only possible with `emits`
emits = [2, 2, 2] | emits = [2, 2, 2]⏎two_sided = 1 # <- | objects[5].two_sided | must be a boolean
scale = 1.5 | scale = [1, nan, 1] | objects[1].transform.scale[1] | finite
background = 0.5 | environment = { image = 3 } | environment.image | must be a path in quotes, not the integer `3`
background = 0.5 | environment = 3 | environment | must be a table, not the integer `3`; its fields are a radiance or an image, scale, rotate
from = [0, 1, 6] | from = 6 | camera.from | must be 3 numbers in brackets
from = [0, 1, 6] | from = [0, 6] | camera.from | must be 3 numbers in brackets, not 2
from = [0, 1, 6] | from = [0, 1, 6, 1] | camera.from | 3 numbers in brackets, not 4
from = [0, 1, 6] | from = [] | camera.from | not 0 of them
from = [0, 1, 6] | from = [0,⏎1,⏎"6" # <-⏎] | camera.from[2] | must be a number
[12, 8] | [12, 8, 3] | film.size | must be 2 numbers in brackets, not 3
[12, 8] | [12.5, 8] | film.size[0] | must be a whole number, not the floating
[12, 8] | [99999999999999999999, 8] | film.size[0] | must be a whole number
[0.5, 0.4, 0.3] | [0.5, 0.4] | materials.dull.lambert.albedo | not 2 of them
[0.5, 0.4, 0.3] | [1, 1, 1, 1] | materials.dull.lambert.albedo | one number for all
[0.5, 0.4, 0.3] | "red" | materials.dull.lambert.albedo | 3 numbers in brackets
{ albedo = [0.5, 0.4, 0.3] } | 0.5 | materials.dull.lambert | must be a table
scale = 1.5 | scale = [1, 2] | objects[1].transform.scale | not 2 of them
columns = 8 | columns = 8.5 | objects[4].bumpy_sphere.columns | a whole number
material = "dull" | material = 1 | objects[0].material | must be a string
material = "dull" | material = "dill" | objects[0].material | defined are clear, dull, shiny
[[objects]]⏎material = "dull"⏎quad | [[objects]]⏎quad | objects[0] | needs a `material`, or `emits`
[materials.dull] | [materials.dull]⏎mirror = { reflectance = 1 } | materials.dull | both lambert and mirror
[materials.dull]⏎lambert = { albedo = [0.5, 0.4, 0.3] } | [materials.dull] | materials.dull | one of lambert, mirror, glass
[[objects]]⏎material = "clear"⏎triangle = { a = [-1, 0, 0], b = [0, 0, 0], c = [0, 1, 0] } | [[objects]]⏎material = "clear" | objects[2] | needs a shape: one of
[[objects]]⏎material = "clear" | [[objects]]⏎material = "clear"⏎sphere = { center = [0, 0, 0], radius = 1 } | objects[2] | both sphere and triangle
"#,
    );
    let folder = folder();
    for (wrong, field, words) in [
        (
            "objects = 3",
            "objects",
            "must be a list, not the integer `3`",
        ),
        (
            "objects = [3]",
            "objects[0]",
            "its fields are material, emits, two_sided, transform, motion, a shape",
        ),
        ("objects = [3]", "objects[0]", "must be a table"),
        ("lights = [{}, 3]", "lights[1]", "must be a table"),
        (
            "camera = 3",
            "camera",
            "must be a table, not the integer `3`",
        ),
        (
            "film = { size = [[1, 2], 3] }",
            "film.size[0]",
            "must be a whole number, not a list",
        ),
    ] {
        let text = format!("name = \"a\"\n\n{wrong}\n");
        scene_refused(folder.path(), text.as_bytes(), 3, field, &[words]);
    }
}

#[test]
fn text_that_is_no_toml() {
    check(
        r#"
fov = 40 | fov = 40⏎fov = 50 # <- |  | is not proper TOML: duplicate key
[film] | [film |  | is not proper TOML: unclosed table
fov = 40 | fov 40 |  | is not proper TOML
fov = 40 | fov =  |  | is not proper TOML
fov = 40 | fov = 4O |  | is not proper TOML
name = "sample" | name = "sample |  | is not proper TOML
[film] | [camera] |  | is not proper TOML
"#,
    );
    let folder = folder();
    scene_refused(folder.path(), b"", 1, "name", &["is missing"]);
    let latin1 = b"name = \"a\"\nbackground = 1\nabout = \"caf\xe9\"\n";
    scene_refused(folder.path(), latin1, 3, "", &["not text", "UTF-8"]);
    scene_refused(folder.path(), b"\xff\xfen\0", 1, "", &["TOML"]);
    scene_refused(folder.path(), b"\xff\xfen", 1, "", &["not text", "UTF-8"]);
    scene_refused(
        folder.path(),
        b"name = \"a\0b\"\n",
        1,
        "",
        &["not proper TOML"],
    );
}

#[test]
fn a_list_in_the_place_of_a_table_is_told_the_fields_of_the_table() {
    check(
        r#"
rotate = { axis = [0, 1, 0], degrees = 30 } | rotate = [0, 90, 0] | objects[1].transform.rotate | must be a table, not a list; its fields are axis, degrees
rotate = { axis = [0, 1, 0], degrees = 30 } | rotate = [[0, 1, 0], 30] | objects[1].transform.rotate | must be a table, not a list; its fields are axis, degrees
sphere = { center = [1, 0.5, 0], radius = 0.5 } | sphere = [[1, 0.5, 0], 0.5] | objects[1].sphere | must be a table, not a list; its fields are center, radius, inward
lambert = { albedo = [0.5, 0.4, 0.3] } | lambert = [0.5] | materials.dull.lambert | must be a table, not a list; its fields are albedo
"#,
    );
}

#[test]
fn a_field_nearly_right_is_followed_by_the_one_that_is_meant() {
    check(
        r#"
fov = 40 | fow = 40 | camera.fow | `focus`, `shutter`; did you mean `fov`?
lambert = | lambret = | materials.dull.lambret | `mixture`; did you mean `lambert`?
sphere = | Sphere = | objects[1].Sphere | `bumpy_sphere`; did you mean `sphere`?
intensity = | intensty = | lights[0].point.intensty | `position` or `intensity`; did you mean `intensity`?
"#,
    );
}

#[test]
fn words_for_a_choice_are_no_fields() {
    check(
        r#"
material = "dull"⏎quad | material = "dull"⏎"a shape" = 3 # <-⏎quad | objects[0]."a shape" | is not a field here
background = 0.5 | environment = { "a radiance or an image" = 1 } | environment."a radiance or an image" | `radiance`, `image`
[materials.dull] | [materials."a shape"]⏎lambert = { albedo = 2 } # <-⏎[materials.dull] | materials."a shape".lambert.albedo | between 0 and 1
[[lights]]⏎point = { | [[lights]]⏎"kind of light" = 3 # <-⏎point = { | lights[0]."kind of light" | `point` or `directional`
"#,
    );
}

#[test]
fn names_that_are_no_scene() {
    let folder = folder();
    std::fs::write(folder.path().join("scene.json"), "{}").unwrap();
    std::fs::create_dir(folder.path().join("scenes")).unwrap();
    std::fs::create_dir(folder.path().join("folder.toml")).unwrap();
    for (name, words) in [
        (
            "cornel",
            "`cornel` is neither a scene of the gallery (cornell, spheres,",
        ),
        (
            "",
            "no scene is named: give one of the gallery (cornell, spheres,",
        ),
        (
            "scene.json",
            "scene.json: is not a scene file: their names end in .toml",
        ),
        (
            "scenes",
            "scenes: is not a scene file: their names end in .toml",
        ),
        ("folder.toml", "folder.toml: cannot be read: "),
        ("none.toml", "none.toml: cannot be read: "),
    ] {
        let sentence = refused(folder.path(), &["render", name], 2);
        assert!(sentence.starts_with(words), "{sentence}");
        assert!(!folder.path().join("out").exists());
    }
    for (name, meant) in [
        ("cornel", "cornell"),
        ("Cornell", "cornell"),
        ("CAUSTICS", "caustic"),
        ("sphere", "spheres"),
    ] {
        let sentence = refused(folder.path(), &["effects", name], 2);
        let ends = format!("nor a file; did you mean `{meant}`?");
        assert!(sentence.ends_with(&ends), "{sentence}");
    }
    let sentence = refused(folder.path(), &["render", "music"], 2);
    assert!(sentence.ends_with("nor a file"), "{sentence}");
    let sentence = refused(folder.path(), &["scenes", "--show", "cornel"], 2);
    assert!(sentence.starts_with("`cornel` is neither"), "{sentence}");
}

#[test]
fn the_sample_itself_is_right() {
    let folder = folder();
    std::fs::write(folder.path().join("good.toml"), SCENE).unwrap();
    let output = super::halfdisk(folder.path(), &["render", "good.toml"]);
    assert!(output.status.success(), "{}", super::complaint(&output));
    assert!(folder.path().join("out/good.png").exists());
}
