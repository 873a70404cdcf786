// SPDX-License-Identifier: MIT
// A program outside the repository that uses the installed package: the whole way from a text to
// the middle pixel of its picture.
#include <fmt/core.h>

#include <chrono>
#include <string>
#include <string_view>

#include "frontend/check/check.hpp"
#include "frontend/source/line_index.hpp"
#include "frontend/source/source_map.hpp"
#include "grammar/vocabulary.hpp"
#include "ir/effects.hpp"
#include "ir/lower.hpp"
#include "renderer/job/render_job.hpp"

namespace {

constexpr std::string_view kScene = R"(PerspectiveCamera {
    center 0 0 5
    direction 0 0 -1
    up 0 1 0
    angle 40
}
Materials {
    Material {
        diffuseColor 0.25 0.5 0.75
    }
}
Group {
    MaterialIndex 0
    Sphere {
        center 0 0 0
        radius 1
    }
}
)";

class NoFiles final : public cobble::source::FileSource {
  public:
    cobble::source::ReadResult read(std::string_view, std::uint64_t) override { return {}; }
    bool exists(std::string_view) override { return false; }
};

}  // namespace

int main() {
    using namespace cobble;
    source::SourceMap sources;
    const source::SourceId id = sources.add("a.scene", std::string(kScene));
    const frontend::CheckedScene checked = frontend::check(id, sources.text(id));
    NoFiles files;
    const ir::Lowered lowered = ir::lower(checked, sources, files);

    renderer::Settings settings;
    settings.width = settings.height = 3;
    settings.samples = 1;
    settings.effects = ir::derive_effects(lowered.scene);
    const auto scheduler = renderer::make_thread_scheduler(1);
    const auto job = renderer::start_render(lowered.scene, settings, *scheduler);
    while (!job->step(std::chrono::steady_clock::now() + std::chrono::seconds(1)).done) {
    }
    const renderer::Plane32& color = job->picture().color;

    const auto sphere = kScene.find("Sphere");
    const auto place = source::LineIndex(kScene).locate(static_cast<std::uint32_t>(sphere));
    const auto* block = grammar::find_block("Sphere");
    // No light at all: the ambient light counts as 1 1 1.
    fmt::print("{}:{} {}, {} finding, pixel {} {} {}\n", place.line, place.column,
               block != nullptr ? block->name : "?", checked.diagnostics.size(), color.at(1, 1, 0),
               color.at(1, 1, 1), color.at(1, 1, 2));
    return 0;
}
