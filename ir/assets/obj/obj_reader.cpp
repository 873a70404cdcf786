// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "ir/assets/obj/obj_file.hpp"
#include "ir/assets/obj/obj_problems.hpp"
#include "ir/assets/obj/obj_published.hpp"
#include "ir/assets/obj/scan_number.hpp"

namespace cobble::ir {
namespace {

using Face = Mesh::Face;
using Corner = Mesh::Corner;

// Stands for an index too large for any file of less than 4 GiB; never in range, unlike kNone.
constexpr std::uint32_t kHuge = 0xfffffffeU;

// All scanning relies on the zero byte that ends a std::string: it is no digit and no blank.
class Reader {
  public:
    Reader(const std::string& text, std::uint64_t max_faces)
        : begin_(text.data()), end_(text.data() + text.size()), max_faces_(max_faces) {}

    ObjFile read() {
        reserve();
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        const bool marked = std::string_view(begin_, end_).starts_with(kByteOrderMark);
        const char* p = marked ? begin_ + kByteOrderMark.size() : begin_;
        while (p < end_ && !stopped_) p = statement(p);
        if (max_position_ >= static_cast<std::int64_t>(file_.positions.size()) ||
            max_uv_ >= static_cast<std::int64_t>(file_.uvs.size()) ||
            max_normal_ >= static_cast<std::int64_t>(file_.normals.size()) ||
            !bad_positions_.empty() || !bad_uvs_.empty() || !bad_normals_.empty()) {
            drop_bad_faces();
        }
        sort_problems(file_);
        return std::move(file_);
    }

  private:
    [[nodiscard]] static bool is_blank(char c) {
        return c == ' ' || c == '\t' || c == '\v' || c == '\f';
    }
    /// Past blanks and line ends that a backslash continues.
    [[nodiscard]] static const char* skip_blanks(const char* p) {
        for (;;) {
            if (is_blank(*p)) {
                ++p;
            } else if (*p == '\\' && p[1] == '\n') {
                p += 2;
            } else if (*p == '\\' && p[1] == '\r') {
                p += p[2] == '\n' ? 3 : 2;
            } else {
                return p;
            }
        }
    }
    [[nodiscard]] bool at_line_end(const char* p) const {
        return *p == '\n' || *p == '\r' || *p == '#' || p >= end_;
    }
    /// The start of the next line; the LF of a CRLF is an empty line of its own, which is harmless.
    [[nodiscard]] const char* next_line(const char* p) const {
        while (p < end_ && *p != '\n' && *p != '\r') {
            if (*p == '\\' && p + 1 < end_ && (p[1] == '\n' || p[1] == '\r')) {
                p = skip_blanks(p);
            } else {
                ++p;
            }
        }
        return p < end_ ? p + 1 : end_;
    }
    /// A comment runs to the end of its line; a backslash does not continue it.
    [[nodiscard]] const char* next_line_after_comment(const char* p) const {
        while (p < end_ && *p != '\n' && *p != '\r') ++p;
        return p < end_ ? p + 1 : end_;
    }
    [[nodiscard]] const char* finish_line(const char* p) const {
        return *p == '#' ? next_line_after_comment(p) : next_line(p);
    }
    [[nodiscard]] const char* word_end(const char* p) const {
        while (p < end_ && !is_blank(*p) && *p != '\n' && *p != '\r') ++p;
        return p;
    }
    [[nodiscard]] bool ends_word(const char* p) const {
        return is_blank(*p) || *p == '\\' || at_line_end(p);
    }
    [[nodiscard]] std::size_t at(const char* p) const {
        return static_cast<std::size_t>(p - begin_);
    }

    /// A word for a message: cut short, and with '?' for bytes that are not printable ASCII.
    static std::string shortened(const char* from, const char* to) {
        constexpr std::ptrdiff_t kLongest = 40;
        std::string text(from, std::min(to, from + kLongest));
        for (char& c : text) {
            if (c < ' ' || c > '~') c = '?';
        }
        if (to - from > kLongest) text += "...";
        return text;
    }

    void report(const source::DiagnosticCode& code, const char* from, const char* to,
                std::string message) {
        add_problem(file_, code, at(from), at(std::max(from, to)), std::move(message));
    }

