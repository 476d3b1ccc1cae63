// Shading of visible pixels, against the textbook path: a probe tells which primitive each pixel shows, the
// tiles are shaded from these numbers alone, and the colours must be the same to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "pipeline/projection.hpp"
#include "raster/draw.hpp"
#include "raster/fast/bins.hpp"
#include "raster/fast/draw_fast.hpp"
#include "raster/fast/stages.hpp"

namespace relevo::tests {

using ShadeTile = std::uint64_t(const raster::fast::DrawState&, raster::fast::TileScratch&, int listed,
                                int tile);
ShadeTile shade_tile_sse4, shade_tile_avx2, shade_tile_avx512;

}  // namespace relevo::tests

namespace relevo::raster::fast {
namespace {

using pipeline::Cull;
using pipeline::Degrees;
using pipeline::Vec3;
using pipeline::Vertex;

tests::ShadeTile* shade_tile_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::Sse4:
            return tests::shade_tile_sse4;
        case InstructionSet::Avx2:
            return tests::shade_tile_avx2;
        case InstructionSet::Avx512:
            break;
    }
    return tests::shade_tile_avx512;
}

// ------------------------------------------------------------------------------------------------ subjects
// An open wavy sheet in [-1, 1]^2 of columns x rows squares: seen from both sides where it bends over.
pipeline::Mesh sheet(int columns, int rows, float bend) {
    pipeline::Mesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const float u = float(i) / float(columns), v = float(j) / float(rows);
            const auto wave = [](float x) { return float(pipeline::sin({360.0 * x})); };
            const float x = 2 * u - 1, y = 2 * v - 1;
            Vertex vertex{
                {{x + bend * wave(v), y + bend * wave(2 * u), bend * wave(u + v)}}, {{0, 0, 1}}, {}};
            vertex.normal = {{wave(u), wave(v + 0.3f), 1}};
            vertex.uv = {3 * u - 0.7f, 2 * v - 0.2f};
            mesh.vertices.push_back(vertex);
        }
    const auto at = [&](int i, int j) { return std::uint32_t(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            for (const std::uint32_t k :
                 {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i + 1, j + 1), at(i, j + 1), at(i, j)})
                mesh.indices.push_back(k);
    return mesh;
}

Texture noise(int width, int height, Encoding encoding) {
    std::mt19937 random(7);
    std::vector<std::uint8_t> bytes(std::size_t(3 * width * height));
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    return make_texture(width, height, 3, bytes, encoding);
}

struct Subject {
    std::vector<pipeline::Mesh> meshes;
    std::vector<Texture> textures;
    Scene scene;
    Settings settings;
    int width = 97, height = 75;
};

pipeline::Affine<pipeline::World, pipeline::Object> placed(Vec3 at, double scale, bool mirrored) {
    glm::dmat4 m(1.0);
    for (int k = 0; k < 3; ++k) m[k][k] = k == 0 && mirrored ? -scale : scale;
    m[1][0] = 0.2 * scale;
    m[3] = {at.x, at.y, at.z, 1};
    return {m};
}

// Sheets of large, middle and tiny triangles, some of them mirrored or of another texture and material.
void fill(Subject& s, bool textured, bool two_sided, std::mt19937& random) {
    s.meshes = {sheet(2, 1, 0.3f), sheet(9, 7, 0.4f), sheet(60, 40, 0.5f), sheet(150, 120, 0.2f)};
    s.textures.push_back(noise(16, 16, Encoding::Srgb));
    s.textures.push_back(noise(7, 5, Encoding::Raw));
    for (std::size_t m = 0; m < s.meshes.size(); ++m) {
        const auto part = [&] { return float(random() % 1000) / 1000; };
        Model model;
        model.mesh = &s.meshes[m];
        model.world_from_object =
            placed({part() - 0.5f, part() - 0.5f, -0.4f * part()}, 0.6 + 0.3 * part(), random() % 2 == 0);
        model.material = {part(),
                          part(),
                          part(),
                          random() % 3 ? Scalar(1 + random() % 128) : 9 * part(),
                          {part(), part(), part()}};
        model.texture = textured && random() % 4 != 0 ? &s.textures[random() % 2] : nullptr;
        model.two_sided = two_sided;
        s.scene.models.push_back(model);
    }
    s.scene.lights = {{pipeline::Light::Kind::Point, {{1, 2, 3}}, {{0, 0, -1}}, {1, 0.9f, 0.8f}},
                      {pipeline::Light::Kind::Directional, {{0, 0, 0}}, {{1, -1, -2}}, {0.3f, 0.4f, 0.5f}},
                      {pipeline::Light::Kind::Point, {{-1, 0, -2}}, {{0, 0, -1}}, {0.2f, 0.5f, 0.1f}}};
    s.scene.lights.resize(random() % 4);
    if (random() % 2)  // grey ones
        for (pipeline::Light& light : s.scene.lights) light.color.r = light.color.g = light.color.b;
    const bool parallel = random() % 3 == 0;
    s.scene.camera = {*pipeline::look_at({0, 0, 2.5}, {0.1, 0, 0}, {0, 1, 0}),
                      parallel
                          ? *pipeline::orthographic(-1, 1, -1, 1, 0.1, 10, pipeline::DepthRange::Reversed)
                          : *pipeline::perspective({50}, 1.3, 0.1, 10, pipeline::DepthRange::Reversed),
                      parallel};
}

