#include "importer/assembly/same_mesh.hpp"

#include "core/base/vec3.hpp"
#include "importer/assembly/block_cells.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>

namespace wakesurf::importer {

using core::Vec3;
using Form = BlockCell::Form;

namespace {

bool equal(vtkDataArray* a, vtkDataArray* b) {
    if (a == b)
        return true;
    if (a == nullptr || b == nullptr || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
        a->GetNumberOfComponents() != b->GetNumberOfComponents())
        return false;
    const vtkIdType count = a->GetNumberOfValues();
    if (a->GetDataType() == b->GetDataType() && a->HasStandardMemoryLayout() &&
        b->HasStandardMemoryLayout() && count > 0 &&
        std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                    static_cast<std::size_t>(count * a->GetDataTypeSize())) == 0)
        return true;
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
        for (int c = 0; c < a->GetNumberOfComponents(); ++c)
            if (a->GetComponent(i, c) != b->GetComponent(i, c))
                return false;
    return true;
}

vtkDataArray* marks(vtkDataSetAttributes& attributes) {
    return attributes.GetArray(vtkDataSetAttributes::GhostArrayName());
}

bool equal(vtkPoints* a, vtkPoints* b) {
    return a == b || (a != nullptr && b != nullptr && equal(a->GetData(), b->GetData()));
}

bool equal(vtkCellArray* a, vtkCellArray* b) {
    return a == b || (a != nullptr && b != nullptr &&
                      equal(a->GetConnectivityArray(), b->GetConnectivityArray()) &&
                      equal(a->GetOffsetsArray(), b->GetOffsetsArray()));
}

bool equal(vtkImageData& a, vtkImageData& b) {
    return std::equal(a.GetExtent(), a.GetExtent() + 6, b.GetExtent()) &&
           std::equal(a.GetOrigin(), a.GetOrigin() + 3, b.GetOrigin()) &&
           std::equal(a.GetSpacing(), a.GetSpacing() + 3, b.GetSpacing()) &&
           std::equal(a.GetDirectionMatrix()->GetData(), a.GetDirectionMatrix()->GetData() + 9,
                      b.GetDirectionMatrix()->GetData());
}

bool equal(vtkRectilinearGrid& a, vtkRectilinearGrid& b) {
    return equal(a.GetXCoordinates(), b.GetXCoordinates()) &&
           equal(a.GetYCoordinates(), b.GetYCoordinates()) &&
           equal(a.GetZCoordinates(), b.GetZCoordinates());
}

bool equal(vtkStructuredGrid& a, vtkStructuredGrid& b) {
    int along_a[3];
    int along_b[3];
    a.GetDimensions(along_a);
    b.GetDimensions(along_b);
    return std::equal(along_a, along_a + 3, along_b) && equal(a.GetPoints(), b.GetPoints());
}

bool equal(vtkUnstructuredGrid& a, vtkUnstructuredGrid& b) {
    return equal(a.GetPoints(), b.GetPoints()) && equal(a.GetCells(), b.GetCells()) &&
           equal(a.GetCellTypesArray(), b.GetCellTypesArray()) &&
           equal(a.GetFaces(), b.GetFaces()) && equal(a.GetFaceLocations(), b.GetFaceLocations());
}

template <class Kind>
bool both(vtkDataSet& a, vtkDataSet& b) {
    auto* first = Kind::SafeDownCast(&a);
    auto* second = Kind::SafeDownCast(&b);
    return first != nullptr && second != nullptr && equal(*first, *second);
}

} // namespace

bool same_block(vtkDataSet& a, vtkDataSet& b) {
    return a.GetNumberOfPoints() == b.GetNumberOfPoints() &&
           a.GetNumberOfCells() == b.GetNumberOfCells() &&
           equal(marks(*a.GetPointData()), marks(*b.GetPointData())) &&
           equal(marks(*a.GetCellData()), marks(*b.GetCellData())) &&
           (both<vtkImageData>(a, b) || both<vtkRectilinearGrid>(a, b) ||
            both<vtkStructuredGrid>(a, b) || both<vtkUnstructuredGrid>(a, b));
}

void share_mesh(vtkDataSet& from, vtkDataSet& to) {
    if (auto* source = vtkPointSet::SafeDownCast(&from), *target = vtkPointSet::SafeDownCast(&to);
        source != nullptr && target != nullptr)
        target->SetPoints(source->GetPoints());
    if (auto* source = vtkUnstructuredGrid::SafeDownCast(&from),
        *target = vtkUnstructuredGrid::SafeDownCast(&to);
        source != nullptr && target != nullptr)
        target->SetCells(source->GetCellTypesArray(), source->GetCells(),
                         source->GetFaceLocations(), source->GetFaces());
}

std::vector<vtkSmartPointer<vtkDataSet>> without_values(BlockList blocks) {
    std::vector<vtkSmartPointer<vtkDataSet>> out;
    for (const auto& block : blocks) {
        auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
        copy->CopyStructure(block);
        if (auto* hidden = marks(*block->GetPointData()))
            copy->GetPointData()->AddArray(hidden);
        if (auto* hidden = marks(*block->GetCellData()))
            copy->GetCellData()->AddArray(hidden);
        out.push_back(std::move(copy));
    }
    return out;
}

