#include "importer/sources/openfoam/openfoam_reader.hpp"

#include "core/base/result.hpp"
#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::importer {

namespace fs = std::filesystem;
using core::Error;
using core::FieldInfo;

namespace {

// Checks that a mesh fits into memory, by the lengths of its lists, and that the files that say which cells a
// face lies between name cells that can exist. One number too large makes VTK's reader allocate, or search,
// as many cells.

using File = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

constexpr std::size_t piece_bytes = std::size_t{1} << 16;

/// Holds the beginning of a list of labels: "FoamFile { ... } // comment
/// 12 (".
struct ListHead {
    std::int64_t count = 0;
    std::size_t begin = 0; ///< of the labels in the file
    bool binary = false;
    std::size_t label_bytes = 4;
};

std::optional<ListHead> head_of(gzFile in) {
    std::string text(foam_header_bytes, '\0');
    const int got = ::gzread(in, text.data(), static_cast<unsigned>(text.size()));
    if (got <= 0)
        return std::nullopt;
    text.resize(static_cast<std::size_t>(got));
    std::size_t at = text.find('}', text.find("FoamFile"));
    if (at == std::string::npos || text.find("MSB") < at)
        return std::nullopt;
    const std::string_view header = std::string_view(text).substr(0, at);
    ListHead out;
    out.binary = header.find("binary") != std::string_view::npos;
    out.label_bytes = header.find("label=64") != std::string_view::npos ? 8 : 4;
    for (++at; at < text.size(); ++at) {
        if (text.compare(at, 2, "//") == 0)
            at = text.find('\n', at);
        if (at >= text.size() || text.find_first_of("0123456789", at) == at)
            break;
    }
    if (at >= text.size())
        return std::nullopt;
    const auto [end, error] =
        std::from_chars(text.data() + at, text.data() + text.size(), out.count);
    const auto open =
        text.find_first_not_of(" \t\r\n", static_cast<std::size_t>(end - text.data()));
    if (error != std::errc() || open == std::string::npos || text[open] != '(')
        return std::nullopt;
    out.begin = open + 1;
    return out;
}

// Calls `label` with each; stops if it returns false, and at anything but a label.
template <class Label>
void each_of_text(gzFile in, std::int64_t count, const Label& label) {
    std::vector<char> piece(piece_bytes);
    std::int64_t value = 0;
    bool within = false;
    bool negative = false;
    for (int got = 0; (got = ::gzread(in, piece.data(), piece_bytes)) > 0;)
        for (int i = 0; i < got; ++i) {
            const char c = piece[static_cast<std::size_t>(i)];
            constexpr std::int64_t most = std::int64_t{1} << 50;
            if (c >= '0' && c <= '9') {
                value = std::min(10 * value + (c - '0'), most);
                within = true;
                continue;
            }
            if (within && (!label(negative ? -value : value) || --count == 0))
                return;
            value = 0;
            within = false;
            negative = c == '-';
            if (c != '-' && c != ' ' && c != '\n' && c != '\r' && c != '\t')
                return;
        }
}

template <class Number, class Label>
void each_of_binary(gzFile in, std::int64_t count, const Label& label) {
    std::vector<Number> piece(piece_bytes / sizeof(Number));
    for (int got = 0; count > 0 && (got = ::gzread(in, piece.data(), piece_bytes)) > 0;) {
        const auto numbers = static_cast<std::size_t>(got) / sizeof(Number);
        for (std::size_t i = 0; i < numbers && count > 0; ++i, --count)
            if (!label(static_cast<std::int64_t>(piece[i])))
                return;
    }
}

// Reads the files of a polyMesh folder, plain or compressed, text or binary, piece by piece. Any other form is left
// to VTK. Error: Corrupt, OverLimit; Unsupported for directives, which VTK would follow to any file. @param name  of the folder in messages
core::Result<void> check_foam_cells(const fs::path& mesh, const std::string& name) {
    constexpr std::array<std::pair<const char*, std::uint64_t>, 4> lists{
        {{"points", 3 * sizeof(float)}, {"faces", 4}, {"owner", 4}, {"neighbour", 4}}};
    for (const char* each : {"points", "faces", "owner", "neighbour", "boundary"})
        if (const auto file = foam_file(mesh / each); file && has_directive(*file))
            return core::fail(core::Error::Code::Unsupported,
                              name + "/" + each +
                                  " has a directive (#include ...), which is not followed",
                              "write out what it stands for");
    for (const auto& [list, bytes] : lists) {
        const auto file = foam_file(mesh / list);
        const File in(file ? ::gzopen(file->c_str(), "rb") : nullptr, ::gzclose);
        const auto head = in ? head_of(in.get()) : std::nullopt;
        if (!head)
            continue; // VTK reports it
        const auto count = static_cast<std::uint64_t>(std::max<std::int64_t>(head->count, 0));
        if (auto fits = check_claim(name + "/" + list, count, bytes); !fits)
            return fits;
    }
    std::int64_t faces = 0;
    for (const char* list : {"owner", "neighbour"}) {
        const auto file = foam_file(mesh / list);
        const File in(file ? ::gzopen(file->c_str(), "rb") : nullptr, ::gzclose);
        const auto head = in ? head_of(in.get()) : std::nullopt;
        if (!head || ::gzseek(in.get(), static_cast<z_off_t>(head->begin), SEEK_SET) < 0)
            return {};
        if (faces == 0)
            faces = head->count; // each has an owner
        // A cell has four faces at least, and a face lies between two cells at most.
        const std::int64_t most = faces / 2;
        std::optional<std::int64_t> wrong;
        const auto fits = [&](std::int64_t cell) {
            if (cell >= most ||
                cell < -1) // -1: older versions write it where there is no neighbour
                wrong = cell;
            return !wrong;
        };
        if (!head->binary)
            each_of_text(in.get(), head->count, fits);
        else if (head->label_bytes == 8)
            each_of_binary<std::int64_t>(in.get(), head->count, fits);
        else
            each_of_binary<std::int32_t>(in.get(), head->count, fits);
        if (wrong)
            return core::fail(core::Error::Code::Corrupt,
                              name + "/" + list + " is damaged: it names cell " +
                                  std::to_string(*wrong) + ", and " + std::to_string(faces) +
                                  " faces bound " + std::to_string(most) + " cells at most",
                              "copy the mesh again");
    }
    return {};
}

// Returns the values of a patch's own entry, else of a group it is in, else of all patches.
std::span<const float>
values_on(const FoamValues& values, const std::string& patch, const FoamRegion& region) {
    std::vector<std::string> entries{patch};
    if (const auto groups = region.groups.find(patch); groups != region.groups.end())
        entries.insert(entries.end(), groups->second.begin(), groups->second.end());
    entries.emplace_back(".*");
    for (const auto& entry : entries)
        if (const auto found = values.patches.find(entry); found != values.patches.end())
            return found->second;
    return {};
}

// Says whether no cell owns a face: decomposePar leaves such meshes where there are more processors than it
// fills.
bool has_no_cells(const fs::path& mesh) {
    const auto file = foam_file(mesh / "owner");
    const File in(file ? ::gzopen(file->c_str(), "rb") : nullptr, ::gzclose);
    const auto head = in ? head_of(in.get()) : std::nullopt;
    return head && head->count == 0;
}

// Gives faces of a patch that states no value one that is no number, so that they are no wall at rest.
core::Result<void> add_array(const Leaf& leaf,
                             const FoamRegion& region,
                             const FieldInfo& field,
                             const FoamValues& values,
                             const std::string& file) {
    constexpr std::array none{std::nanf("")};
    auto given = is_inside(leaf) ? std::span<const float>(values.inside)
                                 : values_on(values, leaf.name(), region);
    if (given.empty() && !is_inside(leaf))
        given = none;
    const auto wanted = static_cast<std::size_t>(leaf.data->GetNumberOfCells() * field.components);
    const bool one_for_all = given.size() == static_cast<std::size_t>(field.components);
    if (given.size() != wanted && !one_for_all && given.data() != none.data())
        return core::fail(Error::Code::Corrupt,
                          file + " has other than " +
                              std::to_string(leaf.data->GetNumberOfCells()) + " values of " +
                              (is_inside(leaf) ? std::string("the cells") : leaf.name()),
                          "copy the case again");
    const auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(field.name.c_str());
    array->SetNumberOfComponents(field.components);
    array->SetNumberOfTuples(leaf.data->GetNumberOfCells());
    for (std::size_t i = 0; i < wanted; ++i)
        array->SetValue(static_cast<vtkIdType>(i), given[i % given.size()]);
    leaf.data->GetCellData()->AddArray(array);
    return {};
}

} // namespace

