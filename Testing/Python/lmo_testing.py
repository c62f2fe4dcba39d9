# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes made in code, the same in every run, and their way into VTK and back.

A mesh is a pair (V, T): coordinates, one row for each point, and three point ids for each triangle,
counter-clockwise seen from outside.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


# --- Between numpy and VTK -----------------------------------------------------------------------
def to_polydata(mesh, **point_arrays):
    V, T = mesh
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(V), deep=True))
    polygons = vtkCellArray()
    for polygon in T.tolist():
        polygons.InsertNextCell(len(polygon), polygon)
    polydata = vtkPolyData()
    polydata.SetPoints(points)
    polydata.SetPolys(polygons)
    for name, values in point_arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        polydata.GetPointData().AddArray(array)
    return polydata


def points_of(polydata):
    return vtk_to_numpy(polydata.GetPoints().GetData()).astype(float)


def mesh_of(polydata):
    connectivity = vtk_to_numpy(polydata.GetPolys().GetConnectivityArray())
    return points_of(polydata), connectivity.reshape(-1, 3).astype(int)


def point_array(polydata, name):
    return vtk_to_numpy(polydata.GetPointData().GetArray(name))


def cell_array(polydata, name):
    return vtk_to_numpy(polydata.GetCellData().GetArray(name))


def metric(polydata, name):
    """A single value of the field data."""
    return polydata.GetFieldData().GetArray(name).GetValue(0)


def updated(filter_class, polydata, **properties):
    """A filter of that class, with its properties set, after Update().

    The optimizer solves once, in mode OPTIMIZE_TRIANGLES, unless the properties say otherwise.
    """
    vtk_filter = filter_class()
    if vtk_filter.IsA("vtkLaplacianMeshOptimizer"):
        vtk_filter.SetMode(vtk_filter.OPTIMIZE_TRIANGLES)
    vtk_filter.SetInputData(polydata)
    for name, value in properties.items():
        getattr(vtk_filter, "Set" + name)(value)
    vtk_filter.Update()
    return vtk_filter


def diagonal(V):
    return np.linalg.norm(V.max(axis=0) - V.min(axis=0))


def root_mean_square(vectors):
    return np.sqrt(np.mean(np.sum(np.reshape(vectors, (len(vectors), -1)) ** 2, axis=1)))


# --- Meshes --------------------------------------------------------------------------------------
def grid_triangles(ids, random):
    """Two triangles for each square of a grid of ids, split along a random diagonal."""
    a, b, c, d = (
        ids[rows, columns].ravel()
        for rows, columns in (
            (np.s_[:-1], np.s_[:-1]),
            (np.s_[1:], np.s_[:-1]),
            (np.s_[1:], np.s_[1:]),
            (np.s_[:-1], np.s_[1:]),
        )
    )
    along_ac = random.random(len(a)) < 0.5
    first = np.where(along_ac, [a, b, c], [a, b, d])
    second = np.where(along_ac, [a, c, d], [b, c, d])
    return np.hstack([first, second]).T


def torus(rows, columns, jitter=0.3, seed=1):
    """A closed, bumpy, irregular surface of genus 1; radii 2 and about 1.

    jitter: largest shift of a point along the surface in units of the grid.
    """
    random = np.random.default_rng(seed)
    ids = np.arange(rows * columns).reshape(rows, columns)
    T = grid_triangles(np.pad(ids, ((0, 1), (0, 1)), mode="wrap"), random)
    i, j = np.indices((rows, columns)) + random.uniform(-jitter, jitter, (2, rows, columns))
    u, v = 2 * np.pi * i.ravel() / rows, 2 * np.pi * j.ravel() / columns
    r = 1 + 0.15 * np.sin(5 * u) * np.cos(3 * v)
    V = np.column_stack(
        [(2 + r * np.cos(v)) * np.cos(u), (2 + r * np.cos(v)) * np.sin(u), r * np.sin(v)]
    )
    return V, T