bool same_mesh(BlockList a, BlockList b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return same_block(*x, *y); });
}

namespace {

using Blocks = std::vector<vtkSmartPointer<vtkDataSet>>;

std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The cells of all blocks, in terms of points that count through the blocks.
struct Cells {
    std::vector<Vec3> at;
    std::vector<std::size_t> first_point{0}; ///< of each block, then the number of all
    std::vector<std::size_t> first_cell{0};
    std::vector<std::size_t> first{
        0}; ///< of each cell in `points`; a cell that is left out has none
    std::vector<std::uint32_t> points; ///< of a cell each once

    std::size_t size() const { return first.size() - 1; }

    std::span<const std::uint32_t> of(std::size_t cell) const {
        return std::span(points).subspan(first[cell], first[cell + 1] - first[cell]);
    }
};

std::optional<Cells> cells_of(BlockList blocks) {
    Cells out;
    BlockCell cell;
    for (const auto& block : blocks) {
        const std::size_t before = out.at.size();
        for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i) {
            Vec3 p;
            block->GetPoint(i, &p[0]);
            out.at.push_back(p + 0.0); // -0 is 0
        }
        BlockCells cells(*block);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!cells.read(i, cell))
                return std::nullopt;
            const auto begin = static_cast<std::ptrdiff_t>(out.points.size());
            const auto add = [&](std::uint32_t p) {
                out.points.push_back(static_cast<std::uint32_t>(before + p));
            };
            if (cell.form == Form::Standard)
                std::for_each_n(cell.point.begin(), core::node_count(cell.shape), add);
            else if (cell.form == Form::Polyhedron)
                for (const auto& face : cell.faces)
                    std::for_each(face.begin(), face.end(), add);
            std::sort(out.points.begin() + begin, out.points.end());
            out.points.erase(std::unique(out.points.begin() + begin, out.points.end()),
                             out.points.end());
            out.first.push_back(out.points.size());
        }
        out.first_point.push_back(out.at.size());
        out.first_cell.push_back(out.size());
    }
    return out;
}

/// The places of a mesh's points: points at one place have one number.
class Places {
  public:
    explicit Places(const Cells& mesh)
        : at_(mesh.at), slots_(std::bit_ceil(2 * mesh.at.size() + 1), no_node),
          of_(mesh.at.size(), no_node) {
        for (const std::uint32_t p : mesh.points)
            if (of_[p] == no_node) {
                auto& slot = slots_[slot_of(at_[p])];
                slot = slot == no_node ? p : slot;
                of_[p] = slot;
            }
    }

    std::uint32_t of(std::uint32_t point) const { return of_[point]; }

    /// Returns no_node where no point of the mesh is.
    std::uint32_t find(const Vec3& p) const { return slots_[slot_of(p)]; }

  private:
    std::size_t slot_of(const Vec3& p) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis)
            hash = mixed(hash + std::bit_cast<std::uint64_t>(p[axis] + 0.0)); // -0 is 0
        std::size_t slot = hash & (slots_.size() - 1);
        while (slots_[slot] != no_node && !(at_[slots_[slot]] == p))
            slot = (slot + 1) & (slots_.size() - 1);
        return slot;
    }

    const std::vector<Vec3>& at_;
    std::vector<std::uint32_t> slots_;
    std::vector<std::uint32_t> of_;
};

/// The points and cells of a step that those of the mesh are.
struct Order {
    std::vector<std::uint32_t> point;
    std::vector<std::uint32_t> cell;
};

class Matching {
  public:
    Matching(const Cells& mesh, const Cells& step)
        : mesh_(mesh), step_(step),
          places_(mesh), order_{std::vector<std::uint32_t>(mesh.at.size(), no_node),
                                std::vector<std::uint32_t>(mesh.size(), no_node)} {}

    std::optional<Order> run() {
        place_.resize(step_.at.size(), no_node);
        for (const std::uint32_t p : step_.points)
            if (place_[p] == no_node && (place_[p] = places_.find(step_.at[p])) == no_node)
                return std::nullopt;
        std::vector<std::pair<std::uint64_t, std::uint32_t>> known; // hash and cell of the mesh
        for (std::size_t i = 0; i < mesh_.size(); ++i)
            if (!mesh_.of(i).empty())
                known.emplace_back(hash_of(mesh_.of(i), [&](auto p) { return places_.of(p); }),
                                   static_cast<std::uint32_t>(i));
        std::sort(known.begin(), known.end());
        for (std::size_t i = 0; i < step_.size(); ++i) {
            if (step_.of(i).empty())
                continue;
            const auto hash = hash_of(step_.of(i), [&](auto p) { return place_[p]; });
            auto at = std::lower_bound(known.begin(), known.end(), std::pair(hash, 0u));
            bool found = false;
            constexpr int most_alike =
                64; // of a file that repeats one cell, all with all take for ever
            for (int alike = 0; at != known.end() && at->first == hash; ++at) {
                found = match(at->second, i) || found;
                if (++alike > most_alike)
                    return std::nullopt;
            }
            if (!found)
                return std::nullopt;
        }
        const bool whole = std::all_of(known.begin(), known.end(), [&](const auto& cell) {
            return order_.cell[cell.second] != no_node;
        });
        return whole && !known.empty() ? std::optional(std::move(order_)) : std::nullopt;
    }

