#include "server/import/image_file.hpp"

#include "core/dataset/store_grid.hpp"
#include "server/import/image_header.hpp"
#include "server/import/vtk_messages.hpp"

#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

namespace wakesurf::server {

using core::Error;
using core::FieldInfo;

namespace {

enum class Arrays { None, All, Chosen };

core::Result<core::UniformGrid> grid_of(vtkXMLImageDataReader& reader, const std::string& name) {
    vtkInformation* info = reader.GetOutputInformation(0);
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    const double* origin = info->Get(vtkDataObject::ORIGIN());
    const double* spacing = info->Get(vtkDataObject::SPACING());
    if (origin == nullptr || spacing == nullptr)
        return core::fail(Error::Code::Corrupt, name + " has no Origin or Spacing");
    core::UniformGrid grid;
    for (int axis = 0; axis < 3; ++axis) {
        const auto nodes = std::int64_t{extent[2 * axis + 1]} - extent[2 * axis] + 1;
        if (nodes < 2)
            return core::fail(Error::Code::Unsupported,
                              name + " is not three-dimensional: it has " + std::to_string(nodes) +
                                  " nodes along " + "xyz"[axis],
                              "extrude it by one cell first");
        grid.dimensions[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(nodes);
        grid.spacing[axis] = spacing[axis];
        grid.origin[axis] = origin[axis] + extent[2 * axis] * spacing[axis];
    }
    if (const double* direction = info->Get(vtkDataObject::DIRECTION()); direction != nullptr)
        for (int i = 0; i < 9; ++i)
            if (direction[i] != (i % 4 == 0 ? 1.0 : 0.0))
                return core::fail(Error::Code::Unsupported,
                                  name + " is rotated: its Direction is not the identity",
                                  "resample it to an axis-aligned grid first");
    if (auto size = core::check_grid(core::stored_grid(grid)); !size)
        return core::fail(size.error().code, name + ": " + size.error().message);
    return grid;
}

void enable_only(vtkDataArraySelection* selection,
                 FieldInfo::Source source,
                 const FieldChoice* choice) {
    selection->DisableAllArrays();
    if (choice == nullptr)
        return;
    if (choice->velocity.source == source)
        selection->EnableArray(choice->velocity.name.c_str());
    if (choice->mask && choice->mask->source == source)
        selection->EnableArray(choice->mask->name.c_str());
}

struct Image {
    core::UniformGrid grid;
    vtkSmartPointer<vtkImageData> data;
};

core::Result<Image> load_image(const SeriesFile& file, Arrays arrays, const FieldChoice* choice) {
    const VtkMessages messages;
    if (auto sound = check_image_header(file); !sound)
        return tl::unexpected(sound.error());
    auto reader = vtkSmartPointer<vtkXMLImageDataReader>::New();
    reader->SetFileName(file.path.c_str());
    if (reader->CanReadFile(file.path.c_str()) == 0)
        return core::fail(Error::Code::Corrupt, file.name + " is not a VTK image file");
    try {
        reader->UpdateInformation();
        if (auto clean = messages.verdict(file.name); !clean)
            return tl::unexpected(clean.error());
        auto grid = grid_of(*reader, file.name);
        if (!grid)
            return tl::unexpected(grid.error());
        if (arrays != Arrays::All) {
            enable_only(reader->GetPointDataArraySelection(), FieldInfo::Source::Point, choice);
            enable_only(reader->GetCellDataArraySelection(), FieldInfo::Source::Cell, choice);
        }
        reader->Update();
        if (auto clean = messages.verdict(file.name); !clean)
            return tl::unexpected(clean.error());
        return Image{*grid, reader->GetOutput()};
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to read " + file.name);
    }
}

void describe(vtkDataSetAttributes& attributes,
              FieldInfo::Source source,
              std::vector<FieldInfo>& fields) {
    for (int i = 0; i < attributes.GetNumberOfArrays(); ++i) {
        vtkDataArray* array = attributes.GetArray(i);
        if (array == nullptr || array->GetName() == nullptr)
            continue;
        FieldInfo field{array->GetName(), array->GetNumberOfComponents(), source, {0.0, 0.0}, {}};
        double range[2] = {0.0, 0.0};
        array->GetFiniteRange(range, field.components == 1 ? 0 : -1);
        if (range[0] <= range[1])
            field.range = {range[0], range[1]};
        fields.push_back(std::move(field));
    }
}

std::optional<double> time_of(vtkImageData& image) {
    vtkDataArray* time = image.GetFieldData()->GetArray("TimeValue");
    if (time == nullptr || time->GetNumberOfValues() < 1 || !std::isfinite(time->GetTuple1(0)))
        return std::nullopt;
    return time->GetTuple1(0);
}

// The chosen array with one tuple a node; cell values are averaged to the nodes.
core::Result<vtkSmartPointer<vtkDataArray>>
node_array(const Image& image, const FieldInfo& field, const std::string& file) {
    vtkImageData* data = image.data;
    vtkSmartPointer<vtkCellDataToPointData> average;
    if (field.source == FieldInfo::Source::Cell) {
        average = vtkSmartPointer<vtkCellDataToPointData>::New();
        average->SetInputData(data);
        average->Update();
        data = vtkImageData::SafeDownCast(average->GetOutput());
    }
    vtkSmartPointer<vtkDataArray> array =
        data == nullptr ? nullptr : data->GetPointData()->GetArray(field.name.c_str());
    if (array == nullptr)
        return core::fail(Error::Code::NotFound, file + " has no field " + field.name);
    if (array->GetNumberOfComponents() != field.components)
        return core::fail(Error::Code::Corrupt, field.name + " of " + file + " has " +
                                                    std::to_string(array->GetNumberOfComponents()) +
                                                    " components");
    if (static_cast<std::size_t>(array->GetNumberOfTuples()) != image.grid.nodes())
        return core::fail(Error::Code::Corrupt,
                          field.name + " of " + file + " does not have one value a node");
    return array;
}

core::Result<std::vector<std::uint8_t>>
read_mask(vtkDataArray& array, const FieldChoice& choice, const std::string& file) {
    std::vector<std::uint8_t> fluid(static_cast<std::size_t>(array.GetNumberOfTuples()));
    const bool averaged = choice.mask->source == FieldInfo::Source::Cell;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const double value = array.GetTuple1(static_cast<vtkIdType>(i));
        if (value != 0.0 && value != 1.0 && !(averaged && value > 0.0 && value < 1.0))
            return core::fail(
                Error::Code::Corrupt,
                "the mask " + choice.mask->name + " of " + file + " is " + std::to_string(value) +
                    " at node " + std::to_string(i),
                "a mask holds 0 and 1 only; give the field another name if it is none");
        fluid[i] = (value >= 0.5) != choice.mask_marks_solid ? 1 : 0;
    }
    return fluid;
}

core::Result<std::vector<float>> read_velocity(vtkDataArray& array,
                                               const std::vector<std::uint8_t>& fluid,
                                               const std::string& file) {
    const auto nodes = static_cast<std::size_t>(array.GetNumberOfTuples());
    std::vector<float> velocity(3 * nodes);
    auto* floats = vtkFloatArray::FastDownCast(&array);
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto id = static_cast<vtkIdType>(i);
        const bool solid = !fluid.empty() && fluid[i] == 0;
        for (int c = 0; c < 3 && !solid; ++c) {
            const float value = floats != nullptr ? floats->GetTypedComponent(id, c)
                                                  : static_cast<float>(array.GetComponent(id, c));
            if (!std::isfinite(value))
                return core::fail(Error::Code::Corrupt,
                                  "the velocity of " + file + " is not a finite number at node " +
                                      std::to_string(i),
                                  "repair the file, or mark the node as solid in a mask");
            velocity[3 * i + static_cast<std::size_t>(c)] = value;
        }
    }
    return velocity;
}

} // namespace