def patch(rows, columns, jitter=0.3, seed=1):
    """An open surface over the square [0, 1] x [0, 1]: flat for x < 1/2, then a bump.

    Its boundaries are straight lines, and their points are jittered along them.
    """
    random = np.random.default_rng(seed)
    T = grid_triangles(np.arange(rows * columns).reshape(rows, columns), random)
    shift = random.uniform(-jitter, jitter, (2, rows, columns))
    shift[0, [0, -1], :] = 0
    shift[1, :, [0, -1]] = 0
    i, j = np.indices((rows, columns)) + shift
    x, y = i.ravel() / (rows - 1), j.ravel() / (columns - 1)
    z = np.where(x > 0.5, 20 * (x - 0.5) * (1 - x) * y * (1 - y) * (2 - 3 * y), 0)
    return np.column_stack([x, y, z]), T


def welded(V, T):
    """Points that coincide become one; points that no triangle uses go."""
    V, ids = np.unique(V[T.ravel()], axis=0, return_inverse=True)
    return V, ids.reshape(-1, 3)


def box(n, bulge=0, jitter=0.2, seed=1):
    """The unit cube, n points along each edge, points jittered within their faces and edges.

    bulge: height of the middle of each face over its edges.
    Returns the mesh and a mask of the points on the edges of the cube.
    """
    random = np.random.default_rng(seed)
    ids = np.arange(n**3).reshape(n, n, n)
    sides = [np.take(ids, side, axis) for axis in range(3) for side in (0, n - 1)]
    # Transposed where rows x columns would point inward.
    sides = [side if k in (1, 2, 5) else side.T for k, side in enumerate(sides)]
    T = np.vstack([grid_triangles(side, random) for side in sides])
    V = np.indices((n, n, n)).reshape(3, -1).T.astype(float)
    may_move = (V > 0) & (V < n - 1)
    V = (V + may_move * random.uniform(-jitter, jitter, V.shape)) / (n - 1)
    V, T = welded(V, T)
    is_on_side = np.abs(2 * V - 1) == 1
    for axis in range(3):
        u, v = (2 * V[:, other] - 1 for other in range(3) if other != axis)
        outward = np.sign(V[:, axis] - 0.5) * is_on_side[:, axis]
        V[:, axis] += bulge * outward * (1 - u**2) * (1 - v**2)
    return (V, T), is_on_side.sum(axis=1) > 1


def double_pyramid(n):
    """|x| + |y| + |z| = 1, each of its eight faces cut into n x n triangles.

    Returns the mesh and a mask of the points on its edges.
    """
    k = np.arange(n + 1)
    ids = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    x, y = (axis.ravel() for axis in np.meshgrid(k, k, indexing="ij"))
    octant = np.column_stack([x, y, n - x - y]) / n
    upward = [(ids[i, j], ids[i + 1, j], ids[i, j + 1]) for i in k[:-1] for j in range(n - i)]
    downward = [
        (ids[i + 1, j], ids[i + 1, j + 1], ids[i, j + 1]) for i in k[:-1] for j in range(n - i - 1)
    ]
    T = np.array(upward + downward)
    points, triangles = [], []
    for signs in np.array(list(np.ndindex(2, 2, 2))) * 2 - 1:
        triangles.append((T if signs.prod() > 0 else T[:, ::-1]) + len(points) * len(octant))
        points.append(octant * signs)
    V, T = welded(np.vstack(points), np.vstack(triangles))
    return (V, T), (V == 0).any(axis=1)


def beside(mesh, other):
    """Both meshes as one, the other one shifted along x by 10."""
    (V, T), (W, U) = mesh, other
    return np.vstack([V, W + [10, 0, 0]]), np.vstack([T, U + len(V)])


def with_isolated_point(mesh):
    """The mesh and, in the middle of the numbering, a point far away that no triangle uses."""
    V, T = mesh
    place = len(V) // 2
    return np.insert(V, place, 50 + V[0], axis=0), T + (T >= place)