// ------------------------------------------------------------------------------------------------ textbook
struct Seen {
    Image<std::uint32_t> primitive;
    void on(const FragmentShaded& f) { primitive.row(f.y)[f.x] = f.primitive; }
};

struct Picture {
    Frame frame;
    Image<std::uint32_t> visible;
};
Picture textbook(const Subject& s) {
    Picture p{{Image<Rgba8>(s.width, s.height), Image<Scalar>(s.width, s.height),
               Image<LinearRgb>(s.width, s.height)},
              {}};
    Seen seen{Image<std::uint32_t>(s.width, s.height, nothing)};
    raster::draw(s.scene, s.settings, p.frame, seen);
    p.visible = seen.primitive;
    return p;
}

// ------------------------------------------------------------------------------------------------ state
// The memory behind a DrawState, filled as the earlier stages would.
struct State {
    std::vector<pipeline::EyeLight> lights;
    std::vector<std::vector<SnappedCorner>> window;
    std::vector<std::vector<Scalar>> carried;
    std::vector<ModelState> models;
    std::vector<Piece> pieces;
    std::vector<PieceName> names;
    std::vector<Pieces> chunks;
    std::vector<std::uint32_t> id_of;  // of each primitive
    Image<LinearRgb> linear;
    DrawState draw;
};

template <class Program>
void fill_model(ModelState& model, const pipeline::Viewport& viewport, std::vector<SnappedCorner>& window,
                std::vector<Scalar>& carried) {
    model.size = Program::size;
    model.stride = Program::size == 0 ? 0 : Program::size <= 4 ? 4 : 8;
    window.resize(model.vertices.size());
    carried.resize(model.vertices.size() * std::size_t(model.stride));
    for (std::size_t i = 0; i < model.vertices.size(); ++i) {
        const auto clip = model.setup.clip_from_object * model.vertices[i].position;
        if (pipeline::clip_codes(clip) == 0) window[i] = pipeline::to_window(clip, viewport);
        const auto values = varying_of<Program>(model.setup, model.vertices[i], false);
        std::copy(values.begin(), values.end(), carried.begin() + std::ptrdiff_t(i) * model.stride);
    }
    model.window = window.data();
    model.carried = carried.data();
}

// Some triangles come as pieces, as if clipping had left them whole.
template <class Program>
void make_pieces(State& state, const ModelState& model, std::mt19937& random) {
    for (std::uint32_t t = 0; t < model.triangles; ++t) {
        if (random() % 8 != 0) continue;
        Piece piece{};
        const std::uint32_t* index = &model.indices[3 * t];
        const int first = int(random() % 3);
        const auto corner = [&](int k) { return index[(k + first) % 3]; };
        for (int k = 0; k < 3; ++k) piece.window[k] = model.window[corner(k)];
        const bool back = pipeline::facing(area2(piece.window[0], piece.window[1], piece.window[2]),
                                           model.setup.mirrored) == Facing::Back;
        for (int k = 0; k < 3; ++k) {
            const auto values =
                varying_of<Program>(model.setup, model.vertices[corner(k)], back && model.setup.both_sides);
            std::copy(values.begin(), values.end(), piece.carried[k]);
        }
        state.id_of[model.first_primitive + t] =
            piece_bit | 1u << piece_index_bits | static_cast<std::uint32_t>(state.pieces.size());
        state.pieces.push_back(piece);
        state.names.push_back({model.first_primitive + t, 0});
    }
}

