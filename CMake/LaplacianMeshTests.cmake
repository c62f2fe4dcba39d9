# The tests that need the whole build, and the benchmark; Testing/CMakeLists.txt has the tests of the
# module alone.
if (BUILD_TESTING)
  add_subdirectory(Testing/Package)
  if (lmo_parallel)
    # The processes may be more than the processors: those that wait let the others run.
    find_package(MPI REQUIRED COMPONENTS C)
    set(lmo_mpirun "${MPIEXEC_EXECUTABLE}" --allow-run-as-root --oversubscribe
      --mca mpi_yield_when_idle 1)
    add_subdirectory(Testing/Parallel)
  endif ()
  if (LMO_WRAP_PYTHON)
    add_subdirectory(Testing/Python)
  endif ()
  if (LMO_PARAVIEW)
    add_subdirectory(Testing/ParaView)
  endif ()
endif ()

if (LMO_BENCHMARKS OR BUILD_TESTING)
  add_subdirectory(Testing/Benchmarks)
endif ()
