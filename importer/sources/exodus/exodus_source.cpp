#include "importer/base/lower_case.hpp"
#include "importer/base/notes.hpp"
#include "importer/base/process_memory.hpp"
#include "importer/base/vtk_messages.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/blocks/wall_patches.hpp"
#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/files/netcdf_size.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/series/series_times.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtk_exodusII.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <new>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

bool is_called_wall(const std::string& name) {
    return lower_case(name).find("wall") != std::string::npos;
}

bool is_solid_shape(vtkDataSet& data) {
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i)
        if (data.GetCell(i)->GetCellDimension() != 3)
            return false;
    return true;
}

bool is_flat(vtkDataSet& data) {
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i)
        if (data.GetCell(i)->GetCellDimension() != 2)
            return false;
    return true;
}

class ExodusSource final : public Source {
  public:
    ExodusSource(const fs::path& path, std::string velocity)
        : file_{path, path.filename().string()}, velocity_(std::move(velocity)) {
        description_.name = path.stem().string();
        description_.reader = "vtkExodusIIReader (Exodus II)";
    }

    core::Result<void> open() {
        if (auto complete = check_netcdf_size(file_); !complete)
            return complete;
        if (auto readable = open_reader(); !readable)
            return readable;
        vtkInformation* info = reader_->GetOutputInformation(0);
        const int steps = info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
        const double* times = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
        std::vector<TimedEntry> entries;
        for (int i = 0; i < steps; ++i)
            entries.push_back({step_name(static_cast<std::size_t>(i)), times[i]});
        if (entries.empty())
            entries.push_back({step_name(0), std::nullopt});
        auto order = describe_times(std::move(entries), description_);
        if (!order)
            return tl::unexpected(order.error());
        order_ = std::move(*order);
        if (steps == 0)
            description_.time_note = "the file has no times";
        for (int i = 0; i < reader_->GetNumberOfPointResultArrays(); ++i)
            if (std::string name = reader_->GetPointResultArrayName(i);
                name.starts_with("DISPL") || name.starts_with("displ") || name.starts_with("Displ"))
                add_note(description_.note, "the displacements " + name + " are not applied");
        const auto first = load(0, nullptr);
        if (!first)
            return tl::unexpected(first.error());
        BlockRoles roles = block_roles(first->blocks, velocity_);
        solid_ = std::move(roles.fluid);
        solid_.flip();
        description_.fields = std::move(roles.fields);
        add_note(description_.note, roles.note);
        return {};
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        return fingerprint({file_});
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t) const override {
        return std::vector<store::SourceFile>{};
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        if (auto complete = check_netcdf_size(file_); !complete)
            return tl::unexpected(complete.error());
        return load(step, &fields);
    }

  private:
    core::Result<void> open_reader() {
        const VtkMessages messages;
        ex_opts(0); // the library prints by itself; VTK says the same
        reader_ = vtkSmartPointer<vtkExodusIIReader>::New();
        if (reader_->CanReadFile(file_.path.c_str()) == 0)
            return core::fail(Error::Code::Corrupt,
                              file_.name + " is not an Exodus II file, or is damaged");
        if (auto fits = check_sizes(); !fits)
            return fits;
        reader_->SetFileName(file_.path.c_str());
        reader_->SetApplyDisplacements(0);
        reader_->SetGenerateObjectIdCellArray(0);
        reader_->SetGenerateGlobalElementIdArray(0);
        reader_->SetGenerateGlobalNodeIdArray(0);
        reader_->UpdateInformation();
        if (auto clean = messages.verdict(file_.name); !clean)
            return clean;
        for (int i = 0; i < reader_->GetNumberOfElementBlockArrays(); ++i)
            reader_->SetElementBlockArrayStatus(reader_->GetElementBlockArrayName(i), 1);
        for (int i = 0; i < reader_->GetNumberOfSideSetArrays(); ++i)
            if (is_called_wall(reader_->GetSideSetArrayName(i)))
                reader_->SetSideSetArrayStatus(reader_->GetSideSetArrayName(i), 1);
        return {};
    }

    // Checks the numbers of nodes and elements in the header: VTK takes memory for all of them at once.
    core::Result<void> check_sizes() const {
        int word = 8;
        int stored = 0;
        float version = 0.0F;
        const int file = ex_open(file_.path.c_str(), EX_READ, &word, &stored, &version);
        if (file < 0)
            return {}; // VTK reports it
        ex_set_int64_status(file, EX_ALL_INT64_API);
        ex_init_params sizes{};
        const bool known = ex_get_init_ext(file, &sizes) >= 0;
        ex_close(file);
        if (!known)
            return {};
        constexpr std::uint64_t bytes_an_element =
            5 * sizeof(vtkIdType); // of a tetrahedron, the least
        const auto count = [](std::int64_t number) {
            return static_cast<std::uint64_t>(std::max<std::int64_t>(number, 0));
        };
        return check_claim(file_.name, count(sizes.num_nodes), 3 * sizeof(double)).and_then([&] {
            return check_claim(file_.name, count(sizes.num_elem), bytes_an_element);
        });
    }

