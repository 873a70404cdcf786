// SPDX-License-Identifier: MIT
// Published scenes through the whole chain, and how far the result is from a published picture.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "frontend/check/check.hpp"
#include "frontend/source/source_map.hpp"
#include "ir/lower.hpp"
#include "renderer/job/render_job.hpp"

namespace cobble::test {

/// A scene and what it refers to.
struct LoadedScene {
    std::unique_ptr<source::SourceMap> sources = std::make_unique<source::SourceMap>();
    frontend::CheckedScene checked;
    ir::Lowered lowered;
};
LoadedScene load_scene(const std::filesystem::path& path, const ir::LowerOptions& options);

/// Runs the job to its end.
renderer::Picture render(const ir::Scene& scene, const renderer::Settings& settings,
                         std::uint32_t threads = 2);

/// In levels of 255, our plane truncated to bytes.
struct Levels {
    double mean = 0;  ///< over pixels and channels
    int maximum = 0;
    double equal = 0, within_1 = 0, within_2 = 0;  ///< part of the pixels, every channel
};
Levels levels_between(const renderer::Plane32& ours, const renderer::Plane32& published);

/// Ours, the published one and eight times the difference, beside each other, as NAME.png in the
/// folder $COBBLE_SHEETS; nothing without that.
void write_sheet(const std::string& name, const renderer::Plane32& ours,
                 const renderer::Plane32& published);

}  // namespace cobble::test
