// A forecast of the remaining time of work, from the growth of the part that is done: by a power of the time,
// since some work is steady and other work, as on a surface that grows, slows down.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

class Forecast {
  public:
    /// Adds an observation.
    /// @param seconds   since the work began; less than in the last call: other work has begun
    /// @param fraction  done by then, 0..1
    void add(double seconds, double fraction);

    /// Returns the remaining seconds at the last add(). Empty: too early for a forecast.
    std::optional<double> left() const;

  private:
    struct Seen {
        double seconds, fraction;
    };

    std::vector<Seen> seen_;
};

/// Returns `about 40 s left`, `about 3 min left`, `about 2 h left`.
std::string words_for_left(double seconds);

} // namespace wakesurf::server
