#include "store/format/documents.hpp"

#include "store/files/files.hpp"
#include "store/format/attributes.hpp"
#include "store/format/layout.hpp"
#include "store/format/zarr_array.hpp"

namespace server::store {

namespace fs = std::filesystem;

namespace {

void check_is_dataset(const fs::path& directory) {
    std::error_code error;
    const auto status = fs::status(directory, error);
    if (!fs::exists(status)) refuse(directory, "does not exist; check the path");
    if (!fs::is_directory(status))
        refuse(directory, "is a file, not a dataset directory; make a dataset from the file with 'ciel import'");
    if (!fs::exists(directory / layout::group_document, error))
        refuse(directory, "is not a CIEL dataset: the directory has no .zgroup; make a dataset with 'ciel import'");
}

} // namespace

Documents read_documents(const fs::path& directory) {
    check_is_dataset(directory);
    const auto group = directory / layout::group_document, attributes = directory / layout::attributes_document,
               marker = directory / layout::commit_marker;
    check_group_text(read_text(group, layout::document_bytes), group);
    std::error_code error;
    if (!fs::exists(attributes, error))
        refuse(directory, "is a Zarr group, but not a CIEL dataset: the group has no .zattrs; make a dataset with "
                          "'ciel import'");
    Documents documents;
    documents.info = parse_root_attributes(read_text(attributes, layout::document_bytes), attributes);
    documents.marker = parse_marker(read_text(marker, layout::marker_bytes), marker);
    auto path = fs::absolute(directory).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    documents.info.name = path.extension() == ".ciel" ? path.stem().string() : path.filename().string();
    return documents;
}

} // namespace server::store
