# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle quality over the error that it costs: this module and other filters.

    budget.py --relax PROGRAM    also CGAL's tangential_relaxation(), built from relax.cxx
    budget.py --meshes FOLDER    instead a table of OPTIMIZE_WITHIN_DEVIATION on meshes of your own
"""
import argparse
import glob
import os
import subprocess
import tempfile

import panels
import shapes
from matplotlib import pyplot as plt
from panels import Optimizer, common, optimized
from vtkmodules.vtkFiltersCore import (
    vtkConstrainedSmoothingFilter,
    vtkSmoothPolyDataFilter,
    vtkWindowedSincPolyDataFilter,
)
from vtkmodules.vtkIOGeometry import vtkOBJWriter

SINGLE_SOLVE = {
    "animal": {"PositionWeighting": Optimizer.CDF},
    "machine part": {
        "PositionWeighting": Optimizer.LINEAR,
        "LaplacianWeighting": Optimizer.LINEAR_COMPLEMENT,
    },
}
NO_FEATURES = 180
ANGLES = {"animal": NO_FEATURES, "machine part": 40}


def within_deviation(mesh, name):
    for bound in (0.0002, 0.0005, 0.001, 0.002, 0.005):
        yield optimized(mesh, Mode=Optimizer.OPTIMIZE_WITHIN_DEVIATION, MaximumDeviation=bound)


def single_solve(mesh, name):
    for factor in (4, 2, 1, 0.5, 0.25, 0.1):
        yield optimized(mesh, ScaleFactor=factor, **SINGLE_SOLVE[name])


def windowed_sinc(mesh, name):
    for band in (0.5, 0.3, 0.2, 0.1, 0.05):
        properties = {"PassBand": band, "NormalizeCoordinates": True, "NumberOfIterations": 20}
        yield panels.updated(vtkWindowedSincPolyDataFilter(), mesh, **properties).GetOutput()


def smooth_with_source(mesh, name):
    for iterations in (2, 5, 20, 100):
        smooth = vtkSmoothPolyDataFilter()
        smooth.SetSourceData(mesh)
        yield panels.updated(smooth, mesh, NumberOfIterations=iterations).GetOutput()


def constrained_smoothing(mesh, name):
    for bound in (0.0005, 0.001, 0.002, 0.005):
        smooth = vtkConstrainedSmoothingFilter()
        smooth.SetConstraintStrategyToConstraintDistance()
        properties = {"ConstraintDistance": bound * mesh.GetLength(), "NumberOfIterations": 50}
        yield panels.updated(smooth, mesh, RelaxationFactor=0.1, **properties).GetOutput()


def tangential_relaxation(program):
    def relaxed(mesh, name):
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, file) for file in ("in.obj", "out.obj")]
            writer = vtkOBJWriter()
            writer.SetFileName(files[0])
            writer.SetInputData(mesh)
            writer.Write()
            for iterations in (1, 3, 10, 30):
                arguments = [program, *files, str(iterations), str(ANGLES[name])]
                subprocess.run(arguments, check=True)
                yield common.read_mesh(files[1])

    return relaxed


def draw(methods):
    meshes = {"animal": shapes.animal(), "machine part": shapes.machine_part()}
    figure, axes = plt.subplots(2, 2, figsize=(11, 7), layout="constrained", sharex="col")
    for (name, mesh), column in zip(meshes.items(), axes.T):
        before = panels.radius_ratios(mesh)
        for method, outputs in methods.items():
            lines = []
            for output in outputs(mesh, name):
                after = panels.radius_ratios(output)
                lines.append((panels.hausdorff(output, mesh), after.mean(), after.min()))
                print("%-13s %-32s %.5f %.3f %.3f" % (name, method, *lines[-1]), flush=True)
            width = 2.5 if outputs is within_deviation else 1.2
            for axis, values in zip(column, (1, 2)):
                distances = [line[0] for line in lines]
                axis.plot(distances, [line[values] for line in lines], ".-", lw=width, label=method)
        for axis, value, label in zip(
            column, (before.mean(), before.min()), ("mean radius ratio", "smallest radius ratio")
        ):
            axis.axhline(value, color="gray", lw=0.8, ls="--", label="input")
            axis.set(xscale="log", xlim=(1.5e-4, 3e-2), ylabel=label)
            axis.grid(alpha=0.3)
        column[0].set_title("%s, %d triangles" % (name, mesh.GetNumberOfPolys()))
        column[1].set_xlabel("Hausdorff distance / diagonal, measured")
    axes[0, 0].legend(loc="lower right", fontsize=8)
    panels.save(figure, "budget")


def print_table(folder):
    print("| mesh | input | 0.0005 | 0.001 | 0.002 |\n|---|---|---|---|---|")
    for path in sorted(glob.glob(os.path.join(folder, "*"))):
        if os.path.splitext(path)[1] not in common.READERS:
            continue
        mesh = common.read_mesh(path)
        before = panels.radius_ratios(mesh)
        before = before[before >= 0]
        cells = ["%.3f / %.3f" % (before.mean(), before.min())]
        for bound in (0.0005, 0.001, 0.002):
            properties = {"Mode": Optimizer.OPTIMIZE_WITHIN_DEVIATION, "MaximumDeviation": bound}
            result = panels.updated(Optimizer(), mesh, **properties)
            figures = result.GetMeanRadiusRatio(), result.GetMinimumRadiusRatio()
            cells.append("%.3f / %.3f" % figures)
        name = os.path.splitext(os.path.basename(path))[0]
        print("| %s | %s |" % (name, " | ".join(cells)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--relax")
    parser.add_argument("--meshes")
    arguments = parser.parse_args()
    if arguments.meshes:
        print_table(arguments.meshes)
        return
    methods = {
        "OPTIMIZE_WITHIN_DEVIATION": within_deviation,
        "OPTIMIZE_TRIANGLES (the paper)": single_solve,
        "vtkWindowedSincPolyDataFilter": windowed_sinc,
        "vtkSmoothPolyDataFilter, Source": smooth_with_source,
        "vtkConstrainedSmoothingFilter": constrained_smoothing,
    }
    if arguments.relax:
        methods["CGAL tangential_relaxation"] = tangential_relaxation(arguments.relax)
    draw(methods)


if __name__ == "__main__":
    main()
