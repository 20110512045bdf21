#include "store/format/step_table.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/file_head.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace server::store {

namespace fs = std::filesystem;

namespace {

enum Flag : std::uint32_t { has_checksum = 1, has_statistics = 2, is_late = 4 };

struct Entry {
    std::uint32_t array, flags; // array: index in TableFacts::arrays
    std::uint64_t chunk, checksum, invalid, missing;
    std::array<double, 2> range;
    std::uint32_t components, extremes; // numbers of component ranges and of extremes that follow
};
static_assert(sizeof(Entry) == 64);

struct Extreme {
    std::uint64_t cell;
    std::array<double, 3> place;
};

constexpr std::size_t most_step_bytes = std::size_t{1} << 26;

fs::path rows_file(const fs::path& dataset) { return dataset / layout::step_table / "rows"; }
fs::path arrays_file(const fs::path& dataset) { return dataset / layout::step_table / "arrays"; }

// Reads values one after another from the bytes of one step.
class Taker {
public:
    Taker(std::span<const std::byte> bytes, const fs::path& file) : bytes_(bytes), file_(file) {}

    template <class T>
    T take() {
        if (bytes_.size() < sizeof(T)) refuse_damage(file_, "lacks the last bytes of a step");
        T value;
        std::memcpy(&value, bytes_.data(), sizeof value);
        bytes_ = bytes_.subspan(sizeof value);
        return value;
    }
    [[nodiscard]] bool is_at_end() const { return bytes_.empty(); }

private:
    std::span<const std::byte> bytes_;
    const fs::path& file_;
};

void check_finite(const fs::path& file, std::span<const double> numbers) {
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
        refuse_damage(file, "has a range or a position that is not finite");
}

CellExtreme taken(Taker& from, const fs::path& file) {
    const auto stored = from.take<Extreme>();
    if (stored.cell >= ciel::none) refuse_damage(file, "has a cell id that is too large for any mesh");
    check_finite(file, stored.place);
    return {static_cast<ciel::Index>(stored.cell), stored.place};
}

MarkedArray array_of(const Entry& entry, Taker& from, const fs::path& file) {
    MarkedArray array;
    array.chunk = entry.chunk;
    if ((entry.flags & has_checksum) != 0) array.checksum = checksum_text(entry.checksum);
    array.late = (entry.flags & is_late) != 0;
    if ((entry.flags & has_statistics) == 0) return array;
    ArrayStep& statistics = array.statistics.emplace();
    statistics.range = entry.range;
    check_finite(file, entry.range);
    statistics.invalid = entry.invalid;
    statistics.missing = entry.missing;
    for (std::uint32_t i = 0; i < entry.components; ++i) {
        statistics.component_ranges.push_back(from.take<std::array<double, 2>>());
        check_finite(file, statistics.component_ranges.back());
    }
    for (std::uint32_t i = 0; i < entry.extremes; ++i) {
        const CellExtreme lowest = taken(from, file);
        statistics.extremes.push_back({lowest, taken(from, file)});
    }
    return array;
}

template <class T>
void put(std::vector<std::byte>& out, const T& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

void put_array(std::vector<std::byte>& out, std::uint32_t number, const MarkedArray& array) {
    Entry entry{number, 0, array.chunk, 0, 0, 0, {}, 0, 0};
    if (!array.checksum.empty()) {
        entry.flags |= has_checksum;
        entry.checksum = checksum_number(array.checksum);
    }
    if (array.late) entry.flags |= is_late;
    if (array.statistics) {
        entry.flags |= has_statistics;
        entry.range = array.statistics->range;
        entry.invalid = array.statistics->invalid;
        entry.missing = array.statistics->missing;
        entry.components = static_cast<std::uint32_t>(array.statistics->component_ranges.size());
        entry.extremes = static_cast<std::uint32_t>(array.statistics->extremes.size());
    }
    put(out, entry);
    if (!array.statistics) return;
    for (const auto& range : array.statistics->component_ranges) put(out, range);
    for (const auto& [lowest, highest] : array.statistics->extremes) {
        put(out, Extreme{lowest.cell, lowest.place});
        put(out, Extreme{highest.cell, highest.place});
    }
}

void check_head(const InputFile& file, FileKind kind, const std::string& dataset_id, std::uint64_t size) {
    if (file.size() < size)
        refuse_damage(file.path(), "has " + std::to_string(file.size()) + " bytes, but the commit marker needs " +
                                       std::to_string(size));
    std::array<std::byte, file_head_bytes> head{};
    file.read(0, head);
    check_file_head(head, kind, dataset_id, file.path());
}

} // namespace

StepTable::StepTable(const fs::path& dataset, const TableFacts& facts, const std::string& dataset_id)
    : arrays_of_(facts.arrays) {
    if (facts.steps == 0) return;
    const InputFile file(rows_file(dataset));
    check_head(file, FileKind::step_rows, dataset_id, file_head_bytes + sizeof(Row) * facts.steps);
    rows_.resize(facts.steps);
    const auto bytes = std::as_writable_bytes(std::span(rows_));
    file.read(file_head_bytes, bytes);
    if (checksum_number(bytes) != checksum_number(facts.checksum))
        refuse_damage(file.path(), "does not match the checksum in the commit marker");
    std::uint64_t begin = file_head_bytes;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!std::isfinite(rows_[i].time) || (i > 0 && !(rows_[i].time > rows_[i - 1].time)))
            refuse_damage(file.path(), "has a step that is not later than the step before it");
        if (rows_[i].mesh >= facts.chunks.size())
            refuse_damage(file.path(), "has a step on a mesh that does not exist");
        if (rows_[i].begin != begin)
            refuse_damage(file.path(), "has a step whose bytes do not follow the bytes of the step before it");
        begin += rows_[i].bytes;
    }
    arrays_ = std::make_unique<InputFile>(arrays_file(dataset));
    check_head(*arrays_, FileKind::step_arrays, dataset_id, begin);
}

