#include "tests/simulation/world_server.hpp"

#include "server/net/methods/client.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/outbox.hpp"
#include "server/sessions/session_exchange.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

namespace wakesurf::simulation {

using nlohmann::json;
using namespace std::chrono_literals;

/// As server/net/websocket_connection.cpp, over a link.
class WorldServer::Connection final : public server::Wire,
                                      public std::enable_shared_from_this<Connection> {
  public:
    Connection(WorldServer& server, std::shared_ptr<Link> link)
        : server_(server), link_(std::move(link)) {}

    void open() {
        client_.emplace(*this, server::Identity{}, server_.grants_);
        const auto weak = weak_from_this();
        link_->attach(
            Link::Server,
            [weak](Message message) {
                if (const auto self = weak.lock())
                    self->received(std::get<std::string>(message));
            },
            [weak] {
                if (const auto self = weak.lock())
                    self->end();
            });
    }

    void crash() {
        open_ = false;
        link_->crash();
    }

    /// Something may still hold the connection when the server has gone.
    void forget() { client_.reset(); }

    void send(std::string message) override {
        if (!open_)
            return;
        if (!outbox_.push(std::move(message)))
            return close();
        write();
    }

    bool may_follow(std::uint32_t surface) override { return outbox_.may_follow(surface); }

    void follow(server::FrameCursor cursor) override {
        cursor.wake_by([weak = weak_from_this()] {
            if (const auto self = weak.lock())
                self->write();
        });
        outbox_.follow(std::move(cursor));
        write();
    }

    bool unfollow(std::uint32_t surface) override { return outbox_.unfollow(surface); }

    bool acknowledge(std::uint32_t surface,
                     std::optional<std::uint32_t> epoch,
                     std::uint32_t seq) override {
        server::FrameCursor* const cursor = outbox_.cursor(surface);
        if (cursor == nullptr)
            return false;
        cursor->acknowledge({epoch.value_or(cursor->ring().epoch()), seq});
        write();
        return true;
    }

    void close(server::Goodbye, const std::string&) override { close(); }

  private:
    void received(const std::string& text) {
        if (!open_)
            return;
        server_.dispatcher_.dispatch(text, client_->identity(), &*client_,
                                     [weak = weak_from_this()](std::string answer) {
                                         const auto self = weak.lock();
                                         if (self && !answer.empty())
                                             self->send(std::move(answer));
                                     });
        server_.compute();
    }

    void write() {
        if (busy_ || !open_)
            return;
        busy_ = true;
        auto item = outbox_.pop();
        if (!item || !open_) {
            busy_ = false;
            return;
        }
        Message message;
        if (auto* text = std::get_if<server::Outbox::Message>(&*item))
            message = **text;
        else
            message = *std::get<server::Outbox::Frame>(*item);
        link_->send(Link::Client, std::move(message), [weak = weak_from_this()] {
            if (const auto self = weak.lock()) {
                self->busy_ = false;
                self->write();
                self->server_.compute(); // a cursor may have asked for a keyframe
            }
        });
    }

    void close() {
        end();
        link_->cut();
    }

    void end() {
        open_ = false;
        server_.loop_.post([self = shared_from_this()] {
            self->client_.reset();
            std::erase(self->server_.connections_, self);
        });
    }

    WorldServer& server_;
    std::shared_ptr<Link> link_;
    server::Outbox outbox_;
    bool busy_ = false;
    bool open_ = true;
    std::optional<server::Client> client_;
};

WorldServer::WorldServer(World& world, Disk& disk, const server::Datasets& datasets)
    : world_(world), clock_(world), loop_(world, [this] { compute(); }), entropy_(world),
      journal_(world, disk),
      grants_({loop_, clock_, entropy_, [] { return std::int64_t{0}; }, &journal_}),
      sessions_({loop_, pool_, datasets, entropy_, nullptr, &journal_, &clock_,
                 [] { return std::int64_t{0}; }}),
      dispatcher_(server::method_table(),
                  {sessions_, datasets, [] { return json::array(); }, prober_, grants_, clock_,
                   loop_, &journal_},
                  {}) {
    const auto restored = server::restore_sessions(disk.entries(), sessions_, grants_);
    if (!restored.refused.empty())
        throw std::runtime_error("not restored: " + restored.refused.front().record.why);
    compute();
}

WorldServer::~WorldServer() {
    for (const auto& each : connections_)
        each->crash();
    for (const auto& each : connections_)
        each->forget();
}

void WorldServer::welcome(const std::shared_ptr<Link>& link) {
    const auto connection = std::make_shared<Connection>(*this, link);
    connections_.push_back(connection);
    connection->open();
}

json WorldServer::ask(const std::string& method, const json& parameters) {
    std::string answer;
    dispatcher_.dispatch(
        json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}}.dump(), {},
        nullptr, [&answer](std::string text) { answer = std::move(text); });
    compute();
    const json whole = json::parse(answer);
    if (!whole.contains("result"))
        throw std::runtime_error(method + " answers " + answer);
    return whole["result"];
}

/// Whoever may have given the pool something to do calls this.
void WorldServer::compute() {
    if (std::exchange(computing_, true))
        return;
    world_.after(world_.time_between(100us, 4000us), [this, alive = std::weak_ptr(alive_)] {
        if (alive.expired())
            return;
        computing_ = false;
        clock_.begin();
        const bool worked = pool_.turn();
        clock_.end();
        if (worked)
            compute();
    });
}

} // namespace wakesurf::simulation
