// A scene whose names all exist in its dataset: the input of geometry.
#pragma once

#include "scene/scene.hpp"
#include "store/loaded.hpp"

#include <memory>

namespace ciel::scene {

// Immutable and therefore thread-safe. Steps that are appended later are not visible in dataset().
class CheckedScene {
public:
    // Throws Invalid if an array, patch or color map does not exist, or if a layer cannot show an array.
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
