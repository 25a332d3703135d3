// Which warnings are told, and which of them count as errors: `-W`, `-A` and `--deny`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic_codes.h"

namespace lray {

enum class WarningLevel : std::uint8_t { allow, warn, deny };

/// The level of every warning. Of two settings for one warning the later counts.
class WarningLevels {
 public:
    WarningLevels();

    WarningLevel operator[](Code code) const { return levels_[static_cast<std::size_t>(code)]; }

    /// Sets the level of the warning with this code ("W1301", any case) or name
    /// ("scale-after-translate"). `all` and `warnings` are all of them; denied are then those that
    /// are told.
    /// Errors: returns what is wrong as the end of a sentence that begins with the option's name.
    std::optional<std::string> set(std::string_view name, WarningLevel level);

 private:
    std::array<WarningLevel, kCodeCount> levels_{};
};

}  // namespace lray
