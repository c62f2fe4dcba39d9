#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
# setup-env.sh, sourced in an environment that holds nothing else, makes the Python package and the
# plugin known.
# usage: TestEnvironmentScript.sh <setup-env.sh> <pvpython> <runtime directory>
set -e
if [ -z "$LMO_CLEAN_ENVIRONMENT" ]; then
  exec env -i LMO_CLEAN_ENVIRONMENT=1 PATH=/usr/bin:/bin HOME="$3" XDG_RUNTIME_DIR="$3" \
    bash "$0" "$@"
fi
cd /
. "$1"

# The package
"$2" -c "from laplacianmesh import vtkLaplacianMeshOptimizer; vtkLaplacianMeshOptimizer()"

# The plugin by its name
"$2" -c "
from paraview.simple import *
LoadPlugin('LaplacianMeshOptimization', remote=False, ns=globals())
optimizer = LaplacianMeshOptimizer(Input=Sphere())
optimizer.UpdatePipeline()
assert optimizer.PointData['Displacement']
"

# The plugin in ParaView's list of plugins
"$2" -c "
from paraview.simple import *
LoadDistributedPlugin('LaplacianMeshOptimization', remote=False, ns=globals())
"
