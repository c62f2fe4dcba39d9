# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the pictures of the guide share: filters in one line, measures, panels in matplotlib."""
import os
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from PIL import Image  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Examples", "Python"))

import common  # noqa: E402
import shapes  # noqa: E402
import viewing  # noqa: E402
from laplacianmesh import vtkLaplacianMeshOptimizer as Optimizer  # noqa: E402
from laplacianmesh import vtkTriangleRadiusRatio  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

IMAGES = os.path.join(HERE, "..", "images")
plt.rcParams.update({"font.size": 10, "axes.titlesize": 10, "figure.dpi": 85})


def updated(vtk_filter, mesh, **properties):
    """The filter after Update(), with its properties set."""
    vtk_filter.SetInputData(mesh)
    for name, value in properties.items():
        getattr(vtk_filter, "Set" + name)(value)
    vtk_filter.Update()
    return vtk_filter


def optimized(mesh, **properties):
    """Mode OPTIMIZE_TRIANGLES unless the properties say otherwise."""
    settings = {"Mode": Optimizer.OPTIMIZE_TRIANGLES, **properties}
    return updated(Optimizer(), mesh, **settings).GetOutput()


def radius_ratios(mesh):
    measured = updated(vtkTriangleRadiusRatio(), mesh).GetOutput()
    return vtk_to_numpy(measured.GetCellData().GetArray("RadiusRatio"))


def hausdorff(mesh, reference):
    """Both directions, / diagonal of the reference."""
    return common.deviation(mesh, reference).GetRelativeHausdorffDistance()


def root_mean_square_distance(mesh, reference):
    """Of the points to the reference, / its diagonal."""
    distance = common.deviation(mesh, reference).GetOutput().GetPointData().GetArray("Distance")
    return np.sqrt(np.mean(vtk_to_numpy(distance) ** 2)) / reference.GetLength()


def normals(mesh):
    """Unit normals of the triangles, and their doubled areas."""
    a, b, c = (shapes.points_of(mesh)[shapes.triangles_of(mesh)[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1)
    return normal / np.maximum(length, 1e-300)[:, None], length


def mean_normal_error(mesh, reference):
    """Degrees; mean over the triangles, which are those of the reference."""
    cosine = (normals(mesh)[0] * normals(reference)[0]).sum(axis=1)
    return np.degrees(np.arccos(np.clip(cosine, -1, 1))).mean()


def photograph(actors, size=(400, 360), **view):
    image = viewing.photograph([viewing.renderer(actors, **view)], size)
    columns, rows, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1]


def show(axes, actors, title="", **view):
    axes.imshow(photograph(actors, **view), interpolation="bilinear")
    axes.set_title(title)
    axes.axis("off")


def show_histogram(axes, ratios):
    axes.hist(ratios, bins=50, range=(0, 1), color=viewing.QUALITY[2])
    axes.set_yticks([])
    axes.set_xticks([0, 0.5, 1])
    axes.spines[["top", "right", "left"]].set_visible(False)


def show_colors(figure, axes, colors, value_range, label):
    """A bar of the colours beside the axes."""
    table = matplotlib.colors.LinearSegmentedColormap.from_list("", colors)
    norm = matplotlib.colors.Normalize(*value_range)
    mappable = matplotlib.cm.ScalarMappable(norm, table)
    figure.colorbar(mappable, ax=axes, shrink=0.8, label=label, pad=0.01)


def save(figure, name, colors=48):
    path = os.path.join(IMAGES, name + ".png")
    figure.savefig(path)
    plt.close(figure)
    shrink(path, colors)


def shrink(path, colors=48, width=1200):
    """Fewer colours, hard to see and a third of the space; no more pixels than the width."""
    picture = Image.open(path).convert("RGB")
    if picture.width > width:
        picture = picture.resize((width, round(picture.height * width / picture.width)))
    picture = picture.quantize(colors, kmeans=1, dither=Image.Dither.NONE)
    picture.save(path, optimize=True)
    print("%s: %d kB" % (os.path.basename(path), os.path.getsize(path) // 1000))
