# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of surfaces, without a window; on a machine without a screen run them in xvfb-run."""
import shapes
import vtkmodules.vtkRenderingFreeType  # noqa: F401 - draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - draws the rest
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

QUALITY = (0.70, 0.05, 0.10), (1.00, 0.95, 0.70), (0.20, 0.40, 0.70)  # bad to good
MAGNITUDE = (0.96, 0.96, 0.96), (0.95, 0.60, 0.25), (0.55, 0.05, 0.10)  # none to much
CLASSES = (0.80, 0.82, 0.86), (0.95, 0.55, 0.10), (0.95, 0.55, 0.10)  # face, edge, corner
SIGNED = (0.15, 0.30, 0.70), (0.96, 0.96, 0.96), (0.70, 0.10, 0.10)

PART = (0.15, -1, 0.75)  # the direction from which shapes.machine_part() shows most


def surface(mesh, array=None, value_range=(0, 1), colors=QUALITY, edges=False):
    """An actor; array: a cell or point array with one component to colour by."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarVisibility(array is not None)
    if array:
        table = vtkColorTransferFunction()
        low, high = value_range
        for value, color in zip((low, (low + high) / 2, high), colors):
            table.AddRGBPoint(value, *color)
        mapper.SetLookupTable(table)
        mapper.SelectColorArray(array)
        if mesh.GetCellData().HasArray(array):
            mapper.SetScalarModeToUseCellFieldData()
        else:
            mapper.SetScalarModeToUsePointFieldData()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetColor(0.80, 0.82, 0.86)
    look.SetAmbient(0.25)
    look.SetDiffuse(0.75)
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(0.25, 0.25, 0.25)
    return actor


def balls(points, radius):
    """An actor of a ball at each point."""
    sphere = vtkSphereSource()
    sphere.SetRadius(radius)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(shapes.polydata(points, []))
    glyphs.SetSourceConnection(sphere.GetOutputPort())
    glyphs.Update()
    actor = surface(glyphs.GetOutput())
    actor.GetProperty().SetColor(0.75, 0.05, 0.10)
    return actor


def renderer(actors, direction=(1, -1, 0.5), zoom=1.4, focus=(0.5, 0.5, 0.5), title=""):
    """The actors seen from a direction, z upward.

    focus: the middle of the picture in fractions of the bounding box; title: above, on the left.
    """
    view = vtkRenderer()
    view.SetBackground(1, 1, 1)
    for actor in actors:
        view.AddActor(actor)
    bounds = view.ComputeVisiblePropBounds()
    middle = [low + f * (high - low) for low, high, f in zip(bounds[::2], bounds[1::2], focus)]
    camera = view.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(direction)
    camera.SetViewUp(0, 0, 1)
    view.ResetCamera()
    shift = [new - old for new, old in zip(middle, camera.GetFocalPoint())]
    camera.SetPosition([p + s for p, s in zip(camera.GetPosition(), shift)])
    camera.SetFocalPoint(middle)
    camera.Zoom(zoom)
    view.ResetCameraClippingRange()
    if title:
        text = vtkTextActor()
        text.SetInput(title)
        text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        text.SetPosition(0.02, 0.93)
        text.GetTextProperty().SetColor(0, 0, 0)
        text.GetTextProperty().SetFontSize(20)
        text.GetTextProperty().SetBackgroundColor(1, 1, 1)
        text.GetTextProperty().SetBackgroundOpacity(0.7)
        view.AddActor2D(text)
    return view


def photograph(renderers, size=(600, 500)):
    """The renderers side by side, as vtkImageData; size: of each."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(size[0] * len(renderers), size[1])
    for k, view in enumerate(renderers):
        view.SetViewport(k / len(renderers), 0, (k + 1) / len(renderers), 1)
        window.AddRenderer(view)
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.Update()
    return grabber.GetOutput()


def save_picture(path, renderers, size=(600, 500)):
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(photograph(renderers, size))
    writer.Write()
