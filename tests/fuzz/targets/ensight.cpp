// An EnSight case and its geometry: the input is the case file, a line of equals signs, and the file it names.
#include "server/import/sources/ensight_case.hpp"
#include "server/import/sources/ensight_geometry.hpp"
#include "server/import/sources/ensight_variable.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/fuzz/targets/scratch_file.hpp"

#include <algorithm>

namespace wakesurf::fuzz {

namespace {

constexpr std::string_view border = "\n====\n";

constexpr std::string_view case_text = R"(FORMAT
type: ensight gold
GEOMETRY
model: geo
VARIABLE
vector per node: 1 velocity vel.**
TIME
time set: 1
number of steps: 2
filename start number: 0
filename increment: 1
time values: 0.5 1.5)";

constexpr std::string_view geometry_text = R"(EnSight Gold
made by hand
node id off
element id off
part
         1
block
coordinates
         4
 0.0
 1.0
 0.0
 0.0
 0.0
 0.0
 1.0
 0.0
 0.0
 0.0
 0.0
 1.0
tetra4
         1
         1         2         3         4
)";

} // namespace

void ensight(Input input) {
    const std::string_view text = text_of(input);
    const auto cut = std::min(text.find(border), text.size());
    const auto path = scratch_file("a.case", text.substr(0, cut));
    const auto geometry =
        scratch_file("geo", text.substr(std::min(cut + border.size(), text.size())));
    if (const auto read = server::read_ensight_case(path))
        demand(std::is_sorted(read->times.begin(), read->times.end()), "times rise");
    const auto parts = server::read_ensight_geometry({geometry, "geo"});
    if (!parts)
        return;
    const core::FieldInfo velocity{"velocity", 3, core::FieldInfo::Source::Point, {0, 0}, ""};
    server::read_ensight_variable({geometry, "vel"}, *parts, velocity);
}

std::vector<std::string> ensight_seeds() {
    const std::string text(case_text), geometry(geometry_text);
    std::string binary(80, '\0');
    binary.replace(0, 8, "C Binary");
    for (const std::string_view line :
         {"made by hand", "", "node id off", "element id off", "part"}) {
        std::string padded(80, '\0');
        padded.replace(0, line.size(), line);
        binary += padded;
    }
    binary += std::string("\1\0\0\0", 4);
    return {text + std::string(border) + geometry, text + std::string(border) + binary,
            "FORMAT\ntype: ensight\n" + std::string(border)};
}

} // namespace wakesurf::fuzz
