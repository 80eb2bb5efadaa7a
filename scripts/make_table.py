#!/usr/bin/python3
"""Makes Markdown tables of the reports of the program handlebody.

usage: make_table.py RESULT_FOLDER...

Each folder has a report.json, which may also be named itself. The first table tells what was measured of the maps, the
second one the CPU seconds of each stage, the third one what was measured of hexahedra if there are any. What a report does
not tell is shown as -; where there is no piecewise linear map, the table says why.

Exit: 0 the tables are printed, 1 a report cannot be read, 2 wrong usage.
"""

import json
import pathlib
import re
import sys

NOTHING = "-"


def main(arguments):
    if "--help" in arguments or "-h" in arguments:
        print(__doc__.strip())
        return 0
    if not arguments or any(a.startswith("-") for a in arguments):
        return complain("usage: make_table.py RESULT_FOLDER...", 2)
    reports = []
    for path in map(pathlib.Path, arguments):
        file = path / "report.json" if path.is_dir() else path
        try:
            reports.append((file, json.loads(file.read_text())))
        except (OSError, ValueError) as error:
            return complain(f"{file}: {getattr(error, 'strerror', None) or error}", 1)
    print_table(table_of_maps(reports))
    print()
    print_table(table_of_stages(reports))
    with_hexahedra = [r for r in reports if "hexahedra" in r[1]]
    if with_hexahedra:
        print()
        print_table(table_of_hexahedra(with_hexahedra))
    return 0


def complain(sentence, code):
    print(f"make_table.py: {sentence}", file=sys.stderr)
    return code


def print_table(rows):
    for row in [rows[0], ["---"] * len(rows[0]), *rows[1:]]:
        print("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |")


def table_of(columns, reports):
    return [["model", *columns]] + [[name(*r), *(column(r[1]) for column in columns.values())] for r in reports]


def table_of_maps(reports):
    return table_of(COLUMNS, reports)


def table_of_hexahedra(reports):
    return table_of(HEXAHEDRA_COLUMNS, reports)


def table_of_stages(reports):
    seconds = [seconds_of_stages(report) for _, report in reports]
    stages = list(dict.fromkeys(stage for s in seconds for stage in s))
    rows = [["CPU seconds", *stages, "total"]]
    for (file, report), s in zip(reports, seconds):
        times = [f"{s[stage]:.2f}" if stage in s else NOTHING for stage in stages]
        rows.append([name(file, report), *times, f"{sum(s.values()):.1f}"])
    return rows


def seconds_of_stages(report):
    """returns the seconds of each stage, those for all partitions that were tried together"""
    seconds = {}
    for stage, measured in report.get("stages", {}).items():
        stage = re.sub(r"^partition \d+: ", "", stage)
        seconds[stage] = seconds.get(stage, 0) + measured["seconds"]
    return seconds


def name(file, report):
    return f"`{pathlib.Path(report.get('input', {}).get('file') or file.resolve().parent).name}`"


def entry(report, path, text):
    """returns what `text` makes of the value at a path of keys; null stands for infinity"""
    for key in path.split("/"):
        if not isinstance(report, dict) or key not in report:
            return NOTHING
        report = report[key]
    return "&infin;" if report is None else text(report)


def number(x):
    return f"{x:.3g}" if abs(x) < 1000 else f"{x:,.0f}" if abs(x) < 1e6 else f"{x:.1e}"


def values(section, keys, text=number):
    def column(report):
        texts = [entry(report, f"{section}/{key}", text) for key in keys.split()]
        return NOTHING if set(texts) == {NOTHING} else " / ".join(texts)

    return column


def has_linear_map(report):
    return report.get("certificates", {}).get("piecewise_linear", False)


def of_linear_map(column):
    return lambda report: column(report) if has_linear_map(report) else NOTHING


def growth(report):
    given = report.get("input", {}).get("tetrahedra")
    return entry(report, "counts/tetrahedra", lambda n: f"{100 * (n / given - 1):.1f} %") if given else NOTHING


def flips(report):
    """those of the first map of the interior, and those that are left; or why there is no map"""
    counts = values("piecewise_linear_map/untangling", "flipped_at_start flipped_at_end", str)(report)
    if has_linear_map(report):
        return counts
    linear = report.get("piecewise_linear_map", {})
    if linear.get("untangling", {}).get("flipped_at_end"):
        return f"{counts}, no map"
    statuses = [s["message"] for s in (linear.get("status"), report.get("status")) if isinstance(s, dict)]
    return "no map: " + statuses[0] if statuses else "no map"


def to_surface(degrees):
    """the angle to a surface, of an angle to its normal; negative if the line runs backwards"""
    return f"{90 - degrees:.1f}&deg;"


def percent(share):
    return f"{100 * share:.2g} %"


def volume_error(report):
    fit = report.get("hexahedra", {}).get("fit", {})
    return percent(fit["volume"] / fit["volume_of_solid"] - 1) if fit else NOTHING


COLUMNS = {
    "genus": values("counts", "genus", str),
    "tetrahedra": values("counts", "tetrahedra", "{:,}".format),
    "growth": growth,
    "flips before / after": flips,
    "least singular value, minimum / mean": of_linear_map(values("distortion/least_singular_value", "minimum mean")),
    "greatest singular value, mean / maximum": of_linear_map(values("distortion/greatest_singular_value", "mean maximum")),
    "energy of the floor, mean / median / maximum":
        values("floor_distortion/symmetric_dirichlet_energy", "mean median maximum"),
    "energy of the volume, mean / median / maximum":
        of_linear_map(values("distortion/symmetric_dirichlet_energy", "mean median maximum")),
    "curves to iso-surfaces of f, median / 5 %": values("angles/curves_to_gradient", "median quantile_95", to_surface),
    "w-lines to iso-surfaces of w, median / 5 %":
        of_linear_map(values("piecewise_linear_map/w_lines_to_gradient_of_w", "median quantile_95", to_surface)),
    "distance to &phi;, mean / maximum":
        of_linear_map(values("piecewise_linear_map/distance_to_phi/at_barycentres", "mean maximum", percent)),
}

HEXAHEDRA_COLUMNS = {
    "hexahedra": values("hexahedra", "number", "{:,}".format),
    "pillow": values("hexahedra", "pillow", lambda has_pillow: "yes" if has_pillow else "no"),
    "inverted": values("hexahedra", "inverted", str),
    "irregular edges": values("hexahedra", "irregular_interior_edges", str),
    "scaled Jacobian, minimum / mean":
        values("hexahedra", "minimum_scaled_jacobian mean_scaled_jacobian", "{:.3f}".format),
    "greatest distance in edges": values("hexahedra/fit", "greatest_distance_by_mean_edge", "{:.2f}".format),
    "volume error": volume_error,
    "Euler characteristic": values("hexahedra", "euler_characteristic", str),
}

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
