// SPDX-License-Identifier: MIT
#include "ir/assets/asset_loader.hpp"

#include <algorithm>
#include <array>

#include "ir/assets/mesh_size.hpp"
#include "ir/assets/transfer.hpp"
#include "ir/image/decoder.hpp"

namespace cobble::ir {

using source::Diagnostic;
using source::DiagnosticCode;
using source::ReadResult;
using source::ReadStatus;
using source::Severity;
using source::Span;

namespace {

const DiagnosticCode kMissing{
    "asset-missing",
    Severity::kError,
    "a texture, cube map face or mesh does not exist",
    "Paths are relative to the folder of the scene file, unless they begin with `/`. With "
    "`--keep-going` a missing texture becomes a magenta checker, and a missing mesh is left out.",
    "texture tex/brik.bmp",
    "Correct the path, or put the file where the scene looks for it."};

const DiagnosticCode kUnreadable{
    "asset-unreadable",
    Severity::kError,
    "a texture or mesh exists but cannot be read",
    "The path names a folder, a device or a file that this user may not read; the note has the "
    "system's reason.",
    "texture tex",
    "Name a regular file, or give yourself permission to read it."};

const DiagnosticCode kCorrupt{
    "asset-corrupt",
    Severity::kError,
    "a picture file is damaged or of an unknown kind",
    "Pictures are BMP (uncompressed), PNG, JPEG, TGA or Radiance HDR, told apart by their content "
    "and not by their name. A file that ends too early or whose checksums do not match is refused, "
    "because what could be read of it is not what its author saw.",
    "texture notes.txt",
    "Export the picture again in one of these formats."};

const DiagnosticCode kTooLarge{
    "asset-too-large",
    Severity::kError,
    "a file, or the picture it claims to hold, is beyond the limits",
    "Sizes are checked before memory is taken, so that a broken or hostile file of a few bytes "
    "cannot exhaust the machine. There is a limit for one file, one for the pixels of one picture, "
    "and one for the bytes that all pictures and meshes of a scene take together.",
    "texture bomb.png",
    "Use a smaller picture or mesh, or fewer of them."};

const DiagnosticCode kCubeFace{
    "asset-cube-map-face",
    Severity::kError,
    "a cube map has no picture for one of its faces",
    "A cube map is a folder with six pictures named `left right up down front back`, all with the "
    "same ending: `.hdr`, `.png`, `.jpg`, `.jpeg`, `.tga` or `.bmp`, sought in this order.",
    "cubeMap tex/church",
    "Put all six pictures with one ending into the folder, or correct the path."};

const DiagnosticCode kCubeShape{
    "asset-cube-map-shape",
    Severity::kError,
    "the faces of a cube map are not squares of one size",
    "Each face covers one side of a cube; a direction could not be looked up in faces of different "
    "shapes without a seam.",
    "cubeMap tex/panorama",
    "Cut or scale the six pictures to squares of one size."};

constexpr std::array<const char*, 6> kFaces{"left", "right", "up", "down", "front", "back"};
constexpr std::array<const char*, 6> kEndings{".hdr", ".png", ".jpg", ".jpeg", ".tga", ".bmp"};
constexpr const char* kEndingList = ".hdr .png .jpg .jpeg .tga .bmp";

/// One spelling for paths that differ only by "./" and doubled slashes.
std::string tidy(std::string_view path) {
    std::string result;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const bool at_start = result.empty() || result.back() == '/';
        if (at_start && path.substr(i, 2) == "./") {
            ++i;
        } else if (path[i] == '/' && !result.empty() && result.back() == '/') {
            continue;
        } else {
            result += path[i];
        }
    }
    return result;
}

std::string size_text(std::uint32_t width, std::uint32_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

ColorTag tag_of(bool data, bool floats) {
    return data ? ColorTag::kData : floats ? ColorTag::kLinear : ColorTag::kDisplay;
}

template <typename T>
bool all_texels_equal(const std::vector<T>& values) {
    for (std::size_t i = 3; i < values.size(); ++i) {
        if (values[i] != values[i - 3]) return false;
    }
    return true;
}

std::string quoted(std::string_view text) {
    std::string result(1, '\'');
    result += text;
    result += '\'';
    return result;
}

}  // namespace

std::uint64_t AssetLoader::file_limit() const {
    // Offsets into a file are 32-bit, and the largest is no place.
    return std::min<std::uint64_t>(options_.limits.file_bytes, 0xfffffffeU);
}

std::size_t AssetLoader::add(const DiagnosticCode& code, std::string message, Span span,
                             std::vector<std::string> notes) {
    Diagnostic diagnostic;
    diagnostic.code = &code;
    diagnostic.severity = code.severity;
    diagnostic.message = std::move(message);
    diagnostic.span = span;
    diagnostic.notes = std::move(notes);
    report(std::move(diagnostic), span);
    return found_.size() - 1;
}

void AssetLoader::report(Diagnostic diagnostic, Span span) {
    found_.push_back({std::move(diagnostic), span});
}

void AssetLoader::also_here(std::size_t finding, Span span) {
    if (finding == kNone) return;
    auto& related = found_[finding].diagnostic.related;
    // A scene that names one missing file a million times needs no list of them.
    constexpr std::size_t kMost = 10;
    if (related.size() < kMost) related.push_back({span, "also named here"});
}

std::size_t AssetLoader::read_failed(const ReadResult& result, const std::string& what,
                                     const std::string& path, Span span, std::uint64_t limit) {
    std::vector<std::string> notes{"tried " + quoted(path)};
    switch (result.status) {
        case ReadStatus::kTooLarge:
            return add(kTooLarge, what + " is larger than " + std::to_string(limit) + " bytes",
                       span, std::move(notes));
        case ReadStatus::kNotAFile:
        case ReadStatus::kUnreadable: {
            std::string message = what + " cannot be read";
            if (!result.reason.empty()) message += ": " + result.reason;
            return add(kUnreadable, std::move(message), span, std::move(notes));
        }
        default:
            return add(kMissing, what + " does not exist", span, std::move(notes));
    }
}

AssetLoader::CachedImage AssetLoader::load_image(const std::string& path, std::string_view written,
                                                 Span span, bool data, const char* what) {
    const auto cached = image_cache_.find({path, data});
    if (cached != image_cache_.end()) {
        also_here(cached->second.finding, span);
        return cached->second;
    }
    // The same file, read for the other use, serves this one.
    const auto other = image_cache_.find({path, !data});
    if (other != image_cache_.end()) {
        also_here(other->second.finding, span);
        const CachedImage shared = for_other_use(other->second, written, span, data, what);
        return image_cache_[{path, data}] = shared;
    }

    CachedImage result;
    const std::string name = std::string(what) + " " + quoted(written);
    ReadResult read = files_.read(path, file_limit());
    if (read.status != ReadStatus::kOk) {
        result.finding = read_failed(read, name, path, span, file_limit());
        return image_cache_[{path, data}] = result;
    }
    const std::uint64_t most = options_.limits.image_pixels;
    std::uint64_t needed = 0;
    if (const auto header = image::read_header(read.bytes);
        header && image::size_problem(header->width, header->height, most).empty()) {
        needed = bytes_of_image(header->width, header->height, header->floats, data);
        if (needed > bytes_left_) {
            result.finding = no_room(name, path, span, needed,
                                     size_text(header->width, header->height) + " pixels");
            return image_cache_[{path, data}] = result;
        }
    }
    image::Decoded decoded = image::decode(read.bytes, {most, false});
    if (decoded.status != image::Status::kOk) {
        const bool large = decoded.status == image::Status::kTooLarge;
        result.finding =
            add(large ? kTooLarge : kCorrupt,
                name + (large ? " is too large: " : " cannot be decoded: ") + decoded.reason, span,
                {"tried " + quoted(path)});
        return image_cache_[{path, data}] = result;
    }
    bytes_left_ -= needed;
    result.floats = !decoded.floats.empty();
    result.id = {static_cast<std::uint32_t>(images_.size())};
    Image& image = images_.emplace_back();
    image.width = decoded.width;
    image.height = decoded.height;
    image.path = path;
    image.source = sources_.add(path, {});
    image.tag = tag_of(data, result.floats);
    image.constant =
        result.floats ? all_texels_equal(decoded.floats) : all_texels_equal(decoded.bytes);
    if (keep_pixels_) {
        image.bytes = std::move(decoded.bytes);
        image.floats = std::move(decoded.floats);
    }
    return image_cache_[{path, data}] = result;
}

AssetLoader::CachedImage AssetLoader::for_other_use(CachedImage loaded, std::string_view written,
                                                    Span span, bool data, const char* what) {
    if (!loaded.id.valid()) return loaded;
    const Image& first = images_[loaded.id.value];
    if (loaded.floats || !options_.decode_srgb) {
        // The same numbers serve both uses; what a colour is tagged says more.
        if (!data) images_[loaded.id.value].tag = tag_of(data, loaded.floats);
        return loaded;
    }
    // Two copies that are not the same: a colour becomes light, as floats, and data stays bytes.
    const std::uint64_t needed = bytes_of_image(first.width, first.height, loaded.floats, data);
    if (needed > bytes_left_) {
        CachedImage result;
        result.finding = no_room(std::string(what) + " " + quoted(written), first.path, span,
                                 needed, size_text(first.width, first.height) + " pixels");
        return result;
    }
    bytes_left_ -= needed;
    Image copy = first;
    copy.tag = tag_of(data, loaded.floats);
    loaded.id = {static_cast<std::uint32_t>(images_.size())};
    images_.push_back(std::move(copy));
    return loaded;
}

std::uint64_t AssetLoader::bytes_of_image(std::uint64_t width, std::uint64_t height, bool floats,
                                          bool data) const {
    const bool becomes_floats = floats || (options_.decode_srgb && !data);
    const std::uint64_t pixel = becomes_floats ? 3 * sizeof(float) : 3;
    const std::uint64_t pixels = width * height;  // both are below 2^32
    return pixels > ~std::uint64_t{0} / pixel ? ~std::uint64_t{0} : pixels * pixel;
}

std::size_t AssetLoader::no_room(const std::string& what, const std::string& path, Span span,
                                 std::uint64_t needed, const std::string& size) {
    return add(kTooLarge,
               what + " is too large: it takes " + std::to_string(needed) + " bytes (" + size +
                   "), and of the " + std::to_string(options_.limits.asset_bytes) +
                   " bytes for all assets of a scene together " + std::to_string(bytes_left_) +
                   " are left",
               span, {"tried " + quoted(path)});
}

std::vector<Image> AssetLoader::take_images() {
    if (options_.decode_srgb) {
        for (Image& image : images_) decode_to_linear(image);
    }
    return std::move(images_);
}

ImageId AssetLoader::checker() {
    if (checker_.valid()) return checker_;
    Image image;
    image.width = 8;
    image.height = 8;
    image.missing = true;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const std::uint8_t on = (x + y) % 2 == 0 ? 255 : 0;
            image.bytes.insert(image.bytes.end(), {on, 0, on});
        }
    }
    checker_ = {static_cast<std::uint32_t>(images_.size())};
    images_.push_back(std::move(image));
    return checker_;
}

