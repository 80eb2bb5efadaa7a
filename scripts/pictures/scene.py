"""Views, panels and actors of a picture."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from .convert import run
from .result_folder import FIRST_WALL, FLOOR, CEILING, Missing

WIDTH, HEIGHT, SUPERSAMPLING = 1200, 900, 2
EDGE_COLOR = (0.15, 0.15, 0.18)
SHELL_COLOR = (0.60, 0.62, 0.66)
BASES = {FLOOR: ("floor", (0.17, 0.40, 0.72)), CEILING: ("ceiling", (0.92, 0.50, 0.16))}
WALL_COLORS = [(0.78, 0.78, 0.75), (0.45, 0.68, 0.45), (0.62, 0.50, 0.74), (0.88, 0.78, 0.42), (0.42, 0.70, 0.74),
               (0.82, 0.56, 0.62)]
HEIGHT_COLORS = [(0.16, 0.24, 0.54), (0.17, 0.46, 0.62), (0.36, 0.66, 0.58), (0.72, 0.80, 0.46), (0.96, 0.72, 0.30),
                 (0.86, 0.36, 0.20)]
QUALITY_COLORS = [(0.70, 0.10, 0.15), (0.93, 0.50, 0.25), (0.98, 0.86, 0.50), (0.55, 0.77, 0.78), (0.20, 0.45, 0.68)]


def label_name_and_color(label):
    wall = label - FIRST_WALL
    return BASES.get(label, (f"wall {wall}", WALL_COLORS[wall % len(WALL_COLORS)]))


def color_map(colors):
    """carries [0, 1] to colours"""
    function = vtk.vtkColorTransferFunction()
    for t, color in zip(np.linspace(0, 1, len(colors)), colors):
        function.AddRGBPoint(t, *color)
    return function


def interpolate_colors(colors, t):
    nodes = np.linspace(0, 1, len(colors))
    return np.column_stack([np.interp(t, nodes, channel) for channel in np.transpose(colors)])


def normalized(vector):
    return vector / np.linalg.norm(vector)


def diagonal(points):
    return np.linalg.norm(np.ptp(points, axis=0))


class View:
    """looks at `points` obliquely: mostly against `normal`, with `right` to the right and `up` upwards"""

    def __init__(self, points, normal, right, up, tilt=(0.35, 0.45)):
        self.points = points
        self.towards_eye = normalized(normal + tilt[0] * right + tilt[1] * up)
        self.right = normalized(np.cross(up, self.towards_eye))
        self.up = np.cross(self.towards_eye, self.right)

    def opposite(self):
        return View(self.points, -self.towards_eye, -self.right, self.up, tilt=(0, 0))

    def extents(self):
        """returns the points' least and greatest positions on the screen's two axes"""
        return [(x.min(), x.max()) for x in (self.points @ self.right, self.points @ self.up)]

    def is_wide(self):
        x, y = self.extents()
        return np.ptp(x) > 1.2 * np.ptp(y)

    def aim(self, camera, aspect):
        x, y = self.extents()
        depth = (self.points @ self.towards_eye).mean()
        focus = np.mean(x) * self.right + np.mean(y) * self.up + depth * self.towards_eye
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(focus)
        camera.SetPosition(focus + 2 * diagonal(self.points) * self.towards_eye)
        camera.SetViewUp(self.up)
        camera.SetParallelScale(0.54 * max(np.ptp(y), np.ptp(x) / aspect))


def principal_axes(points):
    """returns the axes from the longest to the shortest, each with its greatest coordinate positive"""
    axes = np.linalg.eigh(np.cov(points.T))[1].T[::-1]
    return np.array([axis * np.sign(axis[np.abs(axis).argmax()]) for axis in axes])


def main_view(points):
    """shows the flat side"""
    longest, middle, shortest = principal_axes(points)
    return View(points, shortest, longest, middle)


class CutView(View):
    """looks at the half of `points` behind the plane through their mean"""

    def __init__(self, points, normal, right, up):
        self.origin = points.mean(axis=0)
        self.normal = normal
        super().__init__(points[self.is_behind(points)], normal, right, up)

    def is_behind(self, points):
        return (points - self.origin) @ self.normal <= 0

    def cut_open(self, grid):
        plane = vtk.vtkPlane()
        plane.SetOrigin(self.origin)
        plane.SetNormal(-self.normal)
        clip = vtk.vtkTableBasedClipDataSet()
        clip.SetClipFunction(plane)
        return run(clip, grid)


def make_lights():
    """two lights fixed to the camera: from above on the left, and weaker from the right"""
    for position, intensity in (((-0.5, 0.7, 1), 0.8), ((0.8, -0.2, 1), 0.45)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(position)
        light.SetIntensity(intensity)
        yield light


def ordered_pass():
    """blends translucent cells in their order; VTK's own passes mix or sort them"""
    steps = vtk.vtkRenderPassCollection()
    for step in (vtk.vtkLightsPass(), vtk.vtkOpaquePass(), vtk.vtkTranslucentPass(), vtk.vtkOverlayPass()):
        steps.AddItem(step)
    sequence, camera = vtk.vtkSequencePass(), vtk.vtkCameraPass()
    sequence.SetPasses(steps)
    camera.SetDelegatePass(sequence)
    return camera


