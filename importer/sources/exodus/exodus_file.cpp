#include "importer/sources/exodus/exodus_file.hpp"

#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/files/netcdf_size.hpp"
#include "importer/sources/files/source_files.hpp"

#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtk_exodusII.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <new>
#include <optional>
#include <string_view>

namespace wakesurf::importer {

namespace fs = std::filesystem;
using core::Error;
using core::FieldInfo;

namespace {

// Takes digits behind `mark` from the end of a name.
std::optional<unsigned> take_number(std::string& name, std::string_view mark) {
    const auto at = name.rfind(mark);
    if (at == std::string::npos || at == 0)
        return std::nullopt;
    unsigned number = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + at + mark.size(), end, number);
    if (error != std::errc() || stop != end || at + mark.size() == name.size())
        return std::nullopt;
    name.resize(at);
    return number;
}

using Pieces = std::map<unsigned, NamedFile>;

core::Result<std::vector<NamedFile>> whole(const Pieces& pieces, const ExodusName& of) {
    std::vector<NamedFile> out;
    for (unsigned i = 0; i < std::max(of.pieces, 1u); ++i) {
        const auto piece = pieces.find(i);
        if (piece == pieces.end()) {
            std::string missing = std::to_string(i);
            const std::string count = std::to_string(of.pieces);
            missing.insert(0, count.size() - std::min(count.size(), missing.size()), '0');
            return core::fail(Error::Code::NotFound,
                              pieces.begin()->second.name + " is one of " + count +
                                  " pieces, and " + of.base + of.of_restart + "." + count + "." +
                                  missing + " is not there",
                              "copy all pieces, or join them with epu");
        }
        out.push_back(piece->second);
    }
    return out;
}

} // namespace

ExodusName exodus_name(const std::string& name) {
    ExodusName out{name};
    if (auto base = name; const auto piece = take_number(base, "."))
        if (const auto pieces = take_number(base, "."); pieces && *piece < *pieces) {
            out.base = base;
            out.pieces = *pieces;
            out.piece = *piece;
        }
    if (auto base = out.base; const auto restart = take_number(base, "-s")) {
        out.of_restart = out.base.substr(base.size());
        out.base = base;
        out.restart = *restart;
    }
    return out;
}

core::Result<ExodusSet> find_exodus_set(const fs::path& path, bool alone) {
    const ExodusName wanted = exodus_name(path.filename().string());
    std::map<unsigned, std::pair<ExodusName, Pieces>> restarts;
    std::error_code error;
    const fs::path folder = path.parent_path();
    for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error), end;
         !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        const ExodusName here = exodus_name(name);
        if (here.base != wanted.base || here.pieces != wanted.pieces ||
            (alone && here.restart != wanted.restart))
            continue;
        if (name != path.filename().string())
            if (auto inside = named_path(folder, name, "the run of " + path.filename().string());
                !inside)
                return tl::unexpected(inside.error());
        auto& [of, pieces] = restarts[here.restart];
        of = here;
        pieces.insert_or_assign(here.piece, NamedFile{folder / name, name});
    }
    if (error)
        return core::fail(Error::Code::Io, "the folder of " + path.filename().string() +
                                               " cannot be listed: " + error.message());
    ExodusSet out{fs::path(wanted.base).stem().string(), {}, {}};
    unsigned before = 0;
    for (const auto& [number, restart] : restarts) {
        auto pieces = whole(restart.second, restart.first);
        if (!pieces)
            return tl::unexpected(pieces.error());
        if (before > 0 && number != before + 1)
            add_note(out.note, "no file of " + wanted.base + " between " +
                                   out.parts.back().front().name + " and " + pieces->front().name);
        before = number;
        out.parts.push_back(std::move(*pieces));
    }
    if (out.parts.empty())
        return core::fail(Error::Code::NotFound, path.filename().string() + " is not there");
    return out;
}

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

} // namespace

core::Result<std::vector<double>> ExodusFile::open() {
    if (auto complete = check_netcdf_size(file_); !complete)
        return tl::unexpected(complete.error());
    if (auto readable = open_reader(); !readable)
        return tl::unexpected(readable.error());
    vtkInformation* info = reader_->GetOutputInformation(0);
    const int steps = info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    const double* times = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    return std::vector<double>(times, times + steps);
}