ImageId AssetLoader::image(std::string_view path, Span span, ImageUse use) {
    const char* const what = use == ImageUse::kTexture     ? "texture"
                             : use == ImageUse::kNormalMap ? "normal map"
                                                           : "bump map";
    const std::string resolved = tidy(source::resolve(sources_.path(scene_), path));
    const CachedImage found = load_image(resolved, path, span, use != ImageUse::kTexture, what);
    if (found.id.valid() || use != ImageUse::kTexture) return found.id;
    return checker();
}

// Why there is not one face in `folder`, which ends in '/'.
std::string AssetLoader::without_faces(std::string_view folder) {
    folder.remove_suffix(folder.empty() ? 0 : 1);
    if (folder.empty()) return " has no faces";
    switch (files_.read(folder, 0).status) {
        case source::ReadStatus::kMissing:
            return " does not exist";
        case source::ReadStatus::kOk:
        case source::ReadStatus::kTooLarge:
            return " is no folder";
        case source::ReadStatus::kNotAFile:
        case source::ReadStatus::kUnreadable:
            break;
    }
    return " has no faces";
}

std::string AssetLoader::face_ending(const std::string& folder, std::string_view written, Span span,
                                     std::size_t& finding) {
    std::size_t best = 0;
    std::size_t best_count = 0;
    std::array<bool, 6> best_faces{};
    for (std::size_t e = 0; e < kEndings.size(); ++e) {
        std::array<bool, 6> faces{};
        for (std::size_t f = 0; f < kFaces.size(); ++f) {
            faces[f] = files_.exists(folder + kFaces[f] + kEndings[e]);
        }
        const auto count = static_cast<std::size_t>(std::count(faces.begin(), faces.end(), true));
        if (count == kFaces.size()) return kEndings[e];
        if (count > best_count) {
            best = e;
            best_count = count;
            best_faces = faces;
        }
    }
    std::vector<std::string> missing;
    for (std::size_t f = 0; f < kFaces.size(); ++f) {
        if (!best_faces[f]) missing.emplace_back(kFaces[f]);
    }
    std::string message = "cube map " + quoted(written);
    if (best_count == 0) {
        message += without_faces(folder);
    } else {
        message += " has no face ";
        for (std::size_t i = 0; i < missing.size(); ++i) {
            message += (i == 0 ? "" : ", ") + quoted(missing[i] + kEndings[best]);
        }
    }
    finding = add(kCubeFace, std::move(message), span,
                  {"tried " + quoted(folder + missing[0]) + " with " + kEndingList +
                   "; all six faces need the same ending"});
    return {};
}

