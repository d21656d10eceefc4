#!/usr/bin/env python3
"""Write what feature_cost.sh compares: kernels with a feature cut out, and scenes without and with it.

    bench/feature_cost.py FOLDER

FOLDER/kernels/NAME/reference/engine   the kernel without a feature, and `whole`, which has everything
FOLDER/scenes/NAME.toml                the scenes
stdout                                 a line for each feature: title, kernel; scene, stage and sampling without it, and with it
"""
import pathlib
import sys

ENGINE = pathlib.Path(__file__).resolve().parent.parent / "reference" / "engine"

# ---- Cuts ------------------------------------------------------------------------------------------------------------
# Of all kernel/*.hpp, seen as one text. A text alone stands for the statement or function that begins so, which goes; of a pair, the second
# text takes the first one's place. What nothing calls any more need not go: the members of a template are compiled on demand.

LIGHTS_IN_PLANES = ["if (!light.planes.empty()) [[unlikely]] {"]
PLANES = [("const bool planes = !scene.planes.empty(),", "const bool planes = false,")] + LIGHTS_IN_PLANES
GLASS = [
    ("{&scene_.spheres.opaque, &scene_.spheres.glass}", "{&scene_.spheres.opaque}"),
    (" & (hit.place < spheres_.all_at(scene_.spheres.glass.begin))", ""),
    "if (scene_.features.glass) {",
]
MIRRORS = ["if (scene_.features.mirrors && goes_on(from)) send_reflected(from, hit, look[mirror], met);"]
MIRRORS_BESIDE_GLASS = [("select(glass, parts.reflected, look[mirror]), met", "parts.reflected, glass")]
BOUNCES = GLASS + MIRRORS + [("bounces = scene.features.mirrors || scene.features.glass;", "bounces = false;")]
HIGHLIGHTS = ["if (scene_.features.highlights)"]
SHADOWS = [("if (!scene_.features.shadows) return", "return")]
DIRECTIONAL_LIGHTS = ["for (const PreparedDirectionalLight<T>& light : scene_.directional_lights) {"]
POINT_LIGHTS = ["for (const PreparedPointLight<T>& light : scene_.point_lights) {"]
HIERARCHY = ["if (group->hierarchy) search_nearest(", ("if (!scene_.spheres.opaque.hierarchy) return", "return")]
GIANTS = ["if (group->begin < group->loop_end)", "spheres_.for_each_reached(beam, opaque.begin, opaque.loop_end,"]
ADAPTIVE = ["else if (scene_.adaptive)"]
SAMPLES = ADAPTIVE + [("if (scene_.samples.size() == 1)  // through the center\n      ", ""), "else\n      tiles("]


KERNELS = {
    "whole": [],
    "planes": PLANES,
    "glass": GLASS,
    "mirrors": MIRRORS + MIRRORS_BESIDE_GLASS,
    "bounces": BOUNCES,
    "highlights": HIGHLIGHTS,
    "shadows": SHADOWS,
    "lights_in_planes": LIGHTS_IN_PLANES,
    "directional_lights": DIRECTIONAL_LIGHTS,
    "point_lights": POINT_LIGHTS,
    "hierarchy": HIERARCHY,
    "giants": GIANTS,
    "adaptive": ADAPTIVE,
    "samples": SAMPLES,
    "all": PLANES + BOUNCES + HIGHLIGHTS + DIRECTIONAL_LIGHTS + HIERARCHY + SAMPLES,
}


def statement(text, start):
    """From `start` to its end: the first ; or } that no bracket holds."""
    depth = 0
    for i in range(start, len(text)):
        depth += (text[i] in "({") - (text[i] in ")}")
        if depth == 0 and text[i] in ";}":
            return text[start : i + 1]


def cut(text, edits, name):
    for edit in edits:
        old, new = (edit, "") if isinstance(edit, str) else edit
        if text.count(old) == 0 or (isinstance(edit, str) and text.count(old) > 1):
            sys.exit(f"feature_cost.py: {name}: nothing was cut, for there is no, or no single\n{old}")
        text = text.replace(statement(text, text.index(old)) if isinstance(edit, str) else old, new)
    return text


