// SPDX-License-Identifier: MIT
#include "tools/lsp/protocol/message_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace cobble::lsp {
namespace {

// A document of 50 MB takes some 60 MB as a string of JSON; a message of more is no editor's.
constexpr std::size_t kLongestBody = std::size_t{1} << 29U;
// Two headers are known, of some 80 bytes together.
constexpr std::size_t kLongestHeader = 8192;
constexpr std::string_view kEndOfHeader = "\r\n\r\n";

bool same_word(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

// False if the header has no length, or one that is no number.
bool find_length(std::string_view header, std::size_t& length) {
    bool found = false;
    while (!header.empty()) {
        const std::size_t end = std::min(header.find("\r\n"), header.size());
        const std::string_view line = header.substr(0, end);
        header.remove_prefix(std::min(end + 2, header.size()));
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) return false;
        if (!same_word(trimmed(line.substr(0, colon)), "content-length")) continue;
        const std::string_view value = trimmed(line.substr(colon + 1));
        const auto [rest, problem] =
            std::from_chars(value.data(), value.data() + value.size(), length);
        if (problem != std::errc{} || rest != value.data() + value.size()) return false;
        found = true;
    }
    return found;
}

}  // namespace

void MessageReader::drop(std::size_t bytes) {
    at_ += bytes;
    searched_ = 0;
    // Seldom enough that moving what is left costs each byte a constant.
    if (at_ < buffer_.size() / 2) return;
    buffer_.erase(0, at_);
    at_ = 0;
}

MessageReader::Next MessageReader::read_header() {
    const std::string_view text = std::string_view(buffer_).substr(at_);
    // The end may have been cut in two.
    const std::size_t from = searched_ < kEndOfHeader.size() ? 0 : searched_ - kEndOfHeader.size();
    const std::size_t end = text.find(kEndOfHeader, from);
    if (end == std::string_view::npos) {
        if (text.size() > kLongestHeader) {
            return {Status::kLost, {}, "a header does not end"};
        }
        searched_ = text.size();
        return {};
    }
    const bool sound = find_length(text.substr(0, end), length_);
    drop(end + kEndOfHeader.size());
    if (!sound) return {Status::kBad, {}, "a header has no Content-Length that is a number"};
    if (length_ > kLongestBody) return {Status::kLost, {}, "a message is longer than 512 MiB"};
    in_body_ = true;
    return {};
}

MessageReader::Next MessageReader::next() {
    if (!in_body_) {
        Next header = read_header();
        if (!in_body_) return header;
    }
    if (buffer_.size() - at_ < length_) return {};
    in_body_ = false;
    Next message{Status::kMessage, buffer_.substr(at_, length_), {}};
    drop(length_);
    return message;
}

std::string framed(std::string_view body) {
    return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body);
}

}  // namespace cobble::lsp
