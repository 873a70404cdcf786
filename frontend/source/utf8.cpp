// SPDX-License-Identifier: MIT
#include "frontend/source/utf8.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace cobble::source {
namespace {

constexpr std::size_t kSniffedBytes = 8192;

bool begins_as_utf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto continues = [&byte](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned lead = byte(0);
    if (lead < 0x80U) return 1;
    if (lead < 0xC2U) return 0;
    if (lead < 0xE0U) return continues(1) ? 2 : 0;
    if (lead < 0xF0U) {
        const bool overlong = lead == 0xE0U && byte(1) < 0xA0U;
        const bool surrogate = lead == 0xEDU && byte(1) > 0x9FU;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (lead < 0xF5U) {
        const bool overlong = lead == 0xF0U && byte(1) < 0x90U;
        const bool too_large = lead == 0xF4U && byte(1) > 0x8FU;
        return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
    }
    return 0;
}

bool is_ascii(std::string_view text) {
    std::uint64_t seen = 0;
    std::size_t i = 0;
    for (; i + 8 <= text.size(); i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, text.data() + i, 8);
        seen |= eight;
    }
    for (; i < text.size(); ++i) seen |= static_cast<unsigned char>(text[i]);
    return (seen & 0x8080808080808080U) == 0;
}

bool looks_binary(std::string_view text) {
    return begins_as_utf16(text) ||
           text.substr(0, kSniffedBytes).find('\0') != std::string_view::npos;
}

std::string why_not_text(std::string_view bytes) {
    if (begins_as_utf16(bytes)) return "it is UTF-16, not UTF-8";
    const std::size_t zero = std::min(bytes.find('\0'), bytes.size());
    std::size_t at = is_ascii(bytes.substr(0, zero)) ? zero : 0;
    while (at < zero) {
        const std::size_t length = utf8_length(bytes.substr(at));
        if (length == 0) return "invalid UTF-8 at offset " + std::to_string(at);
        at += length;
    }
    return zero == bytes.size() ? "" : "zero byte at offset " + std::to_string(zero);
}

}  // namespace cobble::source
