// Everything that reads the mapped files of a dataset: each kind of layer, probe, histogram, export and append.
#pragma once

#include "engine/server.hpp"
#include "geometry/scene_geometry.hpp"

#include <functional>
#include <string>
#include <vector>

namespace ciel::test {

// What went wrong, as it is told to a user.
struct Told {
    std::string use, sentence;
};

class EveryUse {
public:
    // The catalog of `server` has one dataset; `cells` is its cell array.
    EveryUse(engine::Server& server, std::string dataset, std::string cells, Extraction extraction);

    // Opens the dataset and keeps it open.
    void open();
    // Does everything once, from the mapped files on: nothing that was made before is used again. Returns what was
    // refused. Throws what is no Error, for that is nothing to tell a user.
    [[nodiscard]] std::vector<Told> run();
    [[nodiscard]] std::shared_ptr<store::Dataset> dataset() const { return dataset_; }

private:
    void attempt(const std::string& use, const std::function<void()>& body);
    void show_layers();
    void ask_methods();
    void append_a_step();

    engine::Server& server_;
    std::string name_, cells_;
    Extraction extraction_;
    std::shared_ptr<store::Dataset> dataset_;
    std::vector<Told> told_;
    double last_time_ = 100; // of the steps that were appended: later than any other
};

} // namespace ciel::test