bool is_inside(const Leaf& leaf) {
    return leaf.name() == "internalMesh";
}

std::string region_of(const Leaf& leaf) {
    const std::size_t own_names = is_inside(leaf) ? 1 : 2;
    const std::string region = leaf.path.size() > own_names ? leaf.path.front() : "";
    return region == "defaultRegion" ? "" : region;
}

OpenfoamReader::OpenfoamReader(const FoamCase& found, std::string part)
    : found_(found), part_(std::move(part)) {}

bool OpenfoamReader::has_cells() const {
    return std::any_of(found_.regions.begin(), found_.regions.end(), [&](const FoamRegion& region) {
        return !has_no_cells(
            (found_.folder / found_.mesh_file(part_, region.name, "owner")).parent_path());
    });
}

// A part may have no cells in one region and some in others, which VTK hands out nonetheless.
std::vector<std::string> OpenfoamReader::expected_messages() const {
    const bool empty =
        std::any_of(found_.regions.begin(), found_.regions.end(), [&](const FoamRegion& region) {
            return has_no_cells(
                (found_.folder / found_.mesh_file(part_, region.name, "owner")).parent_path());
        });
    return empty ? std::vector<std::string>{"The mesh contains no cells",
                                            "returned failure for request"}
                 : std::vector<std::string>();
}

