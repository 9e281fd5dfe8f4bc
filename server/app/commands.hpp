// The commands of `wakesurf`: the options of each as given, their declaration, and the function that runs it. Functions return the
// exit status (0 done, 1 failed, 2 wrong usage) and say why on standard error.
#pragma once

#include "server/app/surface_request.hpp"
#include "server/data/open_dataset.hpp"
#include "store/command/source_options.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

// `wakesurf serve`: the server, until Ctrl-C.

struct ServeOptions {
    std::vector<std::string> datasets;
    std::string listen = "127.0.0.1:8080";
    std::string store;
    command::SourceOptions taken; ///< of all datasets
    std::string state;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    unsigned threads = 0;
    /// The command that starts wakesurf-bricks; empty: it is not started.
    std::string bricks;
    std::uint64_t brick_memory = 0; ///< of each rank; 0: what it needs
    std::string token_file;
    bool new_token = false;
    std::string url_file;
    bool no_auth = false;
    std::vector<std::string> origins;
    std::vector<std::string> frame_origins;
    std::vector<std::string> trusted_proxies;
    std::string certificate;
    std::string key;
    std::string web;
    std::string log_level = "info";
    bool open = false;           ///< the page, in a browser
    bool port_by_chance = false; ///< if the one of `listen` is in use
};

void add_serve_options(CLI::App& command, ServeOptions& options);

/// Serves, and returns the exit status.
int run_serve(const ServeOptions& options);

// `wakesurf sessions`: lists and changes sessions of a running server, or of a state folder that no server
// uses.

struct SessionsOptions {
    std::string url;   ///< empty: $WAKESURF_URL, else $WAKESURF_STATE
    std::string state; ///< folder
    std::string authority;
    std::string action;
    std::string session;
    std::string name;
    std::string file;
    bool trash = false;
    bool forever = false;
    bool json = false;
    bool overwrite = false;
};

void add_sessions_options(CLI::App& command, SessionsOptions& options);

/// Runs the command, and returns the exit status.
int run_sessions(const SessionsOptions& options);

// `wakesurf surface`: from a dataset and a rake to a mesh file, without a server.

/// Declares the options of `surface` on its subcommand.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_surface(const SurfaceOptions& options);

// `wakesurf twin`: a surface as `surface` builds it, compared with others of the same seeds.