StepTable::~StepTable() = default;

MarkedStep StepTable::step(std::size_t step) const {
    const Row& row = rows_.at(step);
    if (row.bytes > most_step_bytes) refuse_damage(arrays_->path(), "has a step that is too long");
    std::vector<std::byte> bytes(row.bytes);
    arrays_->read(row.begin, bytes);
    if (checksum_number(bytes) != row.checksum)
        refuse_damage(arrays_->path(), "does not match the checksum of step " + std::to_string(step));
    MarkedStep out{row.time, row.mesh, row.coordinates, {}};
    Taker from(bytes, arrays_->path());
    for (std::uint32_t i = 0; i < row.arrays; ++i) {
        const auto entry = from.take<Entry>();
        if (entry.array >= arrays_of_.size() || !std::ranges::count(arrays_of_[entry.array].meshes, row.mesh))
            refuse_damage(arrays_->path(), "has an array that the commit marker does not list for the step's mesh");
        if (!out.arrays.emplace(arrays_of_[entry.array].name, array_of(entry, from, arrays_->path())).second)
            refuse_damage(arrays_->path(), "has the same array twice at a step");
    }
    if (!from.is_at_end()) refuse_damage(arrays_->path(), "has a step that is longer than its arrays");
    return out;
}

TableFacts append_to_table(const fs::path& dataset, const TableFacts& facts, const std::string& dataset_id,
                           std::span<const MarkedStep> steps) {
    const StepTable before(dataset, facts, dataset_id);
    std::vector<StepTable::Row> rows = before.rows_;
    TableFacts after = facts;
    std::map<std::string, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < after.arrays.size(); ++i) numbers.emplace(after.arrays[i].name, i);
    std::vector<std::byte> arrays;
    const std::uint64_t begin = rows.empty() ? file_head_bytes : rows.back().begin + rows.back().bytes;
    for (const MarkedStep& step : steps) {
        const std::size_t first = arrays.size();
        if (after.chunks.size() <= step.mesh) after.chunks.resize(step.mesh + 1);
        for (const auto& [name, array] : step.arrays) {
            const auto [number, is_new] = numbers.emplace(name, static_cast<std::uint32_t>(after.arrays.size()));
            if (is_new) after.arrays.push_back({name, {}});
            auto& meshes = after.arrays[number->second].meshes;
            if (!std::ranges::count(meshes, step.mesh)) meshes.push_back(step.mesh);
            put_array(arrays, number->second, array);
            after.chunks[step.mesh] = std::max(after.chunks[step.mesh], array.chunk + 1);
        }
        const auto bytes = std::span(arrays).subspan(first);
        if (bytes.size() > most_step_bytes)
            refuse(arrays_file(dataset),
                   "cannot hold a step of " + std::to_string(step.arrays.size()) +
                       " arrays, because their entries need more than 64 MiB; write fewer arrays at a step");
        rows.push_back({step.time, static_cast<std::uint32_t>(step.mesh), static_cast<std::uint32_t>(step.coordinates),
                        begin + first, static_cast<std::uint32_t>(bytes.size()),
                        static_cast<std::uint32_t>(step.arrays.size()), checksum_number(bytes)});
    }
    make_directory(dataset / layout::step_table);
    if (before.size() == 0) {
        write_file(arrays_file(dataset), file_head(FileKind::step_arrays, dataset_id));
        write_file(rows_file(dataset), file_head(FileKind::step_rows, dataset_id));
        sync_directory(dataset / layout::step_table);
        sync_directory(dataset);
    }
    append_after(arrays_file(dataset), begin, arrays);
    append_after(rows_file(dataset), file_head_bytes + before.size() * sizeof(StepTable::Row),
                 std::as_bytes(std::span(rows).subspan(before.size())));
    after.steps = rows.size();
    after.checksum = checksum(std::as_bytes(std::span(rows)));
    return after;
}

} // namespace server::store
