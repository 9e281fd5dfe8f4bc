// `wakesurf family`: makes, lists or removes families of stream surfaces of a dataset, without a server.
#pragma once

#include "store/command/source_options.hpp"

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace wakesurf::server {

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

} // namespace wakesurf::server
