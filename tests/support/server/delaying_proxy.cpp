#include "tests/support/server/delaying_proxy.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <deque>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace wakesurf::tests {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

namespace {

/// The capacity of a line before its sender has to wait, like a router's buffer.
constexpr std::size_t line_buffer = 256u << 10;

/// The two directions of one connection.
class Line : public std::enable_shared_from_this<Line> {
  public:
    Line(tcp::socket client, LineQuality quality)
        : ends_{std::move(client), tcp::socket(ends_[0].get_executor())},
          quality_(quality), ways_{Way{asio::steady_timer(ends_[0].get_executor())},
                                   Way{asio::steady_timer(ends_[0].get_executor())}} {}

    void open(std::uint16_t target) {
        ends_[1].async_connect({asio::ip::address_v4::loopback(), target},
                               [self = shared_from_this()](error_code error) {
                                   if (error)
                                       return self->end();
                                   error_code ignored;
                                   for (tcp::socket& each : self->ends_)
                                       each.set_option(tcp::no_delay(true), ignored);
                                   self->read(0);
                                   self->read(1);
                               });
    }

    void stall(bool stalled) {
        stalled_ = stalled;
        if (!stalled)
            for (std::size_t from : {0, 1}) {
                read(from);
                write(from);
            }
    }

    /// Ends the connection with a reset.
    void end() {
        error_code ignored;
        for (tcp::socket& each : ends_) {
            each.set_option(asio::socket_base::linger(true, 0), ignored);
            each.close(ignored);
        }
        for (Way& way : ways_)
            way.timer.cancel();
    }

    bool closed() const { return !ends_[0].is_open(); }

  private:
    struct Parcel {
        Clock::time_point due;
        std::vector<char> bytes;
    };

    struct Way {
        explicit Way(asio::steady_timer due) : timer(std::move(due)) {}

        asio::steady_timer timer;
        std::array<char, 16384> buffer{};
        std::deque<Parcel> parcels{};
        std::size_t waiting = 0; ///< bytes in parcels
        bool reading = false, writing = false, ended = false;
        Clock::time_point free_at{}; ///< of a line of limited rate
    };

    void read(std::size_t from) {
        Way& way = ways_[from];
        if (way.reading || way.ended || stalled_ || way.waiting >= line_buffer)
            return;
        way.reading = true;
        ends_[from].async_read_some(
            asio::buffer(way.buffer),
            [self = shared_from_this(), from](error_code error, std::size_t bytes) {
                Way& done = self->ways_[from];
                done.reading = false;
                if (error) {
                    done.ended = true;
                } else {
                    done.parcels.push_back({self->due(done, from, bytes),
                                            {done.buffer.begin(), done.buffer.begin() + bytes}});
                    done.waiting += bytes;
                    self->read(from);
                }
                self->write(from);
            });
    }

    Clock::time_point due(Way& way, std::size_t from, std::size_t bytes) const {
        const auto now = Clock::now();
        if (from == 0 || quality_.bytes_per_second == 0)
            return now + quality_.delay;
        way.free_at =
            std::max(way.free_at, now) +
            std::chrono::nanoseconds(bytes * 1'000'000'000ull / quality_.bytes_per_second);
        return way.free_at + quality_.delay;
    }

    void write(std::size_t from) {
        Way& way = ways_[from];
        if (way.writing || stalled_)
            return;
        if (way.parcels.empty()) {
            if (way.ended) // what one side has sent before it closed arrives
                end();
            return;
        }
        way.writing = true;
        way.timer.expires_at(way.parcels.front().due);
        way.timer.async_wait([self = shared_from_this(), from](error_code error) {
            if (error)
                return;
            asio::async_write(self->ends_[1 - from],
                              asio::buffer(self->ways_[from].parcels.front().bytes),
                              [self, from](error_code failed, std::size_t bytes) {
                                  Way& done = self->ways_[from];
                                  done.writing = false;
                                  done.waiting -= bytes;
                                  done.parcels.pop_front();
                                  if (failed)
                                      return self->end();
                                  self->read(from);
                                  self->write(from);
                              });
        });
    }

    std::array<tcp::socket, 2> ends_; ///< client, server
    LineQuality quality_;
    std::array<Way, 2> ways_; ///< from the client, from the server
    bool stalled_ = false;
};

} // namespace

struct DelayingProxy::State {
    State(std::uint16_t to, LineQuality line) : target(to), quality(line) {
        accept();
        thread = std::jthread([this] { context.run(); });
    }

    void accept() {
        acceptor.async_accept([this](error_code error, tcp::socket socket) {
            if (error)
                return;
            std::erase_if(lines, [](const auto& each) { return each->closed(); });
            auto line = std::make_shared<Line>(std::move(socket), quality);
            lines.insert(line);
            line->open(target);
            accept();
        });
    }

    void each(void (*act)(Line&)) {
        asio::post(context, [this, act] {
            for (const auto& line : lines)
                act(*line);
        });
    }

    std::uint16_t target;
    LineQuality quality;
    asio::io_context context{1};
    tcp::acceptor acceptor{context, {asio::ip::address_v4::loopback(), 0}};
    std::set<std::shared_ptr<Line>> lines;
    std::jthread thread;
};

DelayingProxy::DelayingProxy(std::uint16_t target, LineQuality quality)
    : state_(std::make_unique<State>(target, quality)) {}

DelayingProxy::~DelayingProxy() {
    state_->context.stop();
}

std::uint16_t DelayingProxy::port() const {
    return state_->acceptor.local_endpoint().port();
}

void DelayingProxy::cut() {
    state_->each([](Line& line) { line.end(); });
}

void DelayingProxy::stall(bool stalled) {
    if (stalled)
        state_->each([](Line& line) { line.stall(true); });
    else
        state_->each([](Line& line) { line.stall(false); });
}

} // namespace wakesurf::tests
