// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "ir/assets/obj/obj_file.hpp"
#include "ir/assets/obj/scan_number.hpp"

using namespace cobble::ir;
using cobble::math::Vec2d;
using cobble::math::Vec3d;

namespace {

constexpr std::uint64_t kMany = 1U << 20;

ObjFile read(const std::string& text, std::uint64_t max_faces = kMany) {
    return read_obj(text, ObjRules::kStandard, max_faces);
}
ObjFile read_published(const std::string& text) {
    return read_obj(text, ObjRules::kPublished, kMany);
}

/// "code at 'bytes': message" of each problem.
std::vector<std::string> problems(const std::string& text, std::uint64_t max_faces = kMany) {
    std::vector<std::string> result;
    for (const ObjProblem& p : read(text, max_faces).problems) {
        result.push_back(std::string(p.code->code) + " '" + text.substr(p.begin, p.end - p.begin) +
                         "': " + p.message);
    }
    return result;
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
using Strings = std::vector<std::string>;

}  // namespace

TEST_CASE("numbers are read to the nearest double") {
    const auto scan = [](const std::string& text) {
        double value = 0;
        const char* const end = scan_number(text.c_str(), value);
        REQUIRE(end == text.c_str() + text.size());
        return value;
    };
    CHECK(scan("0.1") == 0.1);
    CHECK(scan("-.5") == -0.5);
    CHECK(scan("5.") == 5.0);
    CHECK(scan("+1e-3") == 1e-3);
    CHECK(scan("1.7976931348623157e308") == 1.7976931348623157e308);
    CHECK(scan("4.9406564584124654e-324") == 4.9406564584124654e-324);
    // Halfway between two doubles; more than 19 digits; one above 2^53.
    CHECK(scan("9007199254740993") == 9007199254740992.0);
    CHECK(scan("0.12345678901234567890123") == 0.12345678901234567890123);
    CHECK(scan("9007199254740995") == 9007199254740996.0);
    CHECK(std::signbit(scan("-0")));
    CHECK(std::isinf(scan("1e999")));
    double value = 0;
    for (const char* bad : {"", ".", "-", "e5", "1e", "1e+", "inf", "nan", "x"}) {
        CAPTURE(bad);
        CHECK(scan_number(bad, value) == nullptr);
    }
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        std::string text = std::to_string(random() % 1000000) + ".";
        const int digits = static_cast<int>(random() % 18);
        for (int k = 0; k < digits; ++k) text += static_cast<char>('0' + random() % 10);
        CAPTURE(text);
        REQUIRE(scan(text) == std::strtod(text.c_str(), nullptr));
    }
}

TEST_CASE("all forms of corners, polygons and line ends") {
    const auto file = read("# a comment\n\nmtllib x.mtl\no thing\n" + kThree +
                           "v 1 1 0 1 0.5 0.5 0.5\r\nvt 0.25\nvt 0.5 0.75\nvt 0 1 0\nvn 0 0 2\r\n"
                           "usemtl m\ng a b\ns 1\nl 1 2\np 1\n"
                           "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 3/3/1\n"
                           "f -4 -3 \\\n -1 -2 # a fan\n"
                           "\tf  1/1  2/2  3  \n"
                           "f 1 2 4");
    CHECK(file.problem_count == 0);
    REQUIRE(file.positions.size() == 4);
    CHECK(file.positions[3] == Vec3d{1, 1, 0});
    CHECK(file.uvs == std::vector<Vec2d>{{0.25, 0}, {0.5, 0.75}, {0, 1}});
    CHECK(file.normals == std::vector<Vec3d>{{0, 0, 2}});
    REQUIRE(file.faces.size() == 8);
    CHECK(file.faces[0].corners[2].position == 2);
    CHECK(file.faces[0].corners[2].uv == Mesh::kNone);
    CHECK(file.faces[1].corners[2].uv == 2);
    CHECK(file.faces[1].corners[2].normal == Mesh::kNone);
    CHECK(file.faces[2].corners[0].uv == Mesh::kNone);
    CHECK(file.faces[2].corners[0].normal == 0);
    CHECK(file.faces[3].corners[1].uv == 1);
    CHECK(file.faces[3].corners[1].normal == 0);
    // -4 -3 -1 -2 of four vertices: 0 1 3 2, cut into 0 1 3 and 0 3 2.
    CHECK(file.faces[4].corners[1].position == 1);
    CHECK(file.faces[4].corners[2].position == 3);
    CHECK(file.faces[5].corners[1].position == 3);
    CHECK(file.faces[5].corners[2].position == 2);
    CHECK(file.face_offsets[4] == file.face_offsets[5]);
    // One corner without texture coordinates: none of them counts.
    CHECK(file.faces[6].corners[0].uv == Mesh::kNone);
    CHECK(file.faces[7].corners[2].position == 3);
}

