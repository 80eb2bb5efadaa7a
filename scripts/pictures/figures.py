"""The pictures of a result: each function takes a Result and returns a Picture."""

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from .convert import add_array, add_cell_colors, cells_of, make_grid, make_polylines, make_surface, run, uniform_cells
from .result_folder import Missing
from .scene import (HEIGHT_COLORS, QUALITY_COLORS, WIDTH, CutView, Picture, View, color_map, diagonal, interpolate_colors,
                    label_name_and_color, main_view, make_actor, make_shell, principal_axes, two_panels)

LEVELS = np.arange(1, 12) / 12
HISTOGRAM_HEIGHT = 450
VOLUME_LEVELS = np.arange(1, 6) / 6
SHELL_THICKNESS, SHELL_OPACITY, HAZE = 0.02, 0.12, 0.002  # in f; of one slice of the volume
CURVE_COLORS = [(0.10, 0.22, 0.62), (0.05, 0.52, 0.66), (0.16, 0.58, 0.25), (0.88, 0.66, 0.10), (0.83, 0.25, 0.16),
                (0.55, 0.16, 0.52)]


def draw_labels(result):
    view = main_view(result.mesh.points)
    picture = two_panels(view)
    for side in (view, view.opposite()):
        picture.add_panel(side, [make_labelled_boundary(result.mesh, edges=len(result.mesh.boundary) < 40000)])
    picture.add_text([label_name_and_color(label) for label in np.unique(result.mesh.labels)])
    return picture


def draw_partitions(meshes):
    """side by side, each from both sides; several rows of three if that fits"""
    columns = 3 if len(meshes) % 3 == 0 else len(meshes)
    rows = 2 * len(meshes) // columns
    picture = Picture(columns, rows, height=round(0.7 * rows / columns * WIDTH))
    for k in range(0, len(meshes), columns):
        group = meshes[k:k + columns]
        for mesh in group:
            picture.add_panel(main_view(mesh.points), [make_labelled_boundary(mesh, edges=False)])
            picture.add_title(mesh.name)
        for mesh in group:
            picture.add_panel(main_view(mesh.points).opposite(), [make_labelled_boundary(mesh, edges=False)])
    return picture


def make_labelled_boundary(mesh, edges):
    boundary = make_surface(mesh.points, mesh.boundary)
    add_cell_colors(boundary, np.array([label_name_and_color(label)[1] for label in mesh.labels]))
    return make_actor(boundary, edges=edges)


def draw_isosurfaces(result):
    view = cut_view(result.mesh)
    half = view.cut_open(result.mesh.grid("f"))
    contour = vtk.vtkContourFilter()
    for i, level in enumerate(LEVELS):
        contour.SetValue(i, level)
    colors = color_map(HEIGHT_COLORS)
    picture = Picture()
    picture.add_panel(view, [make_actor(run(contour, half), colors=colors), *make_shell(outer_surface(half))])
    picture.add_scalar_bar(colors, "f")
    return picture


def draw_volume(result):
    view = level_view(result.mesh)
    picture = Picture()
    picture.add_panel(view, [stack_slices(result.mesh.grid("f"), view)], in_order=True)
    picture.add_scalar_bar(color_map(HEIGHT_COLORS), "f")
    return picture


def draw_curves(result):
    mesh, curves, images = result.mesh, result.curves, result.domain_points
    colors = curve_colors(curves)
    x, y, z = np.eye(3)
    views = [main_view(mesh.points), View(images, -y, x, z, tilt=(0.4, 0.9))]
    surfaces = [make_surface(mesh.points, mesh.boundary), make_surface(*result.domain_boundary)]
    picture = two_panels(views[0])
    for domain, (view, surface) in enumerate(zip(views, surfaces)):
        chosen = np.flatnonzero(curves.domain == domain)
        picture.add_panel(view, make_shell(surface) + make_tubes([curves.lines[i] for i in chosen], colors[chosen], view.points))
    return picture


