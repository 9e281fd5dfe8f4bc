#include "server/base/process_account.hpp"

#include "core/base/machine_memory.hpp"
#include "server/base/spare_heap.hpp"

#include <cstdint>

namespace wakesurf::server {

namespace {

/// The default's share of the memory, in percent.
constexpr std::uint64_t part = 60;
constexpr std::size_t without_proc = std::size_t{4} << 30;

} // namespace

std::size_t default_memory() {
    const std::uint64_t granted = core::granted_memory();
    return granted == 0 ? without_proc : static_cast<std::size_t>(granted / 100 * part);
}

ProcessAccount::ProcessAccount(std::size_t budget)
    : account_(budget == 0 ? default_memory() : budget),
      spare_heap_(account_.on_need(core::GiveBack::SpareHeap,
                                   [](std::size_t) { give_back_spare_heap(); })) {
    account_.watch([] { return static_cast<std::size_t>(core::resident_memory()); });
}

bool ProcessAccount::too_much() const {
    account_.look();
    return account_.used() > account_.budget();
}

} // namespace wakesurf::server
