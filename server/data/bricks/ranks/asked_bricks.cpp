#include "server/data/bricks/ranks/asked_bricks.hpp"

#include "server/data/bricks/local_socket.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::size_t most_asks = 1024;
constexpr int welcome_patience = 60'000; // ms

/// Waits until the socket is readable, or for so many milliseconds.
void wait_for(int socket, int milliseconds) {
    pollfd file{socket, POLLIN, 0};
    (void)::poll(&file, 1, milliseconds);
}

} // namespace

core::Result<AskedBricks>
AskedBricks::meet(const std::filesystem::path& door, const RankStore& store, BrickWindow& window) {
    auto server = knock(door);
    if (!server) {
        Error error = server.error();
        error.hint = "rank 0 has to run on the server's node";
        return tl::unexpected(error);
    }
    JobHello hello;
    hello.shape = store.shape();
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    hello.ranks = static_cast<std::uint64_t>(ranks);
    hello.held = window.room();
    std::vector<std::byte> words(sizeof(hello) + store.marks().size());
    std::memcpy(words.data(), &hello, sizeof(hello));
    std::memcpy(words.data() + sizeof(hello), store.marks().data(), store.marks().size());
    ServerWelcome welcome;
    Received came;
    if (send_message(server->get(), words)) {
        wait_for(server->get(), welcome_patience);
        came = receive_message(server->get(), std::as_writable_bytes(std::span(&welcome, 1)));
    }
    if (came.bytes != sizeof(welcome) || welcome.magic != job_magic || came.passed.get() < 0 ||
        welcome.slot_bytes != brick_record_bytes(store.shape().values))
        return core::fail(Error::Code::Io, "the server wants no such job",
                          "its log says why: event=bricks_job");
    return SharedSlots::take(std::move(came.passed), welcome.slots, welcome.slot_bytes)
        .map([&](SharedSlots slots) {
            AskedBricks out(std::move(*server), std::move(slots), store, window);
            out.patience_ = std::chrono::milliseconds(welcome.patience);
            return out;
        });
}

bool AskedBricks::look(bool wait) {
    constexpr int idle = 1000; // ms
    if (wait && requests_.empty())
        wait_for(server_.get(), idle);
    return take_asks() && answer();
}

void AskedBricks::finish() {
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    requests_.clear();
    coming_.clear();
}

bool AskedBricks::take_asks() {
    std::array<BrickAsk, most_asks> asks;
    for (;;) {
        const Received came =
            receive_message(server_.get(), std::as_writable_bytes(std::span(asks)));
        if (came.state == Received::State::Nothing)
            return true;
        if (came.state == Received::State::Closed || came.bytes > sizeof(asks) ||
            came.bytes % sizeof(BrickAsk) != 0)
            return false;
        for (const BrickAsk& ask : std::span(asks).first(came.bytes / sizeof(BrickAsk))) {
            if (ask.slot >= slots_.count() || !store_->has(ask.step, ask.brick))
                return false;
            const auto slot = slots_.slot(ask.slot);
            new (slot.data()) BrickHead{}; // until data come: not held
            const auto rank = window_->rank_of(ask.step, ask.brick);
            const Time now = std::chrono::steady_clock::now();
            if (rank && !is_late(*rank, now)) {
                requests_.push_back(window_->get(ask.step, ask.brick, slot));
                coming_.push_back({ask.slot, *rank, now});
            } else {
                filled_.push_back(ask.slot);
            }
        }
    }
}

bool AskedBricks::is_late(int rank, Time now) const {
    return std::ranges::any_of(coming_, [&](const Coming& each) {
        return each.rank == rank && now - each.since >= patience_;
    });
}

bool AskedBricks::answer() {
    for (std::size_t i = 0; i < requests_.size();) {
        int here = 0;
        MPI_Test(&requests_[i], &here, MPI_STATUS_IGNORE);
        if (here == 0) {
            ++i;
            continue;
        }
        filled_.push_back(coming_[i].slot);
        requests_[i] = requests_.back();
        coming_[i] = coming_.back();
        requests_.pop_back();
        coming_.pop_back();
    }
    if (filled_.empty())
        return true;
    const bool told = send_message(server_.get(), std::as_bytes(std::span(filled_)));
    filled_.clear();
    return told;
}

} // namespace wakesurf::server
