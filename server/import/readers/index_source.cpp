// PVD and .series: a time step has one or several data files. Each data file is read by the reader of its own format.
#include "ciel/types.hpp"
#include "import/parsers/index_entry.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/open_source.hpp"
#include "import/readers/piece_reading.hpp"

#include <fstream>
#include <iterator>

namespace server::importer {

namespace {

constexpr std::uintmax_t max_index_bytes = 256U << 20;

class IndexSource : public Source {
public:
    IndexSource(std::string file, std::string format, std::vector<IndexEntry> entries, SourceOptions options)
        : file_(std::move(file)), format_(std::move(format)), options_(std::move(options)) {
        const auto directory = std::filesystem::path(file_).parent_path();
        for (IndexEntry& entry : entries) {
            entry.file = (directory / entry.file).string(); // operator/ drops the directory if entry.file is absolute
            if (times_.empty() || times_.back() != entry.time) {
                times_.push_back(entry.time);
                steps_.emplace_back();
            }
            steps_.back().push_back(std::move(entry));
        }
    }

    [[nodiscard]] std::string format() const override { return format_; }
    [[nodiscard]] const std::vector<double>& times() const override { return times_; }

    [[nodiscard]] std::optional<std::vector<ArrayName>> listed_arrays(std::size_t step) const override {
        std::vector<ArrayName> all;
        for (const IndexEntry& entry : steps_[step]) {
            const auto listed = opened(entry.file)->listed_arrays(0);
            if (!listed) return std::nullopt;
            all.insert(all.end(), listed->begin(), listed->end());
        }
        return all;
    }

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        const std::vector<IndexEntry>& entries = steps_[step];
        lost_.clear();
        if (entries.size() == 1) return read_entry(entries.front(), progress);
        return read_pieces(
            entries.size(),
            [&](std::size_t i, const ReadProgress& of_entry) { return read_entry(entries[i], of_entry); },
            [&](std::size_t i) { return entries[i].piece.empty() ? "part " + std::to_string(i) : entries[i].piece; },
            lost_, progress);
    }

    [[nodiscard]] std::vector<std::string> lost() const override { return lost_; }
    [[nodiscard]] std::string file_of(const ArrayName&, std::size_t step) const override {
        return std::filesystem::path(steps_[step].front().file).filename().string();
    }

    [[nodiscard]] std::vector<std::filesystem::path> files_of(std::size_t step,
                                                              const std::set<std::string>&) const override {
        std::vector<std::filesystem::path> all;
        for (const IndexEntry& entry : steps_[step]) {
            const auto open = find_format(entry.file).open;
            if (open != open_vtk_xml && open != open_legacy_vtk) return {};
            const auto files =
                open == open_vtk_xml ? files_of_vtk_xml(entry.file) : std::vector{std::filesystem::path(entry.file)};
            all.insert(all.end(), files.begin(), files.end());
        }
        return all;
    }

private:
    // A data file is opened only when its step is read, so that a damaged file affects only this step.
    std::unique_ptr<Source> opened(const std::string& file) const {
        if (!std::filesystem::exists(file))
            throw ciel::Error(file_ + ": names " + file + ", which does not exist; correct the path or copy the file");
        if (find_format(file).open == open_index)
            throw ciel::Error(file_ + ": names " + file +
                              ", which is itself an index file; name the data files directly");
        return open_source({file}, options_);
    }

    vtkSmartPointer<vtkDataObject> read_entry(const IndexEntry& entry, const ReadProgress& progress) {
        const auto source = opened(entry.file);
        auto data = source->read(0, progress);
        for (const std::string& sentence : source->lost()) lost_.push_back(sentence);
        return data;
    }

    std::string file_;
    std::string format_;
    std::vector<std::string> lost_;
    SourceOptions options_;
    std::vector<double> times_;
    std::vector<std::vector<IndexEntry>> steps_;
};

} // namespace

std::unique_ptr<Source> open_index(const Inputs& inputs, const SourceOptions& options) {
    const std::string& file = inputs.front();
    if (std::filesystem::file_size(file) > max_index_bytes)
        throw ciel::Error(file + ": is larger than 256 MiB, the limit for an index file");
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (std::filesystem::path(file).extension() == ".series")
        return std::make_unique<IndexSource>(file, "file series", parse_series(text, file), options);
    return std::make_unique<IndexSource>(file, "PVD collection", parse_pvd(text, file), options);
}

} // namespace server::importer
