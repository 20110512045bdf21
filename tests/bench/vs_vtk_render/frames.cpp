// Times from a changed iso-value to a JPEG frame of 1280 x 720.
#include "vs_vtk_render/pictures.hpp"

#include "bench/volume_pictures.hpp"
#include "frames/frame_of.hpp"
#include "geometry/scene_geometry.hpp"
#include "vs_vtk_render/jpeg.hpp"
#include "vs_vtk_render/vtk_window.hpp"
#include "wire/pictures/jpeg_stream.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <vtkActor.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkContourFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSpanSpace.h>

namespace ciel::vs_vtk {
using namespace server;

namespace {

constexpr int width = 1280, height = 720;

enum class End { pixels, jpeg };

// Makes frames in the same way as the server does for a view.
class Own {
public:
    explicit Own(const bench::Case& data) : data_(data) {
        scene_.dataset = data.dataset->info().name;
        scene_.time = data.time;
        scene_.background = scene::Color{0, 0, 0};
        scene::IsoLayer iso;
        iso.array = data.array;
        scene_.layers = {{"bench", 0, true, 1, iso}};
    }

    std::uint64_t draw(double value, End end, render::Renderer& renderer) {
        std::get<scene::IsoLayer>(scene_.layers.front().kind).values = {value};
        const scene::CheckedScene checked(scene_, data_.loaded);
        const auto geometry = geometry_.update(checked, {}, std::numeric_limits<std::size_t>::max(), true);
        const render::Frame frame = frames::frame_of(*geometry, checked, width, height, 1);
        camera_ = frame.camera;
        origin_ = frame.origin;
        const render::Image& image = renderer.draw(frame);
        jpeg_.clear();
        if (end == End::jpeg) stream_.encode(width, height, image.rgb, jpeg_);
        image_ = &image;
        return geometry->triangles;
    }

    [[nodiscard]] const annotations::ViewCamera& camera() const { return camera_; }
    [[nodiscard]] const Vec3d& origin() const { return origin_; }
    [[nodiscard]] double covered_share() const { return bench::covered_share(image_->rgb); }
    [[nodiscard]] std::size_t bytes() const { return jpeg_.size(); }

private:
    const bench::Case& data_;
    scene::Scene scene_;
    geometry::SceneGeometry geometry_{Extraction{}};
    annotations::ViewCamera camera_;
    Vec3d origin_{};
    const render::Image* image_ = nullptr; // last picture; owned by the renderer
    wire::JpegStream stream_;
    std::vector<std::uint8_t> jpeg_;
};

// `filter` has its input and computes normals.
class Theirs {
public:
    template <class Filter>
    Theirs(vtkSmartPointer<Filter> filter, const Own& own)
        : window_(width, height), set_value_([filter](double value) { filter->SetValue(0, value); }),
          surface_([filter] { return filter->GetOutputDataObject(0); }) {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(filter->GetOutputPort());
        mapper->ScalarVisibilityOff();
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->GetProperty()->SetAmbient(0.1); // oblique surfaces must not be black
        window_.renderer()->AddActor(actor);
        camera_ = own.camera();
        origin_ = own.origin();
    }

    std::uint64_t draw(double value, End end) {
        set_value_(value);
        window_.set_camera(camera_, origin_);
        pixels_ = window_.draw();
        if (end == End::jpeg) encode_jpeg(width, height, pixels_, jpeg_);
        return static_cast<std::uint64_t>(vtkPolyData::SafeDownCast(surface_())->GetNumberOfCells());
    }
    [[nodiscard]] double covered_share() const { return covered_share_of_rgba(pixels_); }
    [[nodiscard]] std::size_t bytes() const { return jpeg_.size(); }

private:
    VtkWindow window_;
    std::function<void(double)> set_value_;
    std::function<vtkDataObject*()> surface_;
    annotations::ViewCamera camera_;
    Vec3d origin_{};
    std::span<const std::uint8_t> pixels_;
    std::vector<std::uint8_t> jpeg_;
};

struct Named {
    std::string name;
    std::unique_ptr<Theirs> theirs;
};

std::vector<Named> pipelines(const bench::Case& data, vtkUnstructuredGrid* grid, const Own& own) {
    std::vector<Named> found;
    if (!is_linear(data)) {
        auto filter = vtkSmartPointer<vtkContourFilter>::New();
        filter->SetInputData(grid);
        filter->ComputeNormalsOn();
        found.push_back({"vtkContourFilter + normals", std::make_unique<Theirs>(filter, own)});
        return found;
    }
    for (const bool tree : {false, true}) {
        auto filter = vtkSmartPointer<vtkContour3DLinearGrid>::New();
        filter->SetInputData(grid);
        filter->MergePointsOn();
        filter->ComputeNormalsOn();
        if (tree) {
            filter->SetScalarTree(vtkNew<vtkSpanSpace>());
            filter->UseScalarTreeOn();
        }
        found.push_back({std::string("vtkContour3DLinearGrid, merged + normals") + (tree ? ", span space" : ""),
                         std::make_unique<Theirs>(filter, own)});
    }
    return found;
}

} // namespace

void frames(const bench::Case& data, vtkUnstructuredGrid* grid, engine::FrameWorkers& drawing) {
    const auto [low, high] = std::ranges::minmax(data.values);
    // VTK needs half a second per surface for arbitrary polyhedra.
    const std::vector<double> values = bench::values_between(low, high, is_linear(data) ? 20 : 4);
    Own own(data);
    const auto draw = [&](double value, End end) {
        return drawing.run([&](engine::Worker& worker) { return own.draw(value, end, worker.renderer()); });
    };
    (void)draw(values.front(), End::pixels); // sets the camera
    std::vector<Named> theirs = pipelines(data, grid, own);
    const auto all = [&](auto&& one) {
        std::uint64_t triangles = 0;
        for (const double value : values) triangles += one(value);
        return triangles;
    };
    const auto compare_to = [&](End end, const char* what) {
        const Contender ciel{"CIEL", [&, end] { return all([&](double value) { return draw(value, end); }); }};
        std::vector<Contender> vtk;
        for (Named& named : theirs)
            vtk.push_back({named.name, [&all, &named, end] {
                               return all([&](double value) { return named.theirs->draw(value, end); });
                           }});
        return duel(std::to_string(values.size()) + what, ciel, vtk);
    };
    const Asked asked = is_linear(data) ? Asked{0.6, 0.35} : Asked{1.0 / 15, 1.0 / 40};
    compare(compare_to(End::jpeg, " values, each to a JPEG frame of 1280x720"), asked);
    // CIEL's JPEG encoder codes only changed parts, on all threads; VTK's pictures are coded by libjpeg in one thread.
    // Compare the pixels, too.
    compare_to(End::pixels, " values, each to the pixels of that frame");
    const double middle = values[values.size() / 2];
    (void)draw(middle, End::jpeg);
    (void)theirs.front().theirs->draw(middle, End::jpeg);
    std::printf("    %zu bytes by CIEL, %zu by VTK\n", own.bytes(), theirs.front().theirs->bytes());
    compare_covered(own.covered_share(), theirs.front().theirs->covered_share());
}

} // namespace ciel::vs_vtk
