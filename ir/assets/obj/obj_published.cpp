// SPDX-License-Identifier: MIT
#include "ir/assets/obj/obj_published.hpp"

#include <cmath>
#include <limits>
#include <string_view>

#include "ir/assets/obj/obj_problems.hpp"
#include "ir/assets/obj/scan_number.hpp"

namespace cobble::ir {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// What `stream >> value` does on one line: skips white space, takes the longest number, and after
// the first failure gives zeros only.
class LineStream {
  public:
    explicit LineStream(std::string line) : line_(std::move(line)), p_(line_.c_str()) {}

    std::string_view word() {
        skip();
        const char* const from = p_;
        while (*p_ != '\0' && !is_space(*p_)) ++p_;
        return {from, static_cast<std::size_t>(p_ - from)};
    }
    double number() {
        skip();
        double value = 0;
        const char* const stop = failed_ ? nullptr : scan_number(p_, value);
        if (stop == nullptr || !fits_single(value)) {
            failed_ = true;
            return 0;
        }
        p_ = stop;
        return value;
    }
    std::int64_t integer() {
        skip();
        const char* q = p_;
        const bool negative = *q == '-';
        if (negative || *q == '+') ++q;
        if (failed_ || !is_digit(*q)) {
            failed_ = true;
            return 0;
        }
        std::int64_t value = 0;
        for (; is_digit(*q); ++q) {
            value = value * 10 + (*q - '0');
            if (value > std::numeric_limits<std::int32_t>::max()) {
                failed_ = true;
                return 0;
            }
        }
        p_ = q;
        return negative ? -value : value;
    }

  private:
    void skip() {
        while (is_space(*p_)) ++p_;
    }
    std::string line_;
    const char* p_;
    bool failed_ = false;
};

struct RawFace {
    std::array<std::int64_t, 3> positions{};  // 1-based, as written
    std::array<std::int64_t, 3> uvs{};
    bool has_uv = false;
};

RawFace read_face(LineStream& in, bool slashes) {
    RawFace face;
    face.has_uv = slashes;
    for (std::size_t i = 0; i < 3; ++i) {
        face.positions[i] = in.integer();
        if (slashes) face.uvs[i] = in.integer();
    }
    return face;
}

}  // namespace

ObjFile read_published_obj(const std::string& text, std::uint64_t max_faces) {
    ObjFile file;
    std::vector<RawFace> raw;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find('\n', begin);
        // Their loop asks for the end of the file before it looks at the line.
        if (end == std::string::npos) break;
        const std::size_t offset = begin;
        std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        if (line.size() < 3 || line[0] == '#') continue;
        bool slashes = false;
        for (char& c : line) {
            if (c == '\0') c = ' ';
            if (c != '/') continue;
            slashes = true;
        }
        LineStream words(line);
        const std::string_view word = words.word();
        if (word == "v") {
            const double x = words.number();
            const double y = words.number();
            const double z = words.number();
            file.positions.push_back({x, y, z});
        } else if (word == "vt") {
            const double u = words.number();
            const double v = words.number();
            file.uvs.push_back({u, v});
        } else if (word == "f") {
            if (raw.size() >= max_faces) {
                add_problem(file, kObjTooManyFaces, offset, end,
                            "more than " + std::to_string(max_faces) + " faces");
                break;
            }
            for (char& c : line) {
                if (c == '/') c = ' ';
            }
            LineStream corners(std::move(line));
            corners.word();
            raw.push_back(read_face(corners, slashes));
            file.face_offsets.push_back(static_cast<std::uint32_t>(offset));
        }
    }

    // Their programs do not check the indices; what they would read out of bounds is left out here.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const std::uint32_t offset = file.face_offsets[i];
        const std::size_t line_end = std::min(text.find('\n', offset), text.size());
        Mesh::Face face{};
        bool good = true;
        for (std::size_t k = 0; k < 3 && good; ++k) {
            const std::int64_t p = raw[i].positions[k];
            const std::int64_t t = raw[i].uvs[k];
            const auto position_count = static_cast<std::int64_t>(file.positions.size());
            const auto uv_count = static_cast<std::int64_t>(file.uvs.size());
            if (p < 1 || p > position_count) {
                add_problem(file, kObjIndex, offset, line_end,
                            index_message(ObjIndexKind::kPosition, p, file.positions.size()));
                good = false;
            } else if (uv_count > 0 && raw[i].has_uv && (t < 1 || t > uv_count)) {
                add_problem(file, kObjIndex, offset, line_end,
                            index_message(ObjIndexKind::kUv, t, file.uvs.size()));
                good = false;
            } else {
                std::uint32_t uv = Mesh::kNone;
                if (uv_count > 0) uv = raw[i].has_uv ? static_cast<std::uint32_t>(t - 1) : 0;
                face.corners[k] = {static_cast<std::uint32_t>(p - 1), Mesh::kNone, uv};
            }
        }
        if (!good) continue;
        file.faces.push_back(face);
        file.face_offsets[kept++] = offset;
    }
    file.face_offsets.resize(kept);
    sort_problems(file);
    return file;
}

}  // namespace cobble::ir
