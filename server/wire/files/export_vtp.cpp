#include "wire/files/export_vtp.hpp"

#include "wire/bytes.hpp"

#include <functional>

namespace server::wire {
namespace {

std::string xml_escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

// Declares arrays in the XML header. Their bytes follow in the section AppendedData, each array after its size.
class AppendedArrays {
public:
    void declare(std::ostream& out, const char* type, const std::string& name, int components, std::uint64_t bytes,
                 std::function<void(std::ostream&)> write) {
        out << "<DataArray type=\"" << type << "\" Name=\"" << xml_escaped(name) << "\" NumberOfComponents=\""
            << components << "\" format=\"appended\" offset=\"" << offset_ << "\"/>\n";
        offset_ += sizeof(std::uint64_t) + bytes;
        arrays_.push_back({bytes, std::move(write)});
    }
    void write(std::ostream& out) const {
        out << "<AppendedData encoding=\"raw\">\n_";
        for (const Array& array : arrays_) {
            write_raw(out, array.bytes);
            array.write(out);
        }
        out << "\n</AppendedData>\n";
    }

private:
    struct Array {
        std::uint64_t bytes;
        std::function<void(std::ostream&)> write;
    };
    std::uint64_t offset_ = 0;
    std::vector<Array> arrays_;
};

void declare_point_data(const ExportSurface& surface, const ExportedPolygons& polygons, AppendedArrays& arrays,
                        std::ostream& out) {
    const std::uint64_t points = polygons.vertices.size();
    const auto& normals = surface.surface.normals;
    out << (normals.empty() ? "<PointData>\n" : "<PointData Normals=\"Normals\">\n");
    if (!normals.empty()) {
        arrays.declare(out, "Float32", "Normals", 3, 12 * points, [&](std::ostream& to) {
            for (const ciel::Index vertex : polygons.vertices) write_raw(to, normals[vertex]);
        });
    }
    for (const NamedValues& values : surface.values) {
        const char* type = values.doubles ? "Float64" : "Float32";
        arrays.declare(out, type, values.name, 1, values.value_bytes() * points, [&](std::ostream& to) {
            for (const ciel::Index vertex : polygons.vertices) write_value(to, values, vertex);
        });
    }
    out << "</PointData>\n";
}

void declare_geometry(const ExportSurface& surface, const ExportedPolygons& polygons, AppendedArrays& arrays,
                      std::ostream& out) {
    out << "<Points>\n";
    arrays.declare(out, "Float64", "Points", 3, 24 * polygons.vertices.size(), [&](std::ostream& to) {
        for (const ciel::Index vertex : polygons.vertices) write_raw(to, surface.place(vertex));
    });
    out << "</Points>\n<Polys>\n";
    arrays.declare(out, "Int64", "connectivity", 1, 8 * polygons.corner.size(), [&](std::ostream& to) {
        for (const ciel::Index corner : polygons.corner) write_raw(to, static_cast<std::int64_t>(corner));
    });
    arrays.declare(out, "Int64", "offsets", 1, 8 * (polygons.offset.size() - 1), [&](std::ostream& to) {
        for (std::size_t i = 1; i < polygons.offset.size(); ++i)
            write_raw(to, static_cast<std::int64_t>(polygons.offset[i]));
    });
    out << "</Polys>\n";
}

} // namespace

ExportedCounts write_vtp(const ExportSurface& surface, std::ostream& out) {
    const ExportedPolygons polygons = exported_polygons(surface.surface, surface.triangles);
    AppendedArrays arrays;
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n";
    if (surface.file_origin != ciel::Vec3d{})
        out << "<FieldData>\n<DataArray type=\"Float64\" Name=\"origin\" NumberOfComponents=\"3\" NumberOfTuples=\"1\" "
               "format=\"ascii\">"
            << origin_text(surface.file_origin) << "</DataArray>\n</FieldData>\n";
    out << "<Piece NumberOfPoints=\"" << polygons.vertices.size()
        << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
        << polygons.offset.size() - 1 << "\">\n";
    declare_point_data(surface, polygons, arrays, out);
    declare_geometry(surface, polygons, arrays, out);
    out << "</Piece>\n</PolyData>\n";
    arrays.write(out);
    out << "</VTKFile>\n";
    return polygons.counts();
}

} // namespace server::wire
