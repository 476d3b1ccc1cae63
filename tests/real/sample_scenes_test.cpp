// Every sample scene in every shading: watched or not, the bytes are the same; and the machine in double
// draws the same picture but for rounding.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "tests/real/double_machine.hpp"
#include "tests/real/drawn.hpp"
#include "tests/real/everything_probe.hpp"

namespace relevo::real {
namespace {

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(RELEVO_SCENES))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class SampleScenes : public testing::TestWithParam<std::string> {
  protected:
    static scene::LoadedScene load(std::pair<int, int> size) {
        return loaded(scene::load_scene(std::string(RELEVO_SCENES) + "/" + GetParam() + ".toml", {{}, size}));
    }
};

TEST(SampleScenes, ThereAreSome) { EXPECT_GE(scene_names().size(), 5u); }

TEST_P(SampleScenes, AProbeChangesNoBit) {
    scene::LoadedScene scene = load({120, 90});
    raster::Frame unwatched = frame_of(scene), watched = frame_of(scene);
    for (const raster::Shading shading : all_shadings) {
        scene.settings.shading = shading;
        EverythingProbe probe;
        raster::draw(scene.scene, scene.settings, unwatched);
        raster::draw(scene.scene, scene.settings, watched, probe);
        EXPECT_GT(probe.events, 100u);
        EXPECT_TRUE(same_bits(unwatched.color, watched.color)) << int(shading);
        EXPECT_TRUE(same_bits(unwatched.depth, watched.depth)) << int(shading);
    }
}

// ------------------------------------------------------------------------------------------------ in double
double_machine::Matrix matrix(const glm::dmat4& m) {
    double_machine::Matrix out;
    for (int i = 0; i < 16; ++i) out[std::size_t(i)] = m[i / 4][i % 4];
    return out;
}
double_machine::Three three(const pipeline::Vec3& v) { return {v.x, v.y, v.z}; }
double_machine::Three three(const pipeline::LinearRgb& c) { return {c.r, c.g, c.b}; }

double_machine::Model plain(const raster::Model& model) {
    double_machine::Model out;
    out.world_from_object = matrix(model.world_from_object.m);
    for (const pipeline::Vertex& v : model.mesh->vertices)
        out.vertices.push_back({v.position.v.x, v.position.v.y, v.position.v.z, v.normal.v.x, v.normal.v.y,
                                v.normal.v.z, v.uv.x, v.uv.y});
    out.indices = model.mesh->indices;
    const pipeline::Material& m = model.material;
    out.ambient = m.ambient, out.diffuse = m.diffuse, out.specular = m.specular, out.shininess = m.shininess;
    out.color = three(m.color), out.two_sided = model.two_sided;
    return out;
}

double_machine::Scene plain(const scene::LoadedScene& loaded) {
    double_machine::Scene out;
    const raster::Scene& scene = loaded.scene;
    out.width = loaded.width, out.height = loaded.height;
    out.eye_from_world = matrix(scene.camera.eye_from_world.m),
    out.clip_from_eye = matrix(scene.camera.clip_from_eye.m);
    out.parallel = scene.camera.parallel, out.background = three(scene.background);
    std::map<const raster::Texture*, int> numbers;
    for (const raster::Model& model : scene.models) {
        out.models.push_back(plain(model));
        if (!model.texture) continue;
        const auto [found, is_new] = numbers.try_emplace(model.texture, int(out.textures.size()));
        if (is_new)
            out.textures.push_back({model.texture->width, model.texture->height, model.texture->texels,
                                    model.texture->unit > pipeline::Scalar(0.001)});
        out.models.back().texture = found->second;
    }
    for (const pipeline::Light& light : scene.lights)
        out.lights.push_back({light.kind == pipeline::Light::Kind::Directional, three(light.position.v),
                              three(light.direction.v), three(light.color)});
    const raster::Settings& s = loaded.settings;
    out.shading = int(s.shading), out.filter = int(s.texture_filter), out.depth = int(s.depth);
    out.cull = int(s.cull), out.output = int(s.output);
    return out;
}

struct Differences {
    int coverage = 0;  // pixels drawn by one of the two only
    int color = 0;     // drawn by both, some channel off by more than 1 of 255
    int largest = 0;   // of all channels of pixels drawn by both
    double depth = 0;  // the same for depth, where the colours agree
    int drawn = 0;
};

Differences differences(const scene::LoadedScene& loaded, const raster::Frame& frame,
                        const double_machine::Pictures& exact) {
    const double cleared = raster::cleared_depth(loaded.settings.depth);
    Differences out;
    for (std::size_t i = 0; i < exact.color.size(); ++i) {
        const auto& a = frame.color.pixels()[i];
        const auto& b = exact.color[i];
        const bool here = double(frame.depth.pixels()[i]) != cleared, there = exact.depth[i] != cleared;
        out.drawn += here;
        out.coverage += here != there;
        if (!here || !there) continue;
        const int off = std::max({std::abs(a.r - b[0]), std::abs(a.g - b[1]), std::abs(a.b - b[2])});
        out.color += off > 1;
        out.largest = std::max(out.largest, off);
        if (off <= 1)
            out.depth = std::max(out.depth, std::abs(double(frame.depth.pixels()[i]) - exact.depth[i]));
    }
    return out;
}

TEST_P(SampleScenes, InDoubleItIsTheSamePicture) {
    scene::LoadedScene scene = load({240, 180});
    raster::Frame frame = frame_of(scene);
    for (const raster::Shading shading : all_shadings) {
        scene.settings.shading = shading;
        raster::draw(scene.scene, scene.settings, frame);
        const Differences found = differences(scene, frame, double_machine::draw(plain(scene)));
        std::printf(
            "%-14s shading %d: of %d pixels %d drawn by one only, %d off by more than 1/255 (by %d), depth "
            "%.3g\n",
            GetParam().c_str(), int(shading), found.drawn, found.coverage, found.color, found.largest,
            found.depth);
        EXPECT_GT(found.drawn, 1000);
        EXPECT_LE(found.coverage, 4);
        EXPECT_LE(found.color, 4);
    }
}

INSTANTIATE_TEST_SUITE_P(Each, SampleScenes, testing::ValuesIn(scene_names()),
                         [](const testing::TestParamInfo<std::string>& name) { return name.param; });

}  // namespace
}  // namespace relevo::real
