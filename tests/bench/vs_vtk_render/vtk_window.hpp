// An offscreen VTK render window, set up for speed: one sample per pixel, read back as RGBA.
#pragma once

#include "render/renderer.hpp"

#include <span>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace ciel::vs_vtk {
using namespace server;

// Use it on one thread only. Needs an X server, because Debian's VTK supports only GLX.
class VtkWindow {
public:
    VtkWindow(int width, int height);
    VtkWindow(const VtkWindow&) = delete;
    VtkWindow& operator=(const VtkWindow&) = delete;
    ~VtkWindow();

    [[nodiscard]] vtkRenderer* renderer() { return renderer_; }
    // `origin`: origin of the positions of the actors.
    void set_camera(const annotations::ViewCamera& camera, const Vec3d& origin);
    // Rows from the bottom, RGBA. Valid until the next draw.
    std::span<const std::uint8_t> draw();

private:
    int width_, height_;
    vtkSmartPointer<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> renderer_;
    vtkSmartPointer<vtkUnsignedCharArray> pixels_;
};

// Share of pixels that are not black.
[[nodiscard]] double covered_share_of_rgba(std::span<const std::uint8_t> rgba);

} // namespace ciel::vs_vtk
