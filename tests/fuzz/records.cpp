// Fuzzes the records of a small mesh with damage that no checksum detects, made before or after the topology checks
// them. Every function that reads records must end and stay in bounds, or throw an Error that says what to do.
#include "fuzz/bytes.hpp"
#include "support/copied_records.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/mapped_records.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

namespace {

using namespace ciel;
using namespace ciel::test;

struct Sample {
    explicit Sample(const NamedMesh& named)
        : assembled(assemble(view(named.make()))), topology(assembled.mesh.view(), {16}),
          values(random_field(topology.counts().vertices, 3)) {}

    Assembled assembled;
    Topology topology;
    std::vector<float> values;
};

const Sample& sample(std::uint8_t which) {
    static const std::vector<NamedMesh> named = all_meshes();
    static std::map<std::size_t, std::unique_ptr<const Sample>> made;
    auto& found = made[which % named.size()];
    if (found == nullptr) found = std::make_unique<const Sample>(named[which % named.size()]);
    return *found;
}

CopiedRecords::Bytes& chosen(CopiedRecords& copied, std::uint8_t which) {
    if (which == 0 || copied.records.empty()) return copied.tables;
    auto record = copied.records.begin();
    std::advance(record, which % copied.records.size());
    return record->second;
}

void patch(CopiedRecords& copied, Bytes& bytes) {
    CopiedRecords::Bytes& record = chosen(copied, bytes.next());
    const std::size_t place = (std::size_t{bytes.next()} << 8 | bytes.next()) % (record.size() * sizeof(record[0]));
    reinterpret_cast<std::uint8_t*>(record.data())[place] = bytes.next();
}

// Calls every function that reads records. An Error must say what to do.
void use(const Topology& topology, const Sample& from) {
    try {
        (void)all_operators(topology);
        (void)cut_in_all_ways(topology, kept(from.assembled.mesh.view()), from.values);
        (void)vertex_gradients(topology, from.assembled.mesh.view(), from.values);
        probe_some(topology, kept(from.assembled.mesh.view()));
        threshold_some(topology, from.assembled.mesh.view(), from.values);
    } catch (const Error& error) {
        require(says_what_to_do(error.what()), error.what());
    }
}

// Changes bytes of the records before the topology checks them.
void patched_before(const Sample& from, Bytes bytes) {
    auto copied = std::make_unique<CopiedRecords>(from.topology);
    while (!bytes.empty()) patch(*copied, bytes);
    try {
        const Topology topology = read_back(std::move(copied));
        if (topology.counts().vertices == from.topology.counts().vertices) use(topology, from);
    } catch (const Error& error) {
        require(says_what_to_do(error.what()), error.what());
    }
}

// Changes bytes of the records after their check, between two uses.
void patched_after(const Sample& from, Bytes bytes) {
    auto mapped = std::make_unique<MappedRecords>(from.topology);
    const auto words = std::as_writable_bytes(mapped->words());
    const CopiedRecords::Bytes tables = from.topology.tables();
    const Topology topology(std::as_bytes(std::span(tables)), std::move(mapped));
    use(topology, from);
    while (!bytes.empty()) {
        const std::size_t place = std::size_t{bytes.next()} << 16 | std::size_t{bytes.next()} << 8 | bytes.next();
        words[place % words.size()] = static_cast<std::byte>(bytes.next());
    }
    use(topology, from);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    const Sample& from = sample(bytes.next());
    if (from.topology.counts().cells == 0) return 0;
    patched_before(from, bytes);
    patched_after(from, bytes);
    return 0;
}
