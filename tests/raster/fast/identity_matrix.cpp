// The whole promise "same bytes", as scripts/identity runs it: minutes, not seconds. Prints a table of what
// was compared; stops at the first difference with the pixel, both values and all settings.
//   identity_matrix [PART]...        all parts without a name
#include <chrono>
#include <cstdio>
#include <cstring>

#include "samples/scene/scene.hpp"
#include "samples/scene/shapes/torus.hpp"
#include "tests/raster/fast/identity_scenes.hpp"

namespace relevo::tests::identity {
namespace {

const std::vector<Size> sizes{{1, 1},    {3, 2},     {33, 65},   {127, 129},
                              {200, 31}, {641, 479}, {640, 480}, {1920, 1080}};

// One row of the table: how many pictures of each path were compared. False at the first difference.
class Row {
  public:
    explicit Row(const std::string& name) : name_(name), start_(std::chrono::steady_clock::now()) {}
    bool same(const raster::Scene& scene, const raster::Settings& settings, Size size,
              const std::vector<Way>& ways, const std::string& what) {
        const std::string found = first_difference(scene, settings, size, ways, &drawn_);
        ++textbook_, fast_ += ways.size();
        if (!found.empty())
            std::printf("%s: DIFFERENT: %s: %s\n", name_.c_str(), what.c_str(), found.c_str());
        return found.empty();
    }
    bool end() const {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
        std::printf("| %-16s | %8llu | %8llu | %9.1f | %7.1f |\n", name_.c_str(),
                    static_cast<unsigned long long>(textbook_), static_cast<unsigned long long>(fast_),
                    static_cast<double>(drawn_) * 1e-6, seconds.count());
        std::fflush(stdout);
        return true;
    }

