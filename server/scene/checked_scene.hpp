// A scene whose names all exist in its dataset: the input of geometry.
#pragma once

#include "scene/scene.hpp"
#include "store/loaded.hpp"

#include <memory>

namespace ciel::scene {

// A scene with its dataset at the time of the check. Immutable and therefore thread-safe. Steps that are appended later
// are not visible in dataset().
class CheckedScene {
public:
    // `loaded`: the dataset that the scene names, opened by the caller. Throws Invalid if the scene names an array,
    // patch or color map that does not exist, or an array with an association that its layer cannot show.
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
