# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of what the parameters do."""
import sys

import numpy as np
import panels
import shapes
import viewing
from matplotlib import pyplot as plt
from panels import Optimizer, optimized
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData,
    vtkArrayCalculator,
    vtkContourFilter,
    vtkMassProperties,
    vtkWindowedSincPolyDataFilter,
)
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

HEAD = {"zoom": 3.4, "focus": (0.76, 0.4, 0.72)}
BUMPS = {"direction": (0.4, -1, 0.7), "zoom": 1.9}
CORNER = {"direction": viewing.PART, "zoom": 3.4, "focus": (0.8, 0.15, 0.5)}
WHOLE_PART = {"direction": viewing.PART, "zoom": 1.3}
CONSTANT, LINEAR, CDF = Optimizer.CONSTANT, Optimizer.LINEAR, Optimizer.CDF


def weights():
    """Position weights side by side, as in Fig. 5 of the paper."""
    mesh = shapes.animal()
    columns = {
        "input": None,
        "CONSTANT": {"PositionWeighting": CONSTANT},
        "CDF": {"PositionWeighting": CDF},
        "LINEAR": {"PositionWeighting": LINEAR},
        "CDF,\ntangent planes": {"TangentPlaneConstraints": True},
        "CDF,\nmodulated": {"ModulateByTriangleQuality": True},
    }
    figure, axes = plt.subplots(
        3, 6, figsize=(12, 6.2), layout="constrained", height_ratios=(3, 1, 3)
    )
    for column, (name, properties) in zip(axes.T, columns.items()):
        output = optimized(mesh, **properties) if properties else mesh
        ratios = panels.radius_ratios(output)
        measured = panels.updated(panels.vtkTriangleRadiusRatio(), output).GetOutput()
        panels.show(
            column[0],
            [viewing.surface(measured, "RadiusRatio")],
            "%s\nmean %.3f, min. %.3f" % (name, ratios.mean(), ratios.min()),
            **HEAD,
        )
        panels.show_histogram(column[1], ratios)
        if properties:
            deviation = panels.common.deviation(output, mesh)
            largest = 0.0015 * mesh.GetLength()
            distant = deviation.GetOutput()
            panels.show(
                column[2],
                [viewing.surface(distant, "Distance", (0, largest), viewing.MAGNITUDE)],
                "distance %.4f" % deviation.GetRelativeHausdorffDistance(),
                **HEAD,
            )
        else:
            column[2].axis("off")
    panels.show_colors(figure, axes[0], viewing.QUALITY, (0, 1), "radius ratio")
    panels.show_colors(figure, axes[2], viewing.MAGNITUDE, (0, 0.0015), "distance / diagonal")
    panels.save(figure, "weights", colors=160)


def scale():
    """The scale factor s in smoothing, as in Fig. 7 of the paper."""
    noisy = shapes.with_noise(shapes.animal(), 0.0007)
    rows = {
        "CONSTANT": {"PositionWeighting": CONSTANT},
        "CDF": {"PositionWeighting": CDF},
        "CDF and\nCDF_COMPLEMENT": {
            "PositionWeighting": CDF,
            "LaplacianWeighting": Optimizer.CDF_COMPLEMENT,
        },
    }
    figure, axes = plt.subplots(3, 5, figsize=(12, 6.6), layout="constrained")
    for row, (name, properties) in zip(axes, rows.items()):
        panels.show(row[0], [viewing.surface(noisy)], "input", **HEAD)
        place = {"transform": row[0].transAxes, "va": "center", "ha": "right"}
        row[0].text(-0.05, 0.5, name, rotation=90, **place)
        for cell, factor in zip(row[1:], (1, 0.3, 0.1, 0.03)):
            smooth = optimized(noisy, Mode=Optimizer.SMOOTH, ScaleFactor=factor, **properties)
            panels.show(cell, [viewing.surface(smooth)], "s = %g" % factor, **HEAD)
    panels.save(figure, "scale")


