// VTK's render window off screen, set up for speed: one sample a pixel, nothing shown, read as RGBA.
#pragma once

#include "render/renderer.hpp"

#include <span>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace ciel::vs_vtk {

// To be used on one thread. Needs an X server, for Debian's VTK draws through GLX only.
class VtkWindow {
public:
    VtkWindow(int width, int height);
    VtkWindow(const VtkWindow&) = delete;
    VtkWindow& operator=(const VtkWindow&) = delete;
    ~VtkWindow();

    [[nodiscard]] vtkRenderer* renderer() { return renderer_; }
    // origin: of what is in the renderer.
    void set_camera(const annotations::Camera& camera, const Vec3d& origin);
    // Rows from the bottom, RGBA; until the next draw.
    std::span<const std::uint8_t> draw();

private:
    int width_, height_;
    vtkSmartPointer<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> renderer_;
    vtkSmartPointer<vtkUnsignedCharArray> pixels_;
};

// Of a picture on black: the share of the pixels that are not.
[[nodiscard]] double covered_share_of_rgba(std::span<const std::uint8_t> rgba);

} // namespace ciel::vs_vtk
