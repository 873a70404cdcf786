#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Renders the scenes into tools/docs/gallery and writes the README's gallery from them.

usage: tools/scenes/gallery.py [--cobble PROGRAM] [NAME ...]

Without names all pictures are made (some minutes). The captions stand here, beside the settings.
"""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURES = ROOT / "tools" / "docs" / "gallery"
BEGIN, END = "<!-- gallery -->", "<!-- /gallery -->"

# name of the scene, size, samples per pixel, caption
SCENES = [
    ("village/village", "960x540", 64, "A village by the river: block meshes, crisp textures, water, a wide sun"),
    ("village/night", "480x320", 128, "The same village at night: seven lanterns with soft shadows"),
    ("village/characters", "480x320", 64, "Characters made of boxes, groups and transforms"),
    ("village/glasshouse", "480x320", 64, "Blocks of water and glass"),
    ("basics/phong", "480x320", 32, "Highlights from `shininess` 0 to 256"),
    ("basics/transforms", "480x320", 32, "Nested transforms, an axis rotation, a shear"),
    ("basics/textures", "480x320", 64, "`nearest` and `bilinear`, on boxes, a sphere and a plane"),
    ("basics/normal_map", "480x320", 32, "A wall flat, with a normal map, and a height map"),
    ("basics/mirror_glass", "480x320", 64, "Mirror, glass, amber, a cut stone"),
    ("basics/soft_shadows", "480x320", 128, "Lights with a size"),
    ("basics/depth_of_field", "480x320", 192, "A thin lens with six blades"),
    ("basics/motion_blur", "480x320", 128, "An open shutter"),
    ("basics/marble", "480x320", 64, "Procedural marble"),
    ("basics/environment", "480x320", 64, "A mirrored sky, and a mirrored scene"),
]


def picture_of(scene):
    return PICTURES / (scene.split("/")[-1] + ".png")


def render(cobble, scene, size, samples):
    command = [cobble, "render", str(ROOT / "scenes" / (scene + ".scene")), "-o",
               str(picture_of(scene)), "--size", size, "--samples", str(samples), "--quiet"]
    print(" ".join(command[1:3]), flush=True)
    subprocess.run(command, check=True)


def gallery_text():
    first, *rest = SCENES

    def image(scene, caption):
        path = picture_of(scene).relative_to(ROOT)
        return f"[![{caption}]({path})](scenes/{scene}.scene)"

    lines = [image(first[0], first[3]), "", f"*{first[3]} ([scene](scenes/{first[0]}.scene)).*", ""]
    columns = 3
    for start in range(0, len(rest), columns):
        row = rest[start:start + columns]
        cells = [image(scene, caption) for scene, _, _, caption in row]
        captions = [caption for _, _, _, caption in row]
        while len(cells) < columns:
            cells.append("")
            captions.append("")
        lines.append("| " + " | ".join(cells) + " |")
        if start == 0:
            lines.append("|" + "---|" * columns)
        lines.append("| " + " | ".join(captions) + " |")
    return "\n".join(lines + ["", "Made by `tools/scenes/gallery.py`; click a picture for its scene."])


def write_readme():
    readme = ROOT / "README.md"
    text = readme.read_text(encoding="utf-8")
    if END not in text:
        text = text.replace(BEGIN, BEGIN + "\n" + END)
    before, rest = text.split(BEGIN, 1)
    _, after = rest.split(END, 1)
    readme.write_text(before + BEGIN + "\n" + gallery_text() + "\n" + END + after, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cobble", default=str(ROOT / "build/release/tools/cobble/cobble"))
    parser.add_argument("names", nargs="*", help="scenes to render, as in village/night; default: all")
    arguments = parser.parse_args()
    known = {scene for scene, *_ in SCENES}
    for name in arguments.names:
        if name not in known:
            sys.exit(f"gallery.py: no scene '{name}'; there are: {' '.join(sorted(known))}")
    PICTURES.mkdir(parents=True, exist_ok=True)
    for scene, size, samples, _ in SCENES:
        if not arguments.names or scene in arguments.names:
            render(arguments.cobble, scene, size, samples)
    write_readme()


if __name__ == "__main__":
    main()
