// A Plot3D grid file, whose layout follows from its length, and the same bytes as a solution on it.
#include "server/import/sources/plot3d_layout.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/fuzz/targets/scratch_file.hpp"

#include <cstring>

namespace wakesurf::fuzz {

namespace {

template <class Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string grid(bool several, int i, int j, int k) {
    std::string bytes;
    if (several)
        append(bytes, 1);
    for (const int each : {i, j, k})
        append(bytes, each);
    for (int node = 0; node < 3 * i * j * k; ++node)
        append(bytes, static_cast<float>(node));
    return bytes;
}

} // namespace

void plot3d(Input input) {
    const auto path = scratch_file("a.xyz", text_of(input));
    const server::ListedFile file{path, "a.xyz", ""};
    const auto layout = server::grid_layout(file);
    if (!layout)
        return;
    for (const auto& block : layout->blocks)
        demand(block[0] > 0 && block[1] > 0 && block[2] > 0, "a block has nodes along each axis");
    server::check_solution(file, *layout);
}

std::vector<std::string> plot3d_seeds() {
    return {grid(false, 2, 2, 2), grid(true, 3, 2, 2),
            "2 2 2\n0 1 0 1 0 1 0 1\n0 0 1 1 0 0 1 1\n0 0 0 0 1 1 1 1\n",
            std::string("\xff\xff\xff\x7f\xff\xff\xff\x7f\xff\xff\xff\x7f", 12)};
}

} // namespace wakesurf::fuzz
