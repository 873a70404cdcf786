// SPDX-License-Identifier: MIT
#include "tools/driver/render_targets.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdint>

#include "tools/driver/pictures.hpp"

namespace cobble::driver {

std::vector<RenderTarget> targets_of(const TargetPaths& paths) {
    const RenderTarget all[] = {
        {paths.color, &renderer::Picture::color, "color"},
        {paths.depth, &renderer::Picture::depth, "depth"},
        {paths.normals, &renderer::Picture::normals, "normals"},
        {paths.albedo, &renderer::Picture::albedo, "albedo"},
        {paths.sample_count, &renderer::Picture::sample_count, "sample-count"}};
    std::vector<RenderTarget> targets;
    for (const RenderTarget& target : all) {
        if (!target.path.empty()) targets.push_back(target);
    }
    return targets;
}

std::string check_targets(const std::vector<RenderTarget>& targets, const renderer::Crop& window) {
    for (const RenderTarget& target : targets) {
        const bool one_channel = target.plane == &renderer::Picture::depth ||
                                 target.plane == &renderer::Picture::sample_count;
        std::string problem = check_picture_path(target.path, window.x1 - window.x0,
                                                 window.y1 - window.y0, one_channel ? 1 : 3);
        if (!problem.empty()) return problem;
    }
    return {};
}

std::string check_memory(std::size_t targets, const renderer::Crop& window, std::uint64_t more) {
    const std::uint32_t width = window.x1 - window.x0;
    const std::uint32_t height = window.y1 - window.y0;
    // Three floats a pixel; every plane stands in memory twice, in the job and as its result, and
    // encoded once more.
    const std::uint64_t needed = std::uint64_t{width} * height * (12 * 3 * targets + more);
    const auto memory = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
    if (needed <= memory) return {};
    return fmt::format("a picture of {}x{} pixels takes {} GiB of memory, and this machine has {}",
                       width, height, needed >> 30U, memory >> 30U);
}

}  // namespace cobble::driver
