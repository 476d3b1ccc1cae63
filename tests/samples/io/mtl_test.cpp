#include "samples/io/mtl.hpp"

#include <gtest/gtest.h>

#include "tests/samples/io/temporary_folder.hpp"

namespace relevo::io {
namespace {

using pipeline::LinearRgb;
using pipeline::Scalar;

std::string error_of(std::string_view text) {
    const TemporaryFolder folder;
    const auto materials = read_mtl(folder.write("x.mtl", text));
    return materials ? "no error" : folder.without_path(materials.error().text());
}

TEST(Mtl, ReadsColoursExponentAndTexture) {
    const TemporaryFolder folder;
    const auto materials =
        read_mtl(folder.write("x.mtl",
                              "# two\r\nnewmtl dark wood\r\nKa 1 0.5 0\r\nKd 0.5 0.25 0\r\n"
                              "Ks 0.3 0.6 0.9\r\nNs 64\r\nd 1\r\nillum 2\r\nmap_Kd .\\tex\\a b.png\r\n"
                              "newmtl plain\n"));
    ASSERT_TRUE(materials) << materials.error().text();
    ASSERT_EQ(materials->size(), 2u);
    const ObjMaterial& wood = (*materials)[0];
    EXPECT_EQ(wood.name, "dark wood");
    EXPECT_EQ(wood.material.ambient, Scalar(0.5) * Scalar(0.1));
    EXPECT_EQ(wood.material.diffuse, Scalar(0.5));
    EXPECT_EQ(wood.material.color, (LinearRgb{1, Scalar(0.5), 0}));
    EXPECT_FLOAT_EQ(static_cast<float>(wood.material.specular), 0.6f);
    EXPECT_EQ(wood.material.shininess, 64);
    EXPECT_EQ(folder.without_path(wood.texture_path), "tex/a b.png");
    EXPECT_EQ((*materials)[1].name, "plain");
    EXPECT_EQ((*materials)[1].material.color, pipeline::Material().color);
    EXPECT_EQ((*materials)[1].texture_path, "");
}

TEST(Mtl, OneNumberIsGreyAndChannelsEndAtOne) {
    const TemporaryFolder folder;
    const auto materials = read_mtl(folder.write("x.mtl", "newmtl a\nKd 0.5\nKs 7 7 7\nnewmtl b\nKd 0 0 0"));
    ASSERT_TRUE(materials);
    EXPECT_EQ((*materials)[0].material.color, (LinearRgb{1, 1, 1}));
    EXPECT_EQ((*materials)[0].material.specular, 1);
    EXPECT_EQ((*materials)[1].material.diffuse, 0);
    EXPECT_EQ((*materials)[1].material.color, (LinearRgb{0, 0, 0}));
}

TEST(Mtl, KnowsWhatIsTransparent) {
    const TemporaryFolder folder;
    const auto transparent = [&](const std::string& statements) {
        const auto materials = read_mtl(folder.write("x.mtl", "newmtl a\nd 0.5\nnewmtl b\n" + statements));
        EXPECT_TRUE(materials) << materials.error().text();
        EXPECT_TRUE((*materials)[0].transparent);
        return (*materials)[1].transparent;
    };
    for (const char* const opaque : {"", "d 1", "Tr 0", "d 1.0\nTr 1.0", "Tr 1\nd 1", "illum 2", "d -halo 1"})
        EXPECT_FALSE(transparent(opaque)) << opaque;
    for (const char* const glass : {"d 0.99", "d 0", "Tr 0.01", "d 0.5\nTr 0", "d -halo 0.5", "map_d a.png",
                                    "map_d a.png\nd 1", "d 1\nmap_d a.png"})
        EXPECT_TRUE(transparent(glass)) << glass;
}

TEST(Mtl, AnAbsoluteTexturePathStays) {
    const TemporaryFolder folder;
    const auto materials = read_mtl(folder.write("x.mtl", "newmtl a\nmap_Kd /usr/a.png"));
    EXPECT_EQ((*materials)[0].texture_path, "/usr/a.png");
}

TEST(Mtl, ErrorsNameTheToken) {
    EXPECT_EQ(error_of("newmtl a\nKd 1 nan 1"),
              "x.mtl:2:6: 'nan' is no colour channel, a number from 0 to 1 is accepted");
    EXPECT_EQ(error_of("newmtl a\nKd 1 -0.5 1"),
              "x.mtl:2:6: '-0.5' is no colour channel, a number from 0 to 1 is accepted");
    EXPECT_EQ(error_of("newmtl a\nKs 1 1"), "x.mtl:2:7: a number is missing: Ks needs red, green and blue");
    EXPECT_EQ(error_of("newmtl a\nKs"), "x.mtl:2:3: a number is missing: Ks needs red, green and blue");
    EXPECT_EQ(error_of("newmtl a\nNs 1e39"), "x.mtl:2:4: '1e39' is no exponent, Ns takes a number from 0 up");
    EXPECT_EQ(error_of("newmtl a\nd 1.5"), "x.mtl:2:3: '1.5' is no opacity, d takes a number from 0 to 1");
    EXPECT_EQ(error_of("newmtl a\nTr"), "x.mtl:2:3: '' is no transparency, Tr takes a number from 0 to 1");
    EXPECT_EQ(error_of("newmtl"), "x.mtl:1:7: a name is missing after newmtl");
    EXPECT_EQ(error_of("Kd 1 1 1"), "x.mtl:1:1: 'Kd' before the first newmtl");
    EXPECT_EQ(error_of("newmtl a\nmap_Kd"), "x.mtl:2:7: a file name is missing after map_Kd");
    EXPECT_EQ(error_of("newmtl a\nmap_Kd -s 2 2 1 a.png"),
              "x.mtl:2:8: options of map_Kd are not supported, write only the name of the image");
}

}  // namespace
}  // namespace relevo::io
