#include "verify/record.hpp"

#include <chrono>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/case_file/text_check.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/case_file/toml_tree.hpp"
#include "io/output/checksum.hpp"
#include "io/output/cpu_name.hpp"
#include "io/output/file.hpp"
#include "io/output/read_file.hpp"
#include "run/manifest.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

std::string stem(std::string_view name, Method method, Effort effort) {
  return fmt::format("{}-{}-{}", name, word_of(method), word_of(effort));
}

/// Of the running program, "" where it cannot be told: what is built from changed files has the
/// version of the last commit.
const std::string& program_checksum() {
  static const std::string sum = [] {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return error ? std::string() : checksum(program);
  }();
  return sum;
}

std::vector<std::string> quoted(const std::vector<std::string>& texts) {
  std::vector<std::string> list;
  for (const std::string& text : texts) list.push_back(toml_string(text));
  return list;
}

std::string toml_of(const VerifyRecord& record) {
  std::string text = fmt::format(
      "# Written by sabo verify.\nversion = {}\nprogram = {}\nname = {}\nmethod = {}\neffort = "
      "{}\ndate = {}\nmachine = {}\n"
      "seconds = {:.3f}\nfailure = {}\nremarks = [{}]\npictures = [{}]\n",
      toml_string(record.version), toml_string(record.is_current ? program_checksum() : ""),
      toml_string(record.name), toml_string(std::string(word_of(record.method))),
      toml_string(std::string(word_of(record.effort))), toml_string(record.date),
      toml_string(record.machine), record.seconds, toml_string(record.failure),
      fmt::join(quoted(record.verdict.remarks), ", "), fmt::join(quoted(record.pictures), ", "));
  for (const Claim& claim : record.verdict.claims)
    text += fmt::format(
        "\n[[claim]]\nwhat = {}\nunit = {}\nmeasured = {:.17g}\nexpected = {:.17g}\ngate = {}\n"
        "margin = {:.17g}\n",
        toml_string(claim.what), toml_string(claim.unit), claim.measured, claim.expected,
        toml_string(std::string(word_of(claim.gate))), claim.margin);
  return text;
}

std::vector<std::string> texts_at(const TomlTable& table, std::string_view key) {
  std::vector<std::string> list;
  const TomlNode* node = find(table, key);
  const auto* array = node ? std::get_if<TomlArray>(&node->value) : nullptr;
  if (!array) return list;
  for (const TomlNode& entry : *array)
    if (const auto* text = std::get_if<std::string>(&entry.value)) list.push_back(*text);
  return list;
}

std::optional<Claim> claim_of(const TomlNode& node) {
  const auto* table = std::get_if<TomlTable>(&node.value);
  if (!table) return std::nullopt;
  const auto gate = value_of_word<GateKind>(text_at(*table, "gate").value_or(""));
  const auto measured = number_at(*table, "measured"), expected = number_at(*table, "expected");
  if (!gate || !measured || !expected) return std::nullopt;
  return Claim{text_at(*table, "what").value_or(""),
               text_at(*table, "unit").value_or(""),
               *measured,
               *expected,
               *gate,
               number_at(*table, "margin").value_or(0)};
}

}  // namespace

VerifyRecord run_verification(const Verification& verification, const VerifySettings& settings) {
  using Clock = std::chrono::steady_clock;
  VerifyRecord record{std::string(verification.name), settings.method, settings.effort};
  record.date = utc_now();
  record.version = build_version;
  record.machine = fmt::format("{} ({} thread{})", cpu_name(), settings.threads,
                               settings.threads == 1 ? "" : "s");
  record.is_current = true;
  const auto begin = Clock::now();
  try {
    record.verdict = verification.run(settings);
  } catch (const RunError& error) {
    record.failure = error.what();
  }
  record.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return record;
}

void write_record(VerifyRecord& record, const fs::path& folder) {
  make_folder(folder);
  std::error_code error;
  const std::string name = stem(record.name, record.method, record.effort);
  record.pictures.clear();
  for (std::size_t k = 0; k < record.verdict.charts.size(); ++k) {
    record.pictures.push_back(fmt::format("{}-{}.svg", name, k + 1));
    write_file_atomically(folder / record.pictures.back(), chart_svg(record.verdict.charts[k]));
  }
  for (std::size_t k = record.pictures.size() + 1;
       fs::remove(folder / fmt::format("{}-{}.svg", name, k), error); ++k) {
  }
  write_file_atomically(folder / (name + ".toml"), toml_of(record));
}

std::optional<VerifyRecord> read_record(const fs::path& folder, std::string_view name,
                                        Method method, Effort effort) {
  const auto text = read_file(folder / (stem(name, method, effort) + ".toml"), largest_text);
  if (!text) return std::nullopt;
  Faults faults;
  const auto file = parse_toml(*text, "record", faults);
  if (!file || !text_at(*file, "version")) return std::nullopt;
  VerifyRecord record{std::string(name), method, effort};
  record.version = *text_at(*file, "version");
  record.machine = text_at(*file, "machine").value_or("");
  record.is_current =
      !program_checksum().empty() && text_at(*file, "program") == program_checksum();
  record.verdict.remarks = texts_at(*file, "remarks");
  record.pictures = texts_at(*file, "pictures");
  record.failure = text_at(*file, "failure").value_or("");
  record.seconds = number_at(*file, "seconds").value_or(0);
  record.date = text_at(*file, "date").value_or("");
  const TomlNode* claims = find(*file, "claim");
  const auto* list = claims ? std::get_if<TomlArray>(&claims->value) : nullptr;
  if (list)
    for (const TomlNode& node : *list)
      if (auto claim = claim_of(node)) record.verdict.claims.push_back(std::move(*claim));
  return record;
}

std::vector<VerifyRecord> read_records(const fs::path& folder, Effort effort) {
  std::vector<VerifyRecord> records;
  for (const Verification& verification : verifications())
    for (const Method method : verification.methods)
      if (auto record = read_record(folder, verification.name, method, effort))
        records.push_back(std::move(*record));
  return records;
}

}  // namespace sabo