    /// Guesses the counts from the file's first 64 KiB, so that arrays rarely move; a guess that is
    /// too small costs a little time, one that is too large only untouched address space.
    void reserve() {
        constexpr std::ptrdiff_t kSample = 1 << 16;
        if (end_ - begin_ < 4 * kSample) return;
        std::size_t vertices = 0;
        std::size_t uvs = 0;
        std::size_t normals = 0;
        for (const char* p = begin_; p < begin_ + kSample; p = next_line_after_comment(p)) {
            if (*p != 'v') continue;
            ++(p[1] == 't' ? uvs : p[1] == 'n' ? normals : vertices);
        }
        // At most half of the file: vertices are rarely more, and faces come after them.
        const auto factor = static_cast<std::size_t>((end_ - begin_) / kSample) / 2;
        file_.positions.reserve(vertices * factor);
        file_.uvs.reserve(uvs * factor);
        file_.normals.reserve(normals * factor);
    }

    const char* statement(const char* p) {
        p = skip_blanks(p);
        if (*p == 'v') {
            if (ends_word(p + 1)) return position(p);
            if (p[1] == 't' && ends_word(p + 2)) return uv(p);
            if (p[1] == 'n' && ends_word(p + 2)) return normal(p);
        } else if (*p == 'f' && ends_word(p + 1)) {
            return face(p);
        }
        if (!at_line_end(p)) check_keyword(p);
        return finish_line(p);
    }

    void check_keyword(const char* p) {
        const char* stop = p + 1;  // a lone backslash is a word too
        while (!ends_word(stop)) ++stop;
        const std::string_view word(p, static_cast<std::size_t>(stop - p));
        if (is_obj_keyword(word)) return;
        const auto same = [&](const ObjProblem& remark) {
            return word == std::string_view(begin_ + remark.begin, begin_ + remark.end);
        };
        if (std::ranges::any_of(file_.remarks, same)) return;
        file_.more_remarks = file_.remarks.size() == kMaxObjRemarks;
        if (file_.more_remarks) return;
        file_.remarks.push_back(
            {&kObjKeyword, static_cast<std::uint32_t>(at(p)), static_cast<std::uint32_t>(at(stop)),
             "unknown keyword '" + shortened(p, stop) + "', the line is not read"});
    }

    /// Reads numbers up to the end of the line: `count` of them at most into `values`. Gives how
    /// many stand there, or -1 after a malformed one, which it reports.
    template <int capacity>
    int numbers(const char*& p, std::array<double, capacity>& values) {
        int count = 0;
        for (;;) {
            p = skip_blanks(p);
            if (at_line_end(p)) return count;
            double value = 0;
            const char* const stop = scan_number(p, value);
            const bool whole = stop != nullptr && (is_blank(*stop) || *stop == '\n' ||
                                                   *stop == '\r' || *stop == '\\' || stop >= end_);
            if (!whole || !fits_single(value)) [[unlikely]] {
                bad_number(p, whole);
                return -1;
            }
            if (count < capacity) values[static_cast<std::size_t>(count)] = value;
            ++count;
            p = stop;
        }
    }

    void bad_number(const char* p, bool too_large) {
        const char* const stop = word_end(p);
        const std::string text = shortened(p, stop);
        report(
            kObjNumber, p, stop,
            too_large ? "number '" + text + "' is too large" : "malformed number '" + text + "'");
    }

    void bad_count(const char* from, const char* to, const char* what, int got) {
        report(kObjStatement, from, to, std::string(what) + ", not " + std::to_string(got));
    }

    const char* position(const char* p) {
        const char* const start = p++;
        std::array<double, 3> v{};
        const int count = numbers<3>(p, v);
        if (count < 3 || count > 7) [[unlikely]] {
            if (count >= 0) bad_count(start, p, "'v' takes 3 to 7 numbers", count);
            bad_positions_.push_back(static_cast<std::uint32_t>(file_.positions.size()));
            v = {};
        }
        file_.positions.push_back({v[0], v[1], v[2]});
        return finish_line(p);
    }

    const char* uv(const char* p) {
        const char* const start = p;
        p += 2;
        std::array<double, 2> v{};
        const int count = numbers<2>(p, v);
        if (count < 1 || count > 3) [[unlikely]] {
            if (count >= 0) bad_count(start, p, "'vt' takes 1 to 3 numbers", count);
            bad_uvs_.push_back(static_cast<std::uint32_t>(file_.uvs.size()));
            v = {};
        }
        file_.uvs.push_back({v[0], v[1]});
        return finish_line(p);
    }

