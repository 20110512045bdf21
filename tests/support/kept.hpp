// Arrays that a test itself keeps alive, for objects that refuse arrays without an owner.
#pragma once

#include "ciel/face_mesh.hpp"

#include <memory>

namespace ciel::test {

inline const std::shared_ptr<const void> kept_by_test = std::make_shared<const char>();

[[nodiscard]] inline FaceMeshView kept(FaceMeshView view) {
    view.keep_alive = kept_by_test;
    return view;
}

} // namespace ciel::test
