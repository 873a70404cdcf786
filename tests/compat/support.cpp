// SPDX-License-Identifier: MIT
#include "tests/compat/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "renderer/picture/picture_io.hpp"

namespace cobble::test {
namespace {

namespace fs = std::filesystem;

class Disk : public source::FileSource {
  public:
    source::ReadResult read(std::string_view path, std::uint64_t max_bytes) override {
        const fs::path file(path);
        std::error_code error;
        if (!fs::is_regular_file(file, error)) return {source::ReadStatus::kMissing, {}, {}};
        if (fs::file_size(file, error) > max_bytes) return {source::ReadStatus::kTooLarge, {}, {}};
        return {source::ReadStatus::kOk, file_text(file), {}};
    }
    bool exists(std::string_view path) override {
        std::error_code error;
        return fs::is_regular_file(fs::path(path), error);
    }
};

/// As it is written to files and read again: bytes over 255, three channels.
renderer::Plane32 truncated(const renderer::Plane32& plane) {
    const auto encoded = renderer::encode(plane, renderer::PictureFormat::kBmp,
                                          {renderer::Quantise::kTruncate, false});
    return renderer::decode(encoded.bytes).plane;
}

int level(float value) { return static_cast<int>(value * 255.0F + 0.5F); }

}  // namespace

fs::path corpus() {
    const char* given = std::getenv("COBBLE_CORPUS");
    const fs::path path =
        given != nullptr ? fs::path(given) : fs::path(COBBLE_ROOT) / "../shared/corpus";
    std::error_code error;
    return fs::is_directory(path / "images", error) ? path : fs::path{};
}

std::string file_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

LoadedScene load_scene(const fs::path& path, const ir::LowerOptions& options) {
    LoadedScene result;
    Disk disk;
    const source::SourceId id = result.sources->add(path.string(), file_text(path));
    result.checked = frontend::check(id, result.sources->text(id));
    result.lowered = ir::lower(result.checked, *result.sources, disk, options);
    return result;
}

renderer::Picture render(const ir::Scene& scene, const renderer::Settings& settings,
                         std::uint32_t threads) {
    const auto scheduler = renderer::make_thread_scheduler(threads);
    const auto job = renderer::start_render(scene, settings, *scheduler);
    using std::chrono::steady_clock;
    while (!job->step(steady_clock::now() + std::chrono::milliseconds(20)).done) {
    }
    return job->picture();
}

Levels levels_between(const renderer::Plane32& ours, const renderer::Plane32& published) {
    Levels result;
    const renderer::Plane32 bytes = truncated(ours);
    if (bytes.values.size() != published.values.size()) {
        result.mean = HUGE_VAL;
        return result;
    }
    const double pixels = static_cast<double>(bytes.values.size() / 3);
    for (std::size_t i = 0; i < bytes.values.size(); i += 3) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            const int d = std::abs(level(bytes.values[c]) - level(published.values[c]));
            result.mean += d / (3 * pixels);
            most = std::max(most, d);
        }
        result.maximum = std::max(result.maximum, most);
        result.equal += (most == 0 ? 1 : 0) / pixels;
        result.within_1 += (most <= 1 ? 1 : 0) / pixels;
        result.within_2 += (most <= 2 ? 1 : 0) / pixels;
    }
    return result;
}

void write_sheet(const std::string& name, const renderer::Plane32& ours,
                 const renderer::Plane32& published) {
    const char* folder = std::getenv("COBBLE_SHEETS");
    if (folder == nullptr) return;
    const renderer::Plane32 left = truncated(ours);
    renderer::Plane32 sheet{left.width * 3, left.height, 3, {}};
    for (std::uint32_t y = 0; y < left.height; ++y) {
        for (std::uint32_t x = 0; x < left.width * 3; ++x) {
            for (std::uint32_t c = 0; c < 3; ++c) {
                const std::uint32_t column = x % left.width;
                const float a = left.at(column, y, c);
                const float b = published.at(column, y, c);
                sheet.values.push_back(x < left.width       ? a
                                       : x < 2 * left.width ? b
                                                            : 8 * std::fabs(a - b));
            }
        }
    }
    std::ofstream file(fs::path(folder) / (name + ".png"), std::ios::binary);
    file << renderer::encode(sheet, renderer::PictureFormat::kPng).bytes;
}

}  // namespace cobble::test
