# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's equations with dense matrices and nothing but numpy, for small meshes.

What the filters must agree with. Written from the paper and the conventions it leaves open, one
function for each equation; properties have the names and the values of the filter's.
"""
import numpy as np


# --- Who is whose neighbour ----------------------------------------------------------------------
def triangles_at_edges(n, T):
    """n x n: the number of triangles at each edge, 0 where there is no edge."""
    counts = np.zeros((n, n), dtype=int)
    for corner in range(3):
        i, j = T[:, corner], T[:, (corner + 1) % 3]
        np.add.at(counts, (i, j), 1)
        np.add.at(counts, (j, i), 1)
    return counts


def is_used(n, T):
    return np.isin(np.arange(n), T)


def is_boundary(n, T):
    return (triangles_at_edges(n, T) == 1).any(axis=1)


def components(n, T):
    """n x n: True where two points are connected."""
    reach = (triangles_at_edges(n, T) > 0) | np.eye(n, dtype=bool)
    while True:
        further = reach @ reach
        if (further == reach).all():
            return reach
        reach = further


# --- Triangles -----------------------------------------------------------------------------------
def edges_from(V, T, corner):
    """The two edge vectors that leave a corner of each triangle."""
    origin = V[T[:, corner]]
    return V[T[:, (corner + 1) % 3]] - origin, V[T[:, (corner + 2) % 3]] - origin


def scaled_normals(V, T):
    """Length: twice the area."""
    return np.cross(*edges_from(V, T, 0))


def angles(V, T):
    """Angle at each corner of each triangle, by the law of cosines."""
    result = np.empty(T.shape)
    for corner in range(3):
        a, b = edges_from(V, T, corner)
        cosine = np.sum(a * b, axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
        result[:, corner] = np.arccos(np.clip(cosine, -1, 1))
    return result


def cotangents(V, T):
    """Cotangent of the angle at each corner (Fig. 4)."""
    double_area = np.linalg.norm(scaled_normals(V, T), axis=1)
    pairs = [edges_from(V, T, corner) for corner in range(3)]
    return np.column_stack([np.sum(a * b, axis=1) / double_area for a, b in pairs])


def radius_ratios(V, T):
    """Eqn. 12 from edge lengths: 8 (p - a)(p - b)(p - c) / (a b c) with p = (a + b + c) / 2."""
    lengths = np.column_stack(
        [np.linalg.norm(V[T[:, (k + 1) % 3]] - V[T[:, k]], axis=1) for k in range(3)]
    )
    p = lengths.sum(axis=1, keepdims=True) / 2
    return 8 * np.prod(p - lengths, axis=1) / np.prod(lengths, axis=1)


def voronoi_areas(V, T):
    """A(v) of Eqn. 7, mixed (Meyer et al. 2003)."""
    areas = np.zeros(len(V))
    cot = cotangents(V, T)
    triangle_area = np.linalg.norm(scaled_normals(V, T), axis=1) / 2
    is_obtuse = cot.min(axis=1) < 0
    for corner in range(3):
        following, preceding = edges_from(V, T, corner)
        voronoi = (
            np.sum(following**2, axis=1) * cot[:, (corner + 2) % 3]
            + np.sum(preceding**2, axis=1) * cot[:, (corner + 1) % 3]
        ) / 8
        share = np.where(cot[:, corner] < 0, triangle_area / 2, triangle_area / 4)
        np.add.at(areas, T[:, corner], np.where(is_obtuse, share, voronoi))
    return areas


# --- Laplacians: Eqns. 1 to 7 --------------------------------------------------------------------
def uniform_weights(V, T):
    """Eqn. 3."""
    return (triangles_at_edges(len(V), T) > 0).astype(float)


def cotangent_weights(V, T):
    """Eqn. 4; a boundary edge has one cotangent."""
    weights = np.zeros((len(V), len(V)))
    for corner, cot in enumerate(cotangents(V, T).T):
        i, j = T[:, (corner + 1) % 3], T[:, (corner + 2) % 3]
        np.add.at(weights, (i, j), cot)
        np.add.at(weights, (j, i), cot)
    return weights


def normalised(weights):
    """Eqns. 2 and 5: L_u or L_c. Isolated points have empty rows."""
    sums = weights.sum(axis=1)
    rows = weights - np.diag(sums)
    return rows / np.where(sums == 0, 1, sums)[:, np.newaxis]


def mean_curvature_laplacian(V, T):
    """Eqn. 7: L_ck."""
    weights, areas = cotangent_weights(V, T), voronoi_areas(V, T)
    rows = weights - np.diag(weights.sum(axis=1))
    return rows / np.where(areas > 0, 4 * areas, 1)[:, np.newaxis]


def squared_length_scale(V, T):
    """Median of 4 A / sum of cotangents, which frees L_ck of the unit of length."""
    sums, areas = cotangent_weights(V, T).sum(axis=1), voronoi_areas(V, T)
    counts = (sums > 0) & (areas > 0)
    return np.median(4 * areas[counts] / sums[counts])


# --- Curvatures ----------------------------------------------------------------------------------
def fill_boundary(values, T):
    """Boundary points take the mean over their inner neighbours, 0 if they have none."""
    boundary = is_boundary(len(values), T)
    filled = values.copy()
    inner_neighbours = (triangles_at_edges(len(values), T) > 0) & ~boundary
    for i in np.flatnonzero(boundary):
        neighbours = values[inner_neighbours[i]]
        filled[i] = neighbours.mean(axis=0) if len(neighbours) else 0
    return filled


def mean_curvature_normals(V, T):
    return fill_boundary(mean_curvature_laplacian(V, T) @ V, T)


def mean_curvatures(V, T):
    kappa = np.linalg.norm(mean_curvature_laplacian(V, T) @ V, axis=1)
    used = V[is_used(len(V), T)]
    diagonal = np.linalg.norm(used.max(axis=0) - used.min(axis=0))
    return fill_boundary(np.where(kappa < 1e-6 / diagonal, 0, kappa), T)


def gaussian_curvatures(V, T):
    defects = np.full(len(V), 2 * np.pi)
    np.add.at(defects, T, -angles(V, T))
    areas = voronoi_areas(V, T)
    return fill_boundary(np.where(areas > 0, defects / np.where(areas > 0, areas, 1), 0), T)


def tangent_plane_normals(V, T):
    """n of Eqn. 14; the area-weighted normal where Eqn. 7 gives none."""
    normals = np.zeros_like(V)
    for corner in range(3):
        np.add.at(normals, T[:, corner], scaled_normals(V, T))
    is_defined = (mean_curvatures(V, T) > 0) & ~is_boundary(len(V), T)
    normals[is_defined] = (mean_curvature_laplacian(V, T) @ V)[is_defined]
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return normals / np.where(lengths > 0, lengths, 1)


# --- Weights: sections 5 and 6 -------------------------------------------------------------------
def box_plot_threshold(kappa):
    first, third = np.quantile(kappa, [0.25, 0.75])
    return third + 1.5 * (third - first)


def linear_weights(kappa, used):
    low, high = kappa[used].min(), min(kappa[used].max(), box_plot_threshold(kappa[used]))
    if kappa[used].max() == low:
        return np.ones_like(kappa)
    return np.clip((kappa - low) / (high - low), 0, 1) if high > low else (kappa > low) * 1.0


def sharp_vertices(V, T):
    """Points where the angle-weighted mean of the unit normals is shorter than cos 30 degrees."""
    normals = scaled_normals(V, T)
    units = normals / np.linalg.norm(normals, axis=1)[:, np.newaxis]
    sums, weights = np.zeros_like(V), np.zeros(len(V))
    for corner in range(3):
        at_corner = angles(V, T)[:, corner]
        np.add.at(sums, T[:, corner], at_corner[:, np.newaxis] * units)
        np.add.at(weights, T[:, corner], at_corner)
    return np.linalg.norm(sums, axis=1) < np.cos(np.pi / 6) * weights


def cumulative_weights(kappa, used):
    """Eqn. 13."""
    return (kappa[used] <= kappa[:, np.newaxis]).mean(axis=1)


def gaussian_weights(kappa, used, width):
    return np.exp(-0.5 * (kappa / (width * box_plot_threshold(kappa[used]))) ** 2)


def quality_weights(V, T):
    """W_t of section 5.2: the least radius ratio of the triangles at each point."""
    t = np.full(len(V), np.inf)
    np.minimum.at(t, T, radius_ratios(V, T)[:, np.newaxis])
    return np.where(np.isinf(t), 0, t)