class Picture:
    """one image of one or several panels, filled row by row"""

    def __init__(self, columns=1, rows=1, height=HEIGHT):
        self.columns, self.rows, self.height, self.renderers = columns, rows, height, []
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(SUPERSAMPLING * WIDTH, SUPERSAMPLING * height)
        self.window.SetMultiSamples(0)
        self.window.SetAlphaBitPlanes(True)

    def add_panel(self, view, actors, in_order=False):
        """`in_order` draws translucent cells as they come instead of sorting them by depth"""
        row, column = divmod(len(self.renderers), self.columns)
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(column / self.columns, 1 - (row + 1) / self.rows, (column + 1) / self.columns,
                             1 - row / self.rows)
        renderer.SetBackground(1, 1, 1)
        renderer.SetUseDepthPeeling(True)
        renderer.SetMaximumNumberOfPeels(12)
        if in_order:
            renderer.SetPass(ordered_pass())
        for actor in actors:
            renderer.AddViewProp(actor)
        for light in make_lights():
            renderer.AddLight(light)
        view.aim(renderer.GetActiveCamera(), WIDTH / self.columns / (self.height / self.rows))
        renderer.ResetCameraClippingRange()
        self.window.AddRenderer(renderer)
        self.renderers.append(renderer)

    def add_bars(self, places, heights, name_of_places, name_of_heights):
        """a panel with a bar for each place in [0, 1]; heights are in percent"""
        table = vtk.vtkTable()
        for name, values in ((name_of_places, places), (name_of_heights, heights)):
            column = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
            column.SetName(name)
            table.AddColumn(column)
        chart = vtk.vtkChartXY()
        bars = chart.AddPlot(vtk.vtkChart.BAR)
        bars.SetInputData(table, 0, 1)
        bars.SetColor(*QUALITY_COLORS[-1])
        top = 10 * np.ceil(np.max(heights) / 10)
        for place, name, end in ((vtk.vtkAxis.BOTTOM, name_of_places, 1), (vtk.vtkAxis.LEFT, name_of_heights, top)):
            axis = chart.GetAxis(place)
            axis.SetTitle(name)
            axis.SetRange(0, end)
            axis.SetBehavior(vtk.vtkAxis.FIXED)
            axis.SetNumberOfTicks(11)
            axis.SetTickLabelAlgorithm(vtk.vtkAxis.TICK_SIMPLE)
            for style in (axis.GetTitleProperties(), axis.GetLabelProperties()):
                style.SetFontSize(17 * SUPERSAMPLING)
                style.BoldOff()
        actor = vtk.vtkContextActor()
        actor.GetScene().AddItem(chart)
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor)
        actor.GetScene().SetRenderer(renderer)
        self.window.AddRenderer(renderer)
        self.renderers.append(renderer)

    def add_text(self, lines, size=20):
        """writes (text, colour) lines into the lower left corner of the last panel"""
        for i, (line, color) in enumerate(reversed(lines)):
            label = vtk.vtkTextActor()
            label.SetInput(line)
            label.GetTextProperty().SetColor(*(0.8 * channel for channel in color))
            label.GetTextProperty().SetFontSize(size * SUPERSAMPLING)
            label.GetTextProperty().BoldOn()
            label.SetPosition(14 * SUPERSAMPLING, (12 + 1.35 * size * i) * SUPERSAMPLING)
            self.renderers[-1].AddViewProp(label)

    def add_title(self, title):
        """at the top of the last panel"""
        label = vtk.vtkTextActor()
        label.SetInput(title)
        label.GetTextProperty().SetColor(0, 0, 0)
        label.GetTextProperty().SetFontSize(17 * SUPERSAMPLING)
        label.GetTextProperty().SetJustificationToCentered()
        label.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        label.SetPosition(0.5, 0.92)
        self.renderers[-1].AddViewProp(label)

    def add_scalar_bar(self, colors, title):
        """at the right of the last panel, whose contents make room"""
        camera = self.renderers[-1].GetActiveCamera()
        camera.SetWindowCenter(0.09, 0)
        camera.SetParallelScale(1.1 * camera.GetParallelScale())
        bar = vtk.vtkScalarBarActor()
        bar.SetLookupTable(colors)
        bar.SetTitle(title)
        bar.SetNumberOfLabels(5)
        bar.SetLabelFormat("%.2f")
        bar.SetVerticalTitleSeparation(8 * SUPERSAMPLING)
        bar.UnconstrainedFontSizeOn()
        for style in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
            style.SetColor(0, 0, 0)
            style.SetFontSize(17 * SUPERSAMPLING)
            style.ShadowOff()
            style.ItalicOff()
        bar.SetPosition(0.91, 0.05)
        bar.SetWidth(0.08)
        bar.SetHeight(0.30)
        self.renderers[-1].AddViewProp(bar)

    def save(self, path):
        capture = vtk.vtkWindowToImageFilter()
        capture.SetInput(self.window)
        capture.ReadFrontBufferOff()
        shrink = vtk.vtkImageShrink3D()
        shrink.SetInputConnection(capture.GetOutputPort())
        shrink.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
        shrink.MeanOn()
        writer = vtk.vtkPNGWriter()
        writer.SetInputConnection(shrink.GetOutputPort())
        writer.SetFileName(str(path))
        writer.Write()
        if writer.GetErrorCode():
            raise Missing(f"{path} cannot be written")


def two_panels(view):
    """one above the other for wide objects, side by side for tall ones"""
    return Picture(rows=2) if view.is_wide() else Picture(columns=2)


def make_actor(data, color=None, opacity=1.0, edges=False, colors=None):
    """without `color` the active scalars are colours, or numbers in [0, 1] that `colors` carries to colours"""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(color is None)
    if colors is not None:
        mapper.SetLookupTable(colors)
        mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    style = actor.GetProperty()
    if color is not None:
        style.SetColor(color)
    style.SetOpacity(opacity)
    style.SetEdgeVisibility(edges)
    style.SetEdgeColor(EDGE_COLOR)
    style.SetLineWidth(0.5 * SUPERSAMPLING)
    style.SetAmbient(0.22)
    style.SetDiffuse(0.85)
    return actor


def make_shell(surface):
    """a translucent surface with its creases"""
    creases = vtk.vtkFeatureEdges()
    creases.SetFeatureAngle(60)
    creases.ColoringOff()
    lines = make_actor(run(creases, surface), color=EDGE_COLOR, opacity=0.6)
    lines.GetProperty().SetLineWidth(SUPERSAMPLING)
    return [make_actor(surface, color=SHELL_COLOR, opacity=0.15), lines]
