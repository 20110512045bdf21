#include "sessions/open_dataset.hpp"

#include "limits/errors.hpp"
#include "store/files/files.hpp"

namespace server::sessions {

std::shared_ptr<store::LoadedDataset> open_dataset(store::Catalog& catalog, const std::string& name) {
    try {
        return catalog.open(name);
    } catch (const ciel::Error& error) {
        for (const auto& entry : catalog.list())
            if (entry.name == name) throw;
        throw limits::NotFound(store::sentence_for_clients(error));
    }
}

} // namespace server::sessions
