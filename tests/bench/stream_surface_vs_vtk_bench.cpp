#include "tests/bench/benchmarks.hpp"

namespace wakesurf::bench {
void register_stream_surface_benchmarks() {}
} // namespace wakesurf::bench
