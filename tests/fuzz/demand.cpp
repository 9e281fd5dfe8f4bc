#include "tests/fuzz/target.hpp"

#include <cstdio>
#include <cstdlib>

namespace wakesurf::fuzz {

void demand(bool holds, std::string_view sentence) {
    if (holds)
        return;
    std::fprintf(stderr, "broken: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
    std::abort();
}

} // namespace wakesurf::fuzz
