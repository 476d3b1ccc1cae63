// Files with random damage: each is read or refused at a line, none crashes, hangs or gives an index that is
// out of range. The damage comes from a fixed seed.
#include <gtest/gtest.h>

#include <cmath>

#include "samples/io/obj.hpp"
#include "samples/io/solid.hpp"
#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

constexpr int mutations = 10000;

class Damage {
  public:
    std::string operator()(std::string text) {
        for (std::size_t count = below(3) + 1; count > 0; --count) one(text);
        return text;
    }

  private:
    // The upper bits of a linear congruential generator (Knuth, TAOCP 3.3.4).
    std::size_t below(std::size_t end) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::size_t>(state_ >> 33) % end;
    }
    void one(std::string& text) {
        static constexpr std::string_view words[] = {"nan",   "1e39", "-1", "0",    "99999999999", "/", "//",
                                                     "\\\n",  "f",    "v",  "#",    "\n",          " ", "-",
                                                     "faces", ".",    "+",  "\xff", "o a\n"};
        if (text.empty()) return;
        const std::size_t at = below(text.size()), length = std::min(below(12) + 1, text.size() - at);
        switch (below(6)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, words[below(std::size(words))]);
                break;
            case 3:
                text.replace(at, length, words[below(std::size(words))]);
                break;
            case 4:
                text.insert(below(text.size()), text.substr(at, length));
                break;
            default:
                text[at] = static_cast<char>('0' + below(10));
                break;
        }
    }

    std::uint64_t state_ = 20261122;
};

void expect_sound(const pipeline::Mesh& mesh, const std::string& text) {
    EXPECT_FALSE(mesh.indices.empty()) << text;
    EXPECT_EQ(mesh.indices.size() % 3, 0u) << text;
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size()) << text;
    for (const pipeline::Vertex& v : mesh.vertices)
        for (int c = 0; c < 3; ++c)
            ASSERT_TRUE(std::isfinite(v.position.v[c]) && std::isfinite(v.normal.v[c])) << text;
}

// One line, and a place in it unless the file as a whole has nothing to draw.
void expect_friendly(const FileError& error, const std::string& text) {
    EXPECT_EQ(error.text().find('\n'), std::string::npos) << error.text();
    if (error.place.line == 0) {
        EXPECT_TRUE(error.message.starts_with("no faces") ||
                    error.message.starts_with("the file holds no words"))
            << error.text() << "\n"
            << text;
    } else {
        EXPECT_GT(error.place.column, 0) << error.text();
    }
}

TEST(Mutations, OfAnObjFile) {
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const std::string good =
        "mtllib m.mtl\no house\nv 0 0 0\nv 1.5 0 0\nv 1 1e0 0 # top\nv 0 1 -0.25\nvt 0 0\nvt 1 0.5\nvn 0 0 "
        "1\n"
        "usemtl red\nf 1 2 3 4\nf 1/1 2/2 \\\n 3/1\ng roof\nusemtl blue\nf -4//1 -3//-1 -2//1\nf 1/1/1 2/2/1 "
        "4/1/1\ns 1\n";
    Damage damage;
    int read = 0;
    for (int i = 0; i < mutations; ++i) {
        const std::string text = i == 0 ? good : damage(good);
        const auto parts = parse_obj(text, folder.path("x.obj"));
        if (!parts) expect_friendly(parts.error(), text);
        if (!parts) continue;
        ++read;
        for (const ObjPart& part : *parts) expect_sound(part.mesh, text);
    }
    // Both things happen often, or the damage is of the wrong kind.
    EXPECT_GT(read, mutations / 25);
    EXPECT_LT(read, mutations * 9 / 10);
}

void mutate_solid(const std::string& name) {
    const std::string good = bytes_of(RELEVO_SOURCE_DIR "/samples/models/" + name);
    Damage damage;
    int read = 0;
    for (int i = 0; i < mutations; ++i) {
        const std::string text = i == 0 ? good : damage(good);
        const auto solid = parse_solid(text, "x.solid");
        if (!solid) expect_friendly(solid.error(), text);
        if (!solid) continue;
        ++read;
        expect_sound(solid->mesh, text);
    }
    EXPECT_GT(read, mutations / 25);
    EXPECT_LT(read, mutations * 9 / 10);
}

TEST(Mutations, OfASolidOfTheFirstFormat) { mutate_solid("cube.solid"); }
TEST(Mutations, OfASolidOfTheSecondFormat) { mutate_solid("dice.solid"); }

}  // namespace
}  // namespace relevo::io
