#include "store/late_writer.hpp"

#include "store/cell_places.hpp"
#include "store/files/files.hpp"
#include "store/format/attributes.hpp"
#include "store/format/checksum.hpp"
#include "store/format/value_ranges.hpp"
#include "store/mesh_arrays.hpp"
#include "store/statistics.hpp"

#include <chrono>
#include <random>
#include <thread>
#include <utility>

namespace server::store {
namespace {

namespace fs = std::filesystem;

// Locks `meshes`. Writers that append lock the directory of the dataset itself, so they can work at the same time.
Descriptor lock_late_files(const fs::path& directory, const std::function<void()>& wait) {
    const fs::path arrays = directory / "meshes";
    make_directory(arrays);
    Descriptor lock;
    while (!lock_directory(arrays, lock)) {
        wait();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return lock;
}

void place_extremes(ArrayStep& statistics, const ciel::Topology& topology, const ciel::FaceMeshView& points) {
    std::vector<ciel::Index> cells;
    for (const auto& [lowest, highest] : statistics.extremes) cells.insert(cells.end(), {lowest.cell, highest.cell});
    if (cells.empty()) return;
    const auto places = cell_places(topology, points, cells);
    for (auto& [lowest, highest] : statistics.extremes) {
        lowest.place = places.at(lowest.cell);
        highest.place = places.at(highest.cell);
    }
}

} // namespace

LateWriter::LateWriter(std::shared_ptr<const Dataset> dataset, const fs::path& folder,
                       const std::function<void()>& wait, Where where)
    : dataset_(std::move(dataset)), files_(dataset_->directory(), folder, dataset_->info().id),
      directory_(where == Where::elsewhere ? files_.elsewhere() : files_.writable()),
      lock_(lock_late_files(directory_, wait)) {
    if (directory_ != dataset_->directory()) files_.name_dataset();
}

bool LateWriter::lacks(std::size_t step) const { return !dataset_->late_chunks(step).empty(); }

bool LateWriter::lacks(std::size_t step, const std::string& array) const {
    return dataset_->late_chunks(step).contains(array);
}

fs::path LateWriter::array_directory(std::size_t mesh, const std::string& array) const {
    return layout::values(layout::mesh(directory_, mesh), array);
}

const ciel::Topology& LateWriter::topology(std::size_t mesh) {
    const auto found = topologies_.find(mesh);
    return found != topologies_.end() ? found->second
                                      : topologies_.emplace(mesh, dataset_->topology(mesh)).first->second;
}

void LateWriter::put(std::size_t step, const ArrayValues& array) {
    const auto late = dataset_->late_chunks(step);
    const auto entry = late.find(array.info.name);
    if (entry == late.end()) return;
    const fs::path attributes = dataset_->directory() / layout::attributes_document;
    if (parse_root_attributes(read_text(attributes, layout::document_bytes), attributes).id != dataset_->info().id)
        refuse(dataset_->directory(), "was replaced by another dataset while its steps were read; try again");
    const ArrayInfo& info = *dataset_->find(array.info.name);
    const Step& at = dataset_->steps().at(step);
    const std::uint64_t wanted =
        items_of(dataset_->info().meshes.at(at.mesh), info.association) * static_cast<std::uint64_t>(info.components);
    if (!info.has_shape_of(array.info) || array.values.size() != wanted)
        throw ciel::Error("array '" + info.name + "' has " + std::to_string(array.values.size()) +
                          " values, but the dataset needs " + std::to_string(wanted) + " at each step");
    write(at, info, entry->second, converted(array.values, info.doubles));
}

// Writes the ranges, the facts, and then the chunk. Without the chunk, readers ignore the other two files.
void LateWriter::write(const Step& step, const ArrayInfo& array, std::uint64_t chunk, ciel::ValuesView values) {
    const fs::path directory = array_directory(step.mesh, array.name);
    make_directory(directory);
    const auto bytes = values.bytes();
    const ciel::Topology& of_mesh = topology(step.mesh);
    ArrayStep facts = statistics(values, array);
    place_extremes(facts, of_mesh, dataset_->mesh_arrays().points_to_load(step.mesh, step.coordinates));
    const fs::path ranges = layout::value_ranges(directory, chunk);
    make_directory(ranges.parent_path());
    replace_file(ranges, to_bytes(value_ranges(values, array, of_mesh), dataset_->info().id, checksum_number(bytes)));
    write_facts(directory, chunk, MarkedArray{chunk, checksum(bytes), std::move(facts), false});
    replace_file(layout::chunk(directory, chunk, array.components > 1 ? 3 : 2), bytes);
}

void LateWriter::write_facts(const fs::path& array, std::uint64_t chunk, const std::optional<MarkedArray>& facts) {
    const fs::path file = layout::late_facts(array, chunk);
    make_directory(file.parent_path());
    replace_file(file, bytes_of(late_facts_text(facts)));
}

void LateWriter::end_step(std::size_t step) {
    const Step& at = dataset_->steps().at(step);
    for (const auto& [array, chunk] : dataset_->late_chunks(step))
        write_facts(array_directory(at.mesh, array), chunk, std::nullopt);
    remove_left_beside(directory_); // temporary files of a killed process
    tell_readers();
}

void LateWriter::tell_readers() const {
    std::random_device device;
    replace_file(directory_ / layout::late_changes, bytes_of(std::to_string(device()) + std::to_string(device())));
}

} // namespace server::store
