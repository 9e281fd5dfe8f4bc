#include "tests/bench/load/swarm.hpp"

#include "protocol/wire/mesh_frame.hpp"

#include <boost/asio/bind_executor.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <nlohmann/json.hpp>

#include <deque>
#include <future>
#include <optional>
#include <stdexcept>
#include <thread>

namespace wakesurf::bench {

namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;
using nlohmann::json;

namespace {

constexpr std::chrono::seconds patience{60};

/// What all viewers of a swarm share; its thread only.
struct SwarmCommon {
    ServerAddress address;
    SwarmTarget target;
    std::vector<Arrival> arrivals{};
    std::size_t bytes = 0;
    std::string trouble{};                 ///< of the first viewer that had any
    std::function<void()> changed = [] {}; ///< a viewer has become ready, or is in trouble
};

class Viewer : public std::enable_shared_from_this<Viewer> {
  public:
    Viewer(asio::io_context& context,
           SwarmCommon& common,
           std::uint32_t number,
           ViewerHabits habits,
           bool idle)
        : context_(context), rest_(context), common_(common), number_(number), habits_(habits),
          idle_(idle) {}

    void open() {
        ready_ = false;
        buffer_.clear();
        const std::uint32_t life = ++life_;
        stream_.emplace(context_);
        stream_->read_message_max(64u << 20);
        stream_->auto_fragment(false);
        stream_->set_option(beast::websocket::stream_base::decorator(
            [bearer = "Bearer " + common_.address.token](beast::websocket::request_type& request) {
                request.set(beast::http::field::authorization, bearer);
                request.set(beast::http::field::sec_websocket_protocol, "wakesurf.v1");
            }));
        const auto port = static_cast<std::uint16_t>(std::stoi(common_.address.port));
        stream_->next_layer().async_connect({asio::ip::make_address(common_.address.host), port},
                                            [self = shared_from_this(), life](error_code error) {
                                                if (life != self->life_)
                                                    return;
                                                if (error)
                                                    return self->fail("connect", error);
                                                error_code ignored;
                                                self->stream_->next_layer().set_option(
                                                    asio::ip::tcp::no_delay(true), ignored);
                                                self->shake_hands(life);
                                            });
    }

    /// Without a goodbye.
    void cut() {
        ++life_;
        error_code ignored;
        if (stream_) {
            stream_->next_layer().set_option(asio::socket_base::linger(true, 0), ignored);
            stream_->next_layer().close(ignored);
        }
        ready_ = false;
    }

    bool ready() const { return ready_; }

    void call(const std::string& method, const json& parameters) {
        send(
            json{{"jsonrpc", "2.0"}, {"id", next_id_++}, {"method", method}, {"params", parameters}}
                .dump());
    }

  private:
    void shake_hands(std::uint32_t life) {
        stream_->async_handshake(common_.address.host + ":" + common_.address.port, "/ws",
                                 [self = shared_from_this(), life](error_code error) {
                                     if (life != self->life_)
                                         return;
                                     if (error)
                                         return self->fail("handshake", error);
                                     self->greet();
                                     self->read(life);
                                 });
    }

    void greet() {
        if (idle_)
            return become_ready();
        json join{{"session", common_.target.session}, {"name", "viewer"}};
        if (!resume_token_.empty())
            join["resumeToken"] = resume_token_;
        send(json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", "session.join"}, {"params", join}}
                 .dump());
        send(json{{"jsonrpc", "2.0"},
                  {"id", 2},
                  {"method", "surface.subscribe"},
                  {"params", {{"surface", common_.target.surface}}}}
                 .dump());
    }

    void send(std::string text) {
        outgoing_.push_back(std::move(text));
        if (outgoing_.size() == 1)
            write(life_);
    }

    void write(std::uint32_t life) {
        stream_->text(true);
        stream_->async_write(asio::buffer(outgoing_.front()),
                             [self = shared_from_this(), life](error_code error, std::size_t) {
                                 if (life != self->life_) {
                                     self->outgoing_.clear();
                                     return;
                                 }
                                 self->outgoing_.pop_front();
                                 if (error)
                                     return self->fail("write", error);
                                 if (!self->outgoing_.empty())
                                     self->write(life);
                             });
    }

    void read(std::uint32_t life) {
        stream_->async_read(buffer_,
                            [self = shared_from_this(), life](error_code error, std::size_t bytes) {
                                if (life != self->life_)
                                    return;
                                if (error)
                                    return self->fail("read", error);
                                if (self->stream_->got_text())
                                    self->message(beast::buffers_to_string(self->buffer_.data()));
                                else
                                    self->frame();
                                self->buffer_.consume(self->buffer_.size());
                                self->rest(bytes, life);
                            });
    }

