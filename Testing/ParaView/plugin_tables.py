# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin is expected to offer: its filters, their properties, the menu."""

ENUMERATIONS = {
    "Mode": [
        "Optimize Triangles",
        "Smooth",
        "Prescribed Laplacians",
        "Optimize Within Deviation",
        "Smooth Guided",
    ],
    "LaplacianType": ["Uniform", "Cotangent", "Mean Curvature"],
    "PositionWeighting": ["Constant", "Linear", "CDF", "Anchors", "Array"],
    "LaplacianWeighting": ["Constant", "Linear Complement", "CDF Complement", "Gaussian", "Array"],
    "BoundaryCondition": ["Fixed", "Sliding", "Free", "Curve"],
    "SelectionUse": ["Selected Points Stay", "Only Selected Points Move"],
    "SolverType": ["Automatic", "Direct", "Iterative"],
}

NUMBERS = {
    "RobustLaplacian": 1,
    "ScaleFactor": 0.25,
    "GaussianWidth": 0.75,
    "ModulateByTriangleQuality": 1,
    "TangentPlaneConstraints": 1,
    "TangentPlaneWeight": 2.5,
    "Tolerance": 1e-9,
    "MaximumNumberOfIterations": 77,
    "MaximumDeviation": 0.001,
    "DeviationIsAbsolute": 1,
    "NumberOfPasses": 3,
    "ImproveWorstTriangles": 0,
    "DetailWeight": 0.5,
    "NormalIterations": 20,
    "NormalWidth": 0.5,
    "FeatureConstraints": 1,
    "DetectFeatures": 0,
    "FeatureAngle": 60,
    "PreserveVolume": 1,
    "Twicing": 1,
    "ComputeNormals": 0,
    "FeatureSmoothing": 1,
    "FreeAxes": [1, 1, 0],
    "InterpolatePointData": 0,
    "WeldCoincidentPoints": 0,
    "CheckSelfIntersections": 1,
    "DiagnosticArrays": 0,
    "StartFromPreviousTimeStep": 1,
}

ARRAYS = [
    "PositionWeightArray",
    "LaplacianWeightArray",
    "PrescribedLaplacianArray",
    "FixedPointArray",
    "FeatureArray",
]

RESULTS = [
    "InputMeanRadiusRatio",
    "MeanRadiusRatio",
    "InputMinimumRadiusRatio",
    "MinimumRadiusRatio",
    "MaximumDisplacement",
    "RelativeMaximumDisplacement",
    "RelativeVolumeChange",
    "FlippedTriangles",
    "Iterations",
    "RelativeResidual",
    "HausdorffBound",
    "RelativeHausdorffBound",
    "SelfIntersections",
    "InputSelfIntersections",
    "PinnedBadTriangles",
]

# What the panel asks the filter for, beside its results.
INFORMATION = ["AreMetricsUpToDate", "HasVolume", "DeviationLength"]

# Those of Optimize Within Deviation alone.
OF_DEVIATION = RESULTS[RESULTS.index("HausdorffBound"):]

# What the panel of Surface Deviation shows.
DISTANCES = [
    "HausdorffDistance",
    "RelativeHausdorffDistance",
    "MeanDistance",
    "RelativeMeanDistance",
]

PROPERTIES = {
    "LaplacianMeshOptimizer": [
        "Input",
        "Selection",
        "Reference",
        *ENUMERATIONS,
        *NUMBERS,
        *ARRAYS,
        *RESULTS,
        *INFORMATION,
        "ReadResults",
    ],
    "MeshLaplacian": [
        "Input",
        "RobustLaplacian",
        "PrincipalCurvatures",
        "WeldCoincidentPoints",
    ],
    "TriangleRadiusRatio": ["Input", "WeldCoincidentPoints"],
    "SurfaceDeviation": [
        "Input",
        "Reference",
        "NumberOfSamples",
        "AreMetricsUpToDate",
        *DISTANCES,
    ],
}


