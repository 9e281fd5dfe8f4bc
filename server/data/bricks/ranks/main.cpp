// wakesurf-bricks: ranks of an MPI job that hold the bricks of a store in their memory, for a server whose
// disk is too slow. The server starts it (`wakesurf serve --bricks`) and outlives it.

#include "core/base/machine_memory.hpp"
#include "core/base/result.hpp"
#include "server/data/bricks/local_socket.hpp"
#include "server/data/bricks/ranks/brick_window.hpp"
#include "server/data/bricks/shared_slots.hpp"
#include "store/command/manual_page.hpp"
#include "store/command/memory_size.hpp"

#include <CLI/CLI.hpp>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <thread>
#include <vector>

namespace wakesurf::server {

/// Rank 0: receives the server's requests by the socket, gets bricks from the ranks into the shared memory,
/// and reports them.
class AskedBricks {
  public:
    /// Connects to the server at `door`. Error: Io; the server is missing, or refuses this job.
    static core::Result<AskedBricks>
    meet(const std::filesystem::path& door, const RankStore& store, BrickWindow& window);

    /// Handles pending requests. Returns false if the server has gone, or asks for a brick that cannot exist.
    /// @param wait  for the server, if there is nothing else to do
    bool poll(bool wait);

    /// Completes pending requests. Call it before the end.
    void finish();

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Coming {
        std::uint32_t slot;
        int rank; ///< the rank that has it
        Time since;
    };

    AskedBricks(OpenFile server, SharedSlots slots, const RankStore& store, BrickWindow& window)
        : server_(std::move(server)), slots_(std::move(slots)), store_(&store), window_(&window) {}

    bool take_asks();
    /// Says whether a rank's answer is overdue: it may hang, and the server has files.
    bool is_late(int rank, Time now) const;
    bool answer();

    OpenFile server_;
    SharedSlots slots_;
    const RankStore* store_;
    BrickWindow* window_;
    std::chrono::milliseconds patience_{};
    std::vector<MPI_Request> requests_;
    std::vector<Coming> coming_;        ///< of each request
    std::vector<std::uint32_t> filled_; ///< to be reported
};

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
        return core::fail(Error::Code::Io, "the server refused this job",
                          "its log says why: event=bricks_job");
    return SharedSlots::take(std::move(came.passed), welcome.slots, welcome.slot_bytes)
        .map([&](SharedSlots slots) {
            AskedBricks out(std::move(*server), std::move(slots), store, window);
            out.patience_ = std::chrono::milliseconds(welcome.patience);
            return out;
        });
}

bool AskedBricks::poll(bool wait) {
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

namespace {

using namespace wakesurf;

constexpr unsigned ending_patience = 10; // s
constexpr std::chrono::microseconds idle_poll_interval{50};

constexpr const char* chapters = R"(.SH SEE ALSO
\fBwakesurf\fR(1), \fBmpirun\fR(1), \fBsrun\fR(1)
)";

struct Wish {
    std::string store, socket;
    std::uint64_t memory = 0;
};

int say(const core::Error& error) {
    std::fprintf(stderr, "wakesurf-bricks: %s%s%s\n", error.message.c_str(),
                 error.hint.empty() ? "" : "; ", error.hint.c_str());
    return 1;
}

/// Returns a quarter of the node's memory, divided by its ranks: the server may run there as well.
std::uint64_t usual_memory() {
    MPI_Comm node = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    int ranks = 1;
    MPI_Comm_size(node, &ranks);
    MPI_Comm_free(&node);
    return core::granted_memory() / 4 / static_cast<std::uint64_t>(ranks);
}

/// Serves the server until it has gone.
core::Result<void>
talk(const Wish& wish, const server::RankStore& store, server::BrickWindow& window) {
    auto asked = server::AskedBricks::meet(wish.socket, store, window);
    if (!asked)
        return tl::unexpected(asked.error());
    bool more = true;
    while (asked->poll(!more))
        more = more && window.load_next();
    ::alarm(ending_patience); // a rank that hangs does not block the others
    asked->finish();
    return {};
}

/// Keeps this rank answering. A rank answers only inside MPI, unless the network does it alone: it calls MPI
/// often, and yields the processor in between.
void hold(server::BrickWindow& window, MPI_Request& end) {
    bool more = true;
    for (int over = 0; over == 0;) {
        MPI_Test(&end, &over, MPI_STATUS_IGNORE);
        more = more && window.load_next();
        if (!more && over == 0)
            std::this_thread::sleep_for(idle_poll_interval);
    }
}

/// Open MPI 4 prefers RDMA for windows also between nodes with TCP alone, where it cannot make one, and ends
/// the job. Its other ways can. Settings of mpirun or the environment stay.
void choose_windows() {
#if defined(OMPI_MAJOR_VERSION) && OMPI_MAJOR_VERSION < 5
    ::setenv("OMPI_MCA_osc", "^rdma", 0);
#endif
}

int run(const Wish& wish) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const auto store = server::RankStore::open(wish.store);
    int mine = store ? 1 : 0, all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (!store)
        return say(store.error());
    if (all == 0)
        return 1; // another rank has reported the error
    if (server::brick_record_bytes((*store)->shape().values) > INT_MAX) {
        return rank == 0 ? say({core::Error::Code::OverLimit, "a brick has more than 2 GiB", ""})
                         : 1;
    }
    const std::uint64_t usual = usual_memory();
    server::BrickWindow window(**store, wish.memory > 0 ? wish.memory : usual);
    MPI_Request end = MPI_REQUEST_NULL;
    core::Result<void> talked;
    if (rank == 0) {
        talked = talk(wish, **store, window);
        ::alarm(ending_patience);
        MPI_Ibarrier(MPI_COMM_WORLD, &end);
        MPI_Wait(&end, MPI_STATUS_IGNORE);
    } else {
        MPI_Ibarrier(MPI_COMM_WORLD, &end);
        hold(window, end);
        ::alarm(ending_patience);
    }
    return talked ? 0 : say(talked.error());
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Holds the bricks of a store in the memory of the ranks of an MPI job, for `wakesurf "
        "serve --bricks \"mpirun -n N\"`, which starts it.",
        "wakesurf-bricks");
    Wish wish;
    app.add_option("STORE", wish.store, "a store in bricks, which every rank can read")->required();
    app.add_option("--socket", wish.socket, "where the server waits for rank 0")->required();
    app.add_option("--memory", wish.memory,
                   "bytes of each rank for bricks, for example 64GiB (default: a quarter of its "
                   "node's memory, shared by the ranks there)")
        ->transform(command::as_memory_size());
    app.set_version_flag("--version", "wakesurf-bricks " WAKESURF_VERSION);
    app.add_flag_callback("--man-page",
                          [&] {
                              throw CLI::CallForVersion(
                                  command::manual_page(app, {WAKESURF_VERSION, chapters}), 0);
                          })
        ->group("");
    CLI11_PARSE(app, argc, argv);
    choose_windows();
    MPI_Init(&argc, &argv);
    const int status = run(wish);
    MPI_Finalize();
    return status;
}
