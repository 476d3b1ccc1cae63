// Relevo and llvmpipe on the same work, frame by frame in turn, in one process on one thread. Writes a table
// in Markdown (standard output) and CSV: median CPU milliseconds of a frame, from the vertices to the 8-bit
// picture, and their ratio, beside the ratio that is allowed. Only ratios mean anything on a shared machine.
//
// Relevo's `flat` lights every face once; llvmpipe's draws one constant colour, which is a little less work.
// Exit status 1 when a ratio is above its limit, or when the two pictures are not the same work.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "raster/draw.hpp"
#include "tests/bench/gl_peer.hpp"

namespace relevo::bench {
namespace {

struct Row {
    const Workload& workload;
    Mode mode;
    double allowed;  // our time / llvmpipe's; 0: not limited
};

constexpr int width = 1920, height = 1080, frames = 25;
constexpr const char* mode_names[] = {"flat", "gouraud", "phong", "phong+bilinear"};

double cpu_milliseconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

template <class Work>
double timed(Work&& work) {
    const double start = cpu_milliseconds();
    work();
    return cpu_milliseconds() - start;
}

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
    return v[v.size() / 2];
}

raster::Texture& texture() {
    static raster::Texture made = [] {
        auto rows = checkerboard();  // bottom row first; make_texture takes the top row first
        const std::size_t stride = std::size_t{3} * texture_size;
        for (std::size_t y = 0; y < texture_size / 2; ++y)
            std::swap_ranges(rows.begin() + std::ptrdiff_t(y * stride),
                             rows.begin() + std::ptrdiff_t((y + 1) * stride),
                             rows.end() - std::ptrdiff_t((y + 1) * stride));
        return raster::make_texture(texture_size, texture_size, 3, rows, raster::Encoding::Raw);
    }();
    return made;
}

// The share of pixels that differ by more than 2 of 255 in a channel: silhouettes, and a little filtering.
double difference(const raster::Image<raster::Rgba8>& a, const raster::Image<raster::Rgba8>& b) {
    std::size_t different = 0;
    for (std::size_t k = 0; k < a.pixels().size(); ++k) {
        const raster::Rgba8 p = a.pixels()[k], q = b.pixels()[k];
        different += std::abs(p.r - q.r) > 2 || std::abs(p.g - q.g) > 2 || std::abs(p.b - q.b) > 2;
    }
    return static_cast<double>(different) / static_cast<double>(a.pixels().size());
}

bool measure(const Row& row, std::ofstream& csv) {
    using namespace raster;
    GlPeer peer(row.workload, row.mode, width, height);
    Scene scene{
        {{&row.workload.mesh, {}, material(), row.mode == Mode::Textured ? &texture() : nullptr, false}},
        {light()},
        camera(width, height, pipeline::DepthRange::Reversed),
        background};
    Settings settings{Shading::Phong, Filter::Bilinear, DepthFormat::Float32Reversed, pipeline::Cull::Back,
                      Output::Raw};
    if (row.mode == Mode::Flat) settings.shading = Shading::Flat;
    if (row.mode == Mode::Gouraud) settings.shading = Shading::Gouraud;
    Frame frame{Image<Rgba8>(width, height), Image<pipeline::Scalar>(width, height), {}};

    std::vector<double> ours, theirs;
    for (int f = -2; f < frames; ++f) {  // two frames to warm up
        scene.models[0].world_from_object = placement(row.workload, f);
        const double a = timed([&] { draw(scene, settings, frame); });
        const double b = timed([&] { peer.draw(f); });
        if (f >= 0) ours.push_back(a), theirs.push_back(b);
    }
    const double a = median(ours), b = median(theirs), ratio = a / b;
    const double unlike = row.mode == Mode::Flat ? 0 : difference(frame.color, peer.picture());
    const bool same_work = unlike < 0.005, fast = row.allowed == 0 || ratio <= row.allowed;
    const char* name = mode_names[static_cast<int>(row.mode)];
    std::printf("| %s | %s | %.1f | %.1f | %.2f | %s | %.3f %% | %s |\n", row.workload.name.c_str(), name, a,
                b, ratio, row.allowed == 0 ? "-" : std::to_string(static_cast<int>(row.allowed)).c_str(),
                unlike * 100,
                !same_work ? "NOT THE SAME PICTURE"
                : fast     ? "yes"
                           : "TOO SLOW");
    std::fflush(stdout);
    csv << row.workload.name << ',' << name << ',' << width << ',' << height << ',' << frames << ',' << a
        << ',' << b << ',' << ratio << ',' << row.allowed << ',' << unlike << '\n';
    return same_work && fast;
}

}  // namespace
}  // namespace relevo::bench

int main(int argc, char** argv) {
    using namespace relevo::bench;
    if (argc != 2) return std::fprintf(stderr, "usage: against_llvmpipe TABLE.csv\n"), 2;
    std::ofstream csv(argv[1]);
    csv << "scene,mode,width,height,frames,relevo_cpu_ms,peer_cpu_ms,ratio,allowed,pixels_unlike\n";
    const Workload torus_1k = torus_workload("torus_1k", 32, 16),
                   torus_100k = torus_workload("torus_100k", 316, 158),
                   torus_1m = torus_workload("torus_1m", 1000, 500), fill = fill_workload();
    const Row rows[] = {{torus_100k, Mode::Flat, 2},  {torus_100k, Mode::Gouraud, 2},
                        {torus_100k, Mode::Phong, 2}, {torus_100k, Mode::Textured, 2},
                        {fill, Mode::Flat, 4},        {fill, Mode::Gouraud, 0},
                        {fill, Mode::Phong, 5},       {fill, Mode::Textured, 6},
                        {torus_1k, Mode::Phong, 0},   {torus_1m, Mode::Phong, 0}};
    std::printf("Relevo (textbook path, one thread) and %s, %d x %d, median CPU ms of %d frames, in turn\n\n",
                GlPeer::renderer().c_str(), width, height, frames);
    std::printf(
        "| scene | mode | Relevo | peer | ratio | allowed | pixels unlike | within "
        "|\n|---|---|---|---|---|---|---|---|\n");
    bool good = true;
    for (const Row& row : rows) good = measure(row, csv) && good;
    csv.flush();
    if (!csv) return std::fprintf(stderr, "cannot write %s\n", argv[1]), 2;
    return good ? 0 : 1;
}
