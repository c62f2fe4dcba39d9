# Dependencies point one way: in Core a file includes, of this project, only headers from lines
# above its own in this list. Of VTK, one header includes one header. The public headers show
# neither Core nor Eigen.
#
#   cmake -DFILTERS=<folder> -P CheckLayers.cmake
set(layers
  Types
  Exceptions
  Rounding
  Monitor
  ThreadTeam
  RunAside
  Parallel
  MeshTopology
  VertexOrder
  TriangleNeighbours
  TriangleGeometry
  TriangleTree
  ConvexityTest
  TriangleCover
  DistanceProofs
  DependentProofs
  Ranking
  Features
  FeatureDetection
  Subdomain
  Weights
  IntrinsicTriangulation
  Laplacian
  RobustLaplacian
  Quality
  ShapeLimits
  DeviationGuard
  NormalFilter
  Curvature
  MeshAnalysis
  SurfaceSampler
  SurfaceComparison
  LeastSquaresProblem
  VolumePreservation
  WorstTriangles
  PackedStiffness
  PackedEquations
  Preconditioner
  ShiftedStiffness
  SparseProduct
  PaddedRows
  SmoothedAggregation
  Ordering
  Elimination
  Multigrid
  StiffnessFactorisation
  InverseCache
  SquaredPreconditioner
  ConjugateGradient
  GuidedSmoothing
  DirectSolver
  LinearSolver
  OptimizerOptions
  ProblemSetup
  DeviationProblem
  DeviationOptimizer
  Optimizer)

# Threads of our own are strangers to vtkSMPTools: what asks it who the calling thread is stands in
# the files that know which thread that is.
function (check_thread_queries file)
  cmake_path(GET file FILENAME filename)
  file(STRINGS "${file}" queries
    REGEX "vtkSMPThreadLocal|GetEstimatedNumberOfThreads|IsParallelScope|GetSingleThread|LocalScope")
  if (queries AND NOT filename MATCHES "^(Parallel|FilterSupport)\\.h$")
    message(SEND_ERROR "${filename} asks vtkSMPTools about the calling thread: ${queries}")
  endif ()
endfunction ()

# What a file includes, as a list of names without < > and quotes.
function (read_includes file result)
  file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include")
  list(TRANSFORM lines REPLACE "^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]*).*" "\\1")
  set("${result}" "${lines}" PARENT_SCOPE)
endfunction ()

function (check_core_file file)
  cmake_path(GET file STEM name)
  cmake_path(GET file FILENAME filename)
  list(FIND layers "${name}" layer)
  if (layer EQUAL -1)
    message(SEND_ERROR "Core/${filename} is in no layer")
    return ()
  endif ()
  read_includes("${file}" includes)
  foreach (include IN LISTS includes)
    cmake_path(GET include STEM included)
    list(FIND layers "${included}" included_layer)
    if (include MATCHES "^vtk" AND NOT (filename STREQUAL "Parallel.h" AND include STREQUAL "vtkSMPTools.h"))
      message(SEND_ERROR "Core/${filename} includes VTK: ${include}")
    elseif (include MATCHES "\\.h$" AND EXISTS "${FILTERS}/${include}")
      message(SEND_ERROR "Core/${filename} includes a filter's header: ${include}")
    elseif (include MATCHES "/" AND NOT include MATCHES "^Eigen/")
      message(SEND_ERROR "Core/${filename} includes from outside Core: ${include}")
    elseif (EXISTS "${FILTERS}/Core/${include}" AND NOT included STREQUAL name AND included_layer GREATER_EQUAL layer)
      message(SEND_ERROR "Core/${filename} includes a higher layer: ${include}")
    endif ()
  endforeach ()
endfunction ()

function (check_public_header file)
  cmake_path(GET file FILENAME filename)
  file(STRINGS "${file}" classes REGEX "class .*_EXPORT ${name}")
  string(REGEX REPLACE ".* : public ([A-Za-z]+).*" "\\1" superclass "${classes}")
  read_includes("${file}" includes)
  list(REMOVE_ITEM includes "vtkFiltersLaplacianMeshModule.h" "${superclass}.h" memory)
  if (includes)
    message(SEND_ERROR "${filename} includes more than its superclass, the export header and <memory>: ${includes}")
  endif ()
endfunction ()

file(GLOB core_files "${FILTERS}/Core/*")
foreach (file IN LISTS core_files)
  check_core_file("${file}")
endforeach ()
foreach (layer IN LISTS layers)
  if (NOT EXISTS "${FILTERS}/Core/${layer}.h")
    message(SEND_ERROR "the layer ${layer} has no header in Core")
  endif ()
endforeach ()
file(GLOB public_headers "${FILTERS}/vtk*.h")
foreach (file IN LISTS public_headers)
  check_public_header("${file}")
endforeach ()
file(GLOB_RECURSE all_files "${FILTERS}/*.h" "${FILTERS}/*.cxx" "${FILTERS}/*.txx")
foreach (file IN LISTS all_files)
  check_thread_queries("${file}")
endforeach ()
list(LENGTH core_files core_count)
list(LENGTH public_headers public_count)
if (core_count EQUAL 0 OR public_count EQUAL 0)
  message(SEND_ERROR "there is nothing to check in '${FILTERS}'")
endif ()
