// The entry points of libFuzzer. Each target has a program of its own, because libFuzzer looks at every counter of a program after each run:
// with `seeds DIR` it writes the target's seeds, else its arguments are libFuzzer's.
#include "tests/fuzz/chosen.hpp"
#include "tests/fuzz/json_mutation.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace {

using namespace wakesurf::fuzz;

constexpr const char* memory_folder = "/dev/shm";

void write_seeds(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : chosen.seeds())
        std::ofstream(folder / ("seed-" + std::to_string(number++)), std::ios::binary) << seed;
}

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    if (std::filesystem::exists(memory_folder))
        setenv("TMPDIR", memory_folder, 0); // millions of scratch files
    if (*count == 3 && std::string_view((*arguments)[1]) == "seeds") {
        write_seeds((*arguments)[2]);
        std::exit(0);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen.run({data, size});
    return 0;
}

extern "C" std::size_t
LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    Random random(seed);
    if (chosen.json && below(2, random) == 0) {
        static const JsonMutation json(chosen.seeds());
        const auto changed = json(text_of({data, size}), random);
        if (changed && changed->size() <= most) {
            std::memcpy(data, changed->data(), changed->size());
            return changed->size();
        }
    }
    return LLVMFuzzerMutate(data, size, most);
}
