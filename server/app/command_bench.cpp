// ciel bench: measures the four tables of the paper, and the cost of pictures, for a dataset on this machine.
#include "app/commands.hpp"
#include "bench/case.hpp"
#include "ciel/process_threads.hpp"
#include "store/files/files.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace server::app {
namespace {

using nlohmann::json;

const std::vector<std::pair<std::string, bench::Table (*)(const bench::Case&)>> all_tables{
    {"memory", bench::memory_table}, {"preprocessing", bench::preprocessing_table},
    {"slices", bench::slices_table}, {"surfaces", bench::surfaces_table},
    {"frames", bench::frames_table}, {"volume", bench::volume_table}};
const std::vector<std::string> picture_tables{"frames", "volume"};

struct BenchCommand {
    std::string dataset, array, output;
    std::vector<std::string> tables;
    unsigned threads = 0;
    bool render = false;
};

json spread_json(const bench::Spread& spread) {
    return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}};
}

json row_json(const bench::Row& row, double cells) {
    json found{{"what", row.what},
               {"wall_seconds", spread_json(row.wall)},
               {"cpu_seconds", spread_json(row.cpu)},
               {"repetitions", row.repetitions},
               {"wall_ns_per_cell", 1e9 * row.wall.median / cells}};
    if (row.triangles > 0) {
        found["triangles"] = row.triangles;
        found["cpu_ns_per_triangle"] = 1e9 * row.cpu.median / static_cast<double>(row.triangles);
    }
    if (!row.note.empty()) found["note"] = row.note;
    return found;
}

json table_json(const bench::Table& table, double cells) {
    json found{{"name", table.name}, {"figures", json::array()}, {"rows", json::array()}};
    for (const bench::Figure& figure : table.figures)
        found["figures"].push_back({{"what", figure.what}, {"value", figure.value}, {"unit", figure.unit}});
    for (const bench::Row& row : table.rows) found["rows"].push_back(row_json(row, cells));
    return found;
}

void print_row(const bench::Row& row, double cells) {
    std::printf("  %-48s %9.3f  %8.3f..%-8.3f %9.3f %9.1f", row.what.c_str(), 1e3 * row.wall.median, 1e3 * row.wall.low,
                1e3 * row.wall.high, 1e3 * row.cpu.median, 1e9 * row.wall.median / cells);
    if (row.triangles > 0)
        std::printf(" %11llu %9.1f", static_cast<unsigned long long>(row.triangles),
                    1e9 * row.cpu.median / static_cast<double>(row.triangles));
    std::printf("%s%s\n", row.note.empty() ? "" : "  ", row.note.c_str());
}

void print(const bench::Table& table, double cells) {
    std::printf("%s\n", table.name.c_str());
    for (const bench::Figure& figure : table.figures)
        std::printf("  %-48s %16.10g %s\n", figure.what.c_str(), figure.value, figure.unit.c_str());
    if (!table.rows.empty())
        std::printf("  %-48s %9s  %8s..%-8s %9s %9s %11s %9s\n", "", "wall ms", "low", "high", "CPU ms", "ns/cell",
                    "triangles", "CPU ns/tri");
    for (const bench::Row& row : table.rows) print_row(row, cells);
    std::fflush(stdout);
}

bool is_wanted(const BenchCommand& command, const std::string& table) {
    const auto is_among = [&](const std::vector<std::string>& tables) {
        return std::ranges::find(tables, table) != tables.end();
    };
    const bool is_picture = is_among(picture_tables);
    if (command.render && is_picture) return true;
    return command.tables.empty() ? !command.render && !is_picture : is_among(command.tables);
}

// Called after each table, so that an interrupted run keeps the finished tables.
void write_report(const std::string& output, const json& report) {
    if (output.empty()) return;
    const std::string text = report.dump(2) + "\n";
    store::replace_file(std::filesystem::absolute(output), store::bytes_of(text));
}

int run_command(const BenchCommand& command) {
    if (command.threads > 0) ciel::set_thread_count(command.threads);
    const bench::Case data = bench::open_case(command.dataset, command.array);
    const double cells = data.mesh.cell_count();
    std::printf("%s, %s at time %g, %u threads\n", data.dataset->info().name.c_str(), data.array.c_str(), data.time,
                ciel::thread_count());
    json report{{"dataset", data.dataset->info().name},
                {"array", data.array},
                {"time", data.time},
                {"threads", ciel::thread_count()},
                {"version", CIEL_VERSION},
                {"cells", data.mesh.cell_count()},
                {"tables", json::array()}};
    write_report(command.output, report); // throws before the first measurement if the file cannot be written
    for (const auto& [name, make] : all_tables) {
        if (!is_wanted(command, name)) continue;
        const bench::Table table = make(data);
        print(table, cells);
        report["tables"].push_back(table_json(table, cells));
        write_report(command.output, report);
    }
    return 0;
}

} // namespace

void add_bench(CLI::App& app, Run& run) {
    CLI::App* command = app.add_subcommand(
        "bench", "Measure memory, preprocessing, slices, surfaces, frames and volumes of a dataset.");
    command->footer(
        "Medians with quartiles; CPU time counts all threads. Compare figures of one run, on a machine that "
        "does nothing else.");
    auto bench = std::make_shared<BenchCommand>();
    command->add_option("dataset", bench->dataset, "NAME.ciel")->required();
    command->add_option("--array", bench->array, "Point scalar; by default the first that varies.")->type_name("ARRAY");
    command
        ->add_option("--table", bench->tables,
                     "memory, preprocessing, slices, surfaces, frames or volume; may be repeated. By default the first "
                     "four, which are the tables of the paper.")
        ->check(CLI::IsMember({"memory", "preprocessing", "slices", "surfaces", "frames", "volume"}))
        ->type_name("TABLE");
    command->add_flag("--render", bench->render,
                      "Measure the tables of pictures: frames (from a change of the scene to an encoded frame of "
                      "1280x720, by stages) and volume (100 slices at 1024x1024).");
    command->add_option("--threads", bench->threads, "Number of threads; by default all of the machine.")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->add_option("--json", bench->output, "Also write the figures to FILE.")->type_name("FILE");
    command->callback([&run, bench] { run = [bench] { return run_command(*bench); }; });
}

} // namespace server::app
