// Runs every operation that reads mapped files of a dataset: each kind of layer, probe, histogram, export and append.
#pragma once

#include "engine/server.hpp"
#include "geometry/scene_geometry.hpp"

#include <functional>
#include <string>
#include <vector>

namespace ciel::test {
using namespace server;

// An operation that was refused, and the message for the user.
struct Told {
    std::string use, sentence;
};

class EveryUse {
public:
    // The catalog of `server` contains `dataset`; `cells` is the name of one of its arrays on cells.
    EveryUse(engine::Server& server, std::string dataset, std::string cells, Extraction extraction);

    // Opens the dataset and keeps it open.
    void open();
    // Runs every operation once, without reusing earlier results. Returns the operations that threw an Error. Other
    // exceptions propagate.
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
    double last_time_ = 100; // time of the last appended step; later than all others
};

} // namespace ciel::test
