#include "importer/level_sets.hpp"

#include "importer/base/one_thread.hpp"
#include "importer/level_message.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <vector>

namespace wakesurf::importer {

using core::Error;

namespace {

/// Returns false at the end of the stream.
bool read_whole(int file, void* into, std::size_t bytes) {
    for (auto* at = static_cast<std::byte*>(into); bytes > 0;) {
        const auto count = ::read(file, at, bytes);
        if (count == 0 || (count < 0 && errno != EINTR))
            return false;
        at += std::max<ssize_t>(count, 0);
        bytes -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    return true;
}

bool write_whole(int file, const void* from, std::size_t bytes) {
    for (const auto* at = static_cast<const std::byte*>(from); bytes > 0;) {
        const auto count = ::write(file, at, bytes);
        if (count < 0 && errno != EINTR)
            return false;
        at += std::max<ssize_t>(count, 0);
        bytes -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    return true;
}

/// Maps the server's shared memory for as long as this process lives.
class Shared {
  public:
    static core::Result<Shared> of(int memory) {
        struct stat size {};

        if (::fstat(memory, &size) != 0 ||
            static_cast<std::uint64_t>(size.st_size) < sizeof(LevelGrid))
            return no_memory();
        void* const start = ::mmap(nullptr, static_cast<std::size_t>(size.st_size), PROT_READ,
                                   MAP_SHARED, memory, 0);
        if (start == MAP_FAILED)
            return no_memory();
        Shared shared(static_cast<std::byte*>(start));
        const LevelGrid& grid = shared.grid();
        if (grid.magic != level_magic || grid.bytes != static_cast<std::uint64_t>(size.st_size))
            return no_memory();
        return shared;
    }

    const LevelGrid& grid() const { return *reinterpret_cast<const LevelGrid*>(start_); }

    /// Returns a pointer to non-const, which VTK takes; it changes nothing of an input.
    template <class T>
    T* at(std::uint64_t offset) const {
        return reinterpret_cast<T*>(start_ + offset);
    }

  private:
    explicit Shared(std::byte* start) : start_(start) {}

    static tl::unexpected<Error> no_memory() {
        return core::fail(Error::Code::Corrupt, "the shared memory for level sets is invalid");
    }

    std::byte* start_;
};

template <class Array, class T>
vtkSmartPointer<Array> borrowed(T* values, std::uint64_t count, int components = 1) {
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(components);
    array->SetArray(values, static_cast<vtkIdType>(count) * components,
                    1); // 1: it is not VTK's to free
    return array;
}

class Levels {
  public:
    virtual ~Levels() = default;
    virtual vtkPolyData* extract(const LevelRequest& request) = 0;
};

/// Extracts in units of node indices: along edges of any rectilinear grid values are linear in these too.
class StructuredLevels final : public Levels {
  public:
    explicit StructuredLevels(const Shared& shared) {
        const LevelGrid& grid = shared.grid();
        values_ = borrowed<vtkFloatArray>(shared.at<float>(grid.values), grid.nodes);
        image_->SetDimensions(static_cast<int>(grid.dimensions[0]),
                              static_cast<int>(grid.dimensions[1]),
                              static_cast<int>(grid.dimensions[2]));
        image_->GetPointData()->SetScalars(values_);
        edges_->SetInputData(image_);
        edges_->ComputeNormalsOff();
        edges_->ComputeGradientsOff();
        edges_->ComputeScalarsOff();
    }

    vtkPolyData* extract(const LevelRequest& request) override {
        if (request.version != version_)
            values_->Modified();
        version_ = request.version;
        edges_->SetValue(0, request.level);
        edges_->Update();
        return edges_->GetOutput();
    }

  private:
    vtkNew<vtkImageData> image_;
    vtkSmartPointer<vtkFloatArray> values_;
    vtkNew<vtkFlyingEdges3D> edges_;
    std::uint64_t version_ = 0;
};

/// Extracts from a mesh. Cells with a node without a value are left out beforehand.
class MeshLevels final : public Levels {
  public:
    explicit MeshLevels(const Shared& shared) : shared_(shared), grid_(shared.grid()) {
        values_ = borrowed<vtkFloatArray>(shared.at<float>(grid_.values), grid_.nodes);
        points_->SetData(borrowed<vtkDoubleArray>(shared.at<double>(grid_.points), grid_.nodes, 3));
        contour_->SetInputData(mesh_);
        contour_->MergePointsOn();
        contour_->ComputeNormalsOff();
        contour_->ComputeScalarsOff();
        contour_->InterpolateAttributesOff();
        contour_->SequentialProcessingOn();
        contour_->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    }

    vtkPolyData* extract(const LevelRequest& request) override {
        if (request.version != version_)
            take(request.gaps != 0);
        version_ = request.version;
        contour_->SetValue(0, request.level);
        contour_->Update();
        return vtkPolyData::SafeDownCast(contour_->GetOutputDataObject(0));
    }

  private:
    bool whole(std::uint64_t cell) const {
        const auto* first = shared_.at<std::int32_t>(grid_.first) + cell;
        const auto* corner = shared_.at<std::int32_t>(grid_.corner);
        const auto* values = shared_.at<float>(grid_.values);
        for (auto k = first[0]; k < first[1]; ++k)
            if (!std::isfinite(values[corner[k]]))
                return false;
        return true;
    }

    void take(bool gaps) {
        std::vector<std::uint64_t> left;
        if (gaps)
            for (std::uint64_t cell = 0; cell < grid_.cells; ++cell)
                if (whole(cell))
                    left.push_back(cell);
        vtkNew<vtkCellArray> cells;
        vtkSmartPointer<vtkUnsignedCharArray> shapes;
        if (gaps) {
            cells->Use32BitStorage();
            shapes = vtkSmartPointer<vtkUnsignedCharArray>::New();
            std::array<vtkIdType, 8> nodes{};
            for (const std::uint64_t cell : left) {
                const auto* first = shared_.at<std::int32_t>(grid_.first) + cell;
                vtkIdType count = 0;
                for (auto k = first[0]; k < first[1]; ++k)
                    nodes[static_cast<std::size_t>(count++)] =
                        shared_.at<std::int32_t>(grid_.corner)[k];
                cells->InsertNextCell(count, nodes.data());
                shapes->InsertNextValue(shared_.at<std::uint8_t>(grid_.shape)[cell]);
            }
        } else {
            shapes =
                borrowed<vtkUnsignedCharArray>(shared_.at<std::uint8_t>(grid_.shape), grid_.cells);
            cells->SetData(
                borrowed<vtkTypeInt32Array>(shared_.at<std::int32_t>(grid_.first), grid_.cells + 1),
                borrowed<vtkTypeInt32Array>(shared_.at<std::int32_t>(grid_.corner), grid_.corners));
        }
        mesh_->SetPoints(points_);
        mesh_->SetCells(shapes, cells);
        mesh_->GetPointData()->SetScalars(values_);
        values_->Modified();
        mesh_->Modified();
    }

    Shared shared_;
    const LevelGrid& grid_;
    vtkNew<vtkUnstructuredGrid> mesh_;
    vtkNew<vtkPoints> points_;
    vtkSmartPointer<vtkFloatArray> values_;
    vtkNew<vtkContour3DLinearGrid> contour_;
    std::uint64_t version_ = 0;
};

bool answer(int talk, const LevelRequest& request, vtkPolyData& found) {
    LevelAnswer head;
    head.number = request.number;
    head.points = static_cast<std::uint64_t>(found.GetNumberOfPoints());
    head.triangles = static_cast<std::uint64_t>(found.GetNumberOfPolys());
    if (head.triangles > request.most_triangles)
        return write_whole(talk, &head, sizeof(head));
    std::vector<std::array<double, 3>> points(head.points);
    for (std::size_t i = 0; i < points.size(); ++i)
        found.GetPoint(static_cast<vtkIdType>(i), points[i].data());
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(head.triangles);
    vtkIdType count = 0;
    const vtkIdType* corner = nullptr;
    vtkCellArray* const polygons = found.GetPolys();
    for (polygons->InitTraversal(); polygons->GetNextCell(count, corner) != 0;)
        if (count == 3)
            triangles.push_back({static_cast<std::uint32_t>(corner[0]),
                                 static_cast<std::uint32_t>(corner[1]),
                                 static_cast<std::uint32_t>(corner[2])});
    head.triangles = triangles.size();
    return write_whole(talk, &head, sizeof(head)) &&
           write_whole(talk, points.data(), points.size() * sizeof(points[0])) &&
           write_whole(talk, triangles.data(), triangles.size() * sizeof(triangles[0]));
}

} // namespace

core::Result<void> answer_level_requests(int talk, int memory) {
    keep_vtk_to_one_thread();
    const auto shared = Shared::of(memory);
    if (!shared)
        return tl::unexpected(shared.error());
    std::unique_ptr<Levels> levels;
    if (shared->grid().dimensions[0] != 0)
        levels = std::make_unique<StructuredLevels>(*shared);
    else
        levels = std::make_unique<MeshLevels>(*shared);
    LevelRequest request;
    while (read_whole(talk, &request, sizeof(request)))
        if (!answer(talk, request, *levels->extract(request)))
            break;
    return {};
}

} // namespace wakesurf::importer