void fill(State& state, const Subject& s, bool with_pieces) {
    state.lights = lights_in_eye_space(s.scene);
    const std::size_t count = s.scene.models.size();
    state.models.resize(count), state.window.resize(count), state.carried.resize(count);
    state.draw.viewport = {s.width, s.height};
    std::mt19937 random(3);
    std::uint32_t first = 0;
    for (std::uint32_t m = 0; m < count; ++m) {
        const Model& from = s.scene.models[m];
        ModelState& model = state.models[m];
        model.vertices = from.mesh->vertices, model.indices = from.mesh->indices;
        model.number = m, model.first_primitive = first;
        model.triangles = static_cast<std::uint32_t>(from.mesh->triangles());
        first += model.triangles;
        model.setup = make_setup(s.scene.camera, from, state.lights, s.settings);
        model.shading = s.settings.shading, model.textured = from.texture != nullptr;
        for (std::uint32_t t = 0; t < model.triangles; ++t) state.id_of.push_back(model.first_primitive + t);
        with_program(model.shading, model.textured, [&]<class Program>(Program) {
            fill_model<Program>(model, state.draw.viewport, state.window[m], state.carried[m]);
            if (with_pieces) make_pieces<Program>(state, model, random);
        });
    }
    state.chunks = {{}, {state.names, state.pieces}};
    state.draw.models = state.models, state.draw.pieces = state.chunks;
    state.draw.settings = s.settings;
    state.draw.background = s.scene.background;
    state.draw.background8 = to_rgba8(s.scene.background, s.settings.output);
}

// ------------------------------------------------------------------------------------------------ the test
// Shades all tiles; empty, or the first pixel that differs from the textbook's picture.
std::string difference(const Subject& s, const Picture& right, InstructionSet set, int tile_size,
                       bool with_pieces, bool with_linear) {
    State state;
    fill(state, s, with_pieces);
    state.draw.tile = tile_size;
    state.linear = Image<LinearRgb>(s.width, s.height, {-1, -1, -1});
    if (with_linear) state.draw.linear = state.linear.row(0);
    Image<Rgba8> color(s.width, s.height);
    Image<Scalar> depth(s.width, s.height);
    state.draw.color = color.row(0), state.draw.depth = depth.row(0);
    state.draw.tiles_across = (s.width + tile_size - 1) / tile_size;
    state.draw.tiles_down = (s.height + tile_size - 1) / tile_size;

    // the list of every tile: all triangles, so that there are more than shading keeps at a time
    std::vector<std::uint32_t> place_of(state.id_of.size()), ids(state.id_of.size());
    for (std::uint32_t k = 0; k < place_of.size(); ++k) place_of[k] = k;
    std::mt19937 random{static_cast<unsigned>(tile_size)};
    if (with_pieces) std::shuffle(place_of.begin(), place_of.end(), random);
    for (std::size_t k = 0; k < ids.size(); ++k) ids[place_of[k]] = state.id_of[k];
    const int listed = static_cast<int>(ids.size());
    ids.resize(ids.size() + first_block, 0);

    const int stride = tile_size + 16;
    const std::size_t pixels = std::size_t(stride) * std::size_t(tile_size) + 16;
    const Scalar cleared = cleared_depth(state.draw.settings.depth);
    std::vector<Scalar> nearness(pixels);
    std::vector<std::uint32_t> visible(pixels), band(pixels);
    std::vector<std::byte> memory(kept_bytes + waiting_bytes + 64);
    auto* const kept = memory.data() + (64 - reinterpret_cast<std::uintptr_t>(memory.data()) % 64) % 64;
    std::uint64_t shaded = 0, shown = 0;
    for (int tile = 0; tile < state.draw.tiles_across * state.draw.tiles_down; ++tile) {
        const int x0 = tile % state.draw.tiles_across * tile_size,
                  y0 = tile / state.draw.tiles_across * tile_size;
        std::fill(visible.begin(), visible.end(), nothing);
        std::fill(nearness.begin(), nearness.end(), cleared);
        for (int y = y0; y < std::min(y0 + tile_size, s.height); ++y)
            for (int x = x0; x < std::min(x0 + tile_size, s.width); ++x) {
                const std::uint32_t primitive = right.visible.at(x, y);
                if (primitive == nothing) continue;
                const auto place = std::size_t((y - y0) * stride + x - x0);
                visible[place] = place_of[primitive], nearness[place] = 0.25f;
                ++shown;
            }
        std::uint32_t* const shown_by = shows_one_color(state.draw) ? nullptr : visible.data();
        TileScratch scratch{
            {stride, nearness.data(), shown_by, band.data()}, ids.data(), kept, kept + kept_bytes};
        shaded += shade_tile_of(set)(state.draw, scratch, listed, tile);
    }
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            const Rgba8 rgba = color.at(x, y), expected = right.frame.color.at(x, y);
            const LinearRgb linear = state.linear.at(x, y), expected_linear = right.frame.linear.at(x, y);
            const Scalar expected_depth = right.visible.at(x, y) == nothing ? cleared : 0.25f;
            const bool same = rgba == expected && depth.at(x, y) == expected_depth &&
                              (!with_linear || std::memcmp(&linear, &expected_linear, sizeof linear) == 0);
            if (same) continue;
            char text[300];
            std::snprintf(
                text, sizeof text,
                "pixel %d %d, primitive %u: %d %d %d instead of %d %d %d; %a %a %a instead of %a %a %a; "
                "depth %a",
                x, y, right.visible.at(x, y), rgba.r, rgba.g, rgba.b, expected.r, expected.g, expected.b,
                linear.r, linear.g, linear.b, expected_linear.r, expected_linear.g, expected_linear.b,
                depth.at(x, y));
            return text;
        }
    if (shaded != shown) return std::to_string(shaded) + " pixels shaded, not " + std::to_string(shown);
    return "";
}

