#include "import/readers/exodus_sets.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtk_exodusII.h>

namespace server::importer {

namespace {

class ExodusFile {
public:
    explicit ExodusFile(const std::string& name) : name_(name) {
        int computer_word = sizeof(double);
        int file_word = 0;
        float version = 0;
        id_ = ex_open(name.c_str(), EX_READ, &computer_word, &file_word, &version);
        check(id_);
        ex_set_int64_status(id_, EX_ALL_INT64_API);
    }
    ~ExodusFile() {
        if (id_ >= 0) ex_close(id_);
    }
    ExodusFile(const ExodusFile&) = delete;
    ExodusFile& operator=(const ExodusFile&) = delete;

    // Returns the ids of the element blocks, in the order in which the file numbers their elements.
    [[nodiscard]] std::vector<std::int64_t> blocks() const {
        std::vector<std::int64_t> ids(
            static_cast<std::size_t>(std::max<std::int64_t>(0, ex_inquire_int(id_, EX_INQ_ELEM_BLK))));
        check(ex_get_ids(id_, EX_ELEM_BLOCK, ids.data()));
        return ids;
    }
    [[nodiscard]] std::int64_t block_size(std::int64_t block) const {
        ex_block description{};
        description.id = block;
        description.type = EX_ELEM_BLOCK;
        check(ex_get_block_param(id_, &description));
        return description.num_entry;
    }
    [[nodiscard]] std::vector<std::int64_t> set(std::int64_t set) const {
        std::int64_t count = 0;
        std::int64_t factors = 0;
        check(ex_get_set_param(id_, EX_ELEM_SET, set, &count, &factors));
        std::vector<std::int64_t> elements(static_cast<std::size_t>(std::max<std::int64_t>(0, count)));
        if (!elements.empty()) check(ex_get_set(id_, EX_ELEM_SET, set, elements.data(), nullptr));
        return elements;
    }

private:
    void check(int status) const {
        if (status < 0) throw ciel::Error(name_ + ": its element sets cannot be read; the file may be damaged");
    }

    std::string name_;
    int id_ = -1;
};

} // namespace

std::vector<ElementSet> read_element_sets(const std::string& file, const std::vector<std::int64_t>& block_ids,
                                          const std::vector<std::int64_t>& set_ids) {
    const ExodusFile exodus(file);
    const std::vector<std::int64_t> blocks = exodus.blocks();
    std::vector<std::int64_t> first{0}; // index of the first element of each element block, then the number of elements
    for (const std::int64_t block : blocks) first.push_back(first.back() + exodus.block_size(block));

    std::vector<ElementSet> sets;
    for (const std::int64_t id : set_ids) {
        ElementSet& set = sets.emplace_back();
        for (const std::int64_t number : exodus.set(id)) {
            const std::int64_t element = number - 1;
            if (element < 0 || element >= first.back())
                throw ciel::Error(file + ": element set " + std::to_string(id) + " contains element " +
                                  std::to_string(number) + ", but the last element of the file is " +
                                  std::to_string(first.back()));
            const auto block =
                static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), element) - first.begin() - 1);
            const auto place = std::find(block_ids.begin(), block_ids.end(), blocks[block]);
            if (place == block_ids.end()) continue;
            set.emplace_back(static_cast<unsigned>(place - block_ids.begin()), element - first[block]);
        }
    }
    return sets;
}

vtkSmartPointer<vtkUnstructuredGrid> copy_cells(vtkMultiBlockDataSet* blocks, const ElementSet& set) {
    auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    copy->SetPoints(points);
    copy->Allocate(static_cast<vtkIdType>(set.size()));
    vtkNew<vtkIdList> ids;
    for (const auto& [block, cell] : set) {
        auto* data = vtkDataSet::SafeDownCast(blocks->GetBlock(block));
        if (data == nullptr || cell >= data->GetNumberOfCells()) continue;
        data->GetCellPoints(cell, ids);
        for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
            double point[3];
            data->GetPoint(ids->GetId(i), point);
            ids->SetId(i, points->InsertNextPoint(point));
        }
        copy->InsertNextCell(VTK_CONVEX_POINT_SET, ids);
    }
    return copy;
}

} // namespace server::importer