CubeMapId AssetLoader::cube_map(std::string_view written, Span span) {
    std::string folder = tidy(source::resolve(sources_.path(scene_), written));
    if (!folder.empty() && folder.back() != '/') folder += '/';
    const auto cached = cube_cache_.find(folder);
    if (cached != cube_cache_.end()) {
        also_here(cached->second.second, span);
        return cached->second.first;
    }
    auto& [id, finding] = cube_cache_[folder];
    finding = kNone;
    const std::string ending = face_ending(folder, written, span, finding);
    if (ending.empty()) return id;

    CubeMap map;
    map.span = span;
    for (std::size_t f = 0; f < kFaces.size(); ++f) {
        const std::string name = kFaces[f] + ending;
        const CachedImage face = load_image(folder + name, std::string(written) + "/" + name, span,
                                            false, "cube map face");
        if (!face.id.valid()) {
            finding = face.finding;
            continue;
        }
        map.faces[f] = face.id;
    }
    const auto usable = [](ImageId face) { return face.valid(); };
    if (!std::all_of(map.faces.begin(), map.faces.end(), usable)) return id;
    const Image& first = images_[map.faces[0].value];
    for (std::size_t f = 0; f < kFaces.size(); ++f) {
        const Image& face = images_[map.faces[f].value];
        if (face.width == first.width && face.height == first.width) continue;
        std::string message = "cube map face " + quoted(kFaces[f] + ending) + " is " +
                              size_text(face.width, face.height);
        message += face.width != face.height ? ", not square"
                                             : ", but " + quoted(kFaces[0] + ending) + " is " +
                                                   size_text(first.width, first.height);
        finding = add(kCubeShape, std::move(message), span, {"tried " + quoted(face.path)});
        return id;
    }
    id = {static_cast<std::uint32_t>(cube_maps_.size())};
    cube_maps_.push_back(map);
    return id;
}

