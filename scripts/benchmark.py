#!/usr/bin/python3
"""Measures the stages of the package, and other programs on the same solids and seeds; scripts/benchmark.sh runs it.

usage: benchmark.py PROGRAMS SURFACES FOLDER small | full [REPETITIONS]

PROGRAMS is the folder of handlebody, benchmark_stages and benchmark_solvers, SURFACES that of CGAL's meshes. Solids, which
are kept for the next time, and benchmark.json are written into FOLDER; tables are printed.
"""

import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import time

from make_table import print_table

HERE = pathlib.Path(__file__).resolve().parent
# A solid with two holes, and a long and thin one that is knotted; with the direction of the sweep.
MODELS = {"eight": "0,1,0", "knot1": "0,0,1"}
SEEDS = 5000


class Size:
    """how much is measured: CELLS of each model, REPETITIONS of each run; FACTORIZED is up to how many cells direct solvers
    are run, the second of them being the slower one, and TRACED up to how many VTK is"""

    def __init__(self, cells, repetitions, factorized, traced):
        self.cells, self.repetitions, self.factorized, self.traced = cells, repetitions, factorized, traced


SIZES = {
    "small": Size([50_000, 200_000], 3, {"cholmod": 200_000, "ldlt": 50_000}, 200_000),
    "full": Size([50_000, 200_000, 1_000_000, 2_000_000], 5, {"cholmod": 1_000_000, "ldlt": 200_000}, 1_000_000),
}


def main(arguments):
    if "--help" in arguments or "-h" in arguments:
        print(__doc__.strip())
        return 0
    if len(arguments) not in (4, 5) or arguments[3] not in SIZES or not all(a.isdecimal() for a in arguments[4:]):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    size = SIZES[arguments[3]]
    if len(arguments) == 5:
        size.repetitions = int(arguments[4])
    bench = Benchmark(*map(pathlib.Path, arguments[:3]), size)
    result = bench.run()
    result["growth"] = {model: growth(of_model(result, model)) for model in MODELS}
    result["acceptance"] = acceptance(result)
    bench.write(result)
    print_tables(result)
    return 0


class Benchmark:
    def __init__(self, programs, surfaces, folder, size):
        self.programs, self.surfaces, self.folder, self.size = programs, surfaces, folder, size
        folder.mkdir(parents=True, exist_ok=True)

    def run(self):
        cold_start = self.cold_start()
        result = {"machine": machine(), "versions": versions(cold_start.pop("versions")), "cold_start": cold_start,
                  "solids": {}}
        for model in MODELS:
            for cells in self.size.cells:
                result["solids"][f"{model} {cells:,}"] = self.measure_solid(model, cells)
                self.write(result)
        return result

    def write(self, result):
        (self.folder / "benchmark.json").write_text(json.dumps(result, indent=2) + "\n")

    def cold_start(self):
        """handlebody on the surface of an eight, as a user starts it"""
        output = self.folder / "cold_start"
        command = [self.programs / "handlebody", "parameterize", self.surfaces / "eight.off", "-o", output, "--quiet",
                   "--threads", "1"]
        runs = [timed(command) for _ in range(self.size.repetitions)]
        report = json.loads((output / "report.json").read_text())
        return {**median(runs), "cells": report["counts"]["tetrahedra"], "versions": report["versions"]}

    def measure_solid(self, model, cells):
        say(f"{model}, {cells:,} tetrahedra")
        solid = self.solid(model, cells)
        vtu = self.folder / "seeds.vtu"
        seeds = [str(SEEDS), vtu] if cells <= self.size.traced else []
        stages = {"1": self.repeat(["benchmark_stages", solid, "1", *seeds]),
                  "2": self.repeat(["benchmark_stages", solid, "2"])}
        result = {"model": model, "cells": stages["1"]["cells"], "threads": stages}
        for of_threads in stages.values():
            add_costs_per_cell(of_threads)
        if seeds:
            result["vtk"] = {name: self.repeat([HERE / "trace_with_vtk.py", vtu, name]) for name in ("rk4", "rk45")}
        result["solvers"] = {
            field: {solver: self.repeat(["benchmark_solvers", solid, field, solver]) for solver in solvers}
            for field, solvers in self.solvers(cells).items()}
        return result

    def solvers(self, cells):
        direct = [name for name, most in self.size.factorized.items() if cells <= most]
        return {"harmonic": ["default", "cg", "petsc", "hypre", *direct], "dual": ["default", "petsc"],
                "flux": ["default", "petsc"], "equilibrated flux": ["default"]}

    def solid(self, model, cells):
        solid = self.folder / f"{model}_{cells}.mesh"
        if not solid.exists():
            surface = self.surfaces / f"{model}.off"
            refined = self.folder / f"{model}.ply"
            levels = subdivisions(surface, cells)
            run([HERE / "subdivide_surface.py", surface, refined, str(levels)])
            run([self.programs / "handlebody", "partition", refined, "-o", solid, "--direction", MODELS[model], "--tets",
                 str(cells), "--keep-triangles", "--quiet"])
        return solid

    def repeat(self, command):
        environment = {"OPENBLAS_NUM_THREADS": "1"}
        if command[-1] == "hypre":
            command = [*command[:-1], "petsc"]
            environment["PETSC_OPTIONS"] = "-pc_type hypre"
        command[0] = self.programs / command[0]
        return median([json.loads(run(command, environment)) for _ in range(self.size.repetitions)])