std::vector<std::string> ExodusFile::displacements() const {
    std::vector<std::string> out;
    for (int i = 0; i < reader_->GetNumberOfPointResultArrays(); ++i)
        if (std::string name = reader_->GetPointResultArrayName(i);
            lower_case(name).starts_with("displ"))
            out.push_back(std::move(name));
    return out;
}

std::string ExodusFile::step_name(std::size_t step) const {
    return "time-step " + std::to_string(step) + " of " + file_.name;
}

core::Result<void> ExodusFile::open_reader() {
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
core::Result<void> ExodusFile::check_sizes() const {
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
    constexpr std::uint64_t bytes_an_element = 5 * sizeof(vtkIdType); // of a tetrahedron, the least
    const auto count = [](std::int64_t number) {
        return static_cast<std::uint64_t>(std::max<std::int64_t>(number, 0));
    };
    return check_claim(file_.name, count(sizes.num_nodes), 3 * sizeof(double)).and_then([&] {
        return check_claim(file_.name, count(sizes.num_elem), bytes_an_element);
    });
}

void ExodusFile::choose_fields(const std::vector<FieldInfo>* fields) {
    const auto wanted = [&](FieldInfo::Source source, const std::string& name) {
        return fields == nullptr ||
               std::any_of(fields->begin(), fields->end(), [&](const FieldInfo& field) {
                   return field.source == source && field.name == name;
               });
    };
    for (int i = 0; i < reader_->GetNumberOfPointResultArrays(); ++i) {
        const char* name = reader_->GetPointResultArrayName(i);
        reader_->SetPointResultArrayStatus(name, wanted(FieldInfo::Source::Point, name) ? 1 : 0);
    }
    for (int i = 0; i < reader_->GetNumberOfElementResultArrays(); ++i) {
        const char* name = reader_->GetElementResultArrayName(i);
        reader_->SetElementResultArrayStatus(name, wanted(FieldInfo::Source::Cell, name) ? 1 : 0);
    }
}

core::Result<SourceStep>
ExodusFile::read(std::size_t step, const std::vector<FieldInfo>* fields, bool plane) {
    const std::string what = step_name(step);
    if (auto complete = check_netcdf_size(file_); !complete)
        return tl::unexpected(complete.error());
    try {
        if (reader_ == nullptr)
            if (auto readable = open_reader(); !readable)
                return give_up(readable.error());
        choose_fields(fields);
        const VtkMessages messages;
        reader_->SetTimeStep(static_cast<int>(step)); // either of two with one time
        reader_->Update();
        if (auto clean = messages.verdict(what); !clean)
            return give_up(clean.error());
        return take(fields, plane);
    } catch (const std::bad_alloc&) {
        return give_up({Error::Code::OverLimit, "there is not enough memory to read " + what, {}});
    }
}

tl::unexpected<Error> ExodusFile::give_up(Error error) {
    reader_ = nullptr;
    const std::string folder = file_.path.parent_path().string() + "/";
    for (auto at = error.message.find(folder); folder != "/" && at != std::string::npos;
         at = error.message.find(folder))
        error.message.erase(at, folder.size());
    return tl::unexpected(std::move(error));
}

core::Result<SourceStep> ExodusFile::take(const std::vector<FieldInfo>* fields, bool plane) const {
    SourceStep out;
    for (const auto& leaf : leaves_of(reader_->GetOutput())) {
        auto data = vtkSmartPointer<vtkDataSet>::Take(leaf.data->NewInstance());
        data->ShallowCopy(leaf.data);
        const bool of_elements = leaf.path.front() == "Element Blocks";
        if (data->GetNumberOfCells() == 0)
            continue; // as pieces have of blocks that lie elsewhere
        if (plane) {
            if (!of_elements || !is_flat(*data))
                continue; // an edge
            auto slab = fluid_part(*data, file_.name);
            if (!slab)
                return tl::unexpected(slab.error());
            out.blocks.push_back(std::move(*slab));
        } else if (leaf.path.front() == "Side Sets" ||
                   (of_elements && is_called_wall(leaf.name()) && is_flat(*data))) {
            const auto faces = faces_of(*data);
            out.walls.push_back(
                {faces, fields != nullptr && stands_still(*faces, *fields), leaf.name()});
        } else if (of_elements && is_solid_shape(*data)) {
            out.blocks.push_back(data);
        }
    }
    return out;
}

} // namespace wakesurf::importer
