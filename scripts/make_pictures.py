#!/usr/bin/python3
"""Draws pictures of a result folder of the program handlebody.

usage: make_pictures.py RESULT_FOLDER [OUTPUT_FOLDER]

OUTPUT_FOLDER, by default RESULT_FOLDER, then has labels.png, isosurfaces.png, volume.png, curves.png, cut.png and
hexahedra.png, as far as RESULT_FOLDER has the files that they show.

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
    if not 1 <= len(arguments) <= 2 or any(a.startswith("-") for a in arguments):
        return complain("usage: make_pictures.py RESULT_FOLDER [OUTPUT_FOLDER]", 2)
    source, target = pathlib.Path(arguments[0]), pathlib.Path(arguments[-1])
    if not source.is_dir():
        return complain(f"there is no folder {source}", 1)
    if not os.environ.get("DISPLAY"):
        restart_with_screen()
    try:
        target.mkdir(parents=True, exist_ok=True)
        return draw_all(source, target)
    except OSError as error:
        return complain(f"{target} cannot be written: {error.strerror}", 1)
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


def draw_all(source, target):
    from pictures.figures import FIGURES
    from pictures.result_folder import Missing, Result

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
