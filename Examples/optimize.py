"""Makes the triangles of a mesh well shaped, or removes noise from it, and shows what changed.

usage: optimize.sh [MESH] [options]

MESH is a triangle mesh in .ply, .obj, .stl, .vtp or .vtk; without one the isosurface of ParaView's
Wavelet source is taken.

  --preset NAME            a recommended combination of the options below:
                             within-error  the best triangles within an error (default)
                             smooth-model  better triangles in one solve on smooth shapes
                             cad-model     the same on CAD shapes, sharp edges stay
                             denoise       remove slight noise from smooth shapes
                             denoise-cad   remove slight noise, sharp edges stay
                             remove-noise  remove strong noise, the volume stays
                             remove-noise-cad  remove strong noise from flat faces
                             paper-cad-model, paper-denoise-cad  the paper's settings for CAD
  --max-deviation NUMBER   the error of within-error: the largest distance between the surfaces
                           before and after as a fraction of the bounding box's diagonal, which is
                           guaranteed (default: 0.002)
  --mode NAME              within-deviation, triangles, smooth; triangles if an option below that
                           within-deviation does not have is given
  --laplacian NAME         uniform, cotangent, mean-curvature (for smooth)
  --position-weights NAME  constant, linear, cdf: how points are held where they were
  --laplacian-weights NAME constant, linear-complement, cdf-complement, gaussian: where to hold back
  --scale NUMBER           factor on the position weights; smaller means more effect
  --boundary NAME          fixed, sliding, free
  --modulate               let the points of bad triangles move more
  --tangent-planes         also hold the points in their tangent planes
  --output FILE            optimised mesh, .vtp .ply .stl or .vtk (default: MESH-optimized.vtp)
  --image FILE             picture (default: MESH-optimized.png)
"""
import argparse
import os
import time

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

LoadPlugin('LaplacianMeshOptimization', remote=False, ns=globals())

BINS = 50  # of the histograms

PRESETS = {
    'within-error': BestTriangleswithinanErrornoRemesh,
    'smooth-model': ImproveTriangleQualitynoRemesh,
    'cad-model': ImproveTriangleQualitynoRemeshCAD,
    'denoise': SmoothandFair,
    'denoise-cad': SmoothandFairCAD,
    'remove-noise': DenoiseSurface,
    'remove-noise-cad': RemoveNoiseCAD,
    'paper-cad-model': ImproveTriangleQualityPaperCAD,
    'paper-denoise-cad': SmoothandFairPaperCAD,
}

# Options of the modes that solve once.
SINGLE_SOLVE = ['LaplacianType', 'PositionWeighting', 'LaplacianWeighting', 'ScaleFactor',
                'ModulateByTriangleQuality', 'TangentPlaneConstraints']


def choice(**values):
    """An option's names with the property texts they stand for."""
    return {name.replace('_', '-'): text for name, text in values.items()}


CHOICES = {
    'Mode': ('--mode', choice(
        within_deviation='Optimize Within Deviation', triangles='Optimize Triangles',
        smooth='Smooth')),
    'LaplacianType': ('--laplacian', choice(
        uniform='Uniform', cotangent='Cotangent', mean_curvature='Mean Curvature')),
    'PositionWeighting': ('--position-weights', choice(
        constant='Constant', linear='Linear', cdf='CDF')),
    'LaplacianWeighting': ('--laplacian-weights', choice(
        constant='Constant', linear_complement='Linear Complement',
        cdf_complement='CDF Complement', gaussian='Gaussian')),
    'BoundaryCondition': ('--boundary', choice(fixed='Fixed', sliding='Sliding', free='Free')),
}


def parse_arguments():
    parser = argparse.ArgumentParser(prog='optimize.sh', usage=__doc__.split('usage: ')[1])
    parser.add_argument('mesh', nargs='?')
    parser.add_argument('--preset', choices=PRESETS)
    parser.add_argument('--max-deviation', dest='MaximumDeviation', type=float)
    for name, (flag, values) in CHOICES.items():
        parser.add_argument(flag, dest=name, choices=values)
    parser.add_argument('--scale', dest='ScaleFactor', type=float)
    parser.add_argument('--modulate', dest='ModulateByTriangleQuality', action='store_true')
    parser.add_argument('--tangent-planes', dest='TangentPlaneConstraints', action='store_true')
    parser.add_argument('--output')
    parser.add_argument('--image')
    arguments = parser.parse_args()
    solves_once = any(getattr(arguments, name) not in (None, False) for name in SINGLE_SOLVE)
    if arguments.preset is None:
        is_single = solves_once and arguments.MaximumDeviation is None
        arguments.preset = 'smooth-model' if is_single else 'within-error'
    stays_within = arguments.Mode == 'within-deviation' or (
        arguments.Mode is None and arguments.preset == 'within-error')
    if arguments.MaximumDeviation is not None and not stays_within:
        parser.error('--max-deviation needs the preset within-error or the mode within-deviation')
    if stays_within and solves_once:
        parser.error('the mode within-deviation has weights of its own: leave them out')
    return arguments


def chosen_properties(arguments):
    """The properties that differ from the preset."""
    properties = {}
    for name, (_, values) in CHOICES.items():
        if getattr(arguments, name):
            properties[name] = values[getattr(arguments, name)]
    for name in ('MaximumDeviation', 'ScaleFactor', 'ModulateByTriangleQuality',
                 'TangentPlaneConstraints'):
        value = getattr(arguments, name)
        if value is not None and value is not False:
            properties[name] = value
    return properties


def open_mesh(path):
    if path is None:
        return Contour(Input=Wavelet(), ContourBy=['POINTS', 'RTData'], Isosurfaces=[157.09])
    if not os.path.exists(path):
        raise SystemExit('optimize: there is no file ' + path)
    return Triangulate(Input=OpenDataFile(path))