void add_twin_options(CLI::App& command, SurfaceOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_twin(const SurfaceOptions& options);

/// Opens the dataset of a command that works without a server, imported first if needed, with its progress on
/// standard error. @param store  empty: the default. Error: as resolve_dataset and open_dataset
core::Result<LoadedDataset> open_for_command(const std::string& dataset,
                                             const std::string& store,
                                             const command::SourceOptions& taken,
                                             const core::MemoryAccount& account,
                                             std::stop_token stop);

// `wakesurf verify`: makes the surface of a file again and compares.

struct VerifyOptions {
    std::string file;
    std::string dataset;      ///< empty: the built-in flow that the file names
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    int threads = 0;          ///< 0: one a core
    std::string store;
    command::SourceOptions taken;
};

void add_verify_options(CLI::App& command, VerifyOptions& options);

/// Returns the exit status: 0 verified, 1 something differs or failed, 2 wrong usage, or a file without a recipe.
int run_verify(const VerifyOptions& options);

// `wakesurf family`: makes, lists or removes families of stream surfaces of a dataset, without a server.

/// Holds the options as given; run_family checks the texts.
struct FamilyOptions {
    std::string dataset;
    std::string name;
    std::string remove;    ///< the name of a family
    std::string from;      ///< inflow=SCALAR
    std::string plane;     ///< point and normal
    std::string scalar;    ///< on the plane
    std::string rake;      ///< points of a curve
    std::string rake_kind; ///< empty: by the number of its points
    std::string times;     ///< with commas; empty: the first time-step
    std::string accuracy = "balanced";
    double length = 0.0;      ///< 0: ten diagonals
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    int threads = 0;          ///< 0: one a core
    std::string store;
    command::SourceOptions taken;
};

void add_family_options(CLI::App& command, FamilyOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_family(const FamilyOptions& options);

// `wakesurf slice`: fields on a plane through a dataset, as a file, without a server.

/// Holds the options as given; run_slice checks the texts.
struct SliceOptions {
    std::string dataset;
    std::string plane;               ///< point and normal
    std::vector<std::string> fields; ///< empty: the speed
    std::optional<double> time;      ///< nothing: the last
    std::string minus; ///< dataset whose fields are subtracted; empty: none, or its own
    std::optional<double> minus_time; ///< nothing: the same
    std::size_t samples = 512;        ///< along the longer side
    std::string output;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    std::string store;
    command::SourceOptions taken;
};

void add_slice_options(CLI::App& command, SliceOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_slice(const SliceOptions& options);

// `wakesurf lines`: streamlines of a dataset at a time, as a file, without a server.

/// Holds the options as given; run_lines checks the texts.
struct LinesOptions {
    std::string dataset;
    std::string from;                 ///< where they are released
    std::vector<std::string> patches; ///< of --from walls, by name; empty: the walls of bodies
    std::uint32_t seeds = 50;
    std::string direction = "both";
    double duration = 0.0;      ///< 0: as long as it takes
    double length = 0.0;        ///< 0: twice the domain's diagonal
    std::string field;          ///< empty: the speed
    std::optional<double> time; ///< nothing: the last
    std::string output;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    std::string store;
    command::SourceOptions taken;
};

void add_lines_options(CLI::App& command, LinesOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_lines(const LinesOptions& options);

// `wakesurf probe`: fields at points, along a line or over time, as CSV, without a server.

/// Holds the options as given; run_probe checks the texts.
struct ProbeOptions {
    std::string dataset;
    std::vector<std::string> at;     ///< points
    std::string line;                ///< corners; empty: points
    std::size_t points = 401;        ///< along the line
    std::vector<std::string> fields; ///< empty: the speed and the velocity
    std::optional<double> time;      ///< nothing: the last
    std::string times;               ///< FIRST:LAST:EVERY or "stored"; empty: one time
    std::string output;              ///< empty: standard output
    std::uint64_t memory = 0;        ///< 0: by the machine and the control group
    std::string store;
    command::SourceOptions taken;
};

void add_probe_options(CLI::App& command, ProbeOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_probe(const ProbeOptions& options);

// `wakesurf body`: writes the walls of a dataset with values beside them, without a server.

struct BodyOptions {
    std::string dataset;
    std::vector<std::string> fields;
    std::vector<std::string> patches; ///< by name; empty: the walls of bodies
    bool all_patches = false;
    std::optional<double> time; ///< nothing: the last
    std::string output;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    std::string store;
    command::SourceOptions taken;
};

void add_body_options(CLI::App& command, BodyOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_body(const BodyOptions& options);

// `wakesurf means`: makes and removes means over time of fields of a dataset, without a server.

struct MeansOptions {
    std::string dataset;
    std::vector<std::string> fields;
    std::string remove;           ///< the name of a field of a mean
    std::optional<double> from{}; ///< empty: all that is there
    std::optional<double> to{};
    std::optional<double> period{};
    std::size_t phases = 0; ///< 0: as many as the period has time-steps
    std::string label;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    int threads = 0;          ///< 0: one a core
    std::string store;
    command::SourceOptions taken;
};

void add_means_options(CLI::App& command, MeansOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_means(const MeansOptions& options);

// `wakesurf info`: describes a dataset without importing it.

struct InfoOptions {
    std::string dataset;
    bool json = false;
    command::SourceOptions taken;
    std::uint64_t memory = 0; ///< in bytes, for describing it; 0: the importer's own bound
};

/// Prints the description, and returns the exit status.
int run_info(const InfoOptions& options);

// `wakesurf import`: a source into a store of the user's choosing.

struct ImportOptions {
    std::string dataset;
    std::string store;
    std::vector<std::string> fields;
    std::string times;     ///< T0:T1[:EVERY], several with commas, or empty
    std::string precision; ///< single, half or empty
    std::string layout = "auto";
    command::SourceOptions taken;
    std::size_t jobs = 0;     ///< 0: one a core
    std::uint64_t memory = 0; ///< bytes; 0: the importer's own bound
};

/// Imports, and returns the exit status.
int run_import(const ImportOptions& options);

// `wakesurf generate`: a built-in flow, sampled into a store.

/// Holds the options as given; run_generate checks the texts.
struct GenerateOptions {
    std::string flow;
    std::string folder;
    std::string grid = "64,64,64";
    std::string times; ///< empty: the flow's own
    std::string parameters;
    std::string layout = "auto";
};

void add_generate_options(CLI::App& command, GenerateOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_generate(const GenerateOptions& options);

// `wakesurf mcp`: the tools for programs that are driven by a language model, over standard input and output.
// They are part of the client for Python (python/wakesurf/mcp), which replaces this process.

struct McpOptions {
    std::vector<std::string> datasets;
    std::string url;
    std::string session;
    std::string folder;
};

void add_mcp_options(CLI::App& command, McpOptions& options);

/// Returns only if they cannot be started, with the exit status.
int run_mcp(const McpOptions& options);

// `wakesurf state aside|backup|check|restore`: maintenance of the folder of `serve --state`, also while the
// server runs.

struct StateCommandOptions {
    std::string folder;
    std::string file;
    bool damaged = false;
};

/// Adds the commands; the chosen one is put into `chosen`, to be run. Each returns the exit status: 0 done
/// (check: sound), 1 failed (check: damaged).
void add_state_commands(CLI::App& command,
                        StateCommandOptions& options,
                        std::function<int()>& chosen);

// `wakesurf bench`: the product's own figures on this machine. The benchmarks are a program of their own,
// `wakesurf-bench` (tests/bench), because they link Google Benchmark and VTK; this command only starts it.

struct BenchOptions {
    std::vector<std::string> names; ///< benchmarks whose names contain one of these; empty: all
    std::string data;               ///< a dataset; empty: the bundled simulation
    int seconds = 60;               ///< of an attack
    std::string json;               ///< file for Google Benchmark's JSON; empty: none
};

/// Declares the options, the same in both programs.
void add_bench_options(CLI::App& command, BenchOptions& options);

/// Replaces this process by wakesurf-bench, whose exit status is then the command's. Returns 1 if it cannot
/// be started.
/// @param program  empty: wakesurf-bench beside our own executable
int run_bench(const BenchOptions& options, std::filesystem::path program = {});

} // namespace wakesurf::server
