#include "server/data/bricks/shared_slots.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <system_error>
#include <utility>

namespace wakesurf::server {

using core::Error;

namespace {

tl::unexpected<Error> no_shared_memory() {
    return core::fail(Error::Code::Io,
                      "no shared memory: " + std::generic_category().message(errno));
}

core::Result<void*> mapped(int file, std::size_t bytes) {
    void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED)
        return no_shared_memory();
    return memory;
}

} // namespace

core::Result<SharedSlots> SharedSlots::make(std::size_t slots, std::size_t slot_bytes) {
    OpenFile file(::memfd_create("wakesurf-bricks", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (file.get() < 0 || ::ftruncate(file.get(), static_cast<off_t>(slots * slot_bytes)) != 0 ||
        ::fcntl(file.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
        return no_shared_memory();
    return mapped(file.get(), slots * slot_bytes).map([&](void* memory) {
        return SharedSlots(std::move(file), memory, slots, slot_bytes);
    });
}

core::Result<SharedSlots>
SharedSlots::take(OpenFile file, std::size_t slots, std::size_t slot_bytes) {
    struct stat status {};

    if (slots == 0 || slot_bytes == 0 ||
        slot_bytes > std::numeric_limits<std::size_t>::max() / slots ||
        ::fstat(file.get(), &status) != 0 ||
        static_cast<std::uint64_t>(status.st_size) < slots * slot_bytes)
        return core::fail(Error::Code::Io, "the shared memory is smaller than announced");
    return mapped(file.get(), slots * slot_bytes).map([&](void* memory) {
        return SharedSlots(std::move(file), memory, slots, slot_bytes);
    });
}

SharedSlots::~SharedSlots() {
    if (memory_ != nullptr)
        ::munmap(memory_, slots_ * slot_bytes_);
}

SharedSlots::SharedSlots(SharedSlots&& other) noexcept
    : file_(std::move(other.file_)), memory_(std::exchange(other.memory_, nullptr)),
      slots_(other.slots_), slot_bytes_(other.slot_bytes_) {}

SharedSlots& SharedSlots::operator=(SharedSlots&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(memory_, other.memory_);
    std::swap(slots_, other.slots_);
    std::swap(slot_bytes_, other.slot_bytes_);
    return *this;
}

} // namespace wakesurf::server
