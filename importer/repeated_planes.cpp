#include "importer/repeated_planes.hpp"

#include "importer/assembly/grid_assembly.hpp"
#include "importer/assembly/node_values.hpp"
#include "importer/base/text.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <cmath>
#include <limits>

namespace wakesurf::importer {

using core::Error;
using core::PeriodicAxes;

namespace {

using Size = std::array<int, 3>;

Size points_along(vtkDataSet& block) {
    Size size{};
    if (auto* image = vtkImageData::SafeDownCast(&block))
        image->GetDimensions(size.data());
    else
        vtkRectilinearGrid::SafeDownCast(&block)->GetDimensions(size.data());
    return size;
}

// Returns where each tuple of a larger block comes from; -1: from none.
vtkSmartPointer<vtkIdList> tuples_of(const Size& small, const Size& large, bool around) {
    auto from = vtkSmartPointer<vtkIdList>::New();
    for (int k = 0; k < large[2]; ++k)
        for (int j = 0; j < large[1]; ++j)
            for (int i = 0; i < large[0]; ++i) {
                const bool within = i < small[0] && j < small[1] && k < small[2];
                const vtkIdType at =
                    i % small[0] +
                    vtkIdType{small[0]} * (j % small[1] + vtkIdType{small[1]} * (k % small[2]));
                from->InsertNextId(within || around ? at : -1);
            }
    return from;
}

void copy_values(vtkDataSetAttributes& from, vtkIdList& tuples, vtkDataSetAttributes& to) {
    for (int a = 0; a < from.GetNumberOfArrays(); ++a) {
        vtkDataArray* const array = from.GetArray(a);
        if (array == nullptr)
            continue;
        auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
        copy->SetName(array->GetName());
        copy->SetNumberOfComponents(array->GetNumberOfComponents());
        copy->SetNumberOfTuples(tuples.GetNumberOfIds());
        for (vtkIdType i = 0; i < tuples.GetNumberOfIds(); ++i) {
            if (tuples.GetId(i) >= 0)
                copy->SetTuple(i, tuples.GetId(i), array);
            else
                for (int c = 0; c < array->GetNumberOfComponents(); ++c)
                    copy->SetComponent(i, c, std::numeric_limits<double>::quiet_NaN());
        }
        to.AddArray(copy);
    }
}

vtkSmartPointer<vtkDataArray> one_more(vtkDataArray& along) {
    auto out = vtkSmartPointer<vtkDoubleArray>::New();
    const vtkIdType count = along.GetNumberOfTuples();
    for (vtkIdType i = 0; i < count; ++i)
        out->InsertNextValue(along.GetComponent(i, 0));
    out->InsertNextValue(2.0 * out->GetValue(count - 1) - out->GetValue(count - 2));
    return out;
}

// Values at points are those of the first plane; values in the cells added are unknown.
vtkSmartPointer<vtkDataSet> with_planes(vtkDataSet& block, const PeriodicAxes& added) {
    const Size small = points_along(block);
    Size large = small;
    for (std::size_t axis = 0; axis < 3; ++axis)
        large[axis] += added[axis] ? 1 : 0;
    vtkSmartPointer<vtkDataSet> out;
    if (auto* image = vtkImageData::SafeDownCast(&block)) {
        auto copy = vtkSmartPointer<vtkImageData>::New();
        std::array<int, 6> extent{};
        image->GetExtent(extent.data());
        for (std::size_t axis = 0; axis < 3; ++axis)
            extent[2 * axis + 1] += added[axis] ? 1 : 0;
        copy->SetOrigin(image->GetOrigin());
        copy->SetSpacing(image->GetSpacing());
        copy->SetExtent(extent.data());
        out = copy;
    } else {
        auto* grid = vtkRectilinearGrid::SafeDownCast(&block);
        auto copy = vtkSmartPointer<vtkRectilinearGrid>::New();
        const auto along = [&](std::size_t axis, vtkDataArray* nodes) {
            return added[axis] ? one_more(*nodes) : vtkSmartPointer<vtkDataArray>(nodes);
        };
        copy->SetDimensions(large.data());
        copy->SetXCoordinates(along(0, grid->GetXCoordinates()));
        copy->SetYCoordinates(along(1, grid->GetYCoordinates()));
        copy->SetZCoordinates(along(2, grid->GetZCoordinates()));
        out = copy;
    }
    copy_values(*block.GetPointData(), *tuples_of(small, large, true), *out->GetPointData());
    const auto cells = [](const Size& points) {
        return Size{points[0] - 1, points[1] - 1, points[2] - 1};
    };
    copy_values(*block.GetCellData(), *tuples_of(cells(small), cells(large), false),
                *out->GetCellData());
    out->SetFieldData(block.GetFieldData());
    return out;
}

class RepeatedSource final : public Source {
  public:
    RepeatedSource(std::unique_ptr<Source> source, const PeriodicAxes& added)
        : source_(std::move(source)), added_(added) {
        description_ = source_->description();
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        return source_->shared_files();
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        return source_->files(step);
    }

    core::Result<SourceStep> read(std::size_t step,
                                  const std::vector<core::FieldInfo>& fields) override {
        auto out = source_->read(step, fields);
        // Another kind of mesh than that of the first time-step is reported by who compares them.
        if (out && is_grid(out->blocks))
            out->blocks.front() = with_planes(*out->blocks.front(), added_);
        return out;
    }

