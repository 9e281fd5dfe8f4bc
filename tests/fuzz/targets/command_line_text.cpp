// What a person types: rakes, vectors and sizes of memory.
#include "server/app/rake_text.hpp"
#include "store/command/memory_size.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::fuzz {

namespace {

void run(Input input) {
    const std::string_view text = text_of(input);
    if (const auto rake = server::parse_rake(text, 16))
        demand(rake->points.size() >= 2 && std::all_of(rake->points.begin(), rake->points.end(),
                                                       [](const core::Vec3& p) {
                                                           return std::isfinite(p.x) &&
                                                                  std::isfinite(p.y) &&
                                                                  std::isfinite(p.z);
                                                       }),
               "a rake has at least two points, all finite");
    if (const auto vector = server::parse_vector(text, "--sweep"))
        demand(std::isfinite(vector->x), "a vector is finite");
    if (const auto size = command::parse_memory_size(text))
        demand(*size > 0, "a size of memory is at least a byte");
}

std::vector<std::string> seeds() {
    return {"0,0,0 1,1,1",
            "-1.5,-1.2,1 -1.5,1.2,5",
            "1e300,1e-300,-0 .5,5.,+1",
            "0,0,1",
            "4GiB",
            "512MB",
            "1.5e3 kB",
            "nan,inf,0 0,0,0",
            "0x10,1,1 1_0,2,2"};
}

} // namespace

const Target command_line_text_target{"command_line_text", run, seeds};

} // namespace wakesurf::fuzz
