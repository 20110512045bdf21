#include "store/cache/stored_array.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/zarr_array.hpp"

#include <algorithm>
#include <cmath>

namespace server::store {

namespace fs = std::filesystem;

ArrayLayout read_layout(const fs::path& directory, std::uint64_t items, int components) {
    const auto document = directory / layout::array_document;
    const ZarrArray array = parse_zarr_array(read_text(document, layout::document_bytes), document);
    std::vector<std::uint64_t> of_step{items};
    if (components > 1) of_step.push_back(static_cast<std::uint64_t>(components));
    const auto is_step = [&](const std::vector<std::uint64_t>& extents) {
        return std::equal(extents.begin() + 1, extents.end(), of_step.begin(), of_step.end());
    };
    const bool is_real = array.type == ElementType::f4 || array.type == ElementType::f8;
    if (!is_real || !is_step(array.shape) || !is_step(array.chunks) || array.chunks[0] != 1)
        refuse(document, "must declare one chunk of float32 or float64 for each step, of " + std::to_string(items) +
                             " x " + std::to_string(components) + " values");
    return {directory, array.shape[0], array.shape.size(), array.chunk_bytes(document), array.type == ElementType::f8};
}

std::optional<ValueRanges> read_ranges(const ArrayLayout& array, std::uint64_t chunk, const std::string& sum,
                                       std::size_t scalars, std::size_t blocks, const std::string& dataset_id) {
    const auto file = layout::value_ranges(array.directory, chunk);
    std::error_code error;
    if (sum.empty() || !fs::exists(file, error)) return std::nullopt;
    return parse_value_ranges(bytes_of(read_text(file, layout::ranges_bytes)), dataset_id, scalars, blocks,
                              array.chunk_bytes, checksum_number(sum), file);
}

StretchChecks checks_of_stretches(const ArrayLayout& array, const std::string& sum, std::optional<ValueRanges> ranges) {
    if (ranges && !ranges->stretch_checksums.empty()) return {stretch_bytes, std::move(ranges->stretch_checksums)};
    StretchChecks whole;
    whole.bytes_each = std::max<std::size_t>(array.chunk_bytes, 1);
    if (!sum.empty()) whole.checksums = {checksum_number(sum)};
    return whole;
}

void refuse_infinite(std::span<const std::byte> stretch, bool doubles, const fs::path& file) {
    const auto check = [&]<class T>(const T* begin) {
        if (!std::all_of(begin, begin + stretch.size() / sizeof(T), [](T v) { return std::isfinite(v); }))
            refuse(file, "contains a coordinate that is not finite; restore the file or import the data again");
    };
    if (doubles)
        check(reinterpret_cast<const double*>(stretch.data()));
    else
        check(reinterpret_cast<const float*>(stretch.data()));
}

ValuesToLoad view_of(std::shared_ptr<const CheckedFile> chunk, bool doubles) {
    const MappedFile& file = chunk->file();
    return {doubles ? ciel::ValuesView(file.as<double>()) : ciel::ValuesView(file.as<float>()), std::move(chunk)};
}

Values loaded(ValuesToLoad to_load) {
    if (to_load.file) to_load.file->load_all();
    return {to_load.values, std::move(to_load.file)};
}

} // namespace server::store
