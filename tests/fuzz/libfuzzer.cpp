// The entry points of libFuzzer. One program for all targets: the first argument names one, `seeds DIR` behind it writes its seeds;
// `targets` lists them.
#include "tests/fuzz/json_mutation.hpp"
#include "tests/fuzz/target.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace {

using namespace wakesurf::fuzz;

const Target* chosen = nullptr;
constexpr const char* memory_folder = "/dev/shm";

void write_seeds(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : chosen->seeds())
        std::ofstream(folder / ("seed-" + std::to_string(number++)), std::ios::binary) << seed;
}

void list_targets() {
    for (const Target& each : targets())
        std::printf("%.*s\n", static_cast<int>(each.name.size()), each.name.data());
    std::exit(0);
}

[[noreturn]] void usage() {
    std::fputs("usage: wakesurf-fuzz targets\n"
               "       wakesurf-fuzz TARGET seeds DIR\n"
               "       wakesurf-fuzz TARGET [libFuzzer's arguments]\n",
               stderr);
    std::exit(2);
}

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    char** const given = *arguments;
    const std::string_view name = *count > 1 ? given[1] : "";
    if (name == "targets")
        list_targets();
    const auto found = std::find_if(targets().begin(), targets().end(),
                                    [&](const Target& each) { return each.name == name; });
    if (found == targets().end())
        usage();
    chosen = &*found;
    if (std::filesystem::exists(memory_folder))
        setenv("TMPDIR", memory_folder, 0); // millions of scratch files
    if (*count == 4 && std::string_view(given[2]) == "seeds") {
        write_seeds(given[3]);
        std::exit(0);
    }
    std::rotate(given + 1, given + 2, given + *count); // libFuzzer takes what is left
    --*count;
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen->run({data, size});
    return 0;
}

extern "C" std::size_t
LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    std::mt19937 random(seed);
    if (chosen->json && random() % 2 == 0) {
        static const JsonMutation json(chosen->seeds());
        const auto changed = json(text_of({data, size}), random);
        if (changed && changed->size() <= most) {
            std::memcpy(data, changed->data(), changed->size());
            return changed->size();
        }
    }
    return LLVMFuzzerMutate(data, size, most);
}
