// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptimizerSession_h
#define OptimizerSession_h

#include "Core/Optimizer/Optimizer.h"
#include "JoinedPieces.h"
#include "MeshFingerprint.h"
#include "PointDataInterpolation.h"
#include "ResultArrays.h"
#include "SurfaceBlocks.h"
#include "SurfaceExtraction.h"

#include "vtkLaplacianMeshOptimizer.h"

#include <map>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArray;
class vtkDataObject;
class vtkFieldData;
class vtkPointData;
class vtkPolyData;
class vtkSelection;

/// What a vtkLaplacianMeshOptimizer does with its input: this class in one process, derived classes
/// in several. The optimizer is kept for the next execution, which often differs in a property
/// alone.
class VTKFILTERSLAPLACIANMESH_EXPORT vtkLaplacianMeshOptimizer::Session
{
public:
  explicit Session(vtkLaplacianMeshOptimizer* filter);
  virtual ~Session();
  Session(const Session&) = delete;
  void operator=(const Session&) = delete;

  struct Inputs
  {
    vtkDataObject* data;
    vtkSelection* selection;  ///< may be null
    vtkDataObject* reference; ///< may be null
  };

  /// What is optimized as one surface.
  struct Job
  {
    lmo::SurfacePieces pieces;
    std::vector<unsigned int> path;        ///< as of lmo::SurfaceBlock
    bool isPartitioned = false;            ///< pieces are joined even if it is one alone
    std::optional<lmo::Vector> isSelected; ///< of the points of all pieces; if there is a selection
    lmo::SurfacePieces reference;          ///< none if there is no reference
  };

  /// How the values of several surfaces become one: the mean over all triangles, the least value,
  /// the one of largest magnitude, or the sum.
  enum Combination
  {
    MEAN,
    LEAST,
    LARGEST,
    SUM
  };

  /// \param output as lmo::SetOutputFor() makes it for the input
  /// \param pieces in which the whole surface comes
  void Execute(const Inputs& inputs, vtkDataObject* output, int pieces);

  /// After an error: makes an input of one surface the output, if it has given a result before. A
  /// view then does not become empty while someone tries settings. For a new input the output stays
  /// empty, so that no script takes the input for the result.
  void ReturnInput(const Inputs& inputs, vtkDataObject* output);

  /// Sets the metrics that the filter's Get methods return.
  static void SetMetrics(vtkLaplacianMeshOptimizer* filter, const lmo::OptimizerResult& result);

protected:
  /// \throw InputError if the surface is to come in several pieces that cannot be solved together.
  virtual void CheckPieces(int pieces) const;

  /// Calls body(), which looks at the data of this process.
  /// \throw if body() does in this or another process
  virtual void Try(const std::function<void()>& body) const;

  virtual std::unique_ptr<lmo::ProgressMonitor> MakeMonitor() const;

  /// The surfaces of a data set or a composite data set.
  virtual std::vector<lmo::SurfaceBlock> FindBlocks(vtkDataObject* data) const;

  /// \return the pieces as they are optimized
  virtual lmo::SurfacePieces Optimize(const Job& job);

  /// Optimize() with the pieces of this process as the input of one optimizer.
  lmo::SurfacePieces OptimizeJoined(const Job& job, lmo::Joining joining);

  /// The input's point data at the new places of its points, which slide along the surface.
  virtual vtkSmartPointer<vtkPointData> PointDataAtNewPlaces(
    vtkPolyData* input, const lmo::OptimizerResult& result) const;

  /// lmo::FindMovingArrays() and lmo::MoveArrays(), which this module does not export.
  static std::vector<lmo::MovingArray> FindMovingArrays(vtkPolyData* input);
  vtkSmartPointer<vtkPointData> MoveArrays(vtkPolyData* input,
    const std::vector<lmo::MovingArray>& arrays, const lmo::MoveFieldsAs& move) const;

  /// Makes the optimizer of the input, unless the one that is there is that of the same mesh:
  /// ParaView touches the input before each execution, so that it seems new.
  /// \throw InputError as lmo::ReadMesh() does.
  /// \param firstPoints as of lmo::JoinedPieces
  virtual void SetInput(vtkPolyData* input, const std::vector<lmo::Index>& firstPoints);

  /// lmo::ReadMesh(), which this module does not export.
  static lmo::SurfaceMesh Read(vtkPolyData* input);

  /// Read(), with the points of several pieces joined, and others welded as the filter says.
  lmo::SurfaceMesh ReadWelded(vtkPolyData* data, const std::vector<lmo::Index>& firstPoints) const;

  /// True if a surface is the object of which the optimizer was made, with the same coordinates.
  bool IsStill(vtkPolyData* surface) const;

  /// True if Optimizer is not that of the input as it is now.
  bool IsNew(vtkPolyData* input) const;

  void SetOptimizer(
    vtkPolyData* input, lmo::MeshNumbering numbering, std::unique_ptr<lmo::Optimizer> optimizer);

