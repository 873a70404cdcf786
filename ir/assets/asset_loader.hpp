// SPDX-License-Identifier: MIT
// Textures, cube maps and meshes of one scene. Input: paths as the scene names them. Output: pixels
// in Scene::images, parsed meshes, and diagnostics. Invariant: no file is read twice, no size is
// believed before it is checked, all assets together keep to the limit, and each finding is
// reported once, with every place in the scene that names the file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "frontend/source/file_source.hpp"
#include "frontend/source/source_map.hpp"
#include "ir/assets/obj/obj_file.hpp"
#include "ir/lower.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// What a picture is for.
enum class ImageUse : std::uint8_t { kTexture, kNormalMap, kBumpMap };

/// A mesh file, read and judged.
struct LoadedObj {
    ObjFile file;
    source::SourceId source;
    std::string path;
    bool usable = false;
};

class AssetLoader {
  public:
    /// Paths are resolved against the path of `scene`. With `keep_pixels` false, pictures are
    /// decoded to be judged, and dropped.
    AssetLoader(source::SourceId scene, source::SourceMap& sources, source::FileSource& files,
                const LowerOptions& options, bool keep_pixels)
        : scene_(scene),
          sources_(sources),
          files_(files),
          options_(options),
          keep_pixels_(keep_pixels),
          bytes_left_(options.limits.asset_bytes) {}

    /// `span` is the path's place in the scene. A texture that cannot be read gives a magenta
    /// checker, a normal or bump map an invalid id.
    ImageId image(std::string_view path, source::Span span, ImageUse use);

    /// A folder with six faces; an invalid id if one of them is unusable.
    CubeMapId cube_map(std::string_view folder, source::Span span);

    /// An index into objs(). The entry may be unusable.
    std::size_t obj(std::string_view path, source::Span span);

    [[nodiscard]] std::vector<LoadedObj>& objs() { return objs_; }
    /// With `decode_srgb`, display pictures have become light; data has not.
    std::vector<Image> take_images();
    [[nodiscard]] std::vector<CubeMap>& cube_maps() { return cube_maps_; }

    /// Adds a diagnostic of its own about the place `span` of the scene.
    void report(source::Diagnostic diagnostic, source::Span span);

    /// In order of the places in the scene.
    std::vector<source::Diagnostic> take_diagnostics();

  private:
    struct Found {
        source::Diagnostic diagnostic;
        source::Span place;  ///< in the scene
    };
    struct CachedImage {
        ImageId id;                   ///< invalid: unusable
        std::size_t finding = kNone;  ///< index into found_ if unusable
        bool floats = false;          ///< an HDR file
    };
    static constexpr std::size_t kNone = ~std::size_t{0};

    CachedImage load_image(const std::string& path, std::string_view written, source::Span span,
                           bool data, const char* what);
    /// What was loaded as data, as a colour (or the reverse).
    CachedImage for_other_use(CachedImage loaded, std::string_view written, source::Span span,
                              bool data, const char* what);
    ImageId checker();
    /// What a picture takes in the end, in bytes.
    [[nodiscard]] std::uint64_t bytes_of_image(std::uint64_t width, std::uint64_t height,
                                               bool floats, bool data) const;
    std::size_t no_room(const std::string& what, const std::string& path, source::Span span,
                        std::uint64_t needed, const std::string& size);
    std::size_t add(const source::DiagnosticCode& code, std::string message, source::Span span,
                    std::vector<std::string> notes);
    std::size_t read_failed(const source::ReadResult& result, const std::string& what,
                            const std::string& path, source::Span span, std::uint64_t limit);
    void also_here(std::size_t finding, source::Span span);
    void report_problems(const LoadedObj& loaded, source::Span span);
    [[nodiscard]] std::uint64_t file_limit() const;
    std::string without_faces(std::string_view folder);
    std::string face_ending(const std::string& folder, std::string_view written, source::Span span,
                            std::size_t& finding);

    source::SourceId scene_;
    source::SourceMap& sources_;
    source::FileSource& files_;
    const LowerOptions& options_;
    bool keep_pixels_;
    /// Of limits.asset_bytes; taken as if pixels were kept, so that lint finds what a render does.
    std::uint64_t bytes_left_;

    std::vector<Image> images_;
    std::vector<CubeMap> cube_maps_;
    std::vector<LoadedObj> objs_;
    std::map<std::pair<std::string, bool>, CachedImage> image_cache_;  ///< path, is data
    std::map<std::string, std::pair<CubeMapId, std::size_t>> cube_cache_;
    std::map<std::string, std::pair<std::size_t, std::size_t>> obj_cache_;
    ImageId checker_;
    std::vector<Found> found_;
};

}  // namespace cobble::ir
