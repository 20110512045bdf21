#include "vs_vtk_render/vtk_window.hpp"
#include "annotations/camera.hpp"

#include <vtkCamera.h>

namespace ciel::vs_vtk {
using namespace server;

VtkWindow::VtkWindow(int width, int height)
    : width_(width), height_(height), window_(vtkSmartPointer<vtkRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()), pixels_(vtkSmartPointer<vtkUnsignedCharArray>::New()) {
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SwapBuffersOff();
    window_->SetSize(width, height);
    window_->AddRenderer(renderer_);
    renderer_->SetBackground(0, 0, 0);
}

VtkWindow::~VtkWindow() = default;

void VtkWindow::set_camera(const annotations::ViewCamera& camera, const Vec3d& origin) {
    vtkCamera* to = renderer_->GetActiveCamera();
    const auto offset = [&](const Vec3d& at) { return Vec3d{at[0] - origin[0], at[1] - origin[1], at[2] - origin[2]}; };
    to->SetPosition(offset(camera.position).data());
    to->SetFocalPoint(offset(camera.target).data());
    to->SetViewUp(camera.up.data());
    to->SetViewAngle(camera.fov_degrees);
    renderer_->ResetCameraClippingRange();
}

std::span<const std::uint8_t> VtkWindow::draw() {
    window_->Render();
    window_->GetRGBACharPixelData(0, 0, width_ - 1, height_ - 1, 0, pixels_);
    return {pixels_->GetPointer(0), static_cast<std::size_t>(pixels_->GetNumberOfValues())};
}

double covered_share_of_rgba(std::span<const std::uint8_t> rgba) {
    std::size_t covered = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) covered += rgba[i] + rgba[i + 1] + rgba[i + 2] > 0 ? 1 : 0;
    return 4.0 * static_cast<double>(covered) / static_cast<double>(rgba.size());
}

} // namespace ciel::vs_vtk