def subdivisions(surface, cells):
    """so many that the triangles are about as small as the tetrahedra have to be"""
    triangles = int(surface.read_text().split()[2])
    return max(0, math.ceil(math.log(1.5 * cells ** (2 / 3) / triangles, 4)))


def run(command, environment=None):
    return subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True,
                          env={**os.environ, **(environment or {})}).stdout


def timed(command):
    cpu, wall = sum(os.times()[2:4]), time.monotonic()
    subprocess.run(command, check=False)
    return {"cpu_seconds": sum(os.times()[2:4]) - cpu, "seconds": time.monotonic() - wall}


def say(sentence):
    print(sentence, file=sys.stderr, flush=True)


def median(runs):
    """the same as each of the runs, with the medians of their numbers; all else must be equal in all of them"""
    if isinstance(runs[0], dict):
        return {key: median([r[key] for r in runs]) for key in runs[0]}
    if isinstance(runs[0], (int, float)):
        return statistics.median_low(runs)
    if any(r != runs[0] for r in runs):
        raise ValueError(f"the same command prints different things: {runs}")
    return runs[0]


def add_costs_per_cell(result):
    """to each stage, and to all together"""
    stages = result["stages"]
    stages["all"] = {"cpu_seconds": sum(s["cpu_seconds"] for s in stages.values()),
                     "seconds": sum(s["seconds"] for s in stages.values()),
                     "peak_bytes": max(s["peak_bytes"] for s in stages.values())}
    for stage in stages.values():
        stage["ns_per_cell"] = 1e9 * stage["cpu_seconds"] / result["cells"]
        stage["bytes_per_cell"] = (stage["peak_bytes"] - result["base_bytes"]) / result["cells"]


def of_model(result, model):
    return [s for s in result["solids"].values() if s["model"] == model]


def growth(solids):
    """e for each stage, its CPU seconds growing like cells^e; from 200,000 cells on if there are two such solids"""
    large = [s for s in solids if s["cells"] > 150_000]
    first, last = (large if len(large) > 1 else solids)[0], solids[-1]
    return {stage: math.log(cost["cpu_seconds"] / first["threads"]["1"]["stages"][stage]["cpu_seconds"]) /
            math.log(last["cells"] / first["cells"]) for stage, cost in last["threads"]["1"]["stages"].items()}


def machine():
    with open("/proc/cpuinfo") as lines:
        model = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), "unknown")
    return {"processor": model, "cores": os.cpu_count(), "load": os.getloadavg()}


