#include "import/parsers/netcdf_extent.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace server::importer {

namespace {

// More entries in a list, or characters in a name, mean that the header is damaged.
constexpr std::uint64_t most_entries = 10'000'000;
constexpr std::uint64_t unlimited = 0; // length that the header declares for the record dimension
constexpr std::uint32_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;

std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

class HeaderReader {
public:
    HeaderReader(std::istream& file, const std::string& name) : file_(file), name_(name) {}

    std::optional<NetcdfExtent> run() {
        std::array<char, 4> magic{};
        file_.read(magic.data(), magic.size());
        if (!file_ || magic[0] != 'C' || magic[1] != 'D' || magic[2] != 'F') return std::nullopt;
        version_ = static_cast<unsigned char>(magic[3]);
        if (version_ != 1 && version_ != 2 && version_ != 5) return std::nullopt;
        extent_.records = count();
        for_list(dimension_tag, [&] { read_dimension(); });
        for_list(attribute_tag, [&] { skip_attribute(); });
        for_list(variable_tag, [&] { read_variable(); });
        extent_.fixed_end = std::max(extent_.fixed_end, static_cast<std::uint64_t>(file_.tellg()));
        if (record_variables_ == 1) extent_.record_bytes = alone_bytes_; // a single record variable has no padding
        if (record_variables_ > 0) extent_.last_bytes = record_end_ - extent_.record_begin;
        if (extent_.records == std::numeric_limits<std::uint32_t>::max() && version_ != 5)
            extent_.records = 0; // STREAMING: the header does not declare the number of records
        return extent_;
    }

private:
    [[noreturn]] void fail(const char* what) const { throw ciel::Error(name_ + ": its netCDF header " + what); }

    std::uint64_t big_endian(std::size_t bytes) {
        std::array<unsigned char, 8> raw{};
        file_.read(reinterpret_cast<char*>(raw.data()), static_cast<std::streamsize>(bytes));
        if (!file_) fail("is cut off");
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) value = value << 8U | raw[i];
        return value;
    }
    std::uint64_t count() { return big_endian(version_ == 5 ? 8 : 4); }
    std::uint64_t offset() { return big_endian(version_ == 1 ? 4 : 8); }

    void skip(std::uint64_t bytes) {
        if (bytes > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) fail("is damaged");
        file_.ignore(static_cast<std::streamsize>(bytes));
        if (!file_) fail("is cut off");
    }
    void skip_name() {
        const std::uint64_t length = count();
        if (length > most_entries) fail("is damaged");
        skip(padded(length));
    }

    // A list starts with its tag and the number of entries. An empty list may start with two zeros instead.
    template <class F>
    void for_list(std::uint32_t tag, F&& entry) {
        const std::uint64_t found = big_endian(4), entries = count();
        if ((found != tag && (found != 0 || entries != 0)) || entries > most_entries) fail("is damaged");
        for (std::uint64_t i = 0; i < entries; ++i) entry();
    }

    std::uint64_t type_bytes() {
        // The index is the number of the type in the netCDF format. NC_BYTE has the number 1.
        constexpr std::array<std::uint64_t, 12> bytes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        const std::uint64_t type = big_endian(4);
        if (type == 0 || type >= bytes.size()) fail("is damaged");
        return bytes[type];
    }
    std::uint64_t product(std::uint64_t a, std::uint64_t b) const {
        if (b != 0 && a > std::numeric_limits<std::uint64_t>::max() / 4 / b) fail("is damaged");
        return a * b;
    }
    std::uint64_t sum(std::uint64_t a, std::uint64_t b) const {
        if (a > std::numeric_limits<std::uint64_t>::max() / 2 || b > std::numeric_limits<std::uint64_t>::max() / 2)
            fail("is damaged");
        return a + b;
    }

    void read_dimension() {
        skip_name();
        lengths_.push_back(count());
    }
    void skip_attribute() {
        skip_name();
        const std::uint64_t bytes = type_bytes();
        skip(padded(product(count(), bytes)));
    }
    void read_variable() {
        skip_name();
        const std::uint64_t rank = count();
        if (rank > most_entries) fail("is damaged");
        bool is_record = false;
        std::uint64_t items = 1;
        for (std::uint64_t i = 0; i < rank; ++i) {
            const std::uint64_t dimension = count();
            if (dimension >= lengths_.size()) fail("is damaged");
            if (i == 0 && lengths_[dimension] == unlimited)
                is_record = true;
            else
                items = product(items, lengths_[dimension]);
        }
        for_list(attribute_tag, [&] { skip_attribute(); });
        const std::uint64_t bytes = product(items, type_bytes());
        (void)count(); // skips the declared size, which is wrong for large variables
        const std::uint64_t begin = offset();
        if (!is_record) {
            extent_.fixed_end = std::max(extent_.fixed_end, sum(begin, bytes));
            return;
        }
        if (record_variables_++ == 0) extent_.record_begin = begin;
        extent_.record_begin = std::min(extent_.record_begin, begin);
        extent_.record_bytes = sum(extent_.record_bytes, padded(bytes));
        alone_bytes_ = bytes;
        record_end_ = std::max(record_end_, sum(begin, bytes));
    }

    std::istream& file_;
    const std::string& name_;
    unsigned version_ = 0;
    std::vector<std::uint64_t> lengths_;
    std::uint64_t record_variables_ = 0, alone_bytes_ = 0;
    std::uint64_t record_end_ = 0; // file offset after the last variable of the first record
    NetcdfExtent extent_;
};

} // namespace

std::uint64_t NetcdfExtent::records_within(std::uint64_t bytes) const {
    if (record_bytes == 0) return records;
    if (bytes < record_begin || bytes - record_begin < last_bytes) return 0;
    return std::min(records, (bytes - record_begin - last_bytes) / record_bytes + 1);
}

std::optional<NetcdfExtent> read_netcdf_extent(std::istream& file, const std::string& name) {
    return HeaderReader(file, name).run();
}

} // namespace server::importer
