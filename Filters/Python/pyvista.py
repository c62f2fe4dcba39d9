# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""One function per job on PyVista meshes.

Each takes a surface (pyvista.PolyData; of other meshes the outer surface is taken), leaves it as
it is, and returns a new pyvista.PolyData with its results as arrays and its quality measures in
field_data. The properties that a function does not name are keyword arguments with the names of the
filter's setters: improve_triangles(mesh, NumberOfPasses=3).

>>> from laplacianmesh.pyvista import improve_triangles
>>> better = improve_triangles(mesh, max_deviation=0.001)
>>> better.plot(scalars="RadiusRatio", show_edges=True)
"""
try:
    import pyvista
except ImportError as error:
    raise ImportError(
        "laplacianmesh.pyvista needs PyVista: install the package python3-pyvista (Debian, Ubuntu), "
        "or pyvista with pip, for the VTK that laplacianmesh was built with."
    ) from error

import laplacianmesh

__all__ = ["improve_triangles", "denoise", "mean_curvature", "deviation"]


def improve_triangles(mesh, max_deviation=0.002, **properties):
    """Moves the points so that the triangles become as regular as they can within an error.

    Parameters
    ----------
    mesh : pyvista.DataSet
        The surface.
    max_deviation : float, default: 0.002
        The largest Hausdorff distance of the new surface to the old one, as a fraction of the
        diagonal of the bounding box; more than 0. It is guaranteed, in both directions.
    **properties
        Other properties of vtkLaplacianMeshOptimizer.

    Returns
    -------
    pyvista.PolyData
        With RadiusRatio and InputRadiusRatio (0 to 1, 1 for an equilateral triangle) as cell and
        point data, Displacement as point data, and in field_data MeanRadiusRatio,
        MinimumRadiusRatio and RelativeHausdorffBound (a fraction of the diagonal) among others.
    """
    return _optimized(
        mesh, Mode="OPTIMIZE_WITHIN_DEVIATION", MaximumDeviation=max_deviation, **properties
    )


def denoise(mesh, scale_factor=0.2, flat_faces=False, **properties):
    """Removes noise from a surface, and preserves its volume if it is closed.

    Parameters
    ----------
    mesh : pyvista.DataSet
        The surface.
    scale_factor : float, default: 0.2
        How strongly the points are attracted to their input positions; more than 0, without unit.
        The smaller it is, the smoother the surface becomes. Has no effect with flat_faces.
    flat_faces : bool, default: False
        For surfaces of flat faces with sharp edges, as CAD parts have them: the triangles follow
        filtered normals instead, and edges stay sharp.
    **properties
        Other properties of vtkLaplacianMeshOptimizer, for example NormalWidth=0.25 with flat_faces.

    Returns
    -------
    pyvista.PolyData
        With the arrays that improve_triangles() describes, and RelativeVolumeChange in field_data.
    """
    if flat_faces:
        return _optimized(mesh, Mode="SMOOTH_GUIDED", **properties)
    settings = dict(
        Mode="SMOOTH", PositionWeighting="CONSTANT", ScaleFactor=scale_factor, Twicing=True,
        PreserveVolume=True,
    )
    return _optimized(mesh, **{**settings, **properties})


def mean_curvature(mesh, **properties):
    """Computes the curvatures and the Laplacians of a surface.

    Parameters
    ----------
    mesh : pyvista.DataSet
        The surface.
    **properties
        Properties of vtkMeshLaplacian, for example RobustLaplacian=True for very thin triangles, or
        PrincipalCurvatures=True for PrincipalCurvature1 and 2 and their directions.

    Returns
    -------
    pyvista.PolyData
        With the point arrays MeanCurvature (0 or more, 1 / length), SignedMeanCurvature (positive
        where the surface is convex), GaussianCurvature (1 / length^2), MeanCurvatureNormal and
        others.
    """
    result = _run(laplacianmesh.vtkMeshLaplacian(), [mesh], properties)
    result.set_active_scalars("MeanCurvature")
    return result


def deviation(mesh, reference, samples=100000):
    """Measures how far two surfaces are apart.

    Parameters
    ----------
    mesh, reference : pyvista.DataSet
        The surfaces.
    samples : int, default: 100000
        Number of points at which the distance is measured inside the triangles of each surface.

    Returns
    -------
    pyvista.PolyData
        mesh with the point array Distance (to the reference, a length), SignedDistance (negative
        inside) if the reference is closed, and in field_data
        HausdorffDistance and MeanDistance (lengths) and RelativeHausdorffDistance and
        RelativeMeanDistance (fractions of the reference's diagonal), of both directions.
    """
    result = _run(
        laplacianmesh.vtkSurfaceDeviation(), [mesh, reference], {"NumberOfSamples": samples}
    )
    result.set_active_scalars("Distance")
    return result


def _optimized(mesh, **properties):
    return _run(laplacianmesh.vtkLaplacianMeshOptimizer(), [mesh], properties)


def _run(filter, meshes, properties):
    """The filter's output; its errors become a RuntimeError."""
    for port, mesh in enumerate(meshes):
        if not isinstance(mesh, pyvista.PolyData):
            mesh = mesh.extract_surface().clean()  # of a grid's faces, each has points of its own
        filter.SetInputData(port, mesh)
    for name, value in properties.items():
        # Enumerations by their name or their value, as in C++.
        getattr(filter, "Set" + name)(getattr(filter, value) if isinstance(value, str) else value)
    errors = []

    def remember(caller, event, message):
        errors.append(message.strip())

    remember.CallDataType = "string0"
    filter.AddObserver("ErrorEvent", remember)
    filter.Update()
    if errors:
        raise RuntimeError(errors[0])
    return pyvista.wrap(filter.GetOutput())
