// The formats that are read: how each is told, by a path's name and what it holds, and its reader. Each is
// implemented in a folder of its own. A reader looks at the first time-step when it is opened; `wish` names
// the velocity asked for.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

using Opened = core::Result<std::unique_ptr<Source>>;

/// Tells CGNS files by their extension, .cgns: structured and unstructured zones, each a block; one file of
/// several time-steps, or numbered files.
bool is_cgns(const std::filesystem::path& path);

/// Names fields as vtkCGNSReader does: VelocityX, Y, Z are Velocity, MomentumX, Y, Z are Momentum. Boundary
/// patches are left out. Zones without the velocity are solids. Error: as open_source.
Opened open_cgns(const std::filesystem::path& path, const command::SourceOptions& wish = {});

/// Tells EnSight Gold cases (.case): text or binary, several parts, values at nodes or elements.
bool is_ensight(const std::filesystem::path& path);

/// Makes blocks of the parts of three dimensions, and walls of those of two dimensions on the points of the
/// blocks which are called wall, or on which the velocity is zero at the first and last time-steps. Particles
/// are left out. Values are 32 bits. Error: as read_ensight_case and Source::read of the first time-step.
Opened open_ensight(const std::filesystem::path& path, const command::SourceOptions& wish = {});

/// Tells Exodus II files, read through vtkExodusIIReader: all element blocks, all times, values at nodes and
/// elements; one file, the pieces of one (run.e.2.0), and those that continue it (run.e-s002).
bool is_exodus(const std::filesystem::path& path);

/// Says whether an Exodus II file belongs to one before it, by its name: it is a restart, or a further piece.
bool continues_exodus(const std::filesystem::path& path);

/// Makes blocks of the element blocks of three dimensions, solids of those without the velocity, and walls of
/// side sets and flat blocks called wall. Displacements are not applied: the mesh stands still. Values are
/// VTK's, 64 bits.
/// Error: NotFound, Io, Corrupt, Unsupported, OverLimit.
Opened open_exodus(const std::filesystem::path& path, const command::SourceOptions& wish = {});

/// Tells NetCDF-CF files by their extension, .nc, .nc4 or .cdf (open_source also by what they hold): on
/// Cartesian grids, each variable a field of one component, so u, v and w are three, or of three along an axis
/// of its own; one file of several time-steps, or numbered files of one or more each.
bool is_netcdf(const std::filesystem::path& path);

/// Makes one block: an image where the nodes are evenly spaced (to a millionth of the spacing, or to what
/// single precision keeps of a coordinate), else a rectilinear grid. Fill values, missing values and those
/// outside the valid range are NaN.
/// Error: as open_source.
Opened open_netcdf(const std::filesystem::path& path, const command::SourceOptions& wish = {});

/// Tells an OpenFOAM case: a folder with a mesh, or a .foam or .OpenFOAM file or controlDict in one.
bool is_openfoam(const std::filesystem::path& path);

/// Reads a case, whole or decomposed, through vtkOpenFOAMReader: one reader a processor folder, each of which
/// it takes for a case of its own. (vtkPOpenFOAMReader appends the same parts, but passes over what a
/// processor lacks.) Blocks: one a fluid region and processor. Walls: the patches by name, those of a type of wall and others. Solids:
/// the boundaries of regions without a velocity. Values are VTK's, 32 bits, of the cells; point fields and
/// particles are left out.
/// Error: as scan_openfoam_case and Source::read of the first time-step.
Opened open_openfoam(const std::filesystem::path& path, const command::SourceOptions& wish = {});

/// Tells Plot3D by the extension: of a grid, of a solution, or .p3d. A dataset is a grid file and one
/// solution ("q") file a time-step, all in one folder. What belongs together is told by names: the grid
/// `name.xyz` (.x, .g, .grd, .p3d too) and the solutions `name.q`, `name_0001.q`, `name_0002.q`, ...; where
/// no solution begins with the grid's name and there is one grid only, the numbered solutions of the folder.
/// Those of FDS have their times in their names: fire_1_0012_50.q is at 12.5 s.
/// A .p3d file may also be a text as ParaView reads it:
/// {"filenames": [{"time": 0.5, "xyz": "name.xyz", "q": "name_0001.q"}, ...]}.
bool is_plot3d(const std::filesystem::path& path);

/// Makes a block of each grid of the file, the cells of blanked nodes marked. Fields: Momentum, Density,
/// StagnationEnergy and the Velocity VTK makes of the first two; or, for a velocity like "2,3,4", the five
/// values by their places, 1 to 5. Values that cannot be the former are refused, unless a velocity is asked for. Times are those of the solutions' headers
/// where they rise, else 0, 1, 2, ...
/// Error: as open_source.
Opened open_plot3d(const std::filesystem::path& path, const command::SourceOptions& wish = {});

/// Tells files of VTK's own formats by their names: one file, a numbered series, a .pvd or .series that lists
/// files, and composite files (.vtm, .pvtu) in each of these places.
bool is_vtk_files(const std::filesystem::path& path);

/// Makes blocks of all parts of a time-step, but for flat ones: those are walls where their name holds
/// "wall", or where their velocity is exactly zero at the first, the last and the time-step read; other
/// patches are left out. Blocks without the velocity, beside blocks with it, are solids.
/// Error: as open_source.
Opened open_vtk_files(const std::filesystem::path& path, const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
