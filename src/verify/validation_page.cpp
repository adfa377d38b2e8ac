#include "verify/validation_page.hpp"

#include <algorithm>
#include <set>

#include "verify/report.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sabo {
namespace {

/// The records of one case, one for each method.
using CaseRecords = std::vector<const VerifyRecord*>;

/// How to read the page.
constexpr const char* legend =
    "Each row of a table below is a number that was measured. A gate says how it must lie to "
    "what is expected; one outside **fails**, and a remark below the table tells what is known of "
    "the cause. "
    "\"Beside\" is no gate: a number of others, or of another setting, to compare with. Rows "
    "that ask for at least so large an error are controls: there the material or a term is "
    "wrong on purpose, and the band must notice.\n\n"
    "`fast` is the default of `sabo`, with its own defaults, among them the shifting of "
    "particles in the inside of a flow. `paper` is the explicit method of the paper in its "
    "accurate setting, not in its default, which reads the paper literally: `viscous_operator = "
    "\"morris\"`, `boundary_stress = \"mirror\"`, `boundary_pressure = \"extrapolated\"`, "
    "`diffusion_form = \"fourtakas\"`; yohutagawa alone takes its defaults. Its explicit steps "
    "are a hundred times shorter in a stiff material, so some of its cases are coarser or left "
    "out.\n";

/// Text of a cell: a bar would end it.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string overview(const std::vector<VerifyRecord>& records) {
  std::string text =
      "| case | method | claims met | time [s] | version | date | |\n"
      "|---|---|---:|---:|---|---|---|\n";
  for (const VerifyRecord& record : records) {
    text += fmt::format("| [{0}](#{0}) | `{1}` | {2} | {3:.0f} | {4} | {5} | {6} |\n", record.name,
                        word_of(record.method), claims_met_text(record.verdict), record.seconds,
                        record.version, record.date.substr(0, 10), outcome_text(record.holds()));
  }
  return text;
}

const Claim* find_claim(const VerifyRecord& record, const std::string& what) {
  const auto& claims = record.verdict.claims;
  const auto found = std::ranges::find(claims, what, &Claim::what);
  return found == claims.end() ? nullptr : &*found;
}

/// Each claim once, in the order in which the methods make them.
std::vector<const Claim*> all_claims(const CaseRecords& records) {
  std::vector<const Claim*> list;
  for (const VerifyRecord* record : records)
    for (const Claim& claim : record->verdict.claims)
      if (std::ranges::none_of(list, [&](const Claim* c) { return c->what == claim.what; }))
        list.push_back(&claim);
  return list;
}

/// What a method measured, with its own gate where that is not the one of the row.
std::string outcome(const Claim& measured, const Claim& row) {
  std::string text = measured_text(measured);
  if (gate_text(measured) != gate_text(row)) text += fmt::format(" ({})", gate_text(measured));
  return measured.holds() ? text : fmt::format("**{}, fails**", text);
}

std::string claims_table(const CaseRecords& records) {
  std::string header = "| | gate |", rule = "|---|---|", rows;
  for (const VerifyRecord* record : records) {
    header += fmt::format(" `{}` |", word_of(record->method));
    rule += "---:|";
  }
  for (const Claim* claim : all_claims(records)) {
    rows += fmt::format("| {} | {} |", cell(claim->what), gate_text(*claim));
    for (const VerifyRecord* record : records) {
      const Claim* measured = find_claim(*record, claim->what);
      rows += measured ? fmt::format(" {} |", outcome(*measured, *claim)) : " |";
    }
    rows += "\n";
  }
  return header + "\n" + rule + "\n" + rows;
}

/// Each remark once, under the methods that make it.
std::string remarks(const CaseRecords& records) {
  std::string text;
  std::set<std::string> written;
  const auto makes = [](const VerifyRecord* record, const std::string& remark) {
    return std::ranges::count(record->verdict.remarks, remark) > 0;
  };
  for (const VerifyRecord* record : records)
    for (const std::string& remark : record->verdict.remarks) {
      if (!written.insert(remark).second) continue;
      std::vector<std::string> methods;
      for (const VerifyRecord* other : records)
        if (makes(other, remark)) methods.push_back(fmt::format("`{}`", word_of(other->method)));
      text += fmt::format("\n{}: {}\n", fmt::join(methods, ", "), remark);
    }
  return text;
}

std::string section(const CaseRecords& records) {
  const Verification& verification = verification_of(*records.front());
  std::string text = fmt::format("\n## {}\n\n{}. Expected: {}.\n\n{}", verification.name,
                                 verification.title, verification.reference, claims_table(records));
  if (!verification.others.empty())
    text += fmt::format("\nOther codes: {}.\n", verification.others);
  for (const VerifyRecord* record : records)
    for (const std::string& picture : record->pictures)
      text += fmt::format("\n![{} by method {}](./{})\n", verification.title,
                          word_of(record->method), picture);
  for (const VerifyRecord* record : records)
    if (!record->failure.empty())
      text += fmt::format("\n`{}` failed: {}\n", word_of(record->method), record->failure);
  return text + remarks(records);
}

}  // namespace

std::string validation_markdown(const std::vector<VerifyRecord>& records) {
  std::string text = fmt::format(
      "# Verification and validation\n\nWritten by `sabo verify` on {}. {} of {} cases pass, each "
      "method counted.\n\n{}\n{}",
      fmt::join(machines(records), ", "), std::ranges::count_if(records, &VerifyRecord::holds),
      records.size(), legend, overview(records));
  for (const Verification& verification : verifications()) {
    CaseRecords of_case;
    for (const VerifyRecord& record : records)
      if (record.name == verification.name) of_case.push_back(&record);
    if (!of_case.empty()) text += section(of_case);
  }
  return text;
}

}  // namespace sabo