def laplacians():
    """The three Laplacians in smoothing, as in Fig. 9 of the paper."""
    noisy = shapes.with_noise(shapes.animal(), 0.0007)
    figure, axes = plt.subplots(1, 4, figsize=(12, 3.1), layout="constrained")
    detail = {"zoom": 6, "focus": (0.82, 0.35, 0.74)}
    panels.show(axes[0], [viewing.surface(noisy, edges=True)], "input", **detail)
    for cell, name in zip(axes[1:], ("UNIFORM", "COTANGENT", "MEAN_CURVATURE")):
        smooth = optimized(
            noisy,
            Mode=Optimizer.SMOOTH,
            LaplacianType=getattr(Optimizer, name),
            PositionWeighting=CONSTANT,
            ScaleFactor=0.3,
        )
        panels.show(cell, [viewing.surface(smooth, edges=True)], name, **detail)
    panels.save(figure, "laplacians")


def fields():
    """A field on a sphere's isosurface, left at its points and interpolated."""
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(*(-15, 15) * 3)
    radius = vtkArrayCalculator()
    radius.SetInputConnection(wavelet.GetOutputPort())
    radius.AddCoordinateVectorVariable("x")
    radius.SetFunction("mag(x)")
    radius.SetResultArrayName("radius")
    sphere = vtkContourFilter()
    sphere.SetInputConnection(radius.GetOutputPort())
    sphere.SetInputArrayToProcess(0, 0, 0, 0, "radius")
    sphere.SetValue(0, 11.3)
    sphere.Update()
    mesh = sphere.GetOutput()

    def field(points):
        return 300 * np.sin(points[:, 0] / 2) * np.cos(points[:, 1] / 2)

    shapes.add_point_array(mesh, "Field", field(shapes.points_of(mesh)))
    within = {"Mode": Optimizer.OPTIMIZE_WITHIN_DEVIATION}
    columns = {
        "input": mesh,
        "InterpolatePointData off": optimized(mesh, InterpolatePointData=False, **within),
        "InterpolatePointData on": optimized(mesh, **within),
    }
    figure, axes = plt.subplots(1, 3, figsize=(12, 4.2), layout="constrained")
    for cell, (name, output) in zip(axes, columns.items()):
        values = vtk_to_numpy(output.GetPointData().GetArray("Field"))
        error = np.sqrt(np.mean((values - field(shapes.points_of(output))) ** 2))
        actor = viewing.surface(output, "Field", (-300, 300), edges=True)
        title = "%s\nmean radius ratio %.2f, error of the field %.1f"
        panels.show(
            cell, [actor], title % (name, panels.radius_ratios(output).mean(), error), zoom=1.4
        )
    panels.show_colors(figure, axes, viewing.QUALITY, (-300, 300), "field")
    panels.save(figure, "fields", colors=160)


def bumpy_layer(cells, height):
    """A square of bumps with points that are not evenly spaced."""
    i, j = (k.ravel() for k in np.meshgrid(*2 * [np.arange(cells + 1)], indexing="ij"))
    random = np.random.default_rng(1)
    inside = (i % cells > 0) & (j % cells > 0)
    x, y = ((k + inside * random.uniform(-0.25, 0.25, len(k))) / cells for k in (i, j))
    z = height + 0.02 * np.sin(25 * x) * np.cos(25 * y)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    lower = np.stack([corner, corner + cells + 1, corner + cells + 2], axis=1)
    upper = np.stack([corner, corner + cells + 2, corner + 1], axis=1)
    return shapes.polydata(np.stack([x, y, z], axis=1), np.concatenate([lower, upper]))


def turned_over(mesh):
    return shapes.polydata(shapes.points_of(mesh), shapes.triangles_of(mesh)[:, ::-1])


def joined(meshes):
    append = vtkAppendPolyData()
    for mesh in meshes:
        append.AddInputData(mesh)
    append.Update()
    return append.GetOutput()