// VTK ignores missing fields.
core::Result<void> OpenfoamReader::check_files(const FoamTime& time,
                                               const std::vector<FieldInfo>& fields) const {
    for (const auto& region : found_.regions) {
        if (!region.fluid)
            continue;
        for (const auto& field : fields) {
            const auto file =
                found_.file_at(found_.relative(part_, time.name, region.name, field.name));
            const auto header = read_foam_header(file.path);
            if (!foam_file(file.path))
                return core::fail(Error::Code::NotFound, found_.file + " has no " + file.name,
                                  "leave the field or the time out, or restore the file");
            if (!header)
                return core::fail(Error::Code::Corrupt,
                                  file.name + " of " + found_.file + " is not an OpenFOAM file");
            const auto bytes = sizeof(float) * static_cast<std::uint64_t>(field.components);
            if (auto fits = check_claim(file.name, header->values, bytes); !fits)
                return fits;
        }
    }
    return {};
}

// VTK looks at the headers of all files at a time, whatever is asked for, and follows what they include.
core::Result<void> OpenfoamReader::check_headers(const std::string& time) const {
    constexpr auto options = fs::directory_options::follow_directory_symlink |
                             fs::directory_options::skip_permission_denied;
    const fs::path folder = found_.folder / part_ / time;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, options, error), end;
         !error && entry != end; entry.increment(error))
        if (entry->is_regular_file(error) && has_include_in_header(entry->path()))
            return core::fail(Error::Code::Unsupported,
                              entry->path().lexically_relative(found_.folder).string() + " of " +
                                  found_.file + " has an #include, which is not followed",
                              "write out what it stands for, or move the file away");
    return {};
}

core::Result<void> OpenfoamReader::open(const std::string& what) {
    const auto times = list_foam_times(found_.folder / part_, part_);
    if (!times)
        return tl::unexpected(times.error());
    constexpr std::size_t begun_with = 2; // by VTK
    for (std::size_t i = 0; i < std::min(begun_with, times->size()); ++i)
        if (auto plain = check_headers((*times)[i].name); !plain)
            return plain;
    for (const auto& region : found_.regions) {
        const auto mesh =
            std::filesystem::path(found_.mesh_file(part_, region.name, "owner")).parent_path();
        if (auto sound = check_foam_cells(found_.folder / mesh, mesh.string()); !sound)
            return sound;
    }
    const VtkMessages messages(expected_messages());
    reader_ = vtkSmartPointer<vtkOpenFOAMReader>::New();
    reader_->SetFileName((found_.folder / part_ / "case.foam").c_str()); // only its folder counts
    reader_->CreateCellToPointOff();
    reader_->DecomposePolyhedraOff();
    reader_->CacheMeshOn();
    reader_->SkipZeroTimeOff();
    reader_->ReadZonesOff();
    reader_->UpdateInformation();
    if (auto clean = messages.verdict(what); !clean)
        return clean;
    choose_patches();
    return {};
}

