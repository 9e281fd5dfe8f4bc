// The processes of an MPI job that hold a store's bricks on this machine, for tests that kill one.
#pragma once

#include <stdlib.h>
#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace wakesurf::tests {

/// Returns the processes of wakesurf-bricks with that store among their arguments.
inline std::vector<pid_t> ranks_of(const std::filesystem::path& store) {
    std::vector<pid_t> out;
    for (const auto& each : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(each.path() / "cmdline", std::ios::binary);
        const std::string words(std::istreambuf_iterator<char>(file), {});
        const std::string program = words.substr(0, words.find('\0'));
        if (program.ends_with("/wakesurf-bricks") && words.find(store.string()) != words.npos)
            out.push_back(std::stoi(each.path().filename().string()));
    }
    return out;
}

/// Returns the process with that number in its job; -1 without one.
inline pid_t rank_of(const std::filesystem::path& store, int number) {
    const std::string wanted = "OMPI_COMM_WORLD_RANK=" + std::to_string(number) + '\0';
    for (const pid_t each : ranks_of(store)) {
        std::ifstream file("/proc/" + std::to_string(each) + "/environ", std::ios::binary);
        if (std::string(std::istreambuf_iterator<char>(file), {}).find(wanted) != std::string::npos)
            return each;
    }
    return -1;
}

/// Returns the words that start them here: also as root, and more than there are cores.
inline std::vector<std::string> mpirun(int ranks) {
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    return {
        "mpirun", "-n", std::to_string(ranks), "--oversubscribe", "--mca", "mpi_yield_when_idle",
        "1"};
}

} // namespace wakesurf::tests