core::Result<ImageDescription> describe_image(const SeriesFile& file) {
    auto image = load_image(file, Arrays::All, nullptr);
    if (!image)
        return tl::unexpected(image.error());
    ImageDescription out{image->grid, {}, time_of(*image->data)};
    describe(*image->data->GetPointData(), FieldInfo::Source::Point, out.fields);
    describe(*image->data->GetCellData(), FieldInfo::Source::Cell, out.fields);
    return out;
}

core::Result<std::optional<double>> image_time(const SeriesFile& file) {
    return load_image(file, Arrays::None, nullptr).map([](const Image& image) {
        return time_of(*image.data);
    });
}

core::Result<ImageStep> read_image(const SeriesFile& file, const FieldChoice& choice) {
    auto image = load_image(file, Arrays::Chosen, &choice);
    if (!image)
        return tl::unexpected(image.error());
    const VtkMessages messages;
    ImageStep step{image->grid, {}, {}};
    if (choice.mask) {
        auto fluid = node_array(*image, *choice.mask, file.name).and_then([&](const auto& array) {
            return read_mask(*array, choice, file.name);
        });
        if (!fluid)
            return tl::unexpected(fluid.error());
        step.fluid = std::move(*fluid);
    }
    auto velocity = node_array(*image, choice.velocity, file.name).and_then([&](const auto& array) {
        return read_velocity(*array, step.fluid, file.name);
    });
    if (!velocity)
        return tl::unexpected(velocity.error());
    step.velocity = std::move(*velocity);
    return messages.verdict(file.name).map([&] { return std::move(step); });
}

std::array<double, 2> speed_range(const std::vector<float>& velocity,
                                  const std::vector<std::uint8_t>& fluid) {
    double lo = std::numeric_limits<double>::infinity();
    double hi = 0.0;
    for (std::size_t i = 0; i < velocity.size() / 3; ++i) {
        if (!fluid.empty() && fluid[i] == 0)
            continue;
        const double speed = std::hypot(velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]);
        lo = std::min(lo, speed);
        hi = std::max(hi, speed);
    }
    return {std::min(lo, hi), hi};
}

} // namespace wakesurf::server