    void choose_fields(const std::vector<FieldInfo>* fields) {
        const auto wanted = [&](FieldInfo::Source source, const std::string& name) {
            return fields == nullptr ||
                   std::any_of(fields->begin(), fields->end(), [&](const FieldInfo& field) {
                       return field.source == source && field.name == name;
                   });
        };
        for (int i = 0; i < reader_->GetNumberOfPointResultArrays(); ++i) {
            const char* name = reader_->GetPointResultArrayName(i);
            reader_->SetPointResultArrayStatus(name,
                                               wanted(FieldInfo::Source::Point, name) ? 1 : 0);
        }
        for (int i = 0; i < reader_->GetNumberOfElementResultArrays(); ++i) {
            const char* name = reader_->GetElementResultArrayName(i);
            reader_->SetElementResultArrayStatus(name,
                                                 wanted(FieldInfo::Source::Cell, name) ? 1 : 0);
        }
    }

    std::string step_name(std::size_t in_file) const {
        return "time-step " + std::to_string(in_file) + " of " + file_.name;
    }

    core::Result<SourceStep> load(std::size_t step, const std::vector<FieldInfo>* fields) {
        const std::string what = step_name(order_.at(step));
        try {
            if (reader_ == nullptr)
                if (auto readable = open_reader(); !readable)
                    return give_up(readable.error());
            choose_fields(fields);
            const VtkMessages messages;
            reader_->SetTimeStep(static_cast<int>(order_[step])); // either of two with one time
            reader_->Update();
            if (auto clean = messages.verdict(what); !clean)
                return give_up(clean.error());
            return take(what, fields);
        } catch (const std::bad_alloc&) {
            return give_up(
                {Error::Code::OverLimit, "there is not enough memory to read " + what, {}});
        }
    }

    tl::unexpected<Error> give_up(Error error) {
        reader_ = nullptr;
        const std::string folder = file_.path.parent_path().string() + "/";
        for (auto at = error.message.find(folder); folder != "/" && at != std::string::npos;
             at = error.message.find(folder))
            error.message.erase(at, folder.size());
        return tl::unexpected(std::move(error));
    }

    core::Result<SourceStep> take(const std::string& what, const std::vector<FieldInfo>* fields) {
        SourceStep out;
        std::size_t block = 0;
        for (const auto& leaf : leaves_of(reader_->GetOutput())) {
            auto data = vtkSmartPointer<vtkDataSet>::Take(leaf.data->NewInstance());
            data->ShallowCopy(leaf.data);
            const bool of_elements = leaf.path.front() == "Element Blocks";
            if (leaf.path.front() == "Side Sets" ||
                (of_elements && is_called_wall(leaf.name()) && is_flat(*data))) {
                const auto faces = faces_of(*data);
                out.walls.push_back({faces, fields != nullptr && stands_still(*faces, *fields)});
                continue;
            }
            if (!of_elements || !is_solid_shape(*data))
                continue;
            if (fields != nullptr && block < solid_.size() && solid_[block++]) {
                out.solids.push_back(boundary_of(*data));
                continue;
            }
            if (fields != nullptr) {
                if (auto whole = require_fields(*data, *fields, what); !whole)
                    return tl::unexpected(whole.error());
                keep_only(*data, *fields);
            }
            out.blocks.push_back(data);
        }
        if (out.blocks.empty())
            return core::fail(Error::Code::Unsupported,
                              file_.name + " has no block of three-dimensional elements");
        return out;
    }

    NamedFile file_;
    std::string velocity_; ///< asked for; may be empty
    vtkSmartPointer<vtkExodusIIReader> reader_;
    std::vector<std::size_t> order_; ///< of each time its place in the file
    std::vector<bool> solid_; ///< of each block of three-dimensional elements: without the velocity
};

} // namespace

bool is_exodus(const fs::path& path) {
    constexpr std::array<const char*, 7> endings{".exo", ".exii", ".ex2",  ".e",
                                                 ".g",   ".gen",  ".exoii"};
    const std::string ending = lower_extension(path);
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
        return false;
    // Plot3D calls its grids .g as well: the signature of netCDF or HDF5 tells them apart.
    std::array<char, 4> start{};
    std::ifstream(path, std::ios::binary).read(start.data(), start.size());
    const std::string_view signature(start.data(), start.size());
    return ending != ".g" || signature.starts_with("CDF") || signature == "\x89HDF";
}

Opened open_exodus(const fs::path& path, const command::SourceOptions& wish) {
    return opened<ExodusSource>(path, wish.velocity);
}

} // namespace wakesurf::importer
