// What a dataset remembers of its import, so that late steps can be read from the same source in the same way.
#pragma once

#include "import/convert.hpp"
#include "store/format/dataset_info.hpp"

namespace server::importer {

class SourceFacts {
public:
    explicit SourceFacts(store::LateSource source) : source_(std::move(source)) {}
    // Of an import that begins now.
    explicit SourceFacts(const Options& options);

    [[nodiscard]] const store::LateSource& stored() const { return source_; }
    [[nodiscard]] const std::vector<std::string>& inputs() const { return source_.inputs; }
    [[nodiscard]] std::vector<std::string> arrays() const;
    [[nodiscard]] Weld weld() const;
    [[nodiscard]] SourceOptions source_options() const;
    // Throws Error if an input is missing or has changed since the import (importing/freshness.hpp).
    void check_unchanged() const;
    // Returns false also if a path cannot be stored, because it is not UTF-8.
    [[nodiscard]] bool is_unchanged() const;

private:
    store::LateSource source_;
};

} // namespace server::importer