def thin_walls():
    """The two sides of a thin wall: each for itself, and together."""
    layers = [bumpy_layer(24, 0), turned_over(bumpy_layer(24, 0.001))]
    within = {
        "Mode": Optimizer.OPTIMIZE_WITHIN_DEVIATION,
        "MaximumDeviation": 0.007,
        "DetectFeatures": False,
        "BoundaryCondition": Optimizer.SLIDING,
    }
    columns = {
        "input": joined(layers),
        "each side for itself": joined([optimized(layer, **within) for layer in layers]),
        "both together": optimized(joined(layers), **within),
    }
    figure, axes = plt.subplots(1, 3, figsize=(12, 4.8), layout="constrained")
    for cell, (name, output) in zip(axes, columns.items()):
        checked = optimized(
            output, Mode=Optimizer.OPTIMIZE_TRIANGLES, ScaleFactor=1e6, CheckSelfIntersections=True
        )
        pairs = checked.GetFieldData().GetArray("InputSelfIntersections").GetValue(0)
        meets = vtk_to_numpy(checked.GetCellData().GetArray("SelfIntersecting"))
        marks = np.zeros(output.GetNumberOfPoints())
        marks[shapes.triangles_of(output)[meets > 0]] = 1
        shapes.add_point_array(output, "Meets", marks)
        actor = viewing.surface(output, "Meets", (0, 1), viewing.QUALITY[::-1], edges=True)
        title = "%s\nmean radius ratio %.2f, %d pairs of triangles meet"
        panels.show(cell, [actor], title % (name, panels.radius_ratios(output).mean(), pairs), **BUMPS)
    panels.save(figure, "thin_walls")


def features():
    """Triangles on a part with sharp edges, as in Fig. 6 of the paper."""
    part = shapes.machine_part()
    constant = {"PositionWeighting": CONSTANT, "ScaleFactor": 0.1}
    panels_of = {
        "input": None,
        "LINEAR": {"PositionWeighting": LINEAR},
        "LINEAR, tangent planes": {"PositionWeighting": LINEAR, "TangentPlaneConstraints": True},
        "LINEAR and LINEAR_COMPLEMENT": {
            "PositionWeighting": LINEAR,
            "LaplacianWeighting": Optimizer.LINEAR_COMPLEMENT,
        },
        "FeatureConstraints,\nCONSTANT, s = 0.1": {"FeatureConstraints": True, **constant},
        "OPTIMIZE_WITHIN_DEVIATION\n0.0005": {
            "Mode": Optimizer.OPTIMIZE_WITHIN_DEVIATION,
            "MaximumDeviation": 0.0005,
        },
    }
    figure, axes = plt.subplots(2, 3, figsize=(12, 7), layout="constrained")
    for cell, (name, properties) in zip(axes.flat, panels_of.items()):
        output = optimized(part, **properties) if properties else part
        ratios = panels.radius_ratios(output)
        measures = "mean %.3f, min. %.3f" % (ratios.mean(), ratios.min())
        if properties:
            measures += ", distance %.5f" % panels.hausdorff(output, part)
        panels.show(cell, [viewing.surface(output, edges=True)], name + "\n" + measures, **CORNER)
    panels.save(figure, "features")


