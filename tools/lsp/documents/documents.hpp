// SPDX-License-Identifier: MIT
// The texts that are open in the client, and how the client changes them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "frontend/source/file_source.hpp"
#include "tools/lsp/documents/language.hpp"
#include "tools/lsp/protocol/text_positions.hpp"

namespace cobble::lsp {

class Document {
  public:
    Document(std::string uri, std::string path, std::int64_t version, std::string text,
             const Language& language);

    [[nodiscard]] const std::string& uri() const { return uri_; }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] std::int64_t version() const { return version_; }
    [[nodiscard]] const std::string& text() const { return text_; }

    /// `changes` as `textDocument/didChange` has them: each with a range in what the changes before
    /// it left, or with the whole text. Throws Json::exception at one that is none, and has then
    /// made those before it.
    void change(const Json& changes, std::int64_t version, PositionEncoding encoding);

    /// Of the text as it is; made when it is asked for.
    [[nodiscard]] Analysis& analysis();
    /// The same to be made anew: files that the text names have changed.
    void forget_analysis() { analysis_.reset(); }

    /// What it says of itself is to be told to the client.
    bool dirty = true;

  private:
    std::string uri_, path_;
    std::int64_t version_;
    std::string text_;
    const Language* language_;
    std::unique_ptr<Analysis> analysis_;
};

/// Files as the client sees them: open texts before those on the disk.
class OpenFiles final : public source::FileSource {
  public:
    explicit OpenFiles(source::FileSource& disk) : disk_(&disk) {}

    source::ReadResult read(std::string_view path, std::uint64_t max_bytes) override;
    bool exists(std::string_view path) override;

    Document& open(std::unique_ptr<Document> document);
    void close(std::string_view uri);
    /// Null if it is not open.
    [[nodiscard]] Document* find(std::string_view uri);
    [[nodiscard]] const std::map<std::string, std::unique_ptr<Document>, std::less<>>& documents()
        const {
        return documents_;
    }

  private:
    [[nodiscard]] const Document* at_path(std::string_view path) const;

    source::FileSource* disk_;
    std::map<std::string, std::unique_ptr<Document>, std::less<>> documents_;  ///< by URI
};

}  // namespace cobble::lsp
