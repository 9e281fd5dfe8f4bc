#include "server/app/command_output.hpp"

#include "core/base/plain_text.hpp"
#include "server/app/name_mapping.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

namespace wakesurf::server {

namespace {

/// Says whether one line can be written without waiting: pipes have room for 4 KiB.
bool takes_lines() {
    pollfd error{STDERR_FILENO, POLLOUT, 0};
    return ::poll(&error, 1, 0) == 1 && error.revents == POLLOUT;
}

class ErrorLines final : public spdlog::sinks::base_sink<std::mutex> {
    void sink_it_(const spdlog::details::log_msg& message) override {
        if (left_out_ > 0) {
            const std::string text = fmt::format("event=lines_left_out count={}", left_out_);
            spdlog::details::log_msg told(message.logger_name, spdlog::level::warn, text);
            if (write(told))
                left_out_ = 0;
        }
        if (left_out_ > 0 || !write(message))
            ++left_out_;
    }

    bool write(const spdlog::details::log_msg& message) {
        spdlog::memory_buf_t line;
        formatter_->format(message, line);
        return takes_lines() && ::write(STDERR_FILENO, line.data(), line.size()) > 0;
    }

    void flush_() override {}

    std::size_t left_out_ = 0;
};

/// Formats %@: the message on one line.
class PrintableMessage final : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message,
                const std::tm&,
                spdlog::memory_buf_t& into) override {
        const std::string text =
            core::printable_line({message.payload.data(), message.payload.size()});
        into.append(text.data(), text.data() + text.size());
    }

    std::unique_ptr<custom_flag_formatter> clone() const override {
        return std::make_unique<PrintableMessage>();
    }
};

} // namespace

void log_to_standard_error(const std::string& level) {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("wakesurf", std::make_shared<ErrorLines>()));
    auto formatter = std::make_unique<spdlog::pattern_formatter>();
    formatter->add_flag<PrintableMessage>('@').set_pattern(
        "time=%Y-%m-%dT%H:%M:%S.%e%z level=%l %@");
    spdlog::set_formatter(std::move(formatter));
    spdlog::set_level(spdlog::level::from_str(level));
}

int report_failure(const core::Error& told) {
    const core::Error error = with_commands(told);
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    tell(stderr, "wakesurf: {}\n", core::printable_line(error.message + hint));
    return 1;
}

int report_refusal(const core::Error& error) {
    const int status = report_failure(error);
    return error.code == core::Error::Code::InvalidArgument ? wrong_usage : status;
}

} // namespace wakesurf::server