    void rest(std::size_t bytes, std::uint32_t life) {
        if (habits_.stalled && ready_)
            return; // the connection stays as it is
        if (habits_.bytes_per_second == 0 || !ready_)
            return read(life);
        rest_.expires_after(
            std::chrono::nanoseconds(bytes * 1'000'000'000ull / habits_.bytes_per_second));
        rest_.async_wait([self = shared_from_this(), life](error_code error) {
            if (!error && life == self->life_)
                self->read(life);
        });
    }

    void message(const std::string& text) {
        if (text.find("\"method\":") !=
            std::string::npos) // a notification: viewers are many, none reads it
            return;
        const json answer = json::parse(text);
        if (answer.contains("error"))
            return trouble("refused: " + answer["error"]["message"].get<std::string>());
        if (answer.value("id", 0) == 1)
            resume_token_ = answer["result"].value("resumeToken", "");
    }

    void frame() {
        common_.bytes += buffer_.size();
        const auto* first = static_cast<const std::byte*>(buffer_.data().data());
        const auto frame = protocol::read_frame(std::span(first, buffer_.size()));
        if (!frame)
            return trouble(frame.error().message);
        if (frame->header.frame_index + 1 != frame->header.frame_count)
            return;
        common_.arrivals.push_back({number_, frame->header.epoch, Clock::now()});
        become_ready();
    }

    void become_ready() {
        if (!std::exchange(ready_, true))
            common_.changed();
    }

    void fail(const char* what, error_code error) {
        trouble(std::string(what) + ": " + error.message());
    }

    void trouble(const std::string& text) {
        if (common_.trouble.empty())
            common_.trouble = "viewer " + std::to_string(number_) + ": " + text;
        common_.changed();
    }

    asio::io_context& context_;
    asio::steady_timer rest_;
    SwarmCommon& common_;
    std::uint32_t number_;
    ViewerHabits habits_;
    bool idle_;
    std::optional<beast::websocket::stream<asio::ip::tcp::socket>> stream_;
    beast::flat_buffer buffer_;
    std::deque<std::string> outgoing_;
    std::string resume_token_;
    int next_id_ = 3;
    std::uint32_t life_ = 0; ///< handlers of an earlier connection do nothing
    bool ready_ = false;
};

} // namespace

struct Swarm::State {
    State(ServerAddress address, SwarmTarget target)
        : common{std::move(address), std::move(target)} {
        common.changed = [this] { look(); };
        thread = std::jthread([this] { context.run(); });
    }

    ~State() { context.stop(); }

    /// Runs `act` on the swarm's thread and waits until every viewer is ready.
    void and_wait(const std::function<void()>& act) {
        std::promise<std::string> settled;
        auto done = settled.get_future();
        asio::post(context, [&] {
            waiting = &settled;
            act();
            look();
        });
        const bool in_time = done.wait_for(patience) == std::future_status::ready;
        if (!in_time)
            throw std::runtime_error("not every viewer was ready within a minute");
        if (const std::string trouble = done.get(); !trouble.empty())
            throw std::runtime_error(trouble);
    }

    void look() {
        constexpr std::size_t at_a_time = 64;
        std::size_t opening = 0;
        for (std::size_t i = 0; i < started; ++i)
            opening += viewers[i]->ready() ? 0 : 1;
        for (; started < viewers.size() && opening < at_a_time; ++opening)
            viewers[started++]->open();
        if (waiting != nullptr && (!common.trouble.empty() || opening == 0))
            std::exchange(waiting, nullptr)->set_value(common.trouble);
    }

    void add(std::size_t count, ViewerHabits habits, bool idle) {
        and_wait([&] {
            for (std::size_t i = 0; i < count; ++i)
                viewers.push_back(std::make_shared<Viewer>(
                    context, common, static_cast<std::uint32_t>(viewers.size()), habits, idle));
        });
    }

    template <class T>
    T taken(T SwarmCommon::*member) {
        std::promise<T> promise;
        asio::post(context, [&] { promise.set_value(std::exchange(common.*member, T{})); });
        return promise.get_future().get();
    }

    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> stay =
        asio::make_work_guard(context);
    SwarmCommon common;
    std::vector<std::shared_ptr<Viewer>> viewers;
    std::size_t started = 0;
    std::promise<std::string>* waiting = nullptr;
    std::jthread thread;
};

Swarm::Swarm(ServerAddress address, SwarmTarget target)
    : state_(std::make_unique<State>(std::move(address), std::move(target))) {}

Swarm::~Swarm() = default;

void Swarm::connect(std::size_t count, ViewerHabits habits) {
    state_->add(count, habits, false);
}

void Swarm::connect_idle(std::size_t count) {
    state_->add(count, {}, true);
}

double Swarm::storm() {
    const auto start = Clock::now();
    state_->and_wait([this] {
        for (const auto& each : state_->viewers)
            each->cut();
        for (const auto& each : state_->viewers)
            each->open();
    });
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void Swarm::send(std::size_t viewer, const std::string& method, const json& parameters) {
    asio::post(state_->context, [state = state_.get(), viewer, method, parameters] {
        state->viewers.at(viewer)->call(method, parameters);
    });
}

std::vector<Arrival> Swarm::take_arrivals() {
    return state_->taken(&SwarmCommon::arrivals);
}

std::size_t Swarm::take_bytes() {
    return state_->taken(&SwarmCommon::bytes);
}

} // namespace wakesurf::bench
