// SPDX-License-Identifier: MIT
#include "tools/lsp/documents/documents.hpp"

#include <utility>

namespace cobble::lsp {

Document::Document(std::string uri, std::string path, std::int64_t version, std::string text,
                   const Language& language)
    : uri_(std::move(uri)),
      path_(std::move(path)),
      version_(version),
      text_(std::move(text)),
      language_(&language) {}

void Document::change(const Json& changes, std::int64_t version, PositionEncoding encoding) {
    for (const Json& change : changes) {
        const auto& text = change.at("text").get_ref<const std::string&>();
        const auto range = change.find("range");
        analysis_.reset();
        dirty = true;
        if (range == change.end() || range->is_null()) {
            text_ = text;
            continue;
        }
        const Bytes bytes = TextPositions(text_, encoding).bytes(*range);
        text_.replace(bytes.begin, bytes.end - bytes.begin, text);
    }
    version_ = version;
}

Analysis& Document::analysis() {
    if (!analysis_) analysis_ = language_->analyse(path_, text_);
    return *analysis_;
}

source::ReadResult OpenFiles::read(std::string_view path, std::uint64_t max_bytes) {
    const Document* const document = at_path(path);
    if (document == nullptr) return disk_->read(path, max_bytes);
    source::ReadResult result;
    const bool fits = document->text().size() <= max_bytes;
    result.status = fits ? source::ReadStatus::kOk : source::ReadStatus::kTooLarge;
    if (fits) result.bytes = document->text();
    return result;
}

bool OpenFiles::exists(std::string_view path) {
    return at_path(path) != nullptr || disk_->exists(path);
}

Document& OpenFiles::open(std::unique_ptr<Document> document) {
    std::unique_ptr<Document>& place = documents_[document->uri()];
    place = std::move(document);
    return *place;
}

void OpenFiles::close(std::string_view uri) {
    const auto found = documents_.find(uri);
    if (found != documents_.end()) documents_.erase(found);
}

Document* OpenFiles::find(std::string_view uri) {
    const auto found = documents_.find(uri);
    return found == documents_.end() ? nullptr : found->second.get();
}

const Document* OpenFiles::at_path(std::string_view path) const {
    for (const auto& [uri, document] : documents_) {
        if (document->path() == path) return document.get();
    }
    return nullptr;
}

}  // namespace cobble::lsp
