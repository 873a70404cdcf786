// SPDX-License-Identifier: MIT
#include "tools/bench/frames/scene_files.hpp"

#include <fstream>

namespace cobble::bench {

bool write_text(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    return bool(file);
}

}  // namespace cobble::bench