    std::optional<std::vector<core::FieldInfo>> fields_at(std::size_t step) override {
        return source_->fields_at(step);
    }

    core::Result<void> describe_by(std::size_t step) override {
        auto described = source_->describe_by(step);
        description_ = source_->description();
        return described;
    }

  private:
    std::unique_ptr<Source> source_;
    PeriodicAxes added_;
};

/// Sums of squared differences of velocities along an axis.
struct PlaneChanges {
    double across = 0.0; ///< of the last plane to the first
    double beside = 0.0; ///< of both to those beside them, half of them

    void add(std::span<const float> velocity, const Size& size, std::size_t axis) {
        const auto last = static_cast<std::size_t>(size[axis] - 1);
        const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(size[0]),
                                                static_cast<std::size_t>(size[0]) *
                                                    static_cast<std::size_t>(size[1])};
        for (std::size_t node = 0; 3 * node < velocity.size(); ++node) {
            if (node / stride[axis] % static_cast<std::size_t>(size[axis]) != 0)
                continue;
            const auto change = [&](std::size_t from, std::size_t to) {
                double sum = 0.0;
                for (std::size_t c = 0; c < 3; ++c) {
                    const double d = double{velocity[3 * (node + to * stride[axis]) + c]} -
                                     double{velocity[3 * (node + from * stride[axis]) + c]};
                    sum += std::isfinite(d) ? d * d : 0.0; // no value is no change
                }
                return sum;
            };
            across += change(last, 0);
            beside += 0.5 * (change(0, 1) + change(last - 1, last));
        }
    }
};

// A plane that comes again is the same but for rounding; one that is missing is about as far on as the next.
constexpr double same = 0.2;
constexpr double next = 4.0;

core::Result<void> check_spacing(vtkDataSet& block, std::size_t axis, const std::string& name) {
    auto* grid = vtkRectilinearGrid::SafeDownCast(&block);
    if (grid == nullptr)
        return {};
    vtkDataArray* const along =
        std::array{grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()}[axis];
    const auto at = [&](vtkIdType i) { return along->GetComponent(i, 0); };
    const vtkIdType last = along->GetNumberOfTuples() - 1;
    const double first_step = at(1) - at(0);
    const double last_step = at(last) - at(last - 1);
    if (std::abs(first_step - last_step) <= 1e-3 * std::max(first_step, last_step))
        return {};
    return core::fail(
        Error::Code::Unsupported,
        name + " does not have its first plane along " + "xyz"[axis] +
            " again as the last one, and its spacing at both ends differs, so that the "
            "period is unknown",
        "write that plane at the end of the period, or leave --periodic out");
}

} // namespace

core::Result<std::string> add_repeated_planes(std::unique_ptr<Source>& source,
                                              const std::vector<std::size_t>& steps,
                                              const FieldChoice& choice,
                                              const PeriodicAxes& axes,
                                              const std::string& name) {
    std::string note;
    if (choice.velocity.arrays.front().source != core::FieldInfo::Source::Point)
        return note;
    std::array<PlaneChanges, 3> changes{};
    SourceStep first;
    for (const std::size_t index : {std::size_t{0}, steps.size() - 1}) {
        auto step = source->read(steps[index], choice.arrays());
        if (!step && index == 0)
            return tl::unexpected(step.error());
        // Those that cannot be read are reported when the import reaches them.
        if (!step || !is_grid(step->blocks))
            break;
        const auto velocity = point_values(step->blocks, choice.velocity);
        if (!velocity)
            break;
        const Size size = points_along(*step->blocks.front());
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (axes[axis] && size[axis] > 1)
                changes[axis].add(*velocity, size, axis);
        if (index == 0)
            first = std::move(*step);
        if (steps.size() == 1)
            break;
    }
    if (first.blocks.empty())
        return note;
    PeriodicAxes added{};
    PeriodicAxes there{};
    PeriodicAxes unclear{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!axes[axis])
            continue;
        const double across = std::sqrt(changes[axis].across);
        const double beside = std::sqrt(changes[axis].beside);
        if (across <= same * beside) {
            (beside > 0.0 ? there : unclear)[axis] = true;
            continue;
        }
        if (across > next * beside)
            return core::fail(Error::Code::InvalidArgument,
                              "--periodic: " + name + " does not repeat along " + "xyz"[axis] +
                                  ": the velocity changes " + length_text(across / beside, 2) +
                                  " times as much from its last plane of nodes to the first as "
                                  "from these to the next",
                              "leave that axis out");
        added[axis] = true;
        if (auto even = check_spacing(*first.blocks.front(), axis, name); !even)
            return tl::unexpected(even.error());
    }
    if (core::any(there))
        add_note(note, "the flow repeats along " + core::axes_text(there) +
                           ": the last plane of nodes is the first again");
    if (core::any(unclear))
        add_note(note, "the flow repeats along " + core::axes_text(unclear) +
                           ": it does not change at either end, and the last plane of nodes is "
                           "taken for the first again");
    if (!core::any(added))
        return note;
    add_note(
        note,
        "the flow repeats along " + core::axes_text(added) +
            ": the last plane of nodes is not the first again, so that one is added behind it");
    source = std::make_unique<RepeatedSource>(std::move(source), added);
    return note;
}

} // namespace wakesurf::importer