std::size_t AssetLoader::obj(std::string_view path, Span span) {
    const std::string resolved = tidy(source::resolve(sources_.path(scene_), path));
    const auto cached = obj_cache_.find(resolved);
    if (cached != obj_cache_.end()) {
        also_here(cached->second.second, span);
        return cached->second.first;
    }
    const std::size_t index = objs_.size();
    LoadedObj& loaded = objs_.emplace_back();
    loaded.path = resolved;
    auto& [cached_index, finding] = obj_cache_[resolved];
    cached_index = index;
    finding = kNone;

    const std::string name = "mesh " + quoted(path);
    ReadResult read = files_.read(resolved, file_limit());
    if (read.status != ReadStatus::kOk) {
        finding = read_failed(read, name, resolved, span, file_limit());
        return index;
    }
    // The text is kept beside what becomes of it, for findings to point into.
    const std::uint64_t text_bytes = read.bytes.size();
    if (text_bytes > bytes_left_ / (1 + kMostBytesPerTextByte)) {
        const std::uint64_t needed = text_bytes + obj_bytes_at_most(read.bytes);
        if (needed > bytes_left_) {
            finding = no_room(name, resolved, span, needed,
                              std::to_string(text_bytes) + " bytes of text");
            return index;
        }
    }
    const ObjRules rules =
        options_.compat == Compat::kNone ? ObjRules::kStandard : ObjRules::kPublished;
    loaded.file = read_obj(read.bytes, rules, options_.limits.mesh_faces);
    bytes_left_ -= text_bytes + bytes_of(loaded.file);
    loaded.source = sources_.add(resolved, std::move(read.bytes));
    loaded.usable = !loaded.file.faces.empty();
    report_problems(loaded, span);
    return index;
}

std::vector<Diagnostic> AssetLoader::take_diagnostics() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Found& a, const Found& b) { return a.place.begin < b.place.begin; });
    std::vector<Diagnostic> result;
    result.reserve(found_.size());
    for (Found& found : found_) result.push_back(std::move(found.diagnostic));
    found_.clear();
    return result;
}

}  // namespace cobble::ir
