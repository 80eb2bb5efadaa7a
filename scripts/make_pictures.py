#!/usr/bin/python3
"""Draws pictures of a result folder of the program handlebody.

usage: make_pictures.py RESULT_FOLDER [OUTPUT_FOLDER]
       make_pictures.py --partitions PICTURE.png LABELLED.mesh...

The second form shows solids with labelled boundaries side by side, for example the candidates that
`handlebody partition --choose I` writes. In the first form OUTPUT_FOLDER, by default RESULT_FOLDER, then has labels.png,
isosurfaces.png, volume.png, curves.png, cut.png, hexahedra.png and histogram.png, as far as RESULT_FOLDER has the files that
they show.

Exit: 0 all pictures are drawn, 1 none is, 2 wrong usage, 3 some are, and stderr says why the others are not.

Needs Debian's packages python3-vtk9 and, without a screen, xvfb and xauth.
"""

import os
import pathlib
import shutil
import sys


def main(arguments):
    if "--help" in arguments or "-h" in arguments:
        print(__doc__.strip())
        return 0
    compares = arguments[:1] == ["--partitions"]
    paths = [pathlib.Path(a) for a in arguments[compares:]]
    if any(a.startswith("-") for a in arguments[compares:]) or not (2 <= len(paths) if compares else 1 <= len(paths) <= 2):
        return complain("usage: make_pictures.py RESULT_FOLDER [OUTPUT_FOLDER] | --partitions PICTURE.png MESH...", 2)
    if not compares and not paths[0].is_dir():
        return complain(f"there is no folder {paths[0]}", 1)
    if not os.environ.get("DISPLAY"):
        restart_with_screen()
    try:
        return compare_partitions(paths[0], paths[1:]) if compares else draw_all(paths[0], paths[-1])
    except OSError as error:
        return complain(f"{error.filename}: {error.strerror}", 1)
    except ImportError as error:
        return complain(f"{error}: Debian's packages python3-vtk9 and python3-numpy are needed", 1)


def complain(sentence, code):
    print(f"make_pictures.py: {sentence}", file=sys.stderr)
    return code


def restart_with_screen():
    """VTK aborts without a screen"""
    if not shutil.which("xvfb-run"):
        sys.exit(complain("there is no screen, and Debian's packages xvfb and xauth are not installed", 1))
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", sys.executable, *sys.argv])


def compare_partitions(target, sources):
    from pictures.figures import draw_partitions
    from pictures.result_folder import Labelled_mesh, Missing

    try:
        draw_partitions([Labelled_mesh(source) for source in sources]).save(target)
    except Missing as reason:
        return complain(str(reason), 1)
    print(target)
    return 0


def draw_all(source, target):
    from pictures.figures import FIGURES
    from pictures.result_folder import Missing, Result

    target.mkdir(parents=True, exist_ok=True)
    result, drawn = Result(source), 0
    for name, draw in FIGURES.items():
        try:
            draw(result).save(target / f"{name}.png")
            print(target / f"{name}.png", flush=True)
            drawn += 1
        except Missing as reason:
            complain(f"{name}.png is skipped: {reason}", 0)
    return 0 if drawn == len(FIGURES) else 3 if drawn else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