void OpenfoamReader::choose_patches() {
    reader_->DisableAllPatchArrays();
    reader_->DisableAllPointArrays();
    reader_->DisableAllCellArrays();
    reader_->DisableAllLagrangianArrays();
    for (const auto& region : found_.regions) {
        const std::string prefix = region.name.empty() ? "" : "/" + region.name + "/";
        if (region.fluid) {
            reader_->SetPatchArrayStatus((prefix + "internalMesh").c_str(), 1);
            for (const auto& wall : region.walls)
                reader_->SetPatchArrayStatus((prefix + "patch/" + wall).c_str(), 1);
            for (const auto& other : region.others)
                reader_->SetPatchArrayStatus((prefix + "patch/" + other).c_str(), 1);
            for (const auto& wedge : region.wedges)
                reader_->SetPatchArrayStatus((prefix + "patch/" + wedge).c_str(), 1);
            for (const auto& [cyclic, other] : region.cyclic)
                reader_->SetPatchArrayStatus((prefix + "patch/" + cyclic).c_str(), 1);
            continue;
        }
        for (int i = 0; i < reader_->GetNumberOfPatchArrays(); ++i)
            if (const std::string name = reader_->GetPatchArrayName(i);
                name.starts_with(prefix + "patch/") &&
                name.find("procBoundary") == std::string::npos)
                reader_->SetPatchArrayStatus(name.c_str(), 1);
    }
}

core::Result<void> OpenfoamReader::add_values(const FoamTime& time,
                                              const std::vector<FieldInfo>& fields,
                                              std::vector<Leaf>& leaves) const {
    for (const auto& region : found_.regions)
        for (const auto& field : fields) {
            if (!region.fluid)
                continue;
            const auto file =
                found_.file_at(found_.relative(part_, time.name, region.name, field.name));
            const std::string name = file.name + " of " + found_.file;
            const auto values = read_foam_values(file.path, name, field.components);
            if (!values)
                return tl::unexpected(values.error());
            for (auto& leaf : leaves)
                if (region_of(leaf) == region.name && !region.others.contains(leaf.name()))
                    if (auto added = add_array(leaf, region, field, *values, name); !added)
                        return added;
        }
    return {};
}

core::Result<std::vector<Leaf>> OpenfoamReader::read(const FoamTime& time,
                                                     const std::vector<FieldInfo>& fields) {
    const std::string what =
        "time-step " + time.name + " of " + found_.file + (part_.empty() ? "" : " (" + part_ + ")");
    if (auto there = check_files(time, fields); !there)
        return tl::unexpected(there.error());
    const auto give_up = [&](Error error) {
        reader_ = nullptr; // or it would go on with half a mesh
        const std::string folder = (found_.folder / "").string();
        for (auto at = error.message.find(folder); at != std::string::npos;
             at = error.message.find(folder))
            error.message.erase(at, folder.size());
        return tl::unexpected(std::move(error));
    };
    try {
        if (auto plain = check_headers(time.name); !plain)
            return give_up(plain.error());
        if (reader_ == nullptr)
            if (auto opened = open(what); !opened)
                return give_up(opened.error());
        const VtkMessages messages(expected_messages());
        reader_->UpdateTimeStep(time.value); // SetTimeValue and Update give the first one again
        if (auto clean = messages.verdict(what); !clean)
            return give_up(clean.error());
        if (reader_->GetTimeValue() != time.value)
            return give_up({Error::Code::NotFound, what + " is not there any more", {}});
        auto leaves = leaves_of(reader_->GetOutput());
        for (auto& leaf : leaves) {
            auto copy = vtkSmartPointer<vtkDataSet>::Take(leaf.data->NewInstance());
            copy->ShallowCopy(leaf.data);
            leaf.data = copy;
        }
        if (auto added = add_values(time, fields, leaves); !added)
            return give_up(added.error());
        return leaves;
    } catch (const std::bad_alloc&) {
        return give_up({Error::Code::OverLimit, "there is not enough memory to read " + what, {}});
    }
}

} // namespace wakesurf::importer
