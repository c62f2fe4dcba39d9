# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces to try the filters on, made in code and the same in every run.

Each is a vtkPolyData of triangles, closed and oriented outward.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData,
    vtkContourFilter,
    vtkDelaunay2D,
    vtkPolyDataConnectivityFilter,
)
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)


def triangles_of(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def polydata(points, triangles):
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    cells = vtkCellArray()
    for triangle in np.asarray(triangles).tolist():
        cells.InsertNextCell(3, triangle)
    mesh = vtkPolyData()
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    return mesh


def add_point_array(mesh, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def spread_points(mesh, count, seed=1):
    """Ids of points that are far from each other: each is the farthest from those before it."""
    points = points_of(mesh)
    ids = [int(np.random.default_rng(seed).integers(len(points)))]
    distance = np.full(len(points), np.inf)
    while len(ids) < count:
        distance = np.minimum(distance, ((points - points[ids[-1]]) ** 2).sum(axis=1))
        ids.append(int(distance.argmax()))
    return ids


def mask(mesh, ids):
    """1 for the points with these ids, else 0."""
    values = np.zeros(mesh.GetNumberOfPoints())
    values[ids] = 1
    return values


def with_noise(mesh, size, seed=1):
    """Gaussian noise on each coordinate; size: standard deviation / bounding-box diagonal."""
    noise = np.random.default_rng(seed).standard_normal((mesh.GetNumberOfPoints(), 3))
    return polydata(points_of(mesh) + size * mesh.GetLength() * noise, triangles_of(mesh))


# --- A smooth shape -------------------------------------------------------------------------------
# Its parts: (centre, radii, angle in the x-z plane); what is symmetric stands once.
BODY = [
    ((0.0, 0.0, 0.0), (0.52, 0.36, 0.36), 0),  # trunk
    ((0.50, 0.0, 0.30), (0.20, 0.17, 0.30), -35),  # neck
    ((0.70, 0.0, 0.55), (0.26, 0.20, 0.20), 20),  # head
    ((0.92, 0.0, 0.47), (0.14, 0.11, 0.10), 10),  # snout
    ((-0.62, 0.0, 0.22), (0.28, 0.06, 0.06), 50),  # tail
]
PAIRS = [
    ((0.33, 0.20, -0.40), (0.11, 0.10, 0.34), 5),  # front leg
    ((-0.33, 0.21, -0.40), (0.12, 0.10, 0.34), -5),  # hind leg
    ((0.38, 0.21, -0.69), (0.15, 0.10, 0.06), 0),  # feet
    ((-0.27, 0.22, -0.69), (0.15, 0.10, 0.06), 0),
    ((0.62, 0.17, 0.78), (0.06, 0.05, 0.19), -25),  # ear
]
EYE = ((0.83, 0.14, 0.635), (0.05, 0.05, 0.05), 0)
MOUTH = ((1.05, 0.0, 0.47), (0.12, 1.0, 0.03), 10)


def ellipsoid(x, y, z, centre, radii, angle):
    """About the distance to the ellipsoid, negative inside."""
    sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    x, y, z = (axis - middle for axis, middle in zip((x, y, z), centre))
    x, z = cosine * x - sine * z, sine * x + cosine * z
    return (np.sqrt(sum((c / r) ** 2 for c, r in zip((x, y, z), radii))) - 1) * min(radii)


def blended(distances, width):
    """A smooth minimum: the union of shapes, rounded where they meet."""
    return -width * np.log(sum(np.exp(-np.clip(d, -1, 2) / width) for d in distances))


def animal(samples=50):
    """An animal with a bumpy skin: an isosurface, whose triangles have every shape.

    samples: of the contoured image per unit of length; 50 gives 37,000 triangles.
    """
    low, high = np.array([-1.1, -0.6, -0.95]), np.array([1.2, 0.6, 1.15])
    counts = np.ceil((high - low) * samples).astype(int)
    x, y, z = np.meshgrid(
        *(np.linspace(a, b, n) for a, b, n in zip(low, high, counts)), indexing="ij", sparse=True
    )
    parts = [ellipsoid(x, y, z, *part) for part in BODY]
    parts += [ellipsoid(x, np.abs(y), z, *part) for part in PAIRS]
    distance = blended(parts, 0.045)
    distance = distance + 0.01 * np.sin(34 * x) * np.sin(34 * y + 1) * np.sin(34 * z + 2)
    distance = -blended([-distance, ellipsoid(x, y, z, *MOUTH)], 0.01)
    distance = blended([distance, ellipsoid(x, np.abs(y), z, *EYE)], 0.005)
    return largest_isosurface(-distance, low, (high - low) / (counts - 1))


def largest_isosurface(values, origin, spacing):
    image = vtkImageData()
    image.SetDimensions(values.shape)
    image.SetOrigin(origin)
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(order="F"), deep=True))
    contour = vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 0)
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(contour.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    clean = vtkCleanPolyData()
    clean.SetInputConnection(largest.GetOutputPort())
    clean.ConvertPolysToLinesOff()
    clean.Update()
    return polydata(points_of(clean.GetOutput()), triangles_of(clean.GetOutput()))


# --- Shapes with sharp edges ----------------------------------------------------------------------
def double_pyramid(subdivisions=5):
    """Two pyramids base to base; 5 subdivisions give 8192 triangles."""
    octahedron = vtkPlatonicSolidSource()
    octahedron.SetSolidTypeToOctahedron()
    subdivision = vtkLinearSubdivisionFilter()
    subdivision.SetInputConnection(octahedron.GetOutputPort())
    subdivision.SetNumberOfSubdivisions(subdivisions)
    subdivision.Update()
    return polydata(points_of(subdivision.GetOutput()), triangles_of(subdivision.GetOutput()))


# The outline (r, z) that the machine part is turned from, anticlockwise.
OUTLINE = np.array(
    [(0.6, 0), (1.5, 0), (1.5, 0.3), (1.15, 0.3), (1.15, 0.6), (0.85, 0.9), (0.6, 0.9)]
)
FILLET = 4  # this corner and the next are joined by an arc


TURN = np.radians(150)


def machine_part(edge=0.04, jitter=0.25, seed=1):
    """A turned part, cut out along two planes: flat and curved faces, straight and curved edges.

    edge: length of the edges; 0.04 gives 14,000 triangles. jitter: how far points are shifted
    within their faces and along their edges, / edge.
    """
    random = np.random.default_rng(seed)
    r, z, angle, turned = turned_outline(edge, jitter, random)
    start = cap(np.column_stack([r[0], z[0]]), edge, random)
    end = cap(np.column_stack([r[-1], z[-1]]), edge, random)
    return welded(
        [
            (on_axis(r, z, angle), turned),
            (on_axis(*start[0].T, 0), start[1]),
            (on_axis(*end[0].T, TURN), end[1][:, ::-1]),
        ]
    )


def on_axis(r, z, angle):
    """Cylinder coordinates as points."""
    return np.stack([r * np.cos(angle), r * np.sin(angle), z], axis=-1).reshape(-1, 3)


def turned_outline(edge, jitter, random):
    """r, z and angle of a grid of points, and its triangles; a row is an outline."""
    outline, is_corner = divided_outline(edge)
    rows = int(1.1 * TURN / edge)
    row, place = np.indices((rows + 1, len(outline))).astype(float)
    row[1:-1] += random.uniform(-jitter, jitter, row[1:-1].shape)
    place[:, ~is_corner] += random.uniform(-jitter, jitter, place[:, ~is_corner].shape)
    places = np.arange(len(outline) + 1)
    r, z = (np.interp(place, places, np.append(axis, axis[0])) for axis in outline.T)

    ids = np.arange(row.size).reshape(row.shape)
    ids = np.column_stack([ids, ids[:, 0]])
    a, b, c, d = ids[:-1, :-1], ids[1:, :-1], ids[1:, 1:], ids[:-1, 1:]
    along_ac = random.random(a.shape) < 0.5
    triangles = np.where(along_ac, [[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]])
    return r, z, TURN * row / rows, np.moveaxis(triangles, 1, -1).reshape(-1, 3)


def divided_outline(edge):
    """Points along the outline, edge apart, and which of them are its corners."""
    points, is_corner = [], []
    for k, start in enumerate(OUTLINE):
        end = OUTLINE[(k + 1) % len(OUTLINE)]
        t = np.linspace(0, 1, max(2, round(np.linalg.norm(end - start) / edge)), endpoint=False)
        if k == FILLET:
            turn = t * np.pi / 2
            r = end[0] + (start - end)[0] * np.cos(turn)
            z = start[1] + (end - start)[1] * np.sin(turn)
            points.append(np.column_stack([r, z]))
        else:
            points.append(start + np.outer(t, end - start))
        is_corner.append(np.arange(len(t)) == 0)
    return np.vstack(points), np.concatenate(is_corner)


def cap(outline, edge, random):
    """A flat region with points inside, triangulated."""
    low, high = outline.min(axis=0), outline.max(axis=0)
    inner = np.stack(np.meshgrid(*(np.arange(a, b, edge) for a, b in zip(low, high))), axis=-1)
    inner = inner.reshape(-1, 2) + random.uniform(-0.3 * edge, 0.3 * edge, (inner.size // 2, 2))
    inner = inner[distance_inside(inner, outline) > 0.5 * edge]
    points = np.vstack([outline, inner])
    boundary = vtkPolyData()
    boundary.SetPoints(polydata(np.column_stack([points, np.zeros(len(points))]), []).GetPoints())
    loop = vtkCellArray()
    loop.InsertNextCell(len(outline), range(len(outline)))
    boundary.SetPolys(loop)
    delaunay = vtkDelaunay2D()
    delaunay.SetInputData(boundary)
    delaunay.SetSourceData(boundary)
    delaunay.Update()
    triangles = triangles_of(delaunay.GetOutput())
    a, b, c = (points[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a) / 2
    triangles = np.where(area[:, None] < 0, triangles[:, ::-1], triangles)
    return points, triangles[np.abs(area) > 1e-9 * edge**2]  # others lie outside, on an edge


def distance_inside(points, outline):
    """Distance to the outline, negative outside."""
    start, end = outline, np.roll(outline, -1, axis=0)
    along = end - start
    offset = points[:, None] - start
    t = np.clip((offset * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
    distance = np.linalg.norm(offset - t[..., None] * along, axis=2).min(axis=1)
    x, y = points[:, None, 0], points[:, None, 1]
    crosses = (start[:, 1] > y) != (end[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = start[:, 0] + (y - start[:, 1]) / along[:, 1] * along[:, 0]
    is_inside = (crosses & (x < at)).sum(axis=1) % 2 == 1
    return np.where(is_inside, distance, -distance)


def welded(parts):
    """Meshes (points, triangles) as one; points that coincide become one."""
    offsets = np.cumsum([0] + [len(points) for points, _ in parts])
    together = polydata(
        np.vstack([points for points, _ in parts]),
        np.vstack([triangles + offset for (_, triangles), offset in zip(parts, offsets)]),
    )
    clean = vtkCleanPolyData()
    clean.SetInputData(together)
    clean.SetTolerance(1e-6)
    clean.Update()
    return polydata(points_of(clean.GetOutput()), triangles_of(clean.GetOutput()))
