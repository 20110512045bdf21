#include "ciel/types.hpp"
#include "import/parsers/index_entry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>

namespace server::importer {

namespace {

double parse_time(const pugi::xml_node& node, const std::string& name) {
    const std::string text = node.attribute("timestep").as_string("0");
    char* end = nullptr;
    const double time = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(time))
        throw ciel::Error(name + ": the timestep \"" + text + "\" is not a finite number");
    return time;
}

} // namespace

std::vector<IndexEntry> parse_pvd(std::string_view text, const std::string& name) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed)
        throw ciel::Error(name + ": is not well-formed XML: " + parsed.description() + " at byte " +
                          std::to_string(parsed.offset));
    const pugi::xml_node file = document.child("VTKFile");
    if (!file || std::string_view(file.attribute("type").value()) != "Collection")
        throw ciel::Error(name + ": is not a PVD file: it has no <VTKFile type=\"Collection\">");

    std::vector<IndexEntry> entries;
    for (const pugi::xml_node& node : file.child("Collection").children("DataSet")) {
        IndexEntry entry{parse_time(node, name), node.attribute("name").value(), node.attribute("file").value()};
        if (entry.piece.empty()) entry.piece = node.attribute("part").value();
        if (entry.file.empty()) throw ciel::Error(name + ": a DataSet element names no file; add the attribute file");
        entries.push_back(std::move(entry));
    }
    if (entries.empty()) throw ciel::Error(name + ": names no files; list at least one data file");
    std::stable_sort(entries.begin(), entries.end(),
                     [](const IndexEntry& a, const IndexEntry& b) { return a.time < b.time; });
    return entries;
}

} // namespace server::importer
