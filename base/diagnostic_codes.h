// The codes of all diagnostics, and what `--explain` says of each. A code is never reused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lray {

/// Lexical E00, syntax E01, names E02, types E03, schema E04, evaluation E05, files E06, assets
/// E07; warnings: geometry W12, transforms W13, materials W14, scene W15, files W16, assets W17.
// clang-format off
enum class Code : std::uint16_t {
    E0001, E0002, E0003, E0004, E0005, E0006, E0007, E0008, E0009, E0010, E0011,
    E0101, E0102, E0103, E0104, E0105, E0106, E0107, E0108, E0109, E0110, E0111, E0112, E0113,
    E0114, E0115, E0116, E0117, E0118, E0119, E0120,
    E0201, E0202, E0203, E0204, E0205, E0206, E0207,
    E0301, E0302, E0303, E0304, E0305, E0306, E0307, E0308, E0309, E0310, E0311, E0312,
    E0401, E0402, E0403, E0404, E0405, E0406, E0407, E0408, E0409, E0410, E0411, E0412,
    E0503, E0504, E0505, E0506, E0507, E0508, E0511, E0512, E0513, E0514, E0515, E0516, E0517,
    E0601, E0602, E0603, E0604, E0605,
    E0701, E0702, E0703, E0704, E0705, E0706,
    W1101, W1102, W1103, W1104, W1105, W1106,
    W1201, W1203, W1204, W1205, W1206,
    W1301, W1302, W1303,
    W1401, W1402, W1403, W1404, W1405,
    W1501, W1502, W1503,
    W1603, W1604, W1605,
    W1701, W1702, W1703, W1704,
};
// clang-format on
inline constexpr std::size_t kCodeCount = static_cast<std::size_t>(Code::W1704) + 1;

/// What `--explain` prints. `wrong` and `right` are whole `.lrs` files (or of the named asset).
struct CodeInfo {
    Code code{};
    std::string_view id{};           // "E0401"
    std::string_view title{};        // "unknown property"
    std::string_view explanation{};  // a few sentences
    std::string_view wrong{};
    std::string_view right{};
    bool is_on = true;  // of a warning: told unless it is silenced
};

/// All codes, in order.
std::span<const CodeInfo> code_infos();

const CodeInfo& code_info(Code code);

/// Returns the code of that id ("E0401", any case); empty if there is none.
std::optional<Code> find_code(std::string_view id);

/// Returns the title as a word for options: "scale after translate" -> "scale-after-translate".
std::string slug(const CodeInfo& info);

constexpr bool is_warning(const CodeInfo& info) {
    return info.id.starts_with('W');
}

/// True for the codes of limits (exit code 3).
bool is_limit(Code code);

}  // namespace lray
