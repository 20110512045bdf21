#include "blocks/record.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little, "records are little-endian");

namespace ciel::detail {

namespace {

constexpr std::uint16_t version = 1;
constexpr std::size_t word = sizeof(std::uint64_t), header_bytes = 16, entry_bytes = 16;

struct Header {
    std::uint32_t kind;
    std::uint16_t version, sections;
    std::uint64_t bytes;
};
static_assert(sizeof(Header) == header_bytes);

std::size_t words_of(std::size_t bytes) { return (bytes + word - 1) / word; }

[[noreturn]] void refuse(const std::string& what) {
    fail("a record of a block is damaged: " + what + "; import the dataset again");
}

} // namespace

void refuse_changed(const char* what) {
    fail(std::string("a record of a block changed while it was used: ") + what + "; import the dataset again");
}

RecordBytes RecordWriter::finish(RecordKind kind) const {
    std::size_t words = (header_bytes + entry_bytes * sections_.size()) / word;
    for (const Section& section : sections_) words += words_of(section.bytes.size());
    RecordBytes out(words, 0);
    auto* bytes = reinterpret_cast<std::byte*>(out.data());
    const Header header{static_cast<std::uint32_t>(kind), version, static_cast<std::uint16_t>(sections_.size()),
                        words * word};
    std::memcpy(bytes, &header, sizeof header);
    std::byte* entry = bytes + header_bytes;
    std::size_t at = (header_bytes + entry_bytes * sections_.size()) / word;
    for (const Section& section : sections_) {
        const std::uint16_t id_flags[2] = {section.id, section.flags};
        const std::uint32_t sizes[3] = {section.element,
                                        static_cast<std::uint32_t>(section.bytes.size() / section.element),
                                        static_cast<std::uint32_t>(at)};
        std::memcpy(entry, id_flags, sizeof id_flags);
        std::memcpy(entry + sizeof id_flags, sizes, sizeof sizes);
        std::memcpy(bytes + at * word, section.bytes.data(), section.bytes.size());
        entry += entry_bytes;
        at += words_of(section.bytes.size());
    }
    return out;
}

RecordView::RecordView(std::span<const std::byte> bytes, RecordKind kind) : bytes_(bytes) {
    static_assert(sizeof(Entry) == entry_bytes);
    Header header{};
    if (bytes.size() < header_bytes) refuse("it has " + std::to_string(bytes.size()) + " bytes, less than a header");
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.kind != static_cast<std::uint32_t>(kind)) refuse("it is of another kind");
    if (header.version > version)
        fail("a record of a block has the version " + std::to_string(header.version) +
             "; this program reads version 1. Update CIEL");
    const std::size_t table = header_bytes + entry_bytes * std::size_t{header.sections};
    if (header.bytes != bytes.size() || table > bytes.size()) refuse("its length does not match its header");
    entries_.resize(header.sections);
    known_.resize(header.sections);
    if (!entries_.empty()) std::memcpy(entries_.data(), bytes.data() + header_bytes, entry_bytes * entries_.size());
    for (const Entry& entry : entries_) {
        const std::uint64_t begin = std::uint64_t{entry.offset} * word;
        const std::uint64_t size = std::uint64_t{entry.element} * entry.count;
        if (entry.element == 0 || begin < table || begin > bytes.size() || size > bytes.size() - begin)
            refuse("section " + std::to_string(entry.id) + " goes beyond the end of the record");
        if (std::ranges::count(entries_, entry.id, &Entry::id) > 1)
            refuse("section " + std::to_string(entry.id) + " is given twice");
    }
}

void RecordView::check_all_known() const {
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (!known_[i] && (entries_[i].flags & RecordWriter::critical) != 0)
            fail("a record of a block has the section " + std::to_string(entries_[i].id) +
                 ", which this program does not know. Update CIEL");
}

std::size_t RecordView::element_size(std::uint16_t id) const {
    const auto found = std::ranges::find(entries_, id, &Entry::id);
    return found == entries_.end() ? 0 : found->element;
}

std::span<const std::byte> RecordView::find(std::uint16_t id, std::size_t element) const {
    const auto found = std::ranges::find(entries_, id, &Entry::id);
    if (found == entries_.end()) return bytes_.last(0);
    if (found->element != element)
        refuse("an element of section " + std::to_string(id) + " has a wrong size of " +
               std::to_string(found->element) + " bytes");
    known_[static_cast<std::size_t>(found - entries_.begin())] = true;
    return bytes_.subspan(std::size_t{found->offset} * word, std::size_t{found->element} * found->count);
}

} // namespace ciel::detail