  private:
    std::string name_;
    std::chrono::steady_clock::time_point start_;
    std::uint64_t textbook_ = 0, fast_ = 0, drawn_ = 0;
};

// Every way, but for pictures so large that most of the time goes into comparing them.
std::vector<Way> ways_for(Size size, std::size_t number) {
    return size.width > 1000 ? few_ways(number) : all_ways();
}

// Each shading without and with a texture, in every size and every way; the other features meet in pairs.
bool every_way(const Subject& subject, const std::vector<Size>& in) {
    Row row(subject.name);
    std::vector<int> others(feature_choices.begin() + 2, feature_choices.end());
    const auto rows = pairs(others);
    std::size_t number = 0;
    for (const Size size : in)
        for (const auto& first : product({feature_choices[0], feature_choices[1]})) {
            std::vector<int> choice = first;
            const auto& rest = rows[number++ % rows.size()];
            choice.insert(choice.end(), rest.begin(), rest.end());
            const Features f = features(choice);
            if (!row.same(dressed(subject, f, size), settings(f), size, ways_for(size, number), text(f)))
                return false;
        }
    return row.end();
}

// Every feature with every other one, each instruction set; threads and tiles turn.
bool every_feature(const Subject& subject, Size size) {
    Row row(subject.name + ", all");
    std::size_t number = 0;
    for (const auto& choice : product(feature_choices)) {
        const Features f = features(choice);
        if (!row.same(dressed(subject, f, size), settings(f), size, few_ways(number++), text(f)))
            return false;
    }
    return row.end();
}

bool sample(const std::string& name) {
    Row row(name);
    for (const char* depth : {"depth=float32-reversed", "depth=float32-forward"}) {
        auto loaded = scene::load_scene(std::string(RELEVO_SCENES) + "/" + name + ".toml", {{depth}, {}});
        if (!loaded) return std::printf("%s\n", loaded.error().text().c_str()), false;
        std::size_t number = 0;
        const auto in = [&](const std::vector<int>& choice, Size size, const std::vector<Way>& ways) {
            raster::Settings& s = loaded->settings;
            s.shading = static_cast<raster::Shading>(choice[0]);
            s.texture_filter = static_cast<raster::Filter>(choice[1]);
            s.output = static_cast<raster::Output>(choice[2]);
            s.cull = static_cast<pipeline::Cull>(choice[3]);
            std::string what = std::string(depth) + ", shading, filter, output, cull:";
            for (const int c : choice) what += ' ' + std::to_string(c);
            return row.same(loaded->scene, s, size, ways, what);
        };
        for (const Size size : sizes) {
            const bool small = size.width < 600;
            for (const auto& choice : small ? product({4, 2, 2, 3}) : pairs({4, 2, 2, 3})) {
                ++number;
                if (!in(choice, size, small ? few_ways(number) : ways_for(size, number))) return false;
            }
        }
    }
    return row.end();
}

// Ten million triangles, and the largest picture: the bytes, and the memory that the workspace takes.
bool limits() {
    const auto bounded = [](const Subject& subject, Size size, int tile) {
        Row row(subject.name);
        Features f;
        f.texturing = Texturing::Bilinear;
        const raster::Scene scene = dressed(subject, f, size);
        for (const Way& way : few_ways(1)) {
            fast::Workspace workspace;
            const Way with_tile{way.set, way.threads, tile, false, false};
            const fast::Counts counts = fast_path(scene, settings(f), size, with_tile, workspace).counts;
            const double bound = double(counts.vertices) * 48 + double(counts.triangles) * 8 + 0x1p26;
            std::printf("%s, %s: %.1f MiB of %.1f allowed\n", subject.name.c_str(), text(with_tile).c_str(),
                        double(workspace.bytes()) / 0x1p20, bound / 0x1p20);
            if (double(workspace.bytes()) > bound) return std::printf("TOO MUCH\n"), false;
        }
        return row.same(scene, settings(f), size, few_ways(1), text(f)) && row.end();
    };
    Subject large{"torus_10m", {}, {}};
    large.add(*scene::torus(2048, 2048, 0.45));
    large.add(*scene::torus(1280, 640, 0.2));
    large.scene.camera = torus("", 3, 3).scene.camera;
    return bounded(large, {1920, 1080}, 64) && bounded(everything(), {8192, 8192}, 32);
}

int run(int count, char** words) {
    if (fast::instruction_sets().empty()) return std::printf("no fast path here\n"), 1;
    std::printf("ways: ");
    for (const fast::InstructionSet set : fast::instruction_sets())
        std::printf("%s ", std::string(fast::name(set)).c_str());
    std::printf("x 1, 2, 7 threads x tiles of 32, 64, 128\n");
    std::printf("| subject          | textbook |     fast | Mpixel    | seconds |\n|---|---|---|---|---|\n");
    const auto wanted = [&](const char* part) {
        bool named = count < 2;
        for (int i = 1; i < count; ++i) named = named || std::strcmp(words[i], part) == 0;
        return named;
    };
    const std::vector<Size> small(sizes.begin(), sizes.end() - 1), large{{641, 479}, {1920, 1080}};
    bool good = true;
    if (wanted("features"))
        good = good && every_feature(everything(), {61, 47}) && every_feature(inside_torus(12, 9), {33, 65});
    if (wanted("ways"))
        good = good && every_way(everything(), sizes) && every_way(torus("torus_1k", 25, 20), sizes) &&
               every_way(fill(), small) && every_way(inside_torus(40, 30), small) &&
               every_way(bunny(), {{127, 129}, {641, 479}}) &&
               every_way(inside_bunny(), {{127, 129}, {641, 479}}) &&
               every_way(torus("torus_100k", 250, 200), {{127, 129}, {641, 479}}) &&
               every_way(torus("torus_1m", 1000, 500), {{641, 479}});
    if (wanted("samples"))
        for (const std::string& name : sample_scenes()) good = good && sample(name);
    if (wanted("limits")) good = good && limits();
    std::printf(good ? "the same bytes everywhere\n" : "NOT the same bytes\n");
    return good ? 0 : 1;
}

}  // namespace
}  // namespace relevo::tests::identity

int main(int count, char** words) { return relevo::tests::identity::run(count, words); }