def smoothing_with_edges(clean, noisy, name, view, factor):
    """Smoothing of a noisy shape with sharp edges: surface, and distance to the clean one."""
    sinc = vtkWindowedSincPolyDataFilter
    sinc_properties = {"NumberOfIterations": 20, "PassBand": 0.05, "NormalizeCoordinates": True}
    smooth = {"Mode": Optimizer.SMOOTH}
    columns = {
        "noisy": noisy,
        "WindowedSinc": panels.updated(sinc(), noisy, **sinc_properties).GetOutput(),
        "SMOOTH\nCONSTANT, s = 0.3": optimized(
            noisy, PositionWeighting=CONSTANT, ScaleFactor=0.3, **smooth
        ),
        "SMOOTH\nLINEAR, s = %g" % factor: optimized(
            noisy, PositionWeighting=LINEAR, ScaleFactor=factor, **smooth
        ),
        "SMOOTH, LINEAR and\nLINEAR_COMPLEMENT, s = %g" % factor: optimized(
            noisy,
            PositionWeighting=LINEAR,
            ScaleFactor=factor,
            LaplacianWeighting=Optimizer.LINEAR_COMPLEMENT,
            **smooth,
        ),
        "SMOOTH_GUIDED": optimized(noisy, Mode=Optimizer.SMOOTH_GUIDED),
    }
    figure, axes = plt.subplots(2, 6, figsize=(12, 4.4), layout="constrained")
    for column, (title, mesh) in zip(axes.T, columns.items()):
        panels.show(column[0], [viewing.surface(mesh)], title, **view)
        distance = panels.common.deviation(mesh, clean).GetOutput()
        largest = 0.005 * clean.GetLength()
        colored = viewing.surface(distance, "Distance", (0, largest), viewing.MAGNITUDE)
        measures = "distance %.5f\nnormals %.1f°" % (
            panels.root_mean_square_distance(mesh, clean),
            panels.mean_normal_error(mesh, clean),
        )
        panels.show(column[1], [colored], measures, **view)
    panels.show_colors(figure, axes[1], viewing.MAGNITUDE, (0, 0.005), "distance / diagonal")
    panels.save(figure, name, colors=96)


def pyramid():
    """A noisy double pyramid, as in Fig. 8 of the paper."""
    clean = shapes.double_pyramid()
    view = {"direction": (0.5, -1, 0.4), "zoom": 1.5}
    smoothing_with_edges(clean, shapes.with_noise(clean, 0.005), "pyramid", view, 0.3)


def cad_noise():
    clean = shapes.machine_part()
    smoothing_with_edges(clean, shapes.with_noise(clean, 0.002), "cad-noise", WHOLE_PART, 0.3)


def volume_of(mesh):
    return panels.updated(vtkMassProperties(), mesh).GetVolume()


def shrinkage():
    """What Twicing and PreserveVolume do, over the scale factor."""
    clean = shapes.animal()
    noisy = shapes.with_noise(clean, 0.0015)
    lines = {
        "plain": {},
        "Twicing": {"Twicing": True},
        "PreserveVolume": {"PreserveVolume": True},
        "both": {"Twicing": True, "PreserveVolume": True},
    }
    factors = np.geomspace(0.05, 2, 9)
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.2), layout="constrained")
    for name, properties in lines.items():
        properties = {"Mode": Optimizer.SMOOTH, "PositionWeighting": CONSTANT, **properties}
        results = [optimized(noisy, ScaleFactor=factor, **properties) for factor in factors]
        changes = [100 * (volume_of(result) / volume_of(noisy) - 1) for result in results]
        distances = [panels.root_mean_square_distance(result, clean) for result in results]
        axes[0].plot(factors, changes, ".-", label=name)
        axes[1].plot(factors, distances, ".-", label=name)
    noise = panels.root_mean_square_distance(noisy, clean)
    axes[1].axhline(noise, color="gray", lw=0.8, label="noisy input")
    axes[0].set(ylabel="change of volume, percent")
    axes[1].set(ylabel="RMS distance to the clean surface", ylim=(0, None))
    for axis in axes:
        axis.set(xlabel="ScaleFactor s", xscale="log")
        axis.grid(alpha=0.3)
        axis.legend()
    panels.save(figure, "shrinkage")


if __name__ == "__main__":
    pictures = (weights, scale, laplacians, fields, thin_walls, features, pyramid, cad_noise)
    for picture in (*pictures, shrinkage):
        if picture.__name__ in (sys.argv[1:] or picture.__name__):
            picture()
