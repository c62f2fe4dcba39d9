# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the examples."""
import os
import subprocess
import sys
import tempfile

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

FOLDER = os.path.join(panels.HERE, "..", "..", "Examples")


def run(command, name, colors, width):
    picture = os.path.join(panels.IMAGES, name + ".png")
    subprocess.run([*command, picture], check=True)
    panels.shrink(picture, colors, width)


for name in EXAMPLES:
    script = os.path.join(FOLDER, "Python", name + ".py")
    run([sys.executable, script, "--picture"], name, colors=64, width=800)
with tempfile.TemporaryDirectory() as folder:
    script = os.path.join(FOLDER, "optimize.py")
    output = os.path.join(folder, "wavelet.vtp")
    run(["pvpython", script, "--output", output, "--image"], "wavelet", colors=128, width=1200)
