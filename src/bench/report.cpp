#include "bench/report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/output/json.hpp"

namespace sabo {
namespace {

std::vector<std::size_t> column_widths(const BenchTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& cell : table.header) widths.push_back(cell.size());
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  return widths;
}

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line = " ";
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += k == 0 ? fmt::format(" {:<{}}", cells[k], widths[k])
                   : fmt::format("  {:>{}}", cells[k], widths[k]);
  return line + "\n";
}

}  // namespace

std::string warning_of(const BenchMachine& machine) {
  if (machine.load + machine.threads <= machine.cores + 0.5) return "";
  return fmt::format(
      "Load {:.1f} on {} cores: other programs run as well. Steps on several threads then tell "
      "about them,\nfor every loop waits for the thread that is kept waiting; --threads 1 still "
      "tells something.\n",
      machine.load, machine.cores);
}

std::string threads_text(int threads) {
  return fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
}

std::string text_of(const BenchTable& table) {
  const std::vector<std::size_t> widths = column_widths(table);
  std::string text = table.title + "\n" + line_of(table.header, widths);
  for (const auto& row : table.rows) text += line_of(row, widths);
  for (const std::string& note : table.notes) text += "  " + note + "\n";
  return text;
}

std::string json_of(const BenchMachine& machine, const std::vector<Measurement>& measurements) {
  std::string text = fmt::format(
      "{{\n  \"format\": 1,\n  \"version\": {},\n  \"compiler\": {},\n  \"cpu\": {},\n"
      "  \"instruction_set\": {},\n  \"threads\": {},\n  \"cores\": {},\n  \"load\": {},\n  "
      "\"date\": {},\n  \"results\": [",
      json_string(machine.version), json_string(machine.compiler), json_string(machine.cpu),
      json_string(machine.instruction_set), machine.threads, machine.cores,
      json_number(machine.load), json_string(machine.date));
  const char* separator = "\n";
  for (const Measurement& m : measurements) {
    text += fmt::format(
        "{}    {{\"name\": {}, \"value\": {}, \"unit\": {}, \"low\": {}, \"high\": {}, "
        "\"repeats\": {}}}",
        separator, json_string(m.name), json_number(m.value), json_string(m.unit),
        json_number(m.low), json_number(m.high), m.repeats);
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

}  // namespace sabo
