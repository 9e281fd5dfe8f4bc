// Chooses the reader of a path: by its extension and, where that tells none or several formats share it, by what
// it holds.

#include "importer/sources/open_source.hpp"

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/series/numbered_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Error;
using namespace std::string_view_literals;
namespace fs = std::filesystem;

namespace {

// Finds the one dataset in a folder that is given as a source.

bool lists_others(const fs::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".pvd" || extension == ".series" || extension == ".case" ||
           extension == ".foam" || extension == ".p3d";
}

// Ranks files that are parts of others when those are there: pieces of .pvtu, blocks of .vtm, Plot3D
// solutions, restarts and further pieces of Exodus.
int rank(const fs::path& path) {
    const auto extension = lower_extension(path);
    if (lists_others(path))
        return 0;
    if (extension == ".vtm" || extension == ".vtmb" || extension.starts_with(".pvt"))
        return 1;
    return extension == ".q" || continues_exodus(path) ? 3 : 2;
}

core::Result<std::vector<fs::path>> files_in(const fs::path& folder) {
    std::vector<fs::path> out;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        out.push_back(entry->path());
    if (error)
        return core::fail(Error::Code::Io,
                          folder.filename().string() + " cannot be listed: " + error.message());
    std::sort(out.begin(), out.end());
    return out;
}

// Returns a file that lists others (.pvd, .series, .case) before the files it may list; else the one file or
// numbered series there is. Only files that `readable` accepts count. Error: NotFound (nothing to read),
// InvalidArgument (several datasets, listed), Io.
core::Result<fs::path> choose_in_folder(const fs::path& folder,
                                        const std::function<bool(const fs::path&)>& readable) {
    constexpr std::size_t most = 8;
    const std::string name = (folder / "").parent_path().filename().string();
    auto files = files_in(folder);
    if (!files)
        return tl::unexpected(files.error());
    std::erase_if(*files, [&](const fs::path& file) { return !readable(file); });
    if (files->empty()) {
        const auto all = files_in(folder);
        for (std::size_t i = 0; all && i < std::min(all->size(), most); ++i)
            if (auto other = other_format((*all)[i]))
                return core::fail(Error::Code::NotFound,
                                  name + " holds nothing that can be read: " + other->message,
                                  other->hint);
        return core::fail(Error::Code::NotFound, name + " holds nothing that can be read",
                          "give a folder with an OpenFOAM case, or with one series of files");
    }
    const auto best =
        std::min_element(files->begin(), files->end(),
                         [](const auto& a, const auto& b) { return rank(a) < rank(b); });
    const int wanted = rank(*best);
    std::vector<fs::path> datasets; // one file of each
    std::set<fs::path> known;
    for (const auto& file : *files) {
        if (rank(file) != wanted || known.contains(file))
            continue;
        datasets.push_back(file);
        if (wanted == 0)
            continue;
        const auto series = numbered_files(file);
        if (!series)
            return tl::unexpected(series.error());
        known.insert(series->files.begin(), series->files.end());
    }
    if (datasets.size() == 1)
        return datasets.front();
    std::string list;
    for (std::size_t i = 0; i < std::min(datasets.size(), most); ++i)
        list += (i == 0 ? "" : ", ") + datasets[i].filename().string();
    if (datasets.size() > most)
        list += ", ...";
    return core::fail(Error::Code::InvalidArgument, name + " holds several datasets: " + list,
                      "give one of them");
}

struct Format {
    bool (*is_it)(const fs::path&);
    Opened (*open)(const fs::path&, const command::SourceOptions&);
};

constexpr std::array formats{
    Format{is_openfoam, open_openfoam}, Format{is_ensight, open_ensight},
    Format{is_exodus, open_exodus},     Format{is_vtk_files, open_vtk_files},
    Format{is_netcdf, open_netcdf},     Format{is_cgns, open_cgns},
    Format{is_plot3d, open_plot3d}};

const Format* format_of(const fs::path& path) {
    for (const auto& format : formats)
        if (format.is_it(path))
            return &format;
    return nullptr;
}

// Opens a file by what it holds, whatever it is called.
Opened open_held(Held held, const fs::path& path, const command::SourceOptions& wish) {
    return held == Held::Netcdf ? open_netcdf(path, wish) : open_cgns(path, wish);
}

} // namespace

