// A completion handler of any type behind one type, so that Beast's algorithms are compiled once for all
// streams. Asio has its own (any_completion_handler) since Boost 1.82.
#pragma once

#include <boost/system/error_code.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace wakesurf::server {

/// Holds a handler. Move-only; called once. Cost: one allocation.
class AnyHandler {
  public:
    template <class Handler>

    requires(!std::is_same_v<std::decay_t<Handler>, AnyHandler>) explicit AnyHandler(
        Handler&& handler)
        : call_(std::make_unique<Held<std::decay_t<Handler>>>(std::forward<Handler>(handler))) {}

    void operator()(boost::system::error_code error, std::size_t bytes = 0) {
        const auto call = std::move(call_); // the handler may own the stream
        call->run(error, bytes);
    }

  private:
    struct Callable {
        virtual ~Callable() = default;
        virtual void run(boost::system::error_code error, std::size_t bytes) = 0;
    };

    template <class Handler>
    struct Held final : Callable {
        template <class From>
        explicit Held(From&& from) : handler(std::forward<From>(from)) {}

        void run(boost::system::error_code error, std::size_t bytes) override {
            Handler local(std::move(handler));
            if constexpr (std::is_invocable_v<Handler&, boost::system::error_code, std::size_t>)
                local(error, bytes);
            else
                local(error);
        }

        Handler handler;
    };

    std::unique_ptr<Callable> call_;
};

} // namespace wakesurf::server
