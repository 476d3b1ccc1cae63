// The thesis's tables 6.1 and 6.2 from our own runs (Clua 2004, 6.5): pictures a second of the inverse
// mapping by the number of slices, of one relief texture and of the six of a box, with what the slices cost
// in accuracy, which the thesis does not give. Markdown, then the same as CSV.
//
//   slices_table [--rounds N]     processor time of one thread, the best of N (5) rounds
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>

#include "relief/box.hpp"
#include "tests/relief/slice_workload.hpp"

namespace relevo {
namespace {

double thread_seconds() {
    std::timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Row {
    relief::SliceSettings settings;
    double depth_error, looks_a_ray;
    double pictures_of_one, pictures_of_six;  // a second
};

double seconds(const std::vector<tests::SliceWork>& works, const relief::SliceSettings& settings,
               int rounds) {
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        const double start = thread_seconds();
        for (const tests::SliceWork& work : works)
            for (const relief::ReliefRay& ray : work.rays)
                if (find_by_slices(work.solid, ray, settings)) asm volatile("" : : : "memory");
        best = std::min(best, thread_seconds() - start);
    }
    return best;
}

void print(const char* object, const std::vector<Row>& rows) {
    std::printf(
        "\n| %s | depth error | look-ups a ray | pictures/s, 1 texture | 6 textures | error x N | time x 1/N "
        "|\n",
        object);
    std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
    for (const Row& row : rows) {
        char name[32];
        std::snprintf(name, sizeof name, row.settings.bisections ? "%d + %d" : "%d", row.settings.slices,
                      row.settings.bisections);
        const bool plain = row.settings.bisections == 0;
        std::printf("| %s | %.5f | %.1f | %.1f | %.1f | ", name, row.depth_error, row.looks_a_ray,
                    row.pictures_of_one, row.pictures_of_six);
        if (plain)
            std::printf("%.3f | %.1f us |\n", row.depth_error * row.settings.slices,
                        1e6 / row.pictures_of_one / row.settings.slices);
        else
            std::printf("| |\n");
    }
}

}  // namespace
}  // namespace relevo

int main(int argc, char** argv) {
    using namespace relevo;
    const int rounds = argc == 3 && std::strcmp(argv[1], "--rounds") == 0 ? std::atoi(argv[2]) : 5;
    constexpr relief::SliceSettings all[] = {{8, 0}, {16, 0}, {32, 0}, {64, 0}, {128, 0}, {256, 0}, {32, 8}};
    const relief::Spheres* const objects[] = {&scene::sphere_object, &scene::bumpy_object,
                                              &scene::complex_object};
    std::string csv =
        "object,slices,bisections,depth_error,look_ups_a_ray,pictures_a_second_1,pictures_a_second_6\n";
    const std::vector<tests::SliceWork> works = tests::slice_works();
    for (std::size_t i = 0; i < works.size(); ++i) {
        // a box's faces in front of the viewer, each searched on its own
        std::vector<tests::SliceWork> faces;
        const relief::Box box{glm::dvec3(-1.001), glm::dvec3(1.001)};
        for (const relief::Face face : relief::all_faces)
            if (relief::box_region(box, works[i].viewer.eye).shows(face))
                faces.push_back(tests::slice_work(works[i].name,
                                                  ray_cast(*objects[i], *relief::face_camera(box, face, 256)),
                                                  works[i].viewer));
        std::vector<Row> rows;
        for (const relief::SliceSettings& settings : all) {
            const std::vector<tests::SliceWork> one = {works[i]};
            const double looks = double(look_ups(works[i], settings)) / double(works[i].rays.size());
            rows.push_back({settings, slice_error(works[i], settings), looks,
                            1 / seconds(one, settings, rounds), 1 / seconds(faces, settings, rounds)});
            char line[200];
            std::snprintf(line, sizeof line, "%s,%d,%d,%g,%g,%g,%g\n", works[i].name, settings.slices,
                          settings.bisections, rows.back().depth_error, looks, rows.back().pictures_of_one,
                          rows.back().pictures_of_six);
            csv += line;
        }
        print(works[i].name, rows);
    }
    std::printf("\n%s", csv.c_str());
    return 0;
}
