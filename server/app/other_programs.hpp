// Commands that are other programs, which replace this process: `mcp` and pictures by the client for Python, `bench` by wakesurf-bench,
// which links Google Benchmark and VTK.
#pragma once

#include <string>
#include <vector>

namespace wakesurf::server {

/// Replaces this process by Python with `main` of a module of the client; $WAKESURF is this program there.
/// Returns the exit status only if it cannot be started, and says why.
int become_python(const std::string& module, const std::vector<std::string>& arguments);

} // namespace wakesurf::server
