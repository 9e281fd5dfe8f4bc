#include "tests/bench/load/link_flood.hpp"

#include "server/live/compute/worker_threads.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::bench {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::chrono::milliseconds before_another_try{50};

/// A masked text frame; the mask of zeros changes nothing.
std::string frame_of(const std::string& payload) {
    std::string frame{static_cast<char>(0x81), static_cast<char>(0x80 | 126),
                      static_cast<char>(payload.size() >> 8),
                      static_cast<char>(payload.size() & 0xff)};
    return frame + std::string(4, '\0') + payload;
}

struct Common {
    ServerAddress address;
    FloodOptions options;
    std::string edit = frame_of(
        R"({"jsonrpc":"2.0","id":1,"method":"rake.set","params":{"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":4,)"
        R"("name":"this is one of the edits that a viewer may not make, over and over again"}})");
    std::atomic<std::size_t> let_in = 0, turned_away = 0, edits = 0, downloaded = 0,
                             not_downloaded = 0;

    std::string request(const std::string& path, const std::string& headers) const {
        return "GET " + path + " HTTP/1.1\r\nHost: " + address.host + "\r\nAuthorization: Bearer " +
               address.token + "\r\n" + headers + "\r\n";
    }
};

/// One connection after the other, each with one request; what comes of it is the heirs' business.
class Loop : public std::enable_shared_from_this<Loop> {
  public:
    Loop(asio::io_context& context, Common& common)
        : common_(common), socket_(context), pause_(context) {}

    virtual ~Loop() = default;

    void begin() {
        const auto port = static_cast<std::uint16_t>(std::stoi(common_.address.port));
        socket_.async_connect({asio::ip::make_address(common_.address.host), port},
                              [self = shared_from_this()](error_code error) {
                                  if (error)
                                      return self->again();
                                  self->text_ = self->request();
                                  self->answer_.clear();
                                  self->write_request();
                              });
    }

  protected:
    virtual std::string request() const = 0;
    /// More of the answer is there.
    virtual void received() = 0;
    /// The connection has ended.
    virtual void ended() = 0;

    void again() {
        error_code ignored;
        socket_.close(ignored);
        pause_.expires_after(before_another_try);
        pause_.async_wait([self = shared_from_this()](error_code error) {
            if (!error)
                self->begin();
        });
    }

    Common& common_;
    tcp::socket socket_;
    std::string answer_; ///< its beginning

  private:
    void write_request() {
        asio::async_write(socket_, asio::buffer(text_),
                          [self = shared_from_this()](error_code error, std::size_t) {
                              if (error)
                                  return self->again();
                              self->read();
                          });
    }

    void read() {
        socket_.async_read_some(asio::buffer(part_),
                                [self = shared_from_this()](error_code error, std::size_t bytes) {
                                    if (error) {
                                        self->ended();
                                        return self->again();
                                    }
                                    if (self->answer_.size() < self->part_.size())
                                        self->answer_.append(self->part_.data(), bytes);
                                    self->received();
                                    self->read();
                                });
    }

    asio::steady_timer pause_;
    std::string text_;
    std::array<char, 16384> part_{};
};

class Socket final : public Loop {
  public:
    using Loop::Loop;

  private:
    std::string request() const override {
        return common_.request("/ws", "Upgrade: websocket\r\nConnection: Upgrade\r\n"
                                      "Sec-WebSocket-Version: 13\r\n"
                                      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n");
    }

    void received() override {
        if (open_ || answer_.find("\r\n\r\n") == std::string::npos)
            return;
        if (!answer_.starts_with("HTTP/1.1 101"))
            return;
        open_ = true;
        ++common_.let_in;
        edit();
    }

    void ended() override {
        if (std::exchange(open_, false))
            --common_.let_in;
        else
            ++common_.turned_away;
    }

    void edit() {
        asio::async_write(socket_, asio::buffer(common_.edit),
                          [self = std::static_pointer_cast<Socket>(shared_from_this())](
                              error_code error, std::size_t) {
                              if (error)
                                  return;
                              ++self->common_.edits;
                              self->edit();
                          });
    }

    bool open_ = false;
};

class Download final : public Loop {
  public:
    using Loop::Loop;

  private:
    std::string request() const override {
        return common_.request(common_.options.mesh, "Connection: close\r\n");
    }

    void received() override {}

    void ended() override {
        ++(answer_.starts_with("HTTP/1.1 200") ? common_.downloaded : common_.not_downloaded);
    }
};

} // namespace

struct LinkFlood::State {
    State(ServerAddress address, FloodOptions options)
        : common{std::move(address), std::move(options)} {
        for (std::size_t i = 0; i < common.options.sockets; ++i)
            std::make_shared<Socket>(context, common)->begin();
        for (std::size_t i = 0; i < common.options.downloads; ++i)
            std::make_shared<Download>(context, common)->begin();
        thread = std::thread([this] {
            server::step_back(server::long_niceness);
            context.run();
        });
    }

    ~State() {
        context.stop();
        thread.join();
    }

    Common common;
    asio::io_context context{1};
    std::thread thread;
};

LinkFlood::LinkFlood(ServerAddress address, FloodOptions options)
    : state_(std::make_unique<State>(std::move(address), std::move(options))) {}

LinkFlood::~LinkFlood() = default;

FloodCounts LinkFlood::counts() const {
    const Common& common = state_->common;
    return {common.let_in, common.turned_away, common.edits, common.downloaded,
            common.not_downloaded};
}

} // namespace wakesurf::bench