    const char* normal(const char* p) {
        const char* const start = p;
        p += 2;
        std::array<double, 3> v{};
        const int count = numbers<3>(p, v);
        if (count != 3) [[unlikely]] {
            if (count >= 0) bad_count(start, p, "'vn' takes 3 numbers", count);
            bad_normals_.push_back(static_cast<std::uint32_t>(file_.normals.size()));
            v = {};
        }
        file_.normals.push_back({v[0], v[1], v[2]});
        return finish_line(p);
    }

    /// An integer with its sign; null if none stands there. Saturates far beyond any file's size.
    static const char* integer(const char* p, std::int64_t& value) {
        const bool negative = *p == '-';
        if (negative || *p == '+') ++p;
        if (!is_digit(*p)) return nullptr;
        std::int64_t result = 0;
        for (; is_digit(*p); ++p) {
            result = std::min<std::int64_t>(result * 10 + (*p - '0'), std::int64_t{1} << 56);
        }
        value = negative ? -result : result;
        return p;
    }

    /// From 1-based or negative to 0-based. Too large ones are judged when the count is known.
    bool resolve(ObjIndexKind kind, std::int64_t index, std::size_t count, std::uint32_t& result,
                 std::int64_t& largest, const char* from, const char* to) {
        std::int64_t zero_based = index - 1;
        if (index <= 0) [[unlikely]] {
            zero_based = static_cast<std::int64_t>(count) + index;
            if (index == 0 || zero_based < 0) {
                report(kObjIndex, from, to, index_message(kind, index, count));
                return false;
            }
        }
        largest = std::max(largest, zero_based);
        result = static_cast<std::uint32_t>(std::min<std::int64_t>(zero_based, kHuge));
        return true;
    }

    /// One corner; `p` ends behind it. False after a problem, which it reports; `malformed` tells
    /// whether the rest of the line is worth reading.
    bool corner(const char*& p, Corner& c, bool& malformed) {
        const char* const from = p;
        std::int64_t index = 0;
        std::int64_t uv_index = 0;
        std::int64_t normal_index = 0;
        bool has_uv = false;
        bool has_normal = false;
        const char* q = integer(p, index);
        if (q != nullptr && *q == '/') {
            if (q[1] == '/') {
                has_normal = true;
                q = integer(q + 2, normal_index);
            } else {
                has_uv = true;
                q = integer(q + 1, uv_index);
                if (q != nullptr && *q == '/') {
                    has_normal = true;
                    q = integer(q + 1, normal_index);
                }
            }
        }
        if (q == nullptr || !(is_blank(*q) || *q == '\n' || *q == '\r' || *q == '\\' || *q == '#' ||
                              q >= end_)) [[unlikely]] {
            p = word_end(p);
            report(kObjFace, from, p, "malformed face corner '" + shortened(from, p) + "'");
            malformed = true;
            return false;
        }
        p = q;
        c = {Mesh::kNone, Mesh::kNone, Mesh::kNone};
        bool good = resolve(ObjIndexKind::kPosition, index, file_.positions.size(), c.position,
                            max_position_, from, q);
        if (has_uv) {
            good &= resolve(ObjIndexKind::kUv, uv_index, file_.uvs.size(), c.uv, max_uv_, from, q);
        }
        if (has_normal) {
            good &= resolve(ObjIndexKind::kNormal, normal_index, file_.normals.size(), c.normal,
                            max_normal_, from, q);
        }
        return good;
    }

    const char* face(const char* p) {
        const char* const start = p++;
        const std::size_t first_face = file_.faces.size();
        Corner first{};
        Corner previous{};
        int count = 0;
        bool good = true;
        for (;; ++count) {
            p = skip_blanks(p);
            if (at_line_end(p)) break;
            Corner current{};
            bool malformed = false;
            good &= corner(p, current, malformed);
            if (malformed) break;
            if (!good) continue;
            if (count == 0) {
                first = current;
            } else if (count > 1) {
                if (file_.faces.size() >= max_faces_) {
                    report(kObjTooManyFaces, start, p,
                           "more than " + std::to_string(max_faces_) + " faces");
                    stopped_ = true;
                    break;
                }
                file_.faces.push_back(uniform({first, previous, current}));
                file_.face_offsets.push_back(static_cast<std::uint32_t>(at(start)));
            }
            previous = current;
        }
        if (good && count < 3 && !stopped_) {
            report(kObjFace, start, p,
                   "a face takes 3 or more corners, not " + std::to_string(count));
        }
        if (!good) {
            file_.faces.resize(first_face);
            file_.face_offsets.resize(first_face);
        }
        return finish_line(p);
    }