TEST_CASE("lone carriage returns end lines") {
    const auto file = read("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r");
    CHECK(file.problem_count == 0);
    CHECK(file.faces.size() == 1);
}

TEST_CASE("faces may come before their vertices") {
    CHECK(read("f 1 2 3\n" + kThree).faces.size() == 1);
    // Negative indices count from where they stand.
    CHECK(problems("f -1 -2 -3\n" + kThree) ==
          Strings{"asset-mesh-index '-1': face refers to vertex -1, but only 0 came before it",
                  "asset-mesh-index '-2': face refers to vertex -2, but only 0 came before it",
                  "asset-mesh-index '-3': face refers to vertex -3, but only 0 came before it"});
}

TEST_CASE("unknown keywords are remarked upon, known ones are not") {
    const auto remarks = [](const std::string& text) {
        Strings result;
        for (const ObjProblem& remark : read(text).remarks) {
            result.push_back(text.substr(remark.begin, remark.end - remark.begin) + ": " +
                             remark.message);
        }
        return result;
    };
    CHECK(remarks(kThree + "hello 1 2\n V 1 2 3\nhello again\nf 1 2 3\n") ==
          Strings{"hello: unknown keyword 'hello', the line is not read",
                  "V: unknown keyword 'V', the line is not read"});
    CHECK(remarks("mtllib a.mtl\no cube\ng a b\ns off\nusemtl red\nl 1 2\np 1\nvp 0 0\n"
                  "cstype bezier\ndeg 3\ncurv 0 1 1 2\nparm u 0 1\nend\n# hello\n\n \t\n") ==
          Strings{});
    CHECK(remarks("\xEF\xBB\xBFv 0 0 0\n") == Strings{});
    CHECK(remarks("h\xFFllo\n\\ x\n") ==
          Strings{"h\xFFllo: unknown keyword 'h?llo', the line is not read",
                  "\\: unknown keyword '\\', the line is not read"});
    CHECK(remarks("a\nb\nc\nd\ne\nh\n").size() == kMaxObjRemarks);
    CHECK(read_published("hello 1 2\n").remarks.empty());
    // A remark takes no error's place.
    CHECK(problems("a\nb\nc\nd\ne\nv 1\n").size() == 1);
}