core::Result<std::unique_ptr<Source>> open_source(const fs::path& path,
                                                  const command::SourceOptions& wish) {
    const std::string name = path.filename().string();
    std::error_code error;
    const Format* format = format_of(path);
    if (format == nullptr && fs::is_directory(path, error)) {
        if (auto other = other_format(path))
            return tl::unexpected(*other);
        auto chosen =
            choose_in_folder(path, [](const fs::path& file) { return format_of(file) != nullptr; });
        if (!chosen && chosen.error().code == Error::Code::NotFound)
            if (auto held = choose_in_folder(
                    path, [](const fs::path& file) { return held_format(file).has_value(); });
                held || held.error().code != Error::Code::NotFound)
                chosen = std::move(held);
        return chosen.and_then([&](const fs::path& file) { return open_source(file, wish); });
    }
    if (!is_pattern(path) || fs::exists(path, error)) {
        const auto size = core::PosixDisk().size(path);
        if (!size && !fs::is_directory(path, error))
            return tl::unexpected(size.error());
        if (size && *size == 0 && !is_openfoam(path)) // a .foam only marks its folder
            return core::fail(Error::Code::Corrupt, name + " is empty");
    }
    if (format == nullptr || is_plot3d(path) || lower_extension(path) == ".hdf")
        if (const auto held = held_format(path))
            return open_held(*held, path, wish);
    // Plot3D's files begin with any bytes.
    if (!is_plot3d(path))
        if (const auto other = other_format(path, format != nullptr))
            return tl::unexpected(*other);
    if (format == nullptr)
        return core::fail(Error::Code::Unsupported, name + " is of a format that cannot be read",
                          "formats: OpenFOAM (case folder or .foam), EnSight (.case), Exodus (.e, "
                          ".exo), CGNS (.cgns), "
                          "NetCDF (.nc), Plot3D (.xyz, .x, .g, .q, .p3d), VTK (.vti, .vtr, .vts, "
                          ".vtu, their .pvt*, .vtm, "
                          ".vtk, .vtkhdf) and collections of it (.pvd, .series)");
    return format->open(path, wish);
}

