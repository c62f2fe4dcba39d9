// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptimizerSession_h
#define OptimizerSession_h

#include "Core/Optimizer/Optimizer.h"
#include "PolyDataConversion.h"
#include "ResultArrays.h"
#include "SurfaceExtraction.h"

#include "vtkLaplacianMeshOptimizer.h"

#include <map>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkCompositeDataSet;
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
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
    vtkDataSet* data;
    vtkSelection* selection; ///< may be null
    vtkDataSet* reference;   ///< may be null
  };

  /// How the values of several blocks become one: the mean over all triangles, the least value, the
  /// one of largest magnitude, or the sum.
  enum Combination
  {
    MEAN,
    LEAST,
    LARGEST,
    SUM
  };

  /// \param pieces in which the whole surface comes
  void Execute(const Inputs& inputs, vtkPolyData* output, int pieces);

  /// After an error: makes the input the output, if it has given a result before. A view then does
  /// not become empty while someone tries settings. For a new input the output stays empty, so that
  /// no script takes the input for the result.
  void ReturnInput(const Inputs& inputs, vtkPolyData* output);

  /// Sets the metrics that the filter's Get methods return.
  static void SetMetrics(vtkLaplacianMeshOptimizer* filter, const lmo::OptimizerResult& result);

  /// Says what the next executions are for: a data set, or a composite data set whose blocks are
  /// executed one by one; null at the end.
  void Begin(vtkDataObject* data);

protected:
  /// \throw InputError if the surface is to come in several pieces that cannot be solved together.
  virtual void CheckPieces(int pieces) const;

  /// Calls body(), which looks at the data of this process.
  /// \throw if body() does in this or another process
  virtual void Try(const std::function<void()>& body) const;

  virtual std::unique_ptr<lmo::ProgressMonitor> MakeMonitor() const;

  /// True if points take the point data of their new places on the input.
  virtual bool InterpolatesPointData() const;

  /// Makes the optimizer of the input, unless it is the one that is there.
  /// \throw InputError as lmo::ReadMesh() does.
  virtual void SetInput(vtkPolyData* input);

  /// lmo::ReadMesh(), which this module does not export.
  static lmo::SurfaceMesh Read(vtkPolyData* input);

  /// Read(), with points welded as the filter says.
  lmo::SurfaceMesh ReadWelded(vtkPolyData* data) const;

  /// True if a surface is the object of which the optimizer was made, with the same coordinates.
  /// ParaView touches it before each execution, so that it seems new.
  bool IsStill(vtkPolyData* surface) const;

  /// True if Optimizer is not that of the input as it is now.
  bool IsNew(vtkPolyData* input) const;

  void SetOptimizer(
    vtkPolyData* input, lmo::MeshNumbering numbering, std::unique_ptr<lmo::Optimizer> optimizer);

  vtkLaplacianMeshOptimizer* const Filter;
  std::unique_ptr<lmo::Optimizer> Optimizer;

private:
  /// The last execution, and what it started from; null where there is none.
  struct TimeSteps
  {
    std::shared_ptr<const lmo::EarlierStep> last;
    std::shared_ptr<const lmo::EarlierStep> start;
  };

  /// \throw InputError if a property is out of range.
  lmo::OptimizerOptions ReadOptions(vtkPolyData* input) const;

  /// The point array of an index; null if none is chosen.
  /// \throw InputError if the chosen one does not exist.
  vtkDataArray* FindArray(int index, vtkPolyData* input) const;

  /// \param isSelected 1 for points that are selected, else 0; no value without a selection
  lmo::VertexArrays ReadArrays(vtkPolyData* input, std::optional<lmo::Vector> isSelected) const;

  /// The points of the input's surface that are selected; no value without a selection.
  std::optional<lmo::Vector> SelectedPointsOf(const Inputs& inputs, vtkPolyData* surface) const;

  /// The flat index of the block of a composite data set that is executed; no value without blocks.
  std::optional<unsigned int> CompositeIndexOf(vtkDataSet* block) const;

  /// Sets the filter's metrics to those of the blocks so far.
  void AddMetrics(const lmo::OptimizerResult& result);

  /// The surface to stay near, if the mode needs one.
  /// \param reference may be null
  /// \return null if there is none
  /// \throw InputError if it has no triangles, and as lmo::ReadMesh() does.
  std::shared_ptr<const lmo::MeshQuantities> ReadReference(vtkPolyData* reference);

  /// The steps of the input, if the filter is to start from the previous one; else null.
  TimeSteps* StepsOf(const Inputs& inputs);

  /// The step that the filter starts from; null if there is none.
  std::shared_ptr<const lmo::EarlierStep> FindEarlierStep(const Inputs& inputs);

  /// Keeps a result for the next step.
  void KeepStep(const Inputs& inputs, const lmo::OptimizerResult& result);

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

  lmo::CachedSurface Surface;
  lmo::CachedSurface SurfaceOfReference;
  lmo::MeshNumbering Numbering;
  Origin InputOrigin;
  bool HasResult = false;                  ///< one has been made of the optimizer's mesh
  std::map<unsigned int, TimeSteps> Steps; ///< of each block by its flat index; 0 without blocks
  std::shared_ptr<const lmo::MeshQuantities> Reference;
  lmo::MeshNumbering ReferenceNumbering;
  Origin ReferenceOrigin;
  vtkSmartPointer<vtkCompositeDataSet> Blocks; ///< null if there are none
  std::vector<double> Totals;                  ///< of each metric; empty before the first block
  double TotalTriangles = 0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
