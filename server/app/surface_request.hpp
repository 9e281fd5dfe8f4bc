// The command line of `surface`, as given and as checked values; what depends on the dataset is still open.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/measures/region.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/files/surface_lines.hpp"
#include "server/app/series_request.hpp"
#include "server/data/open_dataset.hpp"
#include "store/command/source_options.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Holds the options as given; check_surface_options checks the texts.
struct SurfaceOptions {
    std::string dataset;
    std::string rake;
    std::string rake_kind;  ///< empty: by the number of its points
    std::string rake2_kind; ///< likewise
    std::uint32_t seeds = 32;
    /// The parameters of surface.set as given, by their names; empty: none.
    std::map<std::string, std::string> asked;
    std::vector<std::string> fields; ///< scalars written at the vertices
    std::uint64_t max_quads = protocol::limits::quads_default;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    int threads = 0;          ///< 0: one a core
    /// The limit of the wall clock (s), after which the finest surface is written; 0: no limit.
    double seconds = 0.0;
    std::string output;
    bool draco = true;            ///< in .glb files
    std::uint32_t tessellate = 1; ///< quads a cell becomes, each way
    std::string times;            ///< FIRST:LAST:EVERY; empty: one file of one time
    std::string through;          ///< a plane or a box that numbers refer to; empty: none
    std::string lines;            ///< which lines are written instead of the mesh; empty: the mesh
    std::string stats;
    std::vector<std::string> twins; ///< other data that it is compared with
    std::vector<std::string> with;  ///< other settings, likewise
    std::string csv;                ///< file of the distances from twins by age
    std::string size = "1600x1000"; ///< of a picture, in pixels
    std::string store;
    command::SourceOptions taken;
};

struct SurfaceRequest {
    core::Rake rake;
    /// `from` and `to` are filled in later if the options leave them open.
    core::SurfaceParameters parameters;
    std::optional<double> from, to;
    std::optional<protocol::LinesWanted> lines; ///< instead of the mesh
    std::string asked;    ///< JSON: of surface.set, what was given; without rakes and dataset
    bool picture = false; ///< instead of the mesh
    std::optional<Series> series{};        ///< instead of one mesh
    std::optional<core::Region> through{}; ///< of numbers
};

/// Checks the options. Error: InvalidArgument for wrong usage, Unsupported for what wakesurf cannot do,
/// NotFound if the folder of the output does not exist.
core::Result<SurfaceRequest> check_surface_options(const SurfaceOptions& options);

/// Completes the request by the data (the rake, the times, the separation), and prints to standard error what was chosen. Error: what sampling the data reports.
core::Result<void> choose_open_options(SurfaceRequest& request,
                                       const SurfaceOptions& options,
                                       const LoadedDataset& dataset,
                                       const std::stop_token& stop);

/// Fills in `from` and `to` if the options leave them open: the first and last time of the data, the other
/// way round with `--direction backward`; 10 time units from `from` if the data have no such times.
void choose_times(SurfaceRequest& request, const std::vector<double>& times);

} // namespace wakesurf::server