namespace {

// Of the ways to tell a format, all that a row names must fit.
struct Row {
    std::string_view begins; ///< with these bytes; "" any
    std::string_view
        holds; ///< these words near the beginning, in small letters, with | between them
    std::string_view
        ends; ///< the name, in small letters, with one of these, with blanks between them
    std::string_view is;
    std::string_view hint;
};

constexpr std::string_view unpack = "unpack it, and give the file or folder that was in it";
constexpr std::string_view by_paraview = "open it in ParaView and save it there (File, Save Data) "
                                         "as .vtu, .vts or .vtm with all time-steps";
constexpr std::string_view as_values =
    "write the velocity on its grid as .vti, .vtr or NetCDF instead";
constexpr std::string_view by_fluent = "in Fluent: File, Export, Solution Data as EnSight Case "
                                       "Gold, or CGNS; Calculation Activities, Automatic "
                                       "Export for each time-step";
constexpr std::string_view by_star =
    "in STAR-CCM+: File, Export as EnSight Gold or CGNS, with the velocity, at each time-step";
constexpr std::string_view by_meshio =
    "convert it, with the velocity, by meshio: meshio convert flow.msh flow.vtu";
constexpr std::string_view of_a_surface = "give the results in the volume, with a velocity";

// What the first bytes alone tell, and are of no format that is read.
constexpr auto by_first_bytes = std::to_array<Row>({
    {"\x1f\x8b"sv, "", "", "packed by gzip", unpack},
    {"PK\x03\x04"sv, "", "", "a zip archive", unpack},
    {"BZh"sv, "", "", "packed by bzip2", unpack},
    {"\xfd"
     "7zXZ"sv,
     "", "", "packed by xz", unpack},
    {"\x28\xb5\x2f\xfd"sv, "", "", "packed by zstd", unpack},
    {"7z\xbc\xaf"sv, "", "", "a 7z archive", unpack},
    {"Rar!"sv, "", "", "a rar archive", unpack},
    {"#!TDV"sv, "", "", "binary data of Tecplot", by_paraview},
    {"#!SZPLT"sv, "", "", "data of Tecplot in sub-zones",
     "write it as .plt in Tecplot 360 (File, Write Data), open that in ParaView and save it there "
     "as .vtm with all "
     "time-steps"},
    {"GRIB"sv, "", "", "GRIB",
     "convert it to NetCDF (cdo -f nc copy, or grib_to_netcdf), on a grid over x, y and z in "
     "metres"},
    {"\x0e\x03\x13\x01"sv, "", "", "HDF4", "convert it to NetCDF, or to HDF5 as VTKHDF has it"},
    {"MATLAB 5"sv, "", "", "MATLAB's variables", as_values},
    {"\x93NUMPY"sv, "", "", "an array of NumPy", as_values},
    {"NRRD"sv, "", "", "an image in NRRD", as_values},
    {"$MeshFormat"sv, "", "", "Gmsh's", by_meshio},
    {"$PostFormat"sv, "", "", "Gmsh's", by_meshio},
    {"#std"sv, "", "", "a field of Nek5000",
     "open the .nek5000 file beside it in ParaView and save it there as .vtu "
     "with all time-steps"},
    {"#max"sv, "", "", "a field of Nek5000",
     "open the .nek5000 file beside it in ParaView and save it there as .vtu "
     "with all time-steps"},
    {"\xec\x2b\x08\x00"sv, "", "", "a restart of SU2",
     "set OUTPUT_FILES= (RESTART, PARAVIEW) in the configuration and give flow_00000.vtu"},
    {" BDV"sv, "", "", "OpenVDB", as_values},
});

constexpr auto by_all = std::to_array<Row>({
    {"\x89HDF"sv, "vtkhdf", "", "VTKHDF, with an ending that does not say so", "call it .vtkhdf"},
    {"<?xml"sv, "<xdmf", "", "XDMF, which describes arrays in other files", by_paraview},
    {"<Xdmf"sv, "", "", "XDMF, which describes arrays in other files", by_paraview},
    {"", "<paraview>", "", "a state of ParaView, which names data and holds none",
     "open it in ParaView and save the data (File, Save Data) as .vtu, .vts or .vtm with all "
     "time-steps"},
    {"", "<vtkfile|amr", "", "VTK's, with grids that overlap (AMR)",
     "resample it to one image in ParaView (Resample To Image) and save that as .vti"},
    {"", "<vtkfile", "", "VTK's, with an ending that does not say which",
     "call it .vti, .vtr, .vts, .vtu, .vtm or .pvd, by the type in its second line"},
    {"# vtk DataFile"sv, "", "", "VTK's, with an ending that does not say so", "call it .vtk"},
    {"", "foamfile", "", "one file of an OpenFOAM case", "give the folder of the case"},
    {"", "num_el_blk", "", "Exodus II, with an ending that does not say so",
     "call it .exo; join the parts of a parallel run with epu first"},
    {"(0 \""sv, "", "", "a case or data file of Fluent", by_fluent},
    {"(1 \""sv, "", "", "a case or data file of Fluent", by_fluent},
    {"", "", ".cas .cas.h5 .dat.h5 .msh.h5 .cdat", "a case or data file of Fluent", by_fluent},
    {"", "", ".sim .ccm .ccmg", "of STAR-CCM+", by_star},
    {"", "variables|zone|=", "", "text of Tecplot", by_paraview},
    {"", "ndime=", "", "a mesh of SU2",
     "give flow_00000.vtu, which SU2 writes with OUTPUT_FILES= (RESTART, PARAVIEW)"},
    {"", "\"pointid\"|\"x\"", "", "a restart of SU2 as text",
     "set OUTPUT_FILES= (RESTART, PARAVIEW) in the configuration and give flow_00000.vtu"},
    {"", "", ".su2", "a mesh of SU2",
     "give flow_00000.vtu, which SU2 writes with OUTPUT_FILES= (RESTART, PARAVIEW)"},
    {"", "item: timestep", "", "particles of LAMMPS",
     "average them to a grid, and write it as .vti"},
    {"solid"sv, "facet", "", "a surface (STL)", of_a_surface},
    {"C Binary"sv, "", "", "one file of an EnSight case", "give its .case file"},
    {"FIELDVIEW"sv, "", "", "of FieldView", "write CGNS or EnSight Gold from the solver instead"},
    {"", "", ".stl .obj .ply .off .glb .gltf", "a surface", of_a_surface},
    {"", "", ".szplt", "data of Tecplot in sub-zones",
     "write it as .plt in Tecplot 360, open that in ParaView and save "
     "it there as .vtm with all time-steps"},
    {"", "", ".plt .tec", "of Tecplot", by_paraview},
    {"", "", ".xdmf .xmf .xdmf2 .xdmf3", "XDMF, which describes arrays in other files",
     by_paraview},
    {"", "", ".grib .grib2 .grb .grb2", "GRIB",
     "convert it to NetCDF (cdo -f nc copy, or grib_to_netcdf), on a grid over x, y and z in "
     "metres"},
    {"", "", ".nek5000", "of Nek5000", by_paraview},
    {"", "", ".msh", "a mesh of Gmsh or Fluent",
     "give the results: of Gmsh by meshio convert flow.msh flow.vtu, of Fluent as EnSight Case "
     "Gold"},
    {"", "", ".pvsm .pvcc", "a state of ParaView, which names data and holds none", by_paraview},
    {"", "", ".vdf .vdc .vs3 .vapor", "of VAPOR",
     "give the files that it was made from, or write NetCDF over x, y and z in metres"},
    {"", "", ".visit .session", "a list or session of VisIt",
     "give the first of the files that it names"},
    {"", "", ".silo .pdb", "Silo", "export it from VisIt (File, Export database) as VTK"},
    {"", "", ".bov", "a brick of values, as VisIt has it", as_values},
    {"", "", ".f .fun .fn .fvbnd .nam", "a function file of Plot3D",
     "write the five values of the q file (see --velocity), or open grid and functions in ParaView "
     "and save them there "
     "as .vts"},
    {"", "", ".geo .vel .scl .ens", "one file of an EnSight case", "give its .case file"},
    {"", "", ".bp", "of ADIOS",
     "open it in ParaView (as VTX or Fides) and save it there as .vtu with all time-steps"},
    {"", "", ".res .trn", "of ANSYS CFX",
     "in CFD-Post: File, Export as CGNS with the velocity, at each time-step"},
    {"", "", ".odb", "of Abaqus", "export the velocity at the nodes as .vtu"},
    {"", "", ".mhd .mha .raw .vol", "an image without a known grid of vectors", as_values},
    {"", "", ".mat", "MATLAB's variables", as_values},
    {"", "", ".npy .npz", "an array of NumPy", as_values},
    {"", "", ".csv .tsv", "a table", as_values},
    {"", "", ".tar .tgz .zip .gz .bz2 .xz .zst .7z .rar", "an archive", unpack},
    {"\x89HDF"sv, "", "",
     "HDF5 with a layout of the program that wrote it; of HDF5, NetCDF-4, CGNS and VTKHDF are read",
     "if there is an .xdmf beside it, open that in ParaView and save it there as .vtu, .vts or "
     ".vtm with all time-steps"},
});

struct Beginning {
    std::string bytes;
    std::string words; ///< the same in small letters
};

Beginning beginning_of(const fs::path& file, std::size_t most = 1 << 16) {
    std::string bytes(most, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return {bytes, lower_case(bytes)};
}

// Calls visit with each of the words between the separators, until it returns true.
template <class Visit>
bool any_of_words(std::string_view words, char between, const Visit& visit) {
    while (!words.empty()) {
        const auto end = words.find(between);
        if (visit(words.substr(0, end)))
            return true;
        words = end == std::string_view::npos ? "" : words.substr(end + 1);
    }
    return false;
}

bool fits(const Row& row, const Beginning& start, const std::string& name) {
    constexpr std::size_t near = 4096;
    const std::string_view words = std::string_view(start.words).substr(0, near);
    const bool lacks = any_of_words(row.holds, '|', [&](std::string_view word) {
        return words.find(word) == std::string_view::npos;
    });
    return start.bytes.starts_with(row.begins) && !lacks &&
           (row.ends.empty() ||
            any_of_words(row.ends, ' ', [&](std::string_view end) { return name.ends_with(end); }));
}

// Returns what a folder is, and what to do.
std::optional<std::pair<std::string_view, std::string_view>> other_folder(const fs::path& folder) {
    std::error_code error;
    std::ifstream header(folder / "Header");
    std::string first;
    if (header >> first && (first.starts_with("HyperCLaw") || first.starts_with("NavierStokes")))
        return std::pair(
            "a plotfile of AMReX, whose grids overlap"sv,
            "resample it to one image and save that as .vti: ParaView (AMReX/BoxLib grid reader, "
            "Resample To Image), or yt (covering_grid)"sv);
    for (const char* const name : {".zgroup", ".zarray", "zarr.json", ".zmetadata"})
        if (fs::exists(folder / name, error))
            return std::pair("a Zarr"sv,
                             "it needs no import: use it as it is, as in wakesurf serve"sv);
    if (fs::exists(folder / "md.idx", error))
        return std::pair("of ADIOS"sv,
                         "open it in ParaView (as VTX or Fides) and save it there as .vtu with all "
                         "time-steps"sv);
    return std::nullopt;
}

} // namespace

std::optional<Held> held_format(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        return std::nullopt;
    // Folders may hold many files: of most these tell enough.
    constexpr std::string_view adf = "@(#)ADF Database";
    const std::string first = beginning_of(file, adf.size()).bytes;
    const std::string_view bytes = first;
    if (bytes.size() == adf.size() && bytes.substr(4) == adf.substr(4))
        return Held::Cgns;
    const bool hdf = bytes.starts_with("\x89HDF");
    const bool classic = bytes.starts_with("CDF\x01"sv) || bytes.starts_with("CDF\x02"sv) ||
                         bytes.starts_with("CDF\x05"sv);
    if (!hdf && !classic)
        return std::nullopt;
    const auto start = beginning_of(file);
    const auto holds = [&](std::string_view word) {
        return start.bytes.find(word) != std::string::npos;
    };
    if (hdf && holds("CGNSLibraryVersion"))
        return Held::Cgns;
    const bool netcdf = classic || holds("_NCProperties") || holds("_Netcdf4");
    return netcdf && !holds("num_el_blk") ? std::optional(Held::Netcdf) : std::nullopt;
}

std::optional<Error> other_format(const fs::path& path, bool by_bytes) {
    const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
    const auto refusal = [&](std::string_view is, std::string_view hint) {
        return Error{Error::Code::Unsupported,
                     name + " is of a format that cannot be read: " + std::string(is),
                     std::string(hint)};
    };
    std::error_code error;
    if (fs::is_directory(path, error)) {
        const auto folder = by_bytes ? std::nullopt : other_folder(path);
        return folder ? std::optional(refusal(folder->first, folder->second)) : std::nullopt;
    }
    if (!fs::is_regular_file(path, error))
        return std::nullopt;
    const auto start = beginning_of(path);
    constexpr std::size_t mark = 257; // of a tar
    if (start.bytes.size() > mark &&
        std::string_view(start.bytes).substr(mark).starts_with("ustar"))
        return refusal("a tar archive", unpack);
    const std::string small = lower_case(name);
    const auto is_it = [&](const Row& row) { return fits(row, start, small); };
    if (const auto row = std::ranges::find_if(by_first_bytes, is_it); row != by_first_bytes.end())
        return refusal(row->is, row->hint);
    const auto row = std::ranges::find_if(by_all, is_it);
    return by_bytes || row == by_all.end() ? std::nullopt
                                           : std::optional(refusal(row->is, row->hint));
}

} // namespace wakesurf::importer
