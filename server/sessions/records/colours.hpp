// The colours of participants and rakes: those Okabe and Ito chose so that colour-blind people tell them
// apart ("Color Universal Design", 2008), without black, which is not assigned.
#pragma once

#include "protocol/api/base/json_members.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace wakesurf::server {

using protocol::is_colour;

inline constexpr std::array<std::string_view, 7> palette{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                         "#56b4e9", "#d55e00", "#f0e442"};

/// Counts the holders of each colour, to tell the next one of the palette that the fewest have.
class ColourCount {
  public:
    void add(std::string_view colour) {
        const auto same = [](char a, char b) { return a == (b >= 'A' && b <= 'F' ? b + 32 : b); };
        for (std::size_t i = 0; i < users_.size(); ++i)
            users_[i] += std::ranges::equal(palette[i], colour, same) ? 1 : 0;
    }

    std::string rarest() const {
        return std::string(
            palette[static_cast<std::size_t>(std::ranges::min_element(users_) - users_.begin())]);
    }

  private:
    std::array<std::size_t, palette.size()> users_{};
};

} // namespace wakesurf::server
