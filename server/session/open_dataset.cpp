#include "session/open_dataset.hpp"

#include "session/errors.hpp"
#include "store/files.hpp"

namespace ciel::session {

std::shared_ptr<store::LoadedDataset> open_dataset(store::Catalog& catalog, const std::string& name) {
    try {
        return catalog.open(name);
    } catch (const Error& error) {
        for (const auto& entry : catalog.list())
            if (entry.name == name) throw;
        throw NotFound(store::sentence_for_clients(error));
    }
}

} // namespace ciel::session