def draw_cut(result):
    """u, v, w make a checkerboard of boxes"""
    mesh = result.mesh
    view = cut_view(mesh)
    skin = outer_surface(view.cut_open(mesh.grid("u", "v", "w")))
    steps = checker_steps(result.domain_points, result.domain_height)
    for name, step in zip("uvw", steps):
        skin = split_at_multiples(skin, name, step)
    inside = polygon_means(skin, np.column_stack([vtk_to_numpy(skin.GetPointData().GetArray(name)) for name in "uvw"]))
    boxes = np.floor(inside / steps)
    is_light = (boxes.sum(axis=1) % 2)[:, None]
    colors = interpolate_colors(HEIGHT_COLORS, (boxes[:, 2] - boxes[:, 2].min()) / np.ptp(boxes[:, 2]))
    add_cell_colors(skin, colors + 0.6 * is_light * (1 - colors))
    picture = Picture()
    picture.add_panel(view, [make_actor(skin)])
    return picture


def draw_hexahedra(result):
    points, hexahedra = result.hexahedra
    quality = scaled_jacobians(points, hexahedra)
    view = cut_view(result.mesh)
    kept = view.is_behind(points[hexahedra].mean(axis=1))
    grid = make_grid(points, vtk.VTK_HEXAHEDRON, hexahedra[kept], {})
    add_array(grid.GetCellData(), "scaled Jacobian", quality[kept])
    grid.GetCellData().SetActiveScalars("scaled Jacobian")
    colors = color_map(QUALITY_COLORS)
    picture = Picture()
    picture.add_panel(view, [make_actor(outer_surface(grid), colors=colors, edges=True)])
    picture.add_scalar_bar(colors, "scaled\nJacobian")
    picture.add_text([(f"{len(hexahedra)} hexahedra, scaled Jacobian from {quality.min():.3f}, mean "
                       f"{quality.mean():.3f}", (0, 0, 0))], size=17)
    return picture


def draw_histogram(result):
    """the share of the hexahedra with a scaled Jacobian in each twentieth from 0 to 1"""
    report = result.hexahedra_report
    counts = np.array(report["scaled_jacobian_in_twentieths"])
    picture = Picture(height=HISTOGRAM_HEIGHT)
    middles = (np.arange(len(counts)) + 0.5) / len(counts)
    picture.add_bars(middles, 100 * counts / counts.sum(), "scaled Jacobian", "% of the hexahedra")
    picture.add_title(f"{report['number']} hexahedra, {report['inverted']} inverted, scaled Jacobian from "
                      f"{report['minimum_scaled_jacobian']:.3f}, mean {report['mean_scaled_jacobian']:.3f}")
    return picture


FIGURES = {"labels": draw_labels, "isosurfaces": draw_isosurfaces, "volume": draw_volume, "curves": draw_curves,
           "cut": draw_cut, "hexahedra": draw_hexahedra, "histogram": draw_histogram}


def gradients_of_f(mesh):
    """returns gradients and volumes of the tetrahedra that have volume"""
    corners, f = mesh.points[mesh.tetrahedra], mesh.value("f")[mesh.tetrahedra]
    a, b, c = (corners[:, i] - corners[:, 0] for i in (1, 2, 3))
    duals = np.cross(b, c), np.cross(c, a), np.cross(a, b)
    rises = sum((f[:, i + 1] - f[:, 0])[:, None] * dual for i, dual in enumerate(duals))
    volumes = np.einsum("ij,ij->i", a, duals[0])
    good = volumes > 1e-12 * volumes.max()  # the others do not matter for a choice of view
    return rises[good] / volumes[good, None], volumes[good]


def section_axes(mesh):
    """returns the normal of a long section along the gradients of f, and its axes"""
    axes = principal_axes(mesh.points)
    spread = (mesh.points @ axes.T).std(axis=0)
    gradients, volumes = gradients_of_f(mesh)
    across = volumes @ (gradients @ axes.T) ** 2
    normal = int(np.argmax((1 - across / across.sum()) / spread))
    return [axes[normal], *(axes[i] for i in range(3) if i != normal)]


def cut_view(mesh):
    """faces that section, which shows the layers of f side by side"""
    return CutView(mesh.points, *section_axes(mesh))


def level_view(mesh):
    """looks nearly along the level surfaces of f"""
    return View(mesh.points, *section_axes(mesh), tilt=(0.3, 1.1))


def outer_surface(grid):
    return run(vtk.vtkDataSetSurfaceFilter(), grid)