def versions(of_program):
    packages = ["libpetsc-real-dev", "libhypre-dev", "libsuitesparse-dev", "libtbb-dev", "python3-vtk9", "libopenblas0-pthread"]
    listed = subprocess.run(["dpkg-query", "-W", *packages], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return {**of_program, **dict(line.split("\t") for line in listed.stdout.splitlines() if line.split("\t")[1])}


def acceptance(result):
    """what is asked for: value, bar, and whether it holds"""
    solids = of_model(result, "eight")
    million = min(solids, key=lambda s: abs(math.log(s["cells"] / 1e6)))
    traced = [s for s in solids if "vtk" in s][-1]
    return {
        **tracing_against_vtk(traced),
        **of_stages(million),
        **of_fields(solids[-1]),
        "greatest growth exponent of a stage": at_most(1.15, max(max(g.values()) for g in result["growth"].values())),
        "cold start, CPU seconds": at_most(3, result["cold_start"]["cpu_seconds"]),
        "results for 1 and 2 threads are equal": at_least(True, all(
            s["threads"]["1"]["fingerprint"] == s["threads"]["2"]["fingerprint"] for s in result["solids"].values())),
    }


def at_most(bar, value):
    return {"value": value, "bar": bar, "holds": value <= bar}


def at_least(bar, value):
    return {"value": value, "bar": bar, "holds": value >= bar}


def tracing_against_vtk(solid):
    ours, peer = solid["threads"]["1"]["curves_of_seeds"], solid["vtk"]["rk45"]
    ratio = peer["cpu_seconds"] / ours["cpu_seconds"]
    return {
        "VTK's RK45 to certified curves, cost per seed": at_least(25, ratio),
        # VTK's curves end earlier: they pass about as many cells per length
        "VTK's RK45 to certified curves, cost per cell": at_least(25, ratio * ours["length"] / peer["length"]),
        "share of certified curves that arrive": at_least(1, ours["share_that_arrives"]),
    }


def of_stages(solid):
    one, two = solid["threads"]["1"], solid["threads"]["2"]
    curves = one["curves_of_vertices"]
    tetrahedra = f"of {solid['cells']:,} tetrahedra"
    per_million = 1e6 / solid["cells"]

    def gain(stages):
        return stages(one)["seconds"] / stages(two)["seconds"]

    return {
        f"cells passed per second {tetrahedra}": at_least(3e7, curves["crossings"] / curves["cpu_seconds"]),
        f"CPU seconds per million {tetrahedra}, 1 thread": at_most(10, per_million * one["stages"]["all"]["cpu_seconds"]),
        f"seconds per million {tetrahedra}, 2 threads": at_most(6, per_million * two["stages"]["all"]["seconds"]),
        f"bytes per tetrahedron at the peak, {tetrahedra}": at_most(400, one["stages"]["all"]["bytes_per_cell"]),
        f"gain by 2 threads, tracing {tetrahedra}": at_least(1.6, gain(lambda r: r["curves_of_vertices"])),
        f"gain by 2 threads, all stages {tetrahedra}": at_least(1.4, gain(lambda r: r["stages"]["all"])),
    }


def of_fields(solid):
    p1 = solid["solvers"]["harmonic"]
    best_peer = min(cost["solver_cpu_seconds"] for solver, cost in p1.items() if solver not in ("default", "cg"))
    ours = p1["default"]
    assembly = ours["cpu_seconds"] - ours["solver_cpu_seconds"]
    tetrahedra = f"of {solid['cells']:,} tetrahedra"
    return {
        f"solution of P1 {tetrahedra} to that by the best peer": at_most(1.3, ours["solver_cpu_seconds"] / best_peer),
        f"assembly of P1 {tetrahedra} to its solution": at_most(0.5, assembly / ours["solver_cpu_seconds"]),
        f"flux {tetrahedra} to P1":
            at_most(3, solid["solvers"]["equilibrated flux"]["default"]["cpu_seconds"] / ours["cpu_seconds"]),
    }


def print_tables(result):
    print("\n" + ", ".join(f"{name} {version}" for name, version in result["versions"].items()))
    print(f"{result['machine']['processor']}, {result['machine']['cores']} cores, load "
          f"{result['machine']['load'][0]:.1f} at the start\n")
    for model in MODELS:
        print_table(table_of_stages(model, result))
        print()
    for table in (table_of_solvers, table_of_curves, table_of_acceptance):
        print_table(table(result))
        print()


def table_of_stages(model, result):
    solids = of_model(result, model)
    header = [f"{model}, CPU s / ns per tetrahedron / bytes per tetrahedron",
              *(f"{s['cells']:,}" for s in solids), "growth", f"seconds with 1 / 2 threads, {solids[-1]['cells']:,}"]
    costs = [s["threads"]["1"]["stages"] for s in solids]
    last = solids[-1]["threads"]
    return [header] + [
        [stage, *(f"{c[stage]['cpu_seconds']:.2f} / {c[stage]['ns_per_cell']:,.0f} / {c[stage]['bytes_per_cell']:,.0f}"
                  for c in costs), f"{result['growth'][model][stage]:.2f}",
         f"{last['1']['stages'][stage]['seconds']:.2f} / {last['2']['stages'][stage]['seconds']:.2f}"]
        for stage in costs[0]]


def table_of_solvers(result):
    rows = [["field", "solver", *result["solids"]]]
    first = next(iter(result["solids"].values()))["solvers"]
    for field, solvers in first.items():
        for solver in solvers:
            costs = [s["solvers"][field].get(solver) for s in result["solids"].values()]
            rows.append([field, solver, *(cost_of_solver(c, s["cells"]) for c, s in zip(costs, result["solids"].values()))])
    rows[0][1] = "solver: CPU s of assembly + solution, bytes per tetrahedron, residual"
    return rows


def cost_of_solver(cost, cells):
    if cost is None:
        return "-"
    assembly = cost["cpu_seconds"] - cost["solver_cpu_seconds"]
    return (f"{assembly:.2f} + {cost['solver_cpu_seconds']:.2f}, {(cost['peak_bytes'] - cost['base_bytes']) / cells:,.0f}, "
            f"{cost['residual']:.0e}")


def table_of_curves(result):
    rows = [["curves from the same seeds", "program", "&mu;s a seed", "ns a cell passed", "% that arrive"]]
    for name, solid in result["solids"].items():
        if "vtk" not in solid:
            continue
        ours = solid["threads"]["1"]["curves_of_seeds"]
        density = ours["crossings"] / ours["length"]
        for program, curves in {"certified": ours, **solid["vtk"]}.items():
            rows.append([name, program, f"{1e6 * curves['cpu_seconds'] / curves['seeds']:.2f}",
                         f"{1e9 * curves['cpu_seconds'] / (density * curves['length']):.0f}",
                         f"{100 * curves['share_that_arrives']:.1f}"])
    return rows


def table_of_acceptance(result):
    return [["asked for", "value", "bar", "holds"]] + [
        [what, f"{a['value']:.4g}", f"{a['bar']:g}", "yes" if a["holds"] else "no"]
        for what, a in result["acceptance"].items()]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
