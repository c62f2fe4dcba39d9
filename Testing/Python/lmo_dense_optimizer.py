# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Eqn. 11 as the stacked rectangular system that the paper prints, by dense least squares."""
from dataclasses import dataclass
from typing import Optional

import numpy as np

import lmo_reference as reference


@dataclass
class DenseOptimizer:
    """The properties of vtkLaplacianMeshOptimizer, its enumerations as strings."""

    Mode: str = "OPTIMIZE_TRIANGLES"
    LaplacianType: str = "UNIFORM"
    PositionWeighting: str = "CDF"
    ScaleFactor: float = 1
    LaplacianWeighting: str = "CONSTANT"
    GaussianWidth: float = 0.5
    ModulateByTriangleQuality: bool = False
    TangentPlaneConstraints: bool = False
    TangentPlaneWeight: float = 1
    BoundaryCondition: str = "FIXED"
    position_weight_array: Optional[np.ndarray] = None
    laplacian_weight_array: Optional[np.ndarray] = None
    prescribed_laplacian_array: Optional[np.ndarray] = None
    fixed_point_array: Optional[np.ndarray] = None

    def optimize(self, V, T):
        """V' of Eqn. 11, with the rows of Eqn. 15 below where they are wanted."""
        L, f = self.laplacian(V, T), self.target(V, T)
        W_L, W_p = np.diag(self.laplacian_weights(V, T)), np.diag(self.position_weights(V, T))
        A = np.vstack([W_L @ L, W_p])
        b = np.vstack([W_L @ f, W_p @ V])
        if not self.TangentPlaneConstraints and self.BoundaryCondition != "SLIDING":
            return least_squares(A, b, V, ~self.is_fixed(V, T))

        A, b = np.kron(A, np.eye(3)), b.ravel()
        if self.TangentPlaneConstraints:
            normals = reference.tangent_plane_normals(V, T)
            N = self.TangentPlaneWeight * np.eye(len(V))[:, :, np.newaxis] * normals
            N = N.reshape(len(V), 3 * len(V))
            A, b = np.vstack([A, N]), np.append(b, N @ V.ravel())
        return least_squares(A, b, V.ravel(), self.may_change(V, T).ravel()).reshape(-1, 3)

    def laplacian(self, V, T):
        """L of section 4; boundary points have its rows only where they are free."""
        if self.Mode == "OPTIMIZE_TRIANGLES" or self.LaplacianType == "UNIFORM":
            L = reference.normalised(reference.uniform_weights(V, T))
        elif self.LaplacianType == "COTANGENT":
            L = reference.normalised(reference.cotangent_weights(V, T))
        else:
            L = reference.squared_length_scale(V, T) * reference.mean_curvature_laplacian(V, T)
        if self.BoundaryCondition != "FREE":
            L[reference.is_boundary(len(V), T)] = 0
        if self.BoundaryCondition == "SLIDING":
            L += line_laplacian(V, T)
        return L

    def target(self, V, T):
        """f of section 4; 0 along a straight boundary."""
        if self.Mode == "SMOOTH":
            f = np.zeros_like(V)
        elif self.Mode == "PRESCRIBED_LAPLACIANS":
            f = self.prescribed_laplacian_array.copy()
            if self.LaplacianType == "MEAN_CURVATURE":
                # Mean curvature normals, at the boundary those of vtkMeshLaplacian.
                change = f - reference.mean_curvature_normals(V, T)
                own = reference.mean_curvature_laplacian(V, T) @ V
                f = reference.squared_length_scale(V, T) * (own + change)
        else:
            f = reference.normalised(reference.cotangent_weights(V, T)) @ V
        if self.BoundaryCondition == "SLIDING":
            f[reference.is_boundary(len(V), T)] = 0
        return f

    def position_weights(self, V, T):
        """The diagonal of W_p."""
        kappa, used = reference.mean_curvatures(V, T), reference.is_used(len(V), T)
        if self.PositionWeighting == "ARRAY":
            weights = self.position_weight_array.copy()
        else:
            weights = self.ScaleFactor * {
                "CONSTANT": lambda: np.ones(len(V)),
                "LINEAR": lambda: self.linear_weights(V, T),
                "CDF": lambda: reference.cumulative_weights(kappa, used),
                "ANCHORS": lambda: (self.position_weight_array != 0).astype(float),
            }[self.PositionWeighting]()
        if self.ModulateByTriangleQuality:
            weights *= reference.quality_weights(V, T)
        is_held = reference.components(len(V), T) @ (self.is_fixed(V, T) | (weights > 0))
        return np.where(is_held, weights, self.ScaleFactor)

    def linear_weights(self, V, T):
        """1 at sharp vertices if both weightings are those for sharp features."""
        kappa, used = reference.mean_curvatures(V, T), reference.is_used(len(V), T)
        weights = reference.linear_weights(kappa, used)
        pair = (self.PositionWeighting, self.LaplacianWeighting)
        if pair == ("LINEAR", "LINEAR_COMPLEMENT"):
            weights[reference.sharp_vertices(V, T)] = 1
        return weights

    def laplacian_weights(self, V, T):
        """The diagonal of W_L."""
        kappa, used = reference.mean_curvatures(V, T), reference.is_used(len(V), T)
        return {
            "CONSTANT": lambda: np.ones(len(V)),
            "LINEAR_COMPLEMENT": lambda: 1 - self.linear_weights(V, T),
            "CDF_COMPLEMENT": lambda: 1 - reference.cumulative_weights(kappa, used),
            "GAUSSIAN": lambda: reference.gaussian_weights(kappa, used, self.GaussianWidth),
            "ARRAY": lambda: self.laplacian_weight_array,
        }[self.LaplacianWeighting]()

    def is_fixed(self, V, T):
        fixed = ~reference.is_used(len(V), T)
        if self.BoundaryCondition == "FIXED":
            fixed |= reference.is_boundary(len(V), T)
        if self.fixed_point_array is not None:
            fixed |= self.fixed_point_array != 0
        return fixed

    def may_change(self, V, T):
        """n x 3: the coordinates of the points that are unknowns."""
        unknown = np.ones(V.shape, dtype=bool)
        if self.BoundaryCondition == "SLIDING":
            unknown = ~reference.is_boundary(len(V), T)[:, np.newaxis] | (line_tangents(V, T) != 0)
        return unknown & ~self.is_fixed(V, T)[:, np.newaxis]


def least_squares(A, b, V, unknown):
    """V' that minimises |A V' - b| and differs from V only where its rows are unknown."""
    displacement, _, rank, _ = np.linalg.lstsq(A[:, unknown], b - A @ V, rcond=None)
    assert rank == np.count_nonzero(unknown), "the problem has no unique solution"
    result = V.copy()
    result[unknown] += displacement
    return result


# --- Borders that consist of straight lines along the axes ---------------------------------------
def line_tangents(V, T):
    """Unit direction of the boundary at each of its points, 0 at the ends of its straight lines."""
    tangents = np.zeros_like(V)
    for i, boundary in enumerate(reference.triangles_at_edges(len(V), T) == 1):
        if boundary.any():
            out, back = (edge / np.linalg.norm(edge) for edge in V[boundary] - V[i])
            tangents[i] = (out - back) / 2 if out @ back < -0.99 else 0
    return tangents


def line_laplacian(V, T):
    """L_u of the boundary's lines."""
    is_border = reference.triangles_at_edges(len(V), T) == 1
    is_line = line_tangents(V, T).any(axis=1)
    return np.diag(is_line) @ (is_border / 2 - np.eye(len(V)))
