#!/usr/bin/env python3
"""Error times time of halfdisk and of Mitsuba 3 on the same scenes, in turns: lower is better.

    pip install mitsuba
    cargo build --release
    python3 benches/peers.py target/release/halfdisk            # the four scenes
    python3 benches/peers.py target/release/halfdisk cornell    # one of them

The scenes are read from examples/scenes and told to Mitsuba: quads, boxes, spheres and the bumpy sphere; `lambert`,
`mirror` and `glass`. The error of a picture is the mean over pixels and channels of (picture - reference)^2 /
(reference^2 + 0.01), without the pixels in and around lamps, and without the reference's own error. The reference is a
long render by halfdisk with another seed; that both programs mean the same scene is told by their means, which are
printed. Seconds are those of the pixel loops: no loading, and Mitsuba's code compiled by a picture before.
"""

import json
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path

import mitsuba as mi
import numpy as np

SCENES = Path(__file__).parent.parent / "examples" / "scenes"
SAMPLES = {"cornell": 256, "spheres": 256, "caustic": 1024, "mesh": 256}
REFERENCE_SAMPLES = 16  # times as many
VARIANT = "llvm_ad_rgb"
PASS = 128  # samples that Mitsuba's memory has room for
SEEDS = (1, 2)


def rgb(value):
    """A colour from a number or three."""
    return {"type": "rgb", "value": [float(x) for x in np.broadcast_to(value, 3)]}


def bsdf(material):
    """A material as Mitsuba calls it; what only shines is black."""
    match material:
        case None:
            return {"type": "diffuse", "reflectance": rgb(0)}
        case {"lambert": {"albedo": albedo}}:
            return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(albedo)}}
        case {"mirror": {"reflectance": reflectance}}:
            metal = {"type": "conductor", "material": "none", "specular_reflectance": rgb(reflectance)}
            return {"type": "twosided", "bsdf": metal}
        case {"glass": {"ior": ior}}:
            return {"type": "dielectric", "int_ior": ior, "ext_ior": 1.0}
    sys.exit(f"this script cannot tell Mitsuba of the material {material}")


def bumpy_sphere(center, radius, columns, rows):
    """The mesh of src/scene/procedural.rs."""
    theta = (np.pi * np.arange(1, rows) / rows)[:, None]
    phi = (2 * np.pi * np.arange(columns) / columns)[None, :]
    square = np.sin(theta) ** 2
    bumps = 0.12 * np.sin(6 * theta) * np.sin(8 * phi) + 0.03 * np.sin(40 * theta) * np.sin(36 * phi)
    r = radius * (1 + bumps * square)
    x, y, z = r * np.sin(theta) * np.cos(phi), r * np.cos(theta), r * np.sin(theta) * np.sin(phi)
    poles = np.array([[0, radius, 0], [0, -radius, 0]])
    points = np.concatenate([poles[:1], np.stack([x, y, z], -1).reshape(-1, 3), poles[1:]]) + center
    at = 1 + np.arange((rows - 1) * columns).reshape(rows - 1, columns)
    right = np.roll(at, -1, 1)
    top = np.stack([np.zeros(columns, int), right[0], at[0]], -1)
    bottom = np.stack([at[-1], right[-1], np.full(columns, len(points) - 1)], -1)
    upper = np.stack([at[:-1], right[:-1], right[1:]], -1).reshape(-1, 3)
    lower = np.stack([at[:-1], right[1:], at[1:]], -1).reshape(-1, 3)
    faces = np.concatenate([top, upper, lower, bottom])
    mesh = mi.Mesh("bumpy", len(points), len(faces))
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = points.astype("f4").ravel()
    parameters["faces"] = faces.astype("u4").ravel()
    parameters.update()
    path = Path(tempfile.mkdtemp()) / "bumpy.ply"
    mesh.write_ply(str(path))
    return {"type": "ply", "filename": str(path), "face_normals": True}


