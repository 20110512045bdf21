#include "vs_vtk/duel.hpp"

#include "ciel/sweep_sinks.hpp"

#include <vtkContour3DLinearGrid.h>
#include <vtkContourFilter.h>
#include <vtkContourGrid.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSimpleScalarTree.h>
#include <vtkSpanSpace.h>
#include <vtkVersion.h>

namespace ciel::vs_vtk {
using namespace server;

namespace {

enum class Tree { none, simple, span_space };

// From VTK 9.7 on, processing in sequence crashes under TBB before any parallel run, and the span space keeps the
// triangles of the old field after a change.
constexpr bool is_before_9_7 = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 7, 0);

struct Setup {
    bool merge = false, normals = false;
    Tree tree = Tree::none;
    bool sequential = false;
};

std::string name_of(const char* filter, const Setup& setup) {
    std::string name = filter;
    if (setup.merge) name += ", merged";
    if (setup.normals) name += " + normals";
    if (setup.tree != Tree::none) name += setup.tree == Tree::simple ? ", scalar tree" : ", span space";
    if (setup.sequential) name += ", sequential";
    return name;
}

template <class Filter>
void use_tree(Filter* filter, Tree tree) {
    if (tree == Tree::none) return;
    vtkSmartPointer<vtkScalarTree> made;
    if (tree == Tree::simple)
        made = vtkSmartPointer<vtkSimpleScalarTree>::New();
    else
        made = vtkSmartPointer<vtkSpanSpace>::New();
    filter->SetScalarTree(made);
    filter->UseScalarTreeOn();
}

std::uint64_t run(vtkAlgorithm* filter) {
    filter->Update();
    return static_cast<std::uint64_t>(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells());
}

// Extracts one surface after another with the same filter, so that its scalar tree is built once.
template <class Filter>
Contender series(const char* name, vtkSmartPointer<Filter> filter, const Setup& setup, std::vector<double> values) {
    use_tree(filter.Get(), setup.tree);
    return {name_of(name, setup), [filter, values = std::move(values)] {
                std::uint64_t triangles = 0;
                for (const double value : values) {
                    filter->SetValue(0, value);
                    triangles += run(filter);
                }
                return triangles;
            }};
}

vtkSmartPointer<vtkContour3DLinearGrid> linear_filter(vtkUnstructuredGrid* grid, const Setup& setup) {
    auto filter = vtkSmartPointer<vtkContour3DLinearGrid>::New();
    filter->SetInputData(grid);
    filter->SetMergePoints(setup.merge);
    filter->SetComputeNormals(setup.normals);
    filter->SetSequentialProcessing(setup.sequential);
    return filter;
}

template <class Filter>
vtkSmartPointer<Filter> general_filter(vtkUnstructuredGrid* grid, const Setup& setup) {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(grid);
    filter->SetComputeNormals(setup.normals);
    filter->GenerateTrianglesOn();
    return filter;
}

// `span_space`: whether vtkContour3DLinearGrid may use its span space.
std::vector<Contender> contenders(vtkUnstructuredGrid* grid, bool normals, const std::vector<double>& values,
                                  bool span_space) {
    std::vector<Contender> found;
    if (takes_linear_filter(grid)) {
        const auto add = [&](const Setup& setup) {
            found.push_back(series("vtkContour3DLinearGrid", linear_filter(grid, setup), setup, values));
        };
        for (const Tree tree : {Tree::none, Tree::span_space}) {
            if (tree != Tree::none && !span_space) continue;
            add({normals, normals, tree, false});
            if (is_before_9_7) add({normals, normals, tree, true});
        }
        return found;
    }
    for (const Tree tree : {Tree::none, Tree::simple}) {
        const Setup setup{true, normals, tree, false};
        found.push_back(series("vtkContourGrid", general_filter<vtkContourGrid>(grid, setup), setup, values));
        found.push_back(series("vtkContourFilter", general_filter<vtkContourFilter>(grid, setup), setup, values));
    }
    return found;
}

class Own {
public:
    explicit Own(const bench::Case& data)
        : data_(data), field_(bench::field_of(data, data.values)), query_(*data.topology, data.mesh) {
        query_.set_field(field_);
    }
    [[nodiscard]] std::array<double, 2> range() const { return field_.range(); }
    std::uint64_t extract(const std::vector<double>& values, bool normals) {
        std::uint64_t triangles = 0;
        for (const double nu : values) {
            (void)query_.extract(nu, normals, surface_);
            triangles += bench::triangles_of(surface_);
        }
        return triangles;
    }
    std::uint64_t soups(const std::vector<double>& values, std::vector<SoupSink::Out>& out) {
        sweep(*data_.topology, data_.mesh, field_, values, SoupSink{}, buffers_, out);
        std::uint64_t triangles = 0;
        for (const SoupSink::Out& soup : out) triangles += soup.size() / 3;
        return triangles;
    }
    void set_normals(Normals normals) { query_.set_normals(normals); }
    void change(const store::Values& values) {
        Field changed = bench::field_of(data_, values);
        query_.set_field(changed);
        field_ = std::move(changed);
    }

private:
    const bench::Case& data_;
    Field field_;
    Query query_;
    Surface surface_;
    SweepBuffers<SoupSink> buffers_;
};

// Replacing VTK's scalars is not timed. Building CIEL's block ranges is timed.
void changed_field(const bench::Case& data, vtkUnstructuredGrid* grid, Own& own, double nu, const char* name) {
    bool ours = false, theirs = false;
    const Contender ciel{name, [&] {
                             ours = !ours;
                             own.change(ours ? data.changed : data.values);
                             return own.extract({nu}, true);
                         }};
    std::vector<Contender> vtk = contenders(grid, true, {nu}, is_before_9_7);
    for (Contender& contender : vtk)
        contender.prepare = [&] {
            theirs = !theirs;
            set_values(grid, data, theirs ? data.changed : data.values);
        };
    duel("the field changed, then one surface, normals", ciel, vtk);
    set_values(grid, data, data.values);
    own.change(data.values);
}

} // namespace

bool takes_linear_filter(vtkUnstructuredGrid* grid) {
    return vtkContour3DLinearGrid::CanFullyProcessDataObject(grid, "values");
}

void surfaces(const bench::Case& data, vtkUnstructuredGrid* grid, std::size_t many) {
    Own own(data);
    const auto [low, high] = own.range();
    const std::vector<double> values = bench::values_between(low, high, many);
    const std::string count = std::to_string(many) + " surfaces, warm";
    std::vector<SoupSink::Out> soups;
    if (is_linear(data))
        duel(count + ", soup", {"CIEL, soup, one pass", [&] { return own.soups(values, soups); }},
             contenders(grid, false, values, true));
    duel(count + (takes_linear_filter(grid) ? "; VTK makes a soup, CIEL shares points" : ""),
         {"CIEL, merged", [&] { return own.extract(values, false); }}, contenders(grid, false, values, true));

    const double middle = (static_cast<double>(low) + static_cast<double>(high)) / 2;
    // VTK computes normals from polygons; CIEL's default is the field's gradient.
    for (const auto& [normals, name] : {std::pair{Normals::polygons, "CIEL, merged + normals from polygons"},
                                        {Normals::gradient, "CIEL, merged + normals from gradients"}}) {
        own.set_normals(normals);
        duel(count + ", normals", {name, [&] { return own.extract(values, true); }},
             contenders(grid, true, values, true));
        changed_field(data, grid, own, middle, name);
    }
}

} // namespace ciel::vs_vtk
