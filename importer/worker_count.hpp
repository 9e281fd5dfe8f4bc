// How many processes convert time-steps at once, and whether they may share what is open.
#pragma once

#include "importer/import_plan.hpp"

#include <cstddef>

namespace wakesurf::importer {

/// As many as asked for, else as there are cores; fewer where half of the free memory does not hold as many time-steps.
std::size_t worker_count(const ImportPlan& plan, std::size_t nodes);

/// Whether files are open for reading, standard input aside: forked processes would move each other's place in them.
bool reads_open_files();

} // namespace wakesurf::importer