def shape(thing):
    """A shape in its place."""
    place = mi.ScalarTransform4f()
    if transform := thing.get("transform"):
        turn = transform["rotate"]
        place = place.translate(transform["translate"]).rotate(turn["axis"], turn["degrees"])
    match thing:
        case {"quad": quad}:
            corner, u, v = (np.array(quad[key], float) for key in ("corner", "u", "v"))
            normal = np.cross(u, v)
            matrix = np.eye(4)
            matrix[:3] = np.stack([u / 2, v / 2, normal / np.linalg.norm(normal), corner + u / 2 + v / 2], 1)
            return {"type": "rectangle", "to_world": mi.ScalarTransform4f(matrix)}
        case {"box": {"min": low, "max": high}}:
            low, high = np.array(low, float), np.array(high, float)
            middle, half = (low + high) / 2, (high - low) / 2
            return {"type": "cube", "to_world": place.translate(list(middle)).scale(list(half))}
        case {"sphere": ball}:
            return {"type": "sphere", "center": [float(x) for x in ball["center"]], "radius": float(ball["radius"])}
        case {"bumpy_sphere": bumpy}:
            return bumpy_sphere(**bumpy)
    sys.exit(f"this script cannot tell Mitsuba of the shape {thing}")


def told(name):
    """A scene of the gallery as Mitsuba's."""
    said = tomllib.loads((SCENES / f"{name}.toml").read_text())
    camera, [width, height] = said["camera"], said["film"]["size"]
    film = {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"}, "pixel_format": "rgb"}
    look = mi.ScalarTransform4f().look_at(camera["from"], camera["to"], [0, 1, 0])
    scene = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": said["render"]["max_depth"], "rr_depth": 5},
        "sensor": {"type": "perspective", "fov": camera["fov"], "fov_axis": "y", "to_world": look, "film": film},
    }
    for i, thing in enumerate(said["objects"]):
        own = shape(thing) | {"bsdf": bsdf(said["materials"].get(thing.get("material")))}
        if "emits" in thing:
            own["emitter"] = {"type": "area", "radiance": rgb(thing["emits"])}
        scene[f"object{i}"] = own
    return mi.load_dict(scene)


def by_mitsuba(scene, samples, seed):
    """Seconds, and the picture."""
    passes = max(1, samples // PASS)
    start = time.perf_counter()
    total = sum(np.array(mi.render(scene, spp=samples // passes, seed=1000 * seed + i), "f8") for i in range(passes))
    return time.perf_counter() - start, total / passes


def by_halfdisk(program, name, samples, seed, folder):
    """Seconds, and the picture."""
    out = str(Path(folder) / "picture.exr")
    command = [program, "render", name, "--spp", str(samples), "--seed", str(seed), "--out", out, "--json"]
    said = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    bitmap = mi.Bitmap(out)
    names = [field.name for field in bitmap.struct_()]
    picture = np.array(bitmap)[..., [names.index(channel) for channel in "RGB"]]
    return said["seconds"], picture.astype("f8")


def reference(program, name, samples, folder):
    """The mean of two long renders, the pixels that count, and the error of that mean."""
    halves = [by_halfdisk(program, name, samples, seed, folder)[1] for seed in (101, 102)]
    mean = sum(halves) / 2
    lamp = (mean > 2).any(-1)
    near = lamp.copy()
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            near |= np.roll(np.roll(lamp, dy, 0), dx, 1)
    floor = ((halves[0] - halves[1]) / 2) ** 2 / (mean**2 + 0.01)
    return mean, ~near, floor[~near].mean()


def compare(program, name, folder):
    """One line for a scene."""
    samples = SAMPLES[name]
    mean, counts, floor = reference(program, name, samples * REFERENCE_SAMPLES // 2, folder)
    scene = told(name)
    by_mitsuba(scene, min(samples, PASS), 99)
    costs = {"halfdisk": [], "Mitsuba": []}
    for seed in SEEDS:
        for who, (seconds, picture) in (
            ("Mitsuba", by_mitsuba(scene, samples, seed)),
            ("halfdisk", by_halfdisk(program, name, samples, seed, folder)),
        ):
            error = ((picture - mean) ** 2 / (mean**2 + 0.01))[counts].mean() - floor
            costs[who].append((seconds, error, picture[counts].mean()))
    line, products = [], {}
    for who, runs in costs.items():
        seconds, error, brightness = np.mean(runs, 0)
        products[who] = seconds * error
        line.append(f"{who} {seconds:.2f} s x {error:.2e} = {seconds * error * 1e3:.2f} s to 1e-3 (mean {brightness:.5f})")
    ratio = products["halfdisk"] / products["Mitsuba"]
    print(f"{name}: {'; '.join(line)}; ratio {ratio:.3f}", flush=True)


def main():
    """Compares on the scenes that are named, or on all four."""
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    mi.set_variant(VARIANT)
    mi.set_log_level(mi.LogLevel.Error)
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[2:] or SAMPLES:
            compare(sys.argv[1], name, folder)


if __name__ == "__main__":
    main()