TEST_CASE("each problem has its place") {
    CHECK(problems("v 0 1.2.3 0\n") ==
          Strings{"asset-mesh-number '1.2.3': malformed number '1.2.3'"});
    CHECK(problems("v x 0 0\n") == Strings{"asset-mesh-number 'x': malformed number 'x'"});
    CHECK(problems("v 0 nan 0\n") == Strings{"asset-mesh-number 'nan': malformed number 'nan'"});
    CHECK(problems("v 0 1e999 0\n") ==
          Strings{"asset-mesh-number '1e999': number '1e999' is too large"});
    CHECK(problems("vt nan 0\n") == Strings{"asset-mesh-number 'nan': malformed number 'nan'"});
    CHECK(problems("vt 0 -inf\n") == Strings{"asset-mesh-number '-inf': malformed number '-inf'"});
    // Infinite in single precision.
    CHECK(problems("vt 1e39 0\n") ==
          Strings{"asset-mesh-number '1e39': number '1e39' is too large"});
    CHECK(problems("vn 0 -3.5e38 0\nvt 3.4e38 1e-300\n") ==
          Strings{"asset-mesh-number '-3.5e38': number '-3.5e38' is too large"});
    CHECK(problems("v 0 1\n") ==
          Strings{"asset-mesh-statement 'v 0 1': 'v' takes 3 to 7 numbers, not 2"});
    CHECK(problems("v 1 2 3 4 5 6 7 8\n") ==
          Strings{"asset-mesh-statement 'v 1 2 3 4 5 6 7 8': 'v' takes 3 to 7 numbers, not 8"});
    CHECK(problems("vt \n") ==
          Strings{"asset-mesh-statement 'vt ': 'vt' takes 1 to 3 numbers, not 0"});
    CHECK(problems("vn 1 2") ==
          Strings{"asset-mesh-statement 'vn 1 2': 'vn' takes 3 numbers, not 2"});
    CHECK(problems(kThree + "f 1 2\n") ==
          Strings{"asset-mesh-face 'f 1 2': a face takes 3 or more corners, not 2"});
    CHECK(problems(kThree + "f 1 2 3/\n") ==
          Strings{"asset-mesh-face '3/': malformed face corner '3/'"});
    CHECK(problems(kThree + "f 1 2.5 3\n") ==
          Strings{"asset-mesh-face '2.5': malformed face corner '2.5'"});
    CHECK(problems(kThree + "f 1 2 4\nf 1 2 3\n") ==
          Strings{"asset-mesh-index '4': face refers to vertex 4, but the file has 3"});
    CHECK(
        problems(kThree + "f 1/1 2/1 3/1") ==
        Strings{
            "asset-mesh-index '1/1': face refers to texture coordinate 1, but the file has none",
            "asset-mesh-index '2/1': face refers to texture coordinate 1, but the file has none",
            "asset-mesh-index '3/1': face refers to texture coordinate 1, but the file has none"});
    CHECK(problems(kThree + "vn 0 0 1\nf 1//1 2//2 3//1") ==
          Strings{"asset-mesh-index '2//2': face refers to normal 2, but the file has 1"});
    CHECK(problems(kThree + "f 0 1 2\n") ==
          Strings{"asset-mesh-index '0': face refers to vertex 0, but they are counted from 1"});
    CHECK(problems(kThree + "f 1 2 4294967296\nf 1 2 99999999999999999999999\n").size() == 2);
}

TEST_CASE("only the faces that a problem touches are left out") {
    const auto file = read(kThree + "v 0 0 oops\nf 1 2 3\nf 1 2 4\nf 1 2 3 9\nf 3 2 1\n");
    CHECK(file.problem_count == 2);
    REQUIRE(file.faces.size() == 2);
    CHECK(file.faces[1].corners[0].position == 2);
    CHECK(file.face_offsets.size() == 2);
}

TEST_CASE("problems are listed up to a number and counted beyond it") {
    std::string text = kThree;
    for (int i = 0; i < 1000; ++i) text += "f 1 2 x\n";
    const auto file = read(text);
    CHECK(file.problems.size() == kMaxObjProblems);
    CHECK(file.problem_count == 1000);
}

TEST_CASE("reading stops at the limit of faces") {
    std::string text = kThree;
    for (int i = 0; i < 100; ++i) text += "f 1 2 3\n";
    const auto file = read(text, 10);
    CHECK(file.faces.size() == 10);
    REQUIRE(file.problems.size() == 1);
    CHECK(file.problems[0].message == "more than 10 faces");
    std::string fan = kThree + "f 1";
    for (int i = 0; i < 1000; ++i) fan += " 2";
    CHECK(read(fan, 10).faces.size() == 10);
}

