#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
# pip install . in a new virtual environment with the system's packages makes the package known, with
# nothing else set. The wheel is made of the build that is there.
# usage: TestPip.sh <source directory> <build directory> <python> <work directory>
set -e
if [ -z "$LMO_CLEAN_ENVIRONMENT" ]; then
  exec env -i LMO_CLEAN_ENVIRONMENT=1 PATH=/usr/bin:/bin HOME="$4" \
    LD_LIBRARY_PATH="$LMO_VTK_LIBRARIES" PYTHONPATH="$LMO_VTK_PYTHON" LMO_VTK_PYTHON="$LMO_VTK_PYTHON" \
    bash "$0" "$@"
fi
rm -rf "$4"
mkdir -p "$4"
"$3" -m venv --system-site-packages "$4/environment"
# A VTK that is not installed is found by PYTHONPATH, which pip hides from builds that it isolates.
"$4/environment/bin/python" -m pip install --quiet --no-index --config-settings "build-dir=$2" \
  ${LMO_VTK_PYTHON:+--no-build-isolation} "$1"
cd "$4"
environment/bin/python -c "
import laplacianmesh
from vtkmodules.vtkFiltersSources import vtkSphereSource
assert laplacianmesh.__file__.startswith('$4'), laplacianmesh.__file__
sphere = vtkSphereSource()
optimizer = laplacianmesh.vtkLaplacianMeshOptimizer()
optimizer.SetInputConnection(sphere.GetOutputPort())
optimizer.Update()
assert optimizer.GetMeanRadiusRatio() > optimizer.GetInputMeanRadiusRatio()
"
environment/bin/python -m pip uninstall --quiet --yes laplacianmesh
! environment/bin/python -c "import laplacianmesh" 2>/dev/null