  private:
    template <class PlaceOf>
    static std::uint64_t hash_of(std::span<const std::uint32_t> points, const PlaceOf& place_of) {
        std::uint64_t sum = points.size();
        for (const std::uint32_t p : points)
            sum += mixed(place_of(p) + 1u);
        return sum;
    }

    bool match(std::uint32_t cell, std::size_t other) {
        const auto own = mesh_.of(cell);
        const auto others = step_.of(other);
        const auto partner = [&](std::uint32_t p) {
            return std::find_if(others.begin(), others.end(),
                                [&](std::uint32_t q) { return place_[q] == places_.of(p); });
        };
        if (own.size() != others.size() ||
            std::any_of(own.begin(), own.end(),
                        [&](std::uint32_t p) { return partner(p) == others.end(); }))
            return false;
        order_.cell[cell] = static_cast<std::uint32_t>(other);
        for (const std::uint32_t p : own)
            order_.point[p] = *partner(p);
        return true;
    }

    const Cells& mesh_;
    const Cells& step_;
    Places places_;
    std::vector<std::uint32_t> place_; ///< by point of the step
    Order order_;
};

vtkDataSetAttributes& attributes_of(vtkDataSet& block, bool of_points) {
    return of_points ? static_cast<vtkDataSetAttributes&>(*block.GetPointData())
                     : static_cast<vtkDataSetAttributes&>(*block.GetCellData());
}

/// Returns the array for one block: its values from those of all blocks of the step; null if one has another
/// kind of it.
vtkSmartPointer<vtkDataArray> ordered(const std::vector<vtkDataArray*>& arrays,
                                      const std::vector<std::size_t>& first,
                                      std::span<const std::uint32_t> order) {
    auto out = vtkSmartPointer<vtkDataArray>::Take(arrays.front()->NewInstance());
    const int components = arrays.front()->GetNumberOfComponents();
    out->SetName(arrays.front()->GetName());
    out->SetNumberOfComponents(components);
    out->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto to = static_cast<vtkIdType>(i);
        if (order[i] == no_node) {
            for (int c = 0; c < components; ++c)
                out->SetComponent(to, c, 0.0);
            continue;
        }
        const auto block = static_cast<std::size_t>(
            std::upper_bound(first.begin(), first.end(), order[i]) - first.begin() - 1);
        const auto from = static_cast<vtkIdType>(order[i] - first[block]);
        if (arrays[block]->GetDataType() == out->GetDataType())
            out->SetTuple(to, from, arrays[block]);
        else
            for (int c = 0; c < components; ++c)
                out->SetComponent(to, c, arrays[block]->GetComponent(from, c));
    }
    return out;
}

// Returns false if a block of the step lacks an array, or has one of another shape.
bool add_values(BlockList step,
                bool of_points,
                const std::vector<std::size_t>& step_first,
                const std::vector<std::size_t>& first,
                std::span<const std::uint32_t> order,
                Blocks& out) {
    auto& known = attributes_of(*step.front(), of_points);
    for (int i = 0; i < known.GetNumberOfArrays(); ++i) {
        auto* const array = known.GetArray(i);
        if (array == nullptr || array->GetName() == nullptr ||
            std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) == 0)
            continue;
        std::vector<vtkDataArray*> arrays;
        for (std::size_t b = 0; b < step.size(); ++b) {
            arrays.push_back(attributes_of(*step[b], of_points).GetArray(array->GetName()));
            if (arrays.back() == nullptr ||
                arrays.back()->GetNumberOfComponents() != array->GetNumberOfComponents() ||
                static_cast<std::size_t>(arrays.back()->GetNumberOfTuples()) !=
                    step_first[b + 1] - step_first[b])
                return false;
        }
        for (std::size_t b = 0; b < out.size(); ++b)
            attributes_of(*out[b], of_points)
                .AddArray(
                    ordered(arrays, step_first, order.subspan(first[b], first[b + 1] - first[b])));
    }
    return true;
}

} // namespace

std::optional<Blocks> values_on(BlockList mesh, BlockList step) {
    const auto known = cells_of(mesh);
    const auto cells = cells_of(step);
    if (!known || !cells || known->at.size() >= no_node || cells->at.size() >= no_node)
        return std::nullopt;
    const auto order = Matching(*known, *cells).run();
    if (!order)
        return std::nullopt;
    Blocks out;
    for (const auto& block : mesh) {
        out.push_back(vtkSmartPointer<vtkDataSet>::Take(block->NewInstance()));
        out.back()->ShallowCopy(block);
    }
    if (!add_values(step, true, cells->first_point, known->first_point, order->point, out) ||
        !add_values(step, false, cells->first_cell, known->first_cell, order->cell, out))
        return std::nullopt;
    return out;
}

} // namespace wakesurf::importer
