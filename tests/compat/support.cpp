// SPDX-License-Identifier: MIT
#include "tests/compat/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "renderer/picture/picture_io.hpp"
#include "tests/support/disk.hpp"

namespace cobble::test {
namespace {

namespace fs = std::filesystem;

/// As it is written to files and read again: bytes over 255, three channels.
renderer::Plane32 truncated(const renderer::Plane32& plane) {
    const auto encoded = renderer::encode(plane, renderer::PictureFormat::kBmp,
                                          {renderer::Quantise::kTruncate, false});
    return renderer::decode(encoded.bytes).plane;
}

int level(float value) { return static_cast<int>(value * 255.0F + 0.5F); }

}  // namespace

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