# XML name, function, settings other than the defaults.
PRESETS = [
    ("ImproveTriangles", "ImproveTriangleQuality", {}),
    (
        "ImproveTrianglesFast",
        "ImproveTriangleQualityfast",
        {"Mode": "Optimize Triangles", "FeatureConstraints": 1},
    ),
    (
        "DenoiseSurface",
        "DenoiseSurface",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.2,
            "FeatureConstraints": 1,
            "PreserveVolume": 1,
            "Twicing": 1,
        },
    ),
    (
        "DenoiseSurfaceFlatFaces",
        "DenoiseSurfaceflatfacessharpedges",
        {"Mode": "Smooth Guided"},
    ),
    (
        "ImproveTriangleQuality",
        "ImproveTriangleQualitynoRemesh",
        {"Mode": "Optimize Triangles"},
    ),
    (
        "ImproveTriangleQualityFeatures",
        "ImproveTriangleQualitynoRemeshCAD",
        {
            "Mode": "Optimize Triangles",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.1,
            "FeatureConstraints": 1,
        },
    ),
    (
        "ImproveTriangleQualityCAD",
        "ImproveTriangleQualityPaperCAD",
        {
            "Mode": "Optimize Triangles",
            "PositionWeighting": "Linear",
            "LaplacianWeighting": "Linear Complement",
        },
    ),
    (
        "SmoothAndFair",
        "SmoothandFair",
        {
            "Mode": "Smooth",
            "LaplacianType": "Cotangent",
            "ScaleFactor": 0.3,
            "LaplacianWeighting": "CDF Complement",
        },
    ),
    (
        "SmoothAndFairFeatures",
        "SmoothandFairCAD",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.3,
            "FeatureConstraints": 1,
            "PreserveVolume": 1,
        },
    ),
    (
        "SmoothAndFairCAD",
        "SmoothandFairPaperCAD",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Linear",
            "ScaleFactor": 0.1,
            "LaplacianWeighting": "Linear Complement",
        },
    ),
    (
        "BestTrianglesWithinError",
        "BestTriangleswithinanErrornoRemesh",
        {},
    ),
    (
        "RemoveNoise",
        "RemoveNoise",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.2,
            "PreserveVolume": 1,
            "Twicing": 1,
        },
    ),
    ("RemoveNoiseCAD", "RemoveNoiseCAD", {"Mode": "Smooth Guided"}),
]

SETTINGS = {function: settings for _, function, settings in PRESETS}

DOCUMENTED = [*PROPERTIES, *(name for name, _, _ in PRESETS)]

# Proxies and labels of the menu.
MENU = {
    "LaplacianMeshOptimizer": "Laplacian Mesh Optimizer",
    "ImproveTriangles": "Improve Triangle Quality",
    "ImproveTrianglesFast": "Improve Triangle Quality (fast)",
    "DenoiseSurface": "Denoise Surface",
    "DenoiseSurfaceFlatFaces": "Denoise Surface (flat faces, sharp edges)",
    "MeshLaplacianAndCurvature": "Mesh Laplacian and Curvature",
    "TriangleRadiusRatio": "Triangle Radius Ratio",
    "SurfaceDeviationHausdorff": "Surface Deviation (Hausdorff Distance)",
}

# What ParaView's search has to find, in labels or, from ParaView 5.13 on, in short helps too.
IMPROVE = ["ImproveTriangles", "ImproveTrianglesFast", "LaplacianMeshOptimizer"]
DENOISE = ["DenoiseSurface", "DenoiseSurfaceFlatFaces"]
SEARCH = {
    "smooth": [*DENOISE, "LaplacianMeshOptimizer"],
    "fair": ["DenoiseSurface", "LaplacianMeshOptimizer"],
    "denoise": DENOISE,
    "noise": DENOISE,
    "remesh": IMPROVE,
    "triangle quality": IMPROVE,
    "hausdorff": ["SurfaceDeviationHausdorff"],
    "distance": ["SurfaceDeviationHausdorff"],
    "deviation": ["SurfaceDeviationHausdorff"],
    "curvature": ["MeshLaplacianAndCurvature"],
    "laplacian": ["MeshLaplacianAndCurvature", "LaplacianMeshOptimizer"],
}