  /// \throw InputError if a property is out of range.
  lmo::OptimizerOptions ReadOptions(vtkPolyData* input) const;

  vtkLaplacianMeshOptimizer* const Filter;
  std::unique_ptr<lmo::Optimizer> Optimizer;

private:
  /// The last execution, and what it started from; null where there is none.
  struct TimeSteps
  {
    std::shared_ptr<const lmo::EarlierStep> last;
    std::shared_ptr<const lmo::EarlierStep> start;
  };

  /// The point array of an index; null if none is chosen.
  /// \throw InputError if the chosen one does not exist.
  vtkDataArray* FindArray(int index, vtkPolyData* input) const;

  /// \param isSelected 1 for points that are selected, else 0; no value without a selection
  lmo::VertexArrays ReadArrays(vtkPolyData* input, std::optional<lmo::Vector> isSelected) const;

  /// The points of the surface of a data set that are selected.
  lmo::Vector SelectedPointsOf(
    const lmo::SurfacePart& part, vtkSelection* selection, vtkPolyData* surface) const;

  /// \param surfaces of the parts of the block
  Job MakeJob(const lmo::SurfaceBlock& block, const lmo::SurfacePieces& surfaces,
    vtkSelection* selection) const;

  /// A surface that may have been joined from pieces.
  struct Whole
  {
    vtkPolyData* data = nullptr;
    std::vector<lmo::Index> firstPoints; ///< as of lmo::JoinedPieces
  };

  /// \param job of which the surface and the reference are
  /// \param reference its data may be null
  void OptimizeWhole(
    const Whole& whole, const Job& job, const Whole& reference, vtkPolyData* output);

  /// Sets the filter's metrics to those of the surfaces so far.
  void AddMetrics(const lmo::OptimizerResult& result);

  /// The surface to stay near, if the mode needs one.
  /// \param reference its data may be null
  /// \return null if there is none
  /// \throw InputError if it has no triangles, and as lmo::ReadMesh() does.
  std::shared_ptr<const lmo::MeshQuantities> ReadReference(const Whole& reference);

  /// True if points slide along the surface and take the point data of their new places.
  bool InterpolatesPointData() const;

  /// The steps of a surface, if the filter is to start from the previous one; else null.
  TimeSteps* StepsOf(const Job& job);

  /// The step that the filter starts from; null if there is none.
  std::shared_ptr<const lmo::EarlierStep> FindEarlierStep(const Job& job);

  /// Keeps a result for the next step.
  void KeepStep(const Job& job, const lmo::OptimizerResult& result);

  /// Adds the point data and field data that the reference has and the output has not.
  /// \param reference may be null
  void AddDataOfReference(
    vtkPolyData* reference, const lmo::OptimizerResult& result, vtkPolyData* output) const;

  /// Says what the user should know of a result: what could not move and what got worse.
  void Warn(const lmo::OptimizerOptions& options, const lmo::OptimizerResult& result) const;

  /// \param reference may be null
  void WritePoints(lmo::OptimizerResult result, vtkPolyData* input, vtkPolyData* reference,
    lmo::ResultArrays& results, vtkPolyData* output) const;

  /// Cell normals of the new surface where the input has them.
  void WriteCellNormals(vtkPolyData* output) const;

  /// Sets the input's point data as they are at the new positions.
  void WritePointData(
    const lmo::OptimizerResult& result, vtkPolyData* input, vtkPointData* pointData) const;

  void WriteMetrics(
    const lmo::OptimizerResult& result, lmo::ResultArrays& results, vtkFieldData* fieldData) const;

  /// Which data a mesh was read from.
  struct Origin
  {
    vtkPolyData* data = nullptr; ///< to be compared only
    vtkMTimeType time = 0;
    bool isWelded = false;

    bool operator==(const Origin& other) const
    {
      return this->data == other.data && this->time == other.time &&
             this->isWelded == other.isWelded;
    }
  };

  Origin OriginOf(vtkPolyData* data) const;

  std::vector<lmo::CachedSurface> Surfaces; ///< of all parts of the input
  std::vector<lmo::CachedSurface> SurfacesOfReference;
  lmo::CachedJoin Joined;
  lmo::CachedJoin JoinedReference;
  lmo::MeshNumbering Numbering;
  Origin InputOrigin;
  lmo::MeshFingerprint Fingerprint{}; ///< of the optimizer's mesh as it was read
  bool HasResult = false;             ///< one has been made of the optimizer's mesh
  std::map<std::vector<unsigned int>, TimeSteps> Steps; ///< of each surface by its path
  std::shared_ptr<const lmo::MeshQuantities> Reference;
  lmo::MeshNumbering ReferenceNumbering;
  Origin ReferenceOrigin;
  std::vector<double> Totals; ///< of each metric; empty before the first surface
  double TotalTriangles = 0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