def write(path, text):
    """Leaves alone what is there already, so that it need not be compiled again."""
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def write_kernel(folder, name, edits):
    headers = sorted(ENGINE.glob("kernel/*.hpp"))
    between = "\f"
    for path, text in zip(headers, cut(between.join(path.read_text() for path in headers), edits, name).split(between)):
        write(folder / name / "reference/engine/kernel" / path.name, text)
    # valgrind knows no AVX-512, and what is not run need not be compiled
    no_more = [("#define RAYLAB_UNUSABLE (", "#define RAYLAB_UNUSABLE (HWY_AVX3 | HWY_SSE4 | ")]
    write(folder / name / "reference/engine/kernel_packs.cpp", cut((ENGINE / "kernel_packs.cpp").read_text(), no_more, name))
    write(folder / name / "reference/engine/kernel_scalar.cpp", (ENGINE / "kernel_scalar.cpp").read_text())


# ---- Scenes ----------------------------------------------------------------------------------------------------------

HEAD = """background = [0.1, 0.2, 0.3]
[image]
width = 320
height = 240
[camera]
position = [0, 1.5, 7]
facing = [0, -0.1, -1]
up = [0, 1, 0]
half_field_of_view = 23
[[ambient_light]]
intensity = 0.2
"""
POINT_LIGHT = "[[point_light]]\nposition = [5, 4, 3]\nintensity = 40\n"
DIRECTIONAL_LIGHT = "[[directional_light]]\ndirection = [-1, -2, -1]\nintensity = 0.5\n"


def plane(height):
    return f"[[plane]]\npoint = [0, {height}, 0]\nnormal = [0, 1, 0]\ncolor = [0.5, 0.5, 0.4]\n"


def sphere(x, y, z, radius, more=""):
    return f"[[sphere]]\ncenter = [{x}, {y}, {z}]\nradius = {radius}\ncolor = [0.9, 0.5, 0.2]\n{more}\n"


def row(count):
    """Beads in rows of six behind each other, below the five."""
    return "".join(sphere(i % 6 - 2.5, -1 + i // 6 * 0.2, 1 - i // 6, 0.3) for i in range(count))


FIVE = (sphere(-2, 1, 0, 1) + sphere(0, 1.2, -1, 1.2) + sphere(2.1, 0.9, 0, 0.9) + sphere(-0.9, 0.4, 1.6, 0.4)
        + sphere(0.9, 0.5, 1.8, 0.5))
BASE = HEAD + FIVE + POINT_LIGHT
SCENES = {
    "base": BASE,
    "plane": BASE + plane(0),
    "glass": BASE + sphere(0, 0.6, 3, 0.5, "transparent = true"),
    "mirror": BASE + sphere(0, 0.6, 3, 0.5, "shininess = inf"),
    "shiny": BASE + sphere(0, 0.6, 3, 0.5, "shininess = 20"),
    "ceiling": BASE + plane(6),
    "lamp_in_ceiling": BASE + plane(5),
    "sun": HEAD + FIVE + DIRECTIONAL_LIGHT,
    "both_lights": BASE + DIRECTIONAL_LIGHT,
    "twenty": BASE + row(15),
    "thirty": BASE + row(25),
    "thirty_on_ground": BASE + row(25) + sphere(0, -1002, 0, 1000),
}

# Highlights and mirrors are one thing from stage 5 on, but for a perfect mirror, which has no highlight.
ROWS = [
    ("planes", "planes", "base 7 none", "plane 7 none"),
    ("glass", "glass", "base 7 none", "glass 7 none"),
    ("mirrors", "mirrors", "base 7 none", "mirror 7 none"),
    ("glass and mirrors", "bounces", "base 7 none", "-"),
    ("highlights", "highlights", "base 4 none", "shiny 4 none"),
    ("shadows", "shadows", "base 3 none", "base 7 none"),
    ("lights in planes", "lights_in_planes", "ceiling 7 none", "lamp_in_ceiling 7 none"),
    ("directional lights", "directional_lights", "base 7 none", "both_lights 7 none"),
    ("point lights", "point_lights", "sun 7 none", "both_lights 7 none"),
    ("hierarchy, 5 spheres", "hierarchy", "base 7 none", "-"),
    ("hierarchy, 20 spheres", "hierarchy", "twenty 7 none", "thirty 7 none"),
    ("giants beside a hierarchy", "giants", "thirty 7 none", "thirty_on_ground 7 none"),
    ("adaptive anti-aliasing", "adaptive", "base 7 none", "base 7 adaptive"),
    ("more samples than one", "samples", "base 7 none", "base 7 rotated4"),
    ("all that the base scene lacks", "all", "base 7 none", "-"),
]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for name, edits in KERNELS.items():
        write_kernel(folder / "kernels", name, edits)
    for name, text in SCENES.items():
        write(folder / "scenes" / f"{name}.toml", text)
    for fields in ROWS:
        print("|".join(fields))


main()