    /// A triangle has texture coordinates (normals) at all corners or at none.
    static Face uniform(std::array<Corner, 3> c) {
        if (c[0].uv == Mesh::kNone || c[1].uv == Mesh::kNone || c[2].uv == Mesh::kNone) {
            for (Corner& corner : c) corner.uv = Mesh::kNone;
        }
        if (c[0].normal == Mesh::kNone || c[1].normal == Mesh::kNone ||
            c[2].normal == Mesh::kNone) {
            for (Corner& corner : c) corner.normal = Mesh::kNone;
        }
        return {c};
    }

    [[nodiscard]] static bool unusable(std::uint32_t index, std::size_t count,
                                       const std::vector<std::uint32_t>& bad) {
        return index != Mesh::kNone &&
               (index >= count || std::binary_search(bad.begin(), bad.end(), index));
    }

    /// Reports each corner of the line at `offset` whose index is beyond the end. What refers to a
    /// malformed vertex has been reported there.
    void report_line(std::uint32_t offset) {
        const char* p = begin_ + offset + 1;
        for (;;) {
            p = skip_blanks(p);
            if (at_line_end(p)) return;
            const char* const from = p;
            const char* const stop = word_end(p);
            const std::array<std::size_t, 3> counts{file_.positions.size(), file_.uvs.size(),
                                                    file_.normals.size()};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto kind = static_cast<ObjIndexKind>(i);
                const std::size_t count = counts[i];
                std::int64_t index = 0;
                const char* const q = integer(p, index);
                if (q != nullptr) {
                    p = q;
                    if (index > static_cast<std::int64_t>(count)) {
                        report(kObjIndex, from, stop, index_message(kind, index, count));
                    }
                }
                if (*p != '/') break;
                ++p;
            }
            p = std::max(p, stop);
        }
    }

    /// Judges one triangle; `out_of_range` tells whether its line is to be reported.
    bool is_bad(const Face& face, bool& out_of_range) const {
        bool bad = false;
        for (const Corner& c : face.corners) {
            bad |= unusable(c.position, file_.positions.size(), bad_positions_) ||
                   unusable(c.uv, file_.uvs.size(), bad_uvs_) ||
                   unusable(c.normal, file_.normals.size(), bad_normals_);
            out_of_range |= c.position >= file_.positions.size() ||
                            (c.uv != Mesh::kNone && c.uv >= file_.uvs.size()) ||
                            (c.normal != Mesh::kNone && c.normal >= file_.normals.size());
        }
        return bad;
    }

    /// A polygon is left out as a whole: its triangles are neighbours with one offset.
    void drop_bad_faces() {
        std::size_t kept = 0;
        for (std::size_t first = 0, end = 0; first < file_.faces.size(); first = end) {
            const std::uint32_t offset = file_.face_offsets[first];
            bool bad = false;
            bool out_of_range = false;
            for (end = first; end < file_.faces.size() && file_.face_offsets[end] == offset;
                 ++end) {
                bad |= is_bad(file_.faces[end], out_of_range);
            }
            if (out_of_range) report_line(offset);
            for (std::size_t i = first; i < end && !bad; ++i, ++kept) {
                file_.faces[kept] = file_.faces[i];
                file_.face_offsets[kept] = offset;
            }
        }
        file_.faces.resize(kept);
        file_.face_offsets.resize(kept);
    }

    const char* begin_;
    const char* end_;
    std::uint64_t max_faces_;
    ObjFile file_;
    bool stopped_ = false;
    // The largest index of each kind, so that a file without errors is not walked twice.
    std::int64_t max_position_ = -1;
    std::int64_t max_uv_ = -1;
    std::int64_t max_normal_ = -1;
    // Indices of vertices that are there but unusable, ascending.
    std::vector<std::uint32_t> bad_positions_;
    std::vector<std::uint32_t> bad_uvs_;
    std::vector<std::uint32_t> bad_normals_;
};

}  // namespace

ObjFile read_obj(const std::string& text, ObjRules rules, std::uint64_t max_faces) {
    if (rules == ObjRules::kPublished) return read_published_obj(text, max_faces);
    return Reader(text, max_faces).read();
}

}  // namespace cobble::ir
