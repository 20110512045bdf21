// Compares 100 box-aligned slices at 1024 x 1024, read back, with VTK's projected tetrahedra of the same mesh.
#include "vs_vtk_render/pictures.hpp"

#include "bench/volume_pictures.hpp"
#include "color/color_scale.hpp"
#include "vs_vtk_render/vtk_window.hpp"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vtkColorTransferFunction.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkNew.h>
#include <vtkOpenGLProjectedTetrahedraMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

namespace ciel::vs_vtk {
using namespace server;

namespace {

constexpr double turn_degrees = 3;
constexpr Asked asked{0.8, 0.5};

vtkSmartPointer<vtkUnstructuredGrid> tetrahedra_of(vtkUnstructuredGrid* grid) {
    vtkNew<vtkDataSetTriangleFilter> filter;
    filter->SetInputData(grid);
    filter->TetrahedraOnlyOn();
    filter->Update();
    return filter->GetOutput();
}

// VTK's mapper takes the scalar opacity for extinction per length and ignores the unit distance.
vtkSmartPointer<vtkVolumeProperty> look_of(const render::Volume& volume) {
    constexpr std::size_t entries = 257;
    const auto colors = color::color_row(volume.scale, entries);
    const auto [low, high] = volume.scale.range;
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> extinction;
    for (std::size_t i = 0; i < entries; ++i) {
        const double share = static_cast<double>(i) / (entries - 1), at = low + (high - low) * share;
        color->AddRGBPoint(at, colors[i][0] / 255.0, colors[i][1] / 255.0, colors[i][2] / 255.0);
        const auto [from, to] = std::pair(volume.opacity_points.front(), volume.opacity_points.back());
        const double opacity = from[1] + (to[1] - from[1]) * share;
        extinction->AddPoint(at, -std::log(1 - opacity) / volume.unit_length);
    }
    auto look = vtkSmartPointer<vtkVolumeProperty>::New();
    look->SetColor(color);
    look->SetScalarOpacity(extinction);
    look->SetScalarOpacityUnitDistance(1);
    look->SetInterpolationTypeToLinear();
    look->ShadeOff(); // the mapper does not support shading
    return look;
}

glm::dvec3 at(const color::SlabTriangles& mesh, std::size_t corner) {
    const Vec3f& p = mesh.vertices[mesh.triangles[corner]].position;
    return {p[0], p[1], p[2]};
}

// Checks that the slices fill the whole mesh, as the count of samples assumes. Compares their volume with the volume
// inside the boundary. Throws Error if they differ.
void check_samples(const bench::VolumePictures& pictures) {
    const render::Volume& volume = pictures.volume();
    const glm::dvec3 normal(volume.normal[0], volume.normal[1], volume.normal[2]);
    double sliced = 0, whole = 0;
    for (const color::SlabTriangles& slice : volume.slices)
        for (std::size_t i = 0; i < slice.triangles.size(); i += 3) {
            const glm::dvec3 a = at(slice, i), twice = glm::cross(at(slice, i + 1) - a, at(slice, i + 2) - a);
            sliced += volume.thickness * std::abs(glm::dot(twice, normal)) / 2;
        }
    const color::SlabTriangles& boundary = *volume.boundary;
    for (std::size_t i = 0; i < boundary.triangles.size(); i += 3)
        whole += glm::dot(at(boundary, i), glm::cross(at(boundary, i + 1), at(boundary, i + 2))) / 6;
    std::printf("    %.1f million samples by CIEL, of slices that fill %.2f %% of the mesh\n", pictures.samples() / 1e6,
                100 * sliced / std::abs(whole));
    if (std::abs(sliced / std::abs(whole) - 1) > 0.01)
        throw Error("the slices are not the whole mesh, or more; their time cannot be compared");
}

class Projected {
public:
    Projected(vtkUnstructuredGrid* tetrahedra, const render::Volume& volume, bool floats)
        : window_(bench::VolumePictures::side, bench::VolumePictures::side) {
        vtkNew<vtkOpenGLProjectedTetrahedraMapper> mapper;
        mapper->SetInputData(tetrahedra);
        mapper->SetUseFloatingPointFrameBuffer(floats);
        vtkNew<vtkVolume> drawn;
        drawn->SetMapper(mapper);
        drawn->SetProperty(look_of(volume));
        window_.renderer()->AddVolume(drawn);
    }
    void draw(const render::Frame& frame) {
        window_.set_camera(frame.camera, frame.origin);
        pixels_ = window_.draw();
    }
    [[nodiscard]] double covered_share() const { return covered_share_of_rgba(pixels_); }

private:
    VtkWindow window_;
    std::span<const std::uint8_t> pixels_;
};

} // namespace

void volumes(const bench::Case& data, vtkUnstructuredGrid* grid, engine::FrameWorkers& drawing) {
    const auto tetrahedra = tetrahedra_of(grid);
    const auto cells = static_cast<std::uint64_t>(tetrahedra->GetNumberOfCells());
    std::unique_ptr<bench::VolumePictures> pictures;
    const auto draw_there = [&](auto&& work) { return drawing.run([&](engine::Worker&) { return work(); }); };
    draw_there([&] {
        pictures = std::make_unique<bench::VolumePictures>(data);
        return pictures->cut({0, 1, 0});
    });
    {
        Projected floats(tetrahedra, pictures->volume(), true), bytes(tetrahedra, pictures->volume(), false);
        const auto projected = [&](const char* name, Projected& by) {
            return Contender{name, [&] {
                                 by.draw(pictures->frame());
                                 return cells;
                             }};
        };
        const auto duel_of = [&](bool shaded, bool anew) {
            pictures->turn_back();
            const std::string what = std::string("100 box-aligned slices, ") + (shaded ? "shaded" : "unshaded") +
                                     (anew ? ", cut anew" : ", the camera turned") + ", to pixels";
            const auto draw = [&, shaded, anew] {
                if (anew) (void)pictures->cut({0, 1, 0});
                return pictures->draw(shaded);
            };
            const Contender ciel{"CIEL, float target, pre-integrated", [&] { return draw_there(draw); },
                                 [&] { pictures->turn(turn_degrees); }};
            compare(duel(what, ciel,
                         {projected("vtkProjectedTetrahedraMapper, floats", floats),
                          projected("vtkProjectedTetrahedraMapper, bytes", bytes)}),
                    asked);
            check_samples(*pictures);
            compare_covered(pictures->covered_share(), floats.covered_share());
        };
        const auto duel_in_bytes = [&] {
            pictures->turn_back();
            pictures->add_up_in_bytes(true);
            const Contender ciel{"CIEL, bytes, pre-integrated",
                                 [&] { return draw_there([&] { return pictures->draw(false); }); },
                                 [&] { pictures->turn(turn_degrees); }};
            compare(duel("100 box-aligned slices, unshaded, in bytes on both sides, the camera turned, to pixels", ciel,
                         {projected("vtkProjectedTetrahedraMapper, bytes", bytes)}),
                    asked);
            compare_covered(pictures->covered_share(), bytes.covered_share());
            pictures->add_up_in_bytes(false);
        };
        for (const bool shaded : {true, false}) duel_of(shaded, false);
        duel_of(true, true);
        duel_in_bytes();
    }
    draw_there([&] {
        pictures.reset(); // destroys the OpenGL objects on the thread that owns their context
        return 0;
    });
}

} // namespace ciel::vs_vtk