TEST_CASE("the published readers' rules") {
    SUBCASE("a last line without line end is dropped") {
        CHECK(read_published(kThree + "f 1 2 3\nf 3 2 1").faces.size() == 1);
        CHECK(read_published(kThree + "f 1 2 3\nf 3 2 1\n").faces.size() == 2);
    }
    SUBCASE("three corners of a polygon") {
        const auto file = read_published(kThree + "v 1 1 0\nf 1 2 4 3\n");
        REQUIRE(file.faces.size() == 1);
        CHECK(file.faces[0].corners[2].position == 3);
    }
    SUBCASE("slashes are blanks: the normal becomes the next vertex") {
        const auto file =
            read_published(kThree + "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/3 2/2/1 3/3/1\n");
        REQUIRE(file.faces.size() == 1);
        // Pairs of 1 1 3 2 2 1 ...: (1, 1), (3, 2), (2, 1).
        CHECK(file.faces[0].corners[1].position == 2);
        CHECK(file.faces[0].corners[1].uv == 1);
        CHECK(file.faces[0].corners[2].position == 1);
        CHECK(file.faces[0].corners[2].uv == 0);
        CHECK(file.normals.empty());
    }
    SUBCASE("corners without texture coordinates take the first, if there are any") {
        const auto file = read_published(kThree + "vt 0.5 0.5\nf 1 2 3\n");
        REQUIRE(file.faces.size() == 1);
        CHECK(file.faces[0].corners[2].uv == 0);
    }
    SUBCASE("negative indices are out of range") {
        const auto file = read_published(kThree + "f -1 -2 -3\n");
        CHECK(file.faces.empty());
        REQUIRE(file.problem_count == 1);
        CHECK(file.problems[0].begin == kThree.size());
    }
    SUBCASE("CRLF is white space") {
        CHECK(read_published("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n").faces.size() == 1);
    }
}

TEST_CASE("no mutation of a file crashes a reader") {
    const std::string seed = kThree +
                             "v 1 1 0 1\nvt 0 0\nvt 1 0 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\n"
                             "f 1//1 2//1 3//1 4//1 \\\n 1//1\nf -1 -2 -3\n# end\nusemtl x\n";
    const std::string alphabet = "0123456789 -+./e\\\n\r\tvfnt#\0\xff";
    std::mt19937 random(7);
    for (int round = 0; round < 30000; ++round) {
        std::string text = seed;
        const auto count = 1 + random() % 6;
        for (unsigned i = 0; i < count && !text.empty(); ++i) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = alphabet[random() % alphabet.size()];
                    break;
                case 1:
                    text.insert(at, 1, alphabet[random() % alphabet.size()]);
                    break;
                case 2:
                    text.erase(at, 1 + random() % 5);
                    break;
                default:
                    text.resize(at);
                    break;
            }
        }
        for (const ObjRules rules : {ObjRules::kStandard, ObjRules::kPublished}) {
            const auto file = read_obj(text, rules, 64);
            REQUIRE(file.faces.size() == file.face_offsets.size());
            for (const auto& face : file.faces) {
                for (const auto& corner : face.corners) {
                    REQUIRE(corner.position < file.positions.size());
                    REQUIRE((corner.uv == Mesh::kNone || corner.uv < file.uvs.size()));
                    REQUIRE((corner.normal == Mesh::kNone || corner.normal < file.normals.size()));
                }
            }
            for (const auto& problem : file.problems) {
                REQUIRE(problem.begin <= problem.end);
                REQUIRE(problem.end <= text.size());
            }
        }
    }
}

TEST_CASE("statements without any value are errors") {
    CHECK(problems("v\n") == Strings{"asset-mesh-statement 'v': 'v' takes 3 to 7 numbers, not 0"});
    CHECK(problems("vn # none\n").size() == 1);
    CHECK(problems("vt").size() == 1);
    CHECK(problems("f\r\n") ==
          Strings{"asset-mesh-face 'f': a face takes 3 or more corners, not 0"});
    CHECK(problems("fx\nvp\nvx 1\n").empty());
}
