// A scene whose names all exist in its dataset: the input of geometry.
#pragma once

#include "scene/scene.hpp"
#include "store/loaded.hpp"

#include <memory>

namespace server::scene {

// Immutable and therefore thread-safe. Steps that are appended later are not visible in dataset().
class CheckedScene {
public:
    // Throws Invalid if an array, patch or color map does not exist, or if a layer cannot show an array.
    CheckedScene(Scene scene, std::shared_ptr<store::LoadedDataset> loaded);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::shared_ptr<store::LoadedDataset>& loaded() const { return loaded_; }
    [[nodiscard]] const std::shared_ptr<store::Dataset>& dataset() const { return dataset_; }
    // Returns a copy with another camera. The copy is not checked again, because a camera names nothing in the dataset.
    // REQUIRES: `camera` follows the rules of a scene (rules.hpp).
    [[nodiscard]] CheckedScene with_camera(const Camera& camera) const;

private:
    Scene scene_;
    std::shared_ptr<store::LoadedDataset> loaded_;
    std::shared_ptr<store::Dataset> dataset_;
};

} // namespace server::scene
