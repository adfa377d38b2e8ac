#include "verify/report.hpp"

#include <algorithm>

#include "verify/validation_page.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/output/file.hpp"
#include "io/output/index_page.hpp"
#include "io/output/json.hpp"

namespace sabo {
namespace {

/// A value with its unit.
std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string_view outcome(const Claim& claim) {
  return claim.gate == GateKind::none && claim.holds() ? "told" : outcome_text(claim.holds());
}

/// Characters of a UTF-8 text, each a column wide.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t used = columns(text);
  return text + std::string(used < width ? width - used : 0, ' ');
}

std::string title_of(const VerifyRecord& record) {
  return fmt::format("{} ({})", record.name, word_of(record.method));
}

PageTable table_of(const VerifyRecord& record) {
  PageTable table{fmt::format("{}: {}", title_of(record), verification_of(record).title),
                  {"", "measured", "gate", "outcome"},
                  {}};
  for (const Claim& claim : record.verdict.claims)
    table.rows.push_back(
        {claim.what, measured_text(claim), gate_text(claim), std::string(outcome(claim))});
  if (!record.failure.empty()) table.rows.push_back({record.failure, "", "", "FAIL"});
  return table;
}

PageTable overview(const std::vector<VerifyRecord>& records) {
  PageTable table{"Cases", {"", "claims met", "time [s]", "version", "date", "outcome"}, {}};
  for (const VerifyRecord& record : records) {
    table.rows.push_back({title_of(record), claims_met_text(record.verdict),
                          fmt::format("{:.0f}", record.seconds), record.version,
                          record.date.substr(0, 10), std::string(outcome_text(record.holds()))});
  }
  return table;
}

}  // namespace

const Verification& verification_of(const VerifyRecord& record) {
  return *std::ranges::find(verifications(), record.name, &Verification::name);
}

std::set<std::string> machines(const std::vector<VerifyRecord>& records) {
  std::set<std::string> names;
  for (const VerifyRecord& record : records) names.insert(record.machine);
  return names;
}

std::string_view outcome_text(bool holds) { return holds ? "pass" : "FAIL"; }

std::string claims_met_text(const Verdict& verdict) {
  const auto has_gate = [](const Claim& claim) { return claim.gate != GateKind::none; };
  const auto is_met = [&](const Claim& claim) { return has_gate(claim) && claim.holds(); };
  return fmt::format("{} of {}", std::ranges::count_if(verdict.claims, is_met),
                     std::ranges::count_if(verdict.claims, has_gate));
}

std::string measured_text(const Claim& claim) { return with_unit(claim.measured, claim.unit); }

std::string gate_text(const Claim& claim) {
  const std::string expected = with_unit(claim.expected, claim.unit);
  switch (claim.gate) {
    case GateKind::within_share:
      return fmt::format("within {:g} % of {}", 100 * claim.margin, expected);
    case GateKind::within:
      return fmt::format("within {} of {}", with_unit(claim.margin, claim.unit), expected);
    case GateKind::at_most:
      return "at most " + expected;
    case GateKind::at_least:
      return "at least " + expected;
    case GateKind::none:
      return "beside " + expected;
  }
  return "";
}

std::string text_of(const VerifyRecord& record) {
  std::string text = fmt::format("{}  {:<24} {}, {:.0f} s\n", outcome_text(record.holds()),
                                 title_of(record), verification_of(record).title, record.seconds);
  std::size_t what = 0, measured = 0;
  for (const Claim& claim : record.verdict.claims) {
    what = std::max(what, columns(claim.what));
    measured = std::max(measured, columns(measured_text(claim)));
  }
  for (const Claim& claim : record.verdict.claims)
    text += fmt::format("        {}  {}  {}  {}\n", outcome(claim), padded(claim.what, what),
                        padded(measured_text(claim), measured), gate_text(claim));
  for (const std::string& remark : record.verdict.remarks) text += "        " + remark + "\n";
  if (!record.failure.empty()) text += "        " + record.failure + "\n";
  return text;
}

std::string json_of(const std::vector<VerifyRecord>& records) {
  std::string text = "{\n  \"format\": 1,\n  \"cases\": [";
  const char* case_separator = "\n";
  for (const VerifyRecord& record : records) {
    text += fmt::format(
        "{}    {{\"name\": {}, \"method\": \"{}\", \"effort\": \"{}\", \"version\": {}, "
        "\"machine\": {}, \"date\": {}, \"seconds\": {}, \"pass\": {}, \"failure\": {}, "
        "\"claims\": [",
        case_separator, json_string(record.name), word_of(record.method), word_of(record.effort),
        json_string(record.version), json_string(record.machine), json_string(record.date),
        json_number(record.seconds), record.holds(), json_string(record.failure));
    case_separator = ",\n";
    const char* separator = "\n";
    for (const Claim& claim : record.verdict.claims) {
      text += fmt::format(
          "{}      {{\"what\": {}, \"unit\": {}, \"measured\": {}, \"expected\": {}, "
          "\"gate\": \"{}\", \"margin\": {}, \"pass\": {}}}",
          separator, json_string(claim.what), json_string(claim.unit), json_number(claim.measured),
          json_number(claim.expected), word_of(claim.gate), json_number(claim.margin),
          claim.holds());
      separator = ",\n";
    }
    text += "]}";
  }
  return text + "\n  ]\n}\n";
}

std::filesystem::path write_verify_page(const std::vector<VerifyRecord>& records,
                                        const std::filesystem::path& folder) {
  IndexPage page;
  page.title = "Verification of sabo";
  page.subtitle = fmt::format("{} · {} of {} cases pass", fmt::join(machines(records), ", "),
                              std::ranges::count_if(records, &VerifyRecord::holds), records.size());
  page.tables = {overview(records)};
  for (const VerifyRecord& record : records) {
    page.details.push_back(table_of(record));
    for (const std::string& remark : record.verdict.remarks)
      page.details.back().caption += ". " + remark;
    for (const std::string& picture : record.pictures)
      page.pictures.push_back(
          {{picture},
           fmt::format("{}. Reference: {}", title_of(record), verification_of(record).reference),
           false});
  }
  page.files = {{"verify.json", "all numbers"}, {"validation.md", "this page in Markdown"}};
  write_file_atomically(folder / "verify.json", json_of(records));
  write_file_atomically(folder / "validation.md", validation_markdown(records));
  std::filesystem::path file = folder / "index.html";
  write_file_atomically(file, index_html(page));
  return file;
}

}  // namespace sabo
