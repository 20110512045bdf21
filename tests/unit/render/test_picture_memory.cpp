// The estimate of a picture's memory is not below what llvmpipe keeps of that picture.
#include "scenes.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

namespace server::render {
using namespace ciel;
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool own_heap = true; // a sanitizer replaces malloc and counts nothing
#else
constexpr bool own_heap = false;
#endif

std::uint64_t used_by_malloc() {
    const struct mallinfo2 now = ::mallinfo2();
    return now.uordblks + now.hblkhd;
}

class PictureMemory : public testing::TestWithParam<int> {}; // number of spheres

TEST_P(PictureMemory, IsNoLessThanWhatTheSoftwareGlKeeps) {
    if (own_heap) GTEST_SKIP() << "the sanitizer's malloc counts nothing";
    Renderer renderer(Backend::automatic);
    if (renderer.gl_renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << "not drawn by llvmpipe";
    const Shape dot = sphere(0.5, {}, 8);
    Frame frame = front_view(320, 200);
    frame.check_wanted = [] {};
    frame.primitives = {dot.primitives()};
    (void)renderer.draw(frame);
    const std::uint64_t before = used_by_malloc();
    std::vector<Shape> spheres;
    for (int i = 0; i < GetParam(); ++i) spheres.push_back(sphere(0.5 + 0.02 * i, {}, 400));
    const std::uint64_t of_spheres = used_by_malloc() - before;
    frame.primitives.clear();
    for (const Shape& each : spheres) {
        frame.primitives.push_back(each.primitives());
        frame.primitives.back().identity = frame.primitives.size();
    }
    (void)renderer.draw(frame);
    const std::uint64_t kept = used_by_malloc() - before - of_spheres;
    EXPECT_LE(kept, renderer.kept_memory());
}

INSTANTIATE_TEST_SUITE_P(Spheres, PictureMemory, testing::Values(1, 2, 4, 6, 8, 12, 20));

} // namespace
} // namespace server::render
