// A scene whose names are all there: what geometry is made of.
#pragma once

#include "scene/scene.hpp"
#include "store/loaded.hpp"

#include <memory>

namespace ciel::scene {

// A scene with its dataset as it stood when the scene was checked. Immutable, may be read from any thread. Steps that
// are appended later are seen by a scene that is checked later.
class CheckedScene {
public:
    // loaded: of scene.dataset; the caller opened it. Throws Invalid when the scene names an array, patch or color map
    // that is not there, or an array whose association its layer cannot show.
    CheckedScene(Scene scene, std::shared_ptr<store::LoadedDataset> loaded);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::shared_ptr<store::LoadedDataset>& loaded() const { return loaded_; }
    [[nodiscard]] const std::shared_ptr<store::Dataset>& dataset() const { return dataset_; }

private:
    Scene scene_;
    std::shared_ptr<store::LoadedDataset> loaded_;
    std::shared_ptr<store::Dataset> dataset_;
};

} // namespace ciel::scene
