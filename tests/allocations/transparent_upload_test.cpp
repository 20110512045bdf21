// The buffers for transparent layers are allocated once, for any number of layers. Growing them layer by layer would
// copy the earlier layers each time.
#include "allocations/counted_new.hpp"
#include "render/context/gl_context.hpp"
#include "render/surfaces/transparency.hpp"
#include "render/surfaces/transparent_points.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

constexpr std::size_t layers = 384; // layers of one surface with patches
// Allocations for vertices, triangles, their order, sorting, and the list of sources.
constexpr std::size_t most = 8;

std::vector<Primitives> meshes_of(const std::vector<Vec3f>& positions, const std::vector<Index>& indices) {
    std::vector<Primitives> all(layers);
    for (std::size_t i = 0; i < layers; ++i) {
        all[i].positions = positions;
        all[i].indices = indices;
        all[i].color[3] = 0.5F;
        all[i].identity = all[i].revision = i + 1;
    }
    return all;
}

template <typename Transparent>
std::vector<ScaledPrimitives> parts_of(const std::vector<Primitives>& all) {
    std::vector<ScaledPrimitives> parts;
    for (const Primitives& primitives : all) parts.push_back({&primitives, {}});
    return parts;
}

class TransparentUpload : public testing::Test {
protected:
    TransparentUpload() : chosen(make_context(Backend::automatic)) {
        EXPECT_TRUE(make_current(*chosen.context));
        gl = Gl::load(chosen.context->loader());
        // Mesa allocates with operator new too. Without the upload, only the renderer's allocations are counted.
        gl.BufferData = [](GLenum, GLsizeiptr, const void*, GLenum) {};
    }
    template <typename Load>
    static void expect_few(const Load& load) {
        const std::size_t before = test::allocations();
        load();
        EXPECT_LE(test::allocations() - before, most);
    }

    ChosenContext chosen;
    Gl gl;
    std::vector<Vec3f> positions = std::vector<Vec3f>(300);
    std::vector<Index> indices = std::vector<Index>(3000);
};

TEST_F(TransparentUpload, TrianglesAreCopiedOnce) {
    const std::vector<Primitives> all = meshes_of(positions, indices);
    const auto parts = parts_of<TransparentTriangles>(all);
    TransparentTriangles triangles(gl);
    expect_few([&] { triangles.load(parts, {0, 0, 1, 0}, true); });
}

TEST_F(TransparentUpload, PointsAreCopiedOnce) {
    const std::vector<Primitives> all = meshes_of(positions, indices);
    const auto parts = parts_of<TransparentPoints>(all);
    TransparentPoints points(gl);
    expect_few([&] { points.load(parts, {0, 0, 1, 0}); });
}

} // namespace
} // namespace server::render
