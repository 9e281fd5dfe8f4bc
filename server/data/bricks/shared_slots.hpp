// Memory shared by the server and a job, which writes bricks there. The server makes it and seals its size,
// so that no job can remove it while it is read.
#pragma once

#include "core/base/result.hpp"
#include "server/base/private_file.hpp"

#include <cstddef>
#include <span>

namespace wakesurf::server {

/// Holds slots of equal size.
class SharedSlots {
  public:
    /// Makes the memory. Error: Io.
    static core::Result<SharedSlots> make(std::size_t slots, std::size_t slot_bytes);
    /// Maps memory made by another process. Error: Io, also if it is smaller than that.
    static core::Result<SharedSlots> take(OpenFile file, std::size_t slots, std::size_t slot_bytes);
    ~SharedSlots();
    SharedSlots(SharedSlots&& other) noexcept;
    SharedSlots& operator=(SharedSlots&& other) noexcept;

    int file() const { return file_.get(); }

    std::size_t count() const { return slots_; }

    /// Returns a slot. REQUIRES: which < count().
    std::span<std::byte> slot(std::size_t which) const {
        return {static_cast<std::byte*>(memory_) + which * slot_bytes_, slot_bytes_};
    }

  private:
    SharedSlots(OpenFile file, void* memory, std::size_t slots, std::size_t slot_bytes)
        : file_(std::move(file)), memory_(memory), slots_(slots), slot_bytes_(slot_bytes) {}

    OpenFile file_;
    void* memory_ = nullptr;
    std::size_t slots_ = 0;
    std::size_t slot_bytes_ = 0;
};

} // namespace wakesurf::server
