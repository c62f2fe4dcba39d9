// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// CGAL's tangential_relaxation() for the comparison in the guide; not part of the product.
//   relax IN.obj OUT.obj ITERATIONS FEATURE_ANGLE    the angle in degrees; 180: no features
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  if (argc != 5 || !CGAL::IO::read_OBJ(argv[1], mesh))
  {
    return EXIT_FAILURE;
  }
  auto isFeature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  if (std::atof(argv[4]) < 180)
  {
    PMP::detect_sharp_edges(mesh, std::atof(argv[4]), isFeature);
  }
  PMP::tangential_relaxation(mesh, CGAL::parameters::number_of_iterations(std::atoi(argv[3]))
                                     .edge_is_constrained_map(isFeature)
                                     .relax_constraints(true));
  return CGAL::IO::write_OBJ(argv[2], mesh, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                    : EXIT_FAILURE;
}
