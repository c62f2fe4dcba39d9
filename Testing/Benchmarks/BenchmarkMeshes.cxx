// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include "vtkContourFilter.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <random>
#include <set>

namespace
{
using Mesh = vtkSmartPointer<vtkPolyData>;

/// The points and polygons alone: arrays would be passed on and normals computed anew.
Mesh Bare(vtkPolyData* mesh)
{
  auto bare = Mesh::New();
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  return bare;
}

Mesh Subdivided(vtkPolyData* mesh, int times)
{
  vtkNew<vtkLinearSubdivisionFilter> subdivision;
  subdivision->SetInputData(mesh);
  subdivision->SetNumberOfSubdivisions(times);
  subdivision->Update();
  return Bare(subdivision->GetOutput());
}

Mesh NoisySphere(int subdivisions)
{
  vtkNew<vtkPlatonicSolidSource> icosahedron;
  icosahedron->SetSolidTypeToIcosahedron();
  icosahedron->Update();
  Mesh sphere = Subdivided(icosahedron->GetOutput(), subdivisions);

  std::mt19937 generator(1);
  std::normal_distribution<double> radius(1, 0.001);
  const vtkIdType count = sphere->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_FLOAT);
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    sphere->GetPoint(i, point);
    vtkMath::Normalize(point);
    vtkMath::MultiplyScalar(point, radius(generator));
    points->SetPoint(i, point);
  }
  sphere->SetPoints(points);
  return sphere;
}

/// The same shape for every number of samples, apart from the resolution.
Mesh Isosurface(int samples)
{
  const double scale = 10. / samples;
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-samples, samples, -samples, samples, -samples, samples);
  wavelet->SetCenter(0, 0, 0);
  wavelet->SetXFreq(60 * scale);
  wavelet->SetYFreq(30 * scale);
  wavelet->SetZFreq(40 * scale);
  wavelet->SetStandardDeviation(0.5);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(wavelet->GetOutputPort());
  contour->SetValue(0, 157);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return Bare(contour->GetOutput());
}

template <typename Reader>
Mesh Read(const std::filesystem::path& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.string().c_str());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* mesh = triangles->GetOutput();
  return mesh->GetNumberOfPolys() > 0 ? Bare(mesh) : nullptr;
}

using ReadFunction = Mesh (*)(const std::filesystem::path&);

/// Null if the file is no mesh.
ReadFunction FindReader(const std::filesystem::path& file)
{
  static const std::map<std::string, ReadFunction> readers = {
    { ".ply", Read<vtkPLYReader> },
    { ".obj", Read<vtkOBJReader> },
    { ".stl", Read<vtkSTLReader> },
    { ".vtp", Read<vtkXMLPolyDataReader> },
  };
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto reader = readers.find(extension);
  return reader == readers.end() ? nullptr : reader->second;
}

/// Null if the subdivided mesh would be too large or the filter cannot subdivide the mesh.
Mesh SubdividedIfSmall(vtkPolyData* mesh, int times)
{
  vtkIdType vertices = mesh->GetNumberOfPoints();
  vtkIdType triangles = mesh->GetNumberOfPolys();
  for (int k = 0; k < times; ++k)
  {
    vertices += triangles * 3 / 2; // a new vertex on every edge
    triangles *= 4;
  }
  if (vertices >= 1000000)
  {
    return nullptr;
  }
  Mesh subdivided = Subdivided(mesh, times);
  return subdivided->GetNumberOfPolys() == triangles ? subdivided : nullptr;
}
}

std::vector<MeshSource> GeneratedMeshes()
{
  std::vector<MeshSource> meshes;
  const std::pair<const char*, int> spheres[] = { { "10k", 5 }, { "41k", 6 }, { "164k", 7 },
    { "655k", 8 }, { "2.6M", 9 } };
  for (const auto& [size, subdivisions] : spheres)
  {
    meshes.push_back({ std::string("icosphere-") + size,
      [subdivisions = subdivisions] { return NoisySphere(subdivisions); } });
  }
  const std::pair<const char*, int> isosurfaces[] = { { "10k", 22 }, { "85k", 70 }, { "711k", 200 },
    { "2.2M", 352 }, { "5M", 530 } };
  for (const auto& [size, samples] : isosurfaces)
  {
    meshes.push_back(
      { std::string("isosurface-") + size, [samples = samples] { return Isosurface(samples); } });
  }
  return meshes;
}

std::vector<MeshSource> MeshesInFolder(const std::string& folder)
{
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (FindReader(entry.path()))
    {
      files.insert(entry.path());
    }
  }
  std::vector<MeshSource> meshes;
  for (const std::filesystem::path& file : files)
  {
    const auto read = [file, reader = FindReader(file)] { return reader(file); };
    const std::string name = file.stem().string();
    meshes.push_back({ name, read });
    for (const int times : { 1, 2 })
    {
      const auto subdivide = [read, times]
      {
        const Mesh mesh = read();
        return mesh ? SubdividedIfSmall(mesh, times) : nullptr;
      };
      meshes.push_back({ name + (times == 1 ? "-x4" : "-x16"), subdivide });
    }
  }
  return meshes;
}
