#include "core/dataset/slab.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <limits>
#include <new>
#include <utility>

namespace wakesurf::core {

namespace {

constexpr std::size_t page = 4096;
constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t overread = 64;

std::byte* map_anonymous(std::size_t bytes) {
    void* address =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (address == MAP_FAILED)
        throw std::bad_alloc();
    return static_cast<std::byte*>(address);
}

// Maps more than needed and gives back both ends, because mmap only promises 4 KiB alignment and a
// huge page needs 2 MiB.
std::byte* map_aligned(std::size_t bytes) {
    std::byte* const start = map_anonymous(bytes + huge_page);
    const auto misplaced = reinterpret_cast<std::uintptr_t>(start) % huge_page;
    const std::size_t before = misplaced == 0 ? 0 : huge_page - misplaced;
    if (before > 0)
        ::munmap(start, before);
    ::munmap(start + before + bytes, huge_page - before);
    ::madvise(start + before, bytes, MADV_HUGEPAGE);
    return start + before;
}

} // namespace

std::size_t Slab::reservation(std::size_t bytes) {
    if (bytes == 0)
        return 0;
    if (bytes > std::numeric_limits<std::size_t>::max() / 2)
        throw std::bad_alloc();
    return (bytes + overread + page - 1) / page * page;
}

Slab::Slab(std::size_t bytes) : size_(bytes), reserved_(reservation(bytes)) {
    if (reserved_ > 0)
        data_ = reserved_ >= huge_page ? map_aligned(reserved_) : map_anonymous(reserved_);
}

Slab::~Slab() {
    if (data_ != nullptr)
        ::munmap(data_, reserved_);
}

Slab::Slab(Slab&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
      reserved_(std::exchange(other.reserved_, 0)) {}

Slab& Slab::operator=(Slab&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(reserved_, other.reserved_);
    return *this;
}

} // namespace wakesurf::core
