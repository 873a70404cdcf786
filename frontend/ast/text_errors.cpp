// SPDX-License-Identifier: MIT
#include "frontend/ast/text_errors.hpp"

#include <fmt/format.h>

#include <utility>

#include "frontend/lex/invisible.hpp"

namespace cobble::frontend {
namespace {

using source::Diagnostic;
using source::DiagnosticCode;
using source::Severity;

const DiagnosticCode kUnterminatedString(
    "unterminated-string", Severity::kError, "a string has no closing quote on its line",
    "A string begins and ends with a quote on one line, and what stands between them is taken as "
    "it "
    "is. Without the second quote the rest of the line is lost to it, braces included.",
    "PhongMaterial {\n    texture \"brick.bmp\n}\n", "Put a quote where the string ends.");

const DiagnosticCode kInvalidUtf8(
    "invalid-utf8", Severity::kError, "the file holds bytes that are not UTF-8",
    "Scenes are UTF-8 text. Bytes that do not form characters come from files saved in another "
    "encoding, or from damage, and mean different things on different machines.",
    "texture br\xEF\xBF\xBD"
    "ck.bmp",
    "Save the file as UTF-8. If the byte is part of a path, check that the path still names the "
    "file.");

const DiagnosticCode kInvisibleCharacter(
    "invisible-character", Severity::kError, "a character that cannot be seen is part of a word",
    "Only blanks, tabs and line ends separate words. Other characters that look like a blank, or "
    "like nothing, come with text that is copied from web pages and chats, and make another word "
    "of the one beside them.",
    "Group\xC2\xA0{\n}\n", "Put a blank in its place, or remove it.");

}  // namespace

bool report_invisible(TokenId token, Reporter& reporter) {
    const std::string_view text = reporter.text(token);
    auto found = find_invisible(text);
    if (!found) return false;
    const std::uint32_t begin = reporter.tokens().range(token).begin;
    const auto bytes_of = [begin](const Invisible& character) {
        const auto at = begin + static_cast<std::uint32_t>(character.at);
        return ByteRange{at, at + static_cast<std::uint32_t>(character.bytes)};
    };
    Diagnostic& finding =
        reporter.add(kInvisibleCharacter, bytes_of(*found),
                     fmt::format("here is {}, which {}", found->name,
                                 found->blank ? "is no blank to the language" : "cannot be seen"));
    source::Fix fix{found->blank ? "put a blank in its place" : "remove it", true, {}};
    for (; found; found = find_invisible(text, found->at + found->bytes)) {
        fix.edits.push_back({reporter.span(bytes_of(*found)), found->blank ? " " : ""});
    }
    finding.fixes.push_back(std::move(fix));
    return true;
}

void report_text_errors(Reporter& reporter) {
    const Tokens& tokens = reporter.tokens();
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const TokenId token{i};
        if (tokens.kind(token) != TokenKind::kUnterminatedString) continue;
        Diagnostic& finding =
            reporter.add(kUnterminatedString, token, "this string has no closing quote");
        const std::uint32_t end = tokens.range(token).end;
        finding.fixes.push_back({"close the string at the end of the line",
                                 false,
                                 {{reporter.span(ByteRange{end, end}), "\""}}});
    }
    const std::vector<std::uint32_t>& invalid = tokens.invalid_utf8;
    for (std::size_t i = 0; i < invalid.size();) {
        const std::size_t first = i++;
        while (i < invalid.size() && invalid[i] == invalid[i - 1] + 1) ++i;
        const ByteRange bytes{invalid[first], invalid[i - 1] + 1};
        const auto byte = static_cast<unsigned char>(tokens.text[bytes.begin]);
        reporter.add(kInvalidUtf8, bytes,
                     i - first == 1 ? fmt::format("byte 0x{:02X} is not valid UTF-8", byte)
                                    : fmt::format("{} bytes from 0x{:02X} on are not valid UTF-8",
                                                  i - first, byte));
    }
}

}  // namespace cobble::frontend
