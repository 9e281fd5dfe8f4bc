// The process that extracts level sets, from the server's side: a library that crashes, hangs or is taken
// over harms nothing else. Sizes in its answers are checked before memory is allocated.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "importer/level_message.hpp"
#include "server/data/levels/level_memory.hpp"

#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct LevelMesh {
    /// The points, in units of node indices for a uniform or rectilinear grid.
    std::vector<core::Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Runs the process, and ends it on destruction. One thread at a time.
class LevelProcess {
  public:
    struct Options {
        std::filesystem::path program{}; ///< empty: wakesurf-import beside our own executable
        /// The bound on its memory, shared memory included, in bytes; 0: its own.
        std::uint64_t memory = 0;
        /// For a sign of life: bytes of an answer, or processor time that extracting takes.
        std::chrono::milliseconds patience{20'000};
        std::chrono::milliseconds longest{600'000}; ///< for an answer
    };

    /// Starts the process. Error: Io if it cannot be started.
    static core::Result<std::unique_ptr<LevelProcess>> start(const LevelMemory& memory,
                                                             const Options& options);
    ~LevelProcess();
    LevelProcess(const LevelProcess&) = delete;
    LevelProcess& operator=(const LevelProcess&) = delete;

    /// Waits until the process does not read the memory any more, so that values may be written. Error: as
    /// extract().
    core::Result<void> rest(const std::stop_token& stop);

    /// Extracts a level set. Error: Cancelled within 50 ms of `stop`, and the process continues; OverLimit
    /// for more triangles, or without memory; Io if it ended, hung, or answered nonsense, after which it is
    /// of no use. A job of the compute pool lends its place to others meanwhile.
    core::Result<LevelMesh> extract(importer::LevelRequest request, const std::stop_token& stop);

    bool usable() const { return usable_; }

    /// Returns true if it ended by itself, for a reason that the next process need not meet.
    bool gone() const { return gone_; }

    pid_t id() const { return process_; }

  private:
    LevelProcess(pid_t process, int talk, int errors, const Options& options)
        : process_(process), talk_(talk), errors_(errors), options_(options) {}

    core::Result<void> send(const importer::LevelRequest& request);
    core::Result<void> read(std::size_t bytes, const std::stop_token& stop);
    core::Result<LevelMesh> answer(const std::stop_token& stop);
    std::chrono::nanoseconds worked() const;
    core::Error give_up(const std::string& why);
    core::Error ended();

    pid_t process_;
    int talk_;
    int errors_;
    Options options_;
    std::uint64_t number_ = 0;
    std::uint64_t most_ = 0;      ///< triangles, of the request that is not answered yet
    bool asked_ = false;          ///< a request is pending
    std::vector<std::byte> part_; ///< the received part of its answer
    bool usable_ = true;
    bool gone_ = false;
};

} // namespace wakesurf::server
