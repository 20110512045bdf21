// Creates contexts with EGL on a device, without a window system (EGL_EXT_platform_device).
#include "ciel/types.hpp"
#include "render/context/egl.hpp"

#include <algorithm>
#include <vector>

namespace server::render {
namespace {

struct Device {
    EGLDeviceEXT handle;
    bool is_software;
    std::string name;
};

std::vector<Device> list_devices(const Egl& egl) {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
    const auto describe =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.GetProcAddress("eglQueryDeviceStringEXT"));
    if (query == nullptr || describe == nullptr || !egl.has_client_extension("EGL_EXT_platform_device"))
        throw ciel::Error(
            "EGL cannot list devices: it lacks EGL_EXT_platform_device, eglQueryDevicesEXT or eglQueryDeviceStringEXT");
    EGLint count = 0;
    std::vector<EGLDeviceEXT> handles(32);
    if (query(static_cast<EGLint>(handles.size()), handles.data(), &count) != EGL_TRUE)
        throw ciel::Error("EGL cannot list devices (" + egl.last_error() + ")");
    std::vector<Device> devices;
    for (EGLint i = 0; i < count; ++i) {
        const auto handle = handles[static_cast<std::size_t>(i)];
        const char* extensions = describe(handle, EGL_EXTENSIONS);
        const bool is_software = has_word(extensions, "EGL_MESA_device_software");
        const char* file =
            has_word(extensions, "EGL_EXT_device_drm") ? describe(handle, EGL_DRM_DEVICE_FILE_EXT) : nullptr;
        std::string name = "device " + std::to_string(i);
        if (is_software) name += " (software)";
        if (file != nullptr) name += " (" + std::string(file) + ")";
        devices.push_back({handle, is_software, std::move(name)});
    }
    // EGL may list the software device before GPUs.
    std::stable_partition(devices.begin(), devices.end(), [](const Device& device) { return !device.is_software; });
    return devices;
}

} // namespace

std::unique_ptr<GlContext> make_egl_device_context() {
    const Egl& egl = Egl::instance();
    std::string failures;
    for (const Device& device : list_devices(egl)) {
        try {
            const EGLDisplay display = egl.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device.handle, nullptr);
            return make_egl_context(egl, display,
                                    device.name + (failures.empty() ? "" : " (tried before: " + failures + ")"));
        } catch (const ciel::Error& error) {
            failures += (failures.empty() ? "" : "; ") + device.name + ": " + error.what();
        }
    }
    throw ciel::Error(failures.empty() ? "EGL lists no devices" : failures);
}

} // namespace server::render
