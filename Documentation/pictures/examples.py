# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the examples."""
import os
import subprocess
import sys

import panels

EXAMPLES = (
    "triangles_within_error",
    "cad_triangles",
    "denoise",
    "denoise_cad",
    "least_squares_mesh",
    "detail_preserving",
    "exaggerate_detail",
    "curvature_plot",
)

for name in EXAMPLES:
    script = os.path.join(panels.HERE, "..", "..", "Examples", "Python", name + ".py")
    picture = os.path.join(panels.IMAGES, name + ".png")
    subprocess.run([sys.executable, script, "--picture", picture], check=True)
    panels.shrink(picture, colors=64, width=800)
