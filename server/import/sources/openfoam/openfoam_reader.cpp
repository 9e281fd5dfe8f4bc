#include "server/import/sources/openfoam/openfoam_reader.hpp"

#include "server/import/sources/openfoam/openfoam_cells.hpp"
#include "server/import/sources/openfoam/openfoam_file.hpp"
#include "server/import/sources/openfoam/openfoam_times.hpp"
#include "server/import/vtk_messages.hpp"

#include <vtkMultiBlockDataSet.h>

#include <algorithm>
#include <new>

namespace wakesurf::server {

using core::Error;
using core::FieldInfo;

OpenfoamReader::OpenfoamReader(const FoamCase& found, std::string part)
    : found_(found), part_(std::move(part)) {}

// VTK passes over a field that is not there, and takes a field's name from inside the file: a copy beside it would be
// read over it.
core::Result<void> OpenfoamReader::check_files(const FoamTime& time,
                                               const std::vector<FieldInfo>& fields) const {
    for (const auto& region : found_.regions) {
        if (!region.fluid)
            continue;
        const auto folder = found_.folder / found_.relative(part_, time.name, region.name, "");
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
            if (header->object != field.name)
                return core::fail(Error::Code::Unsupported,
                                  file.name + " of " + found_.file + " says it is the field '" +
                                      header->object + "'",
                                  "write `object " + field.name + ";` into its header");
        }
        for (const auto& field : fields) {
            const auto file =
                found_.file_at(found_.relative(part_, time.name, region.name, field.name));
            if (const auto header = read_foam_header(file.path); header && !header->words.empty())
                return core::fail(Error::Code::Unsupported,
                                  file.name + " of " + found_.file +
                                      " has its dimensions in words, " + header->words +
                                      ", which VTK's reader cannot read",
                                  "write them as numbers: [0 1 -1 0 0 0 0] for a velocity in m/s");
        }
        for (const auto& name : foam_fields(folder)) {
            const auto same = [&](const FieldInfo& field) { return field.name == name; };
            const auto other = foam_file(folder / name);
            if (!other || std::any_of(fields.begin(), fields.end(), same))
                continue;
            const auto header = read_foam_header(*other);
            for (const auto& field : fields)
                if (header && header->object == field.name)
                    return core::fail(Error::Code::Unsupported,
                                      found_.relative(part_, time.name, region.name, name) +
                                          " of " + found_.file + " says it is the field " +
                                          field.name + ", as the file of that name does",
                                      "move it out of the time folder");
        }
    }
    return {};
}

core::Result<void> OpenfoamReader::open(const std::string& what) {
    for (const auto& region : found_.regions) {
        const auto mesh =
            std::filesystem::path(found_.mesh_file(part_, region.name, "owner")).parent_path();
        if (auto sound = check_foam_cells(found_.folder / mesh, mesh.string()); !sound)
            return sound;
    }
    const VtkMessages messages;
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
    reader_->DisableAllLagrangianArrays();
    for (const auto& region : found_.regions) {
        const std::string prefix = region.name.empty() ? "" : "/" + region.name + "/";
        if (region.fluid) {
            reader_->SetPatchArrayStatus((prefix + "internalMesh").c_str(), 1);
            for (const auto& wall : region.walls)
                reader_->SetPatchArrayStatus((prefix + "patch/" + wall).c_str(), 1);
            continue;
        }
        for (int i = 0; i < reader_->GetNumberOfPatchArrays(); ++i)
            if (const std::string name = reader_->GetPatchArrayName(i);
                name.starts_with(prefix + "patch/") &&
                name.find("procBoundary") == std::string::npos)
                reader_->SetPatchArrayStatus(name.c_str(), 1);
    }
}

// What VTK meets first at a later time it would read unasked, unless it is known as not wanted.
void OpenfoamReader::choose_fields(const FoamTime& time, const std::vector<FieldInfo>& fields) {
    for (const auto& region : found_.regions)
        for (const auto& name :
             foam_fields(found_.folder / found_.relative(part_, time.name, region.name, ""))) {
            const bool wanted =
                std::any_of(fields.begin(), fields.end(),
                            [&](const FieldInfo& field) { return field.name == name; });
            reader_->SetPointArrayStatus(name.c_str(), 0);
            if ((reader_->GetCellArrayStatus(name.c_str()) != 0) != wanted || !wanted)
                reader_->SetCellArrayStatus(name.c_str(), wanted ? 1 : 0);
        }
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
        if (reader_ == nullptr)
            if (auto opened = open(what); !opened)
                return give_up(opened.error());
        choose_fields(time, fields);
        const VtkMessages messages;
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
        return leaves;
    } catch (const std::bad_alloc&) {
        return give_up({Error::Code::OverLimit, "there is not enough memory to read " + what, {}});
    }
}

} // namespace wakesurf::server