def report(optimizer, surface, seconds):
    mesh = servermanager.Fetch(optimizer)
    if not mesh.GetFieldData().HasArray('MeanRadiusRatio'):
        raise SystemExit('optimize: the filter failed; its message is above')
    deviation = SurfaceDeviation(Input=optimizer, Reference=surface)
    distance = servermanager.Fetch(deviation).GetFieldData().GetArray('RelativeHausdorffDistance')

    def metric(name):
        return mesh.GetFieldData().GetArray(name).GetValue(0)

    def share_of_bad(name):
        ratios = vtk_to_numpy(mesh.GetCellData().GetArray(name))
        return (ratios[ratios >= 0] < 0.3).mean()

    print('%d points, %d triangles' % (mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()))
    print('                           before     after')
    print('mean radius ratio        %8.4f  %8.4f'
          % (metric('InputMeanRadiusRatio'), metric('MeanRadiusRatio')))
    print('minimum radius ratio     %8.4f  %8.4f'
          % (metric('InputMinimumRadiusRatio'), metric('MinimumRadiusRatio')))
    print('triangles under 0.3      %7.2f%%  %7.2f%%'
          % (100 * share_of_bad('InputRadiusRatio'), 100 * share_of_bad('RadiusRatio')))
    print('maximum displacement     %8.5f of the diagonal' % metric('RelativeMaximumDisplacement'))
    print('Hausdorff distance       %8.5f of the diagonal' % distance.GetValue(0))
    if optimizer.Mode == 'Optimize Within Deviation':
        print('  guaranteed at most     %8.5f' % metric('RelativeHausdorffBound'))
    print('volume change            %+7.3f%% (0 if the surface is open)'
          % (100 * metric('RelativeVolumeChange')))
    print('flipped triangles        %8d' % metric('FlippedTriangles'))
    print('iterations               %8d' % metric('Iterations'))
    print('time                     %8.3f s' % seconds)


def show_surface(view, source, title):
    display = Show(source, view)
    few = source.GetDataInformation().GetNumberOfCells() < 20000
    display.Representation = 'Surface With Edges' if few else 'Surface'
    display.EdgeColor = [0.25, 0.25, 0.25]
    display.Ambient = 0.3
    ColorBy(display, ('CELLS', 'RadiusRatio'))
    colors = GetColorTransferFunction('RadiusRatio')
    colors.ColorSpace = 'RGB'
    colors.RGBPoints = [0, 0.7, 0.05, 0.1, 0.5, 1, 0.95, 0.7, 1, 0.2, 0.4, 0.7]
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = 'radius ratio', ''
    version = GetParaViewVersion()
    is_printf = (version.major, version.minor) < (6, 1)
    bar.RangeLabelFormat = '%.0f' if is_printf else '{:.0f}'
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.WindowLocation = 'Lower Center'
    bar.Orientation = 'Horizontal'
    label = Show(Text(Text=title), view)
    label.Color, label.FontSize = [0, 0, 0], 24
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.GetActiveCamera().Azimuth(30)
    view.GetActiveCamera().Elevation(20)
    ResetCamera(view)
    view.GetActiveCamera().Zoom(1.3)


def show_histogram(view, source, tallest):
    histogram = Histogram(Input=source, SelectInputArray=['CELLS', 'RadiusRatio'], BinCount=BINS,
                          UseCustomBinRanges=1, CustomBinRanges=[0, 1])
    Show(histogram, view).SeriesColor = ['bin_values', '0.2', '0.4', '0.7']
    view.BottomAxisTitle, view.LeftAxisTitle = 'radius ratio', 'triangles'
    view.LeftAxisUseCustomRange, view.LeftAxisRangeMaximum = 1, tallest
    view.ShowLegend = 0


def tallest_bin(source):
    ratios = vtk_to_numpy(servermanager.Fetch(source).GetCellData().GetArray('RadiusRatio'))
    return numpy.histogram(ratios, BINS, (0, 1))[0].max()


def picture(surface, optimizer, path):
    """Before on the left, after on the right, the histograms of the radius ratio below."""
    before = TriangleRadiusRatio(Input=surface)
    tallest = max(tallest_bin(before), tallest_bin(optimizer))
    layout = CreateLayout('Before and after')
    layout.SplitHorizontal(0, 0.5)
    layout.SplitVertical(1, 0.7)
    layout.SplitVertical(2, 0.7)
    for top, bottom, source, title in ((3, 4, before, 'before'), (5, 6, optimizer, 'after')):
        view, chart = CreateView('RenderView'), CreateView('XYBarChartView')
        layout.AssignView(top, view)
        layout.AssignView(bottom, chart)
        show_surface(view, source, title)
        show_histogram(chart, source, tallest)
    layout.SetSize(1600, 1200)
    SaveScreenshot(path, layout, ImageResolution=[1600, 1200])


def main():
    arguments = parse_arguments()
    mesh = open_mesh(arguments.mesh)
    mesh.UpdatePipeline()

    optimizer = PRESETS[arguments.preset](Input=mesh, **chosen_properties(arguments))
    start = time.perf_counter()
    optimizer.UpdatePipeline()
    report(optimizer, mesh, time.perf_counter() - start)

    stem = os.path.splitext(os.path.basename(arguments.mesh or 'wavelet'))[0] + '-optimized'
    output = arguments.output or stem + '.vtp'
    SaveData(output, optimizer, **({'DataMode': 'Binary'} if output.endswith('.vtp') else {}))
    image = arguments.image or stem + '.png'
    picture(mesh, optimizer, image)
    print('written: %s, %s' % (output, image))


main()