def stack_slices(grid, view, number=250):
    """renders a volume by translucent slices that face the eye, the farthest first"""
    plane = vtk.vtkPlane()
    plane.SetNormal(view.towards_eye)
    depths = view.points @ view.towards_eye
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane)
    for i, depth in enumerate(np.linspace(depths.min(), depths.max(), number + 2)[1:-1]):
        cutter.SetValue(i, depth)
    slices = run(cutter, grid)
    triangles = cells_of(slices.GetPolys())[0].reshape(-1, 3)
    height = vtk_to_numpy(slices.GetPoints().GetData()) @ view.towards_eye
    slices.SetPolys(uniform_cells(triangles[np.argsort(height[triangles[:, 0]])]))
    actor = make_actor(slices, colors=shells_table())
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()
    actor.GetProperty().LightingOff()
    actor.ForceTranslucentOn()
    return actor


def shells_table(entries=1024):
    """colours for f in [0, 1]: opaque near each level, a haze between"""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(entries)
    table.SetTableRange(0, 1)
    f = np.linspace(0, 1, entries)
    nearness = np.clip(1 - np.abs(f[:, None] - VOLUME_LEVELS).min(axis=1) / SHELL_THICKNESS, 0, 1)
    opacity = HAZE + (SHELL_OPACITY - HAZE) * nearness
    for i, color in enumerate(interpolate_colors(HEIGHT_COLORS, f)):
        table.SetTableValue(i, *color, opacity[i])
    return table


def curve_colors(curves):
    """returns a colour for each line that tells where its curve stands in P"""
    feet = {c: line[0][:2] for c, d, line in zip(curves.curve, curves.domain, curves.lines) if d == 1}
    if set(feet) < set(curves.curve):
        raise Missing("curves.vtp lacks a curve in P that it has in M")
    places = np.array([feet[c] for c in curves.curve])
    s, t = ((places - places.min(axis=0)) / np.maximum(np.ptp(places, axis=0), 1e-300)).T
    colors = interpolate_colors(CURVE_COLORS, s)
    return colors + 0.5 * t[:, None] * (1 - colors)


def make_tubes(lines, colors, points):
    if not lines:
        return []
    polydata = make_polylines(lines)
    add_cell_colors(polydata, colors)
    tube = vtk.vtkTubeFilter()
    tube.SetRadius(0.0025 * diagonal(points))
    tube.SetNumberOfSides(10)
    return [make_actor(run(tube, polydata))]


def checker_steps(domain_points, unit_of_w):
    """16 squares along the floor, and layers of about the same height, at least 6"""
    length, width, height = np.ptp(domain_points, axis=0)
    side = max(length, width) / 16
    return np.array([side, side, height / unit_of_w / max(6, round(height / side))])


def split_at_multiples(polydata, name, step):
    """cuts the polygons where the value is a multiple of `step`"""
    polydata.GetPointData().SetActiveScalars(name)
    low, high = polydata.GetPointData().GetArray(name).GetRange()
    slabs = vtk.vtkAppendPolyData()
    for k in range(int(np.floor(low / step)) + 1, int(np.ceil(high / step))):
        clip = vtk.vtkClipPolyData()
        clip.SetValue(k * step)
        clip.GenerateClippedOutputOn()
        polydata = run(clip, polydata)
        slabs.AddInputData(clip.GetClippedOutput())
    slabs.AddInputData(polydata)
    slabs.Update()
    return slabs.GetOutput()


def polygon_means(polydata, values):
    """returns the mean of `values` over the corners of each polygon"""
    corners, offsets = cells_of(polydata.GetPolys())
    return np.add.reduceat(values[corners], offsets[:-1]) / np.diff(offsets)[:, None]


def scaled_jacobians(points, hexahedra):
    """returns the least normalized determinant over the eight corners and the centre of each hexahedron"""
    neighbors = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))
    sides = (((1, 2, 5, 6), (0, 3, 4, 7)), ((2, 3, 6, 7), (0, 1, 4, 5)), ((4, 5, 6, 7), (0, 1, 2, 3)))
    corners = points[hexahedra]
    frames = [[corners[:, n] - corners[:, i] for n in neighbors[i]] for i in range(8)]
    frames.append([corners[:, list(high)].sum(axis=1) - corners[:, list(low)].sum(axis=1) for high, low in sides])
    return np.min([normalized_determinants(*frame) for frame in frames], axis=0)


def normalized_determinants(a, b, c):
    lengths = np.prod([np.linalg.norm(edge, axis=1) for edge in (a, b, c)], axis=0)
    determinants = np.einsum("ij,ij->i", a, np.cross(b, c))
    return np.where(lengths > 0, determinants / np.where(lengths > 0, lengths, 1), -1)