void compare(const Subject& s, unsigned turn) {
    const Picture right = textbook(s);
    for (const InstructionSet set : instruction_sets())
        for (const bool with_pieces : {false, true}) {
            const int tile_size = 32 << (turn + unsigned(with_pieces)) % 3;
            const bool with_linear = (turn + unsigned(set)) % 3 != 0;
            EXPECT_EQ(difference(s, right, set, tile_size, with_pieces, with_linear), "")
                << name(set) << ", tile " << tile_size << (with_pieces ? ", with pieces" : "");
        }
}

constexpr Shading shadings[] = {Shading::Unlit, Shading::Flat, Shading::Gouraud, Shading::Phong};

TEST(ShadeTile, IsTheTextbooksForAllProgramsAndSides) {
    std::mt19937 random(1);
    unsigned turn = 0;
    for (const Shading shading : shadings)
        for (const bool textured : {false, true})
            for (const bool two_sided : {false, true})
                for (const Cull cull : {Cull::None, Cull::Back, Cull::Front})
                    for (const Output output : {Output::Raw, Output::Srgb}) {
                        Subject s;
                        fill(s, textured, two_sided, random);
                        s.settings.shading = shading, s.settings.cull = cull, s.settings.output = output;
                        s.settings.texture_filter = turn % 2 ? Filter::Bilinear : Filter::Nearest;
                        s.width = 20 + int(random() % 150), s.height = 20 + int(random() % 100);
                        SCOPED_TRACE(testing::Message()
                                     << "shading " << int(shading) << (textured ? ", textured" : "")
                                     << (two_sided ? ", two-sided" : "") << ", cull " << int(cull)
                                     << ", output " << int(output) << ", " << s.width << " x " << s.height);
                        compare(s, turn++);
                        if (HasFailure()) return;
                    }
}

// Alternating triangles of one pixel, of two, and of more than a row: all kinds of groups, side by side.
TEST(ShadeTile, IsTheTextbooksForAllSizesOfTriangles) {
    std::mt19937 random(2);
    unsigned turn = 0;
    for (const Shading shading : shadings)
        for (const int fineness : {1, 3, 10, 25, 60, 200}) {
            Subject s;
            fill(s, true, false, random);
            s.meshes = {sheet(fineness, fineness, 0.1f)};
            s.scene.models.resize(1);
            s.scene.models[0].mesh = s.meshes.data();
            s.settings.shading = shading, s.settings.cull = Cull::None;
            s.width = 200, s.height = 130;
            SCOPED_TRACE(testing::Message() << "shading " << int(shading) << ", fineness " << fineness);
            compare(s, turn++);
            if (HasFailure()) return;
        }
}

TEST(ShadeTile, EmptyTilesAreBackground) {
    std::mt19937 random(2);
    Subject s;
    fill(s, false, false, random);
    s.scene.models.clear();
    s.width = 1, s.height = 1;
    compare(s, 1);
}

}  // namespace
}  // namespace relevo::raster::fast
