// How long a piece of work will still take, from how the part that is done has grown: by a power of the
// time, since some work goes evenly and other work, as on a surface that grows, slows down.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

class Forecast {
  public:
    /// @param seconds   since the work began; less than in the last call: of other work
    /// @param fraction  done by then, 0..1
    void add(double seconds, double fraction);

    /// Seconds from the last call of add(). Nothing: it is too early to tell.
    std::optional<double> left() const;

  private:
    struct Seen {
        double seconds, fraction;
    };

    std::vector<Seen> seen_;
};

/// `about 40 s left`, `about 3 min left`, `about 2 h left`.
std::string words_for_left(double seconds);

} // namespace wakesurf::server
