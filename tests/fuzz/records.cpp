// Fuzzes the records of a small mesh: bytes that a checksum would not catch are refused, or all that reads them ends
// and stays in bounds.
#include "fuzz/bytes.hpp"
#include "support/copied_records.hpp"
#include "support/fields.hpp"
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

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    const Sample& from = sample(bytes.next());
    if (from.topology.counts().cells == 0) return 0;
    auto copied = std::make_unique<CopiedRecords>(from.topology);
    while (!bytes.empty()) patch(*copied, bytes);
    try {
        const Topology topology = read_back(std::move(copied));
        if (topology.counts().vertices != from.topology.counts().vertices) return 0;
        (void)all_operators(topology);
        (void)cut_in_all_ways(topology, from.assembled.mesh.view(), from.values);
        (void)vertex_gradients(topology, from.assembled.mesh.view(), from.values);
    } catch (const Error& error) {
        require(says_what_to_do(error.what()), error.what());
    }
    return 0;
}
