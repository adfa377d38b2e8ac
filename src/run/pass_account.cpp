#include "run/pass_account.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/counted.hpp"
#include "io/case_file/toml_string.hpp"

namespace sabo {

std::vector<PassShare> pass_shares(const PassTimes& times, double wall) {
  const auto share = [&](double seconds) { return wall > 0 ? seconds / wall : 0; };
  std::vector<PassShare> shares;
  for (const PassTime& pass : times.passes()) {
    const double rate = pass.seconds > 0 ? static_cast<double>(pass.pairs) / pass.seconds : 0;
    shares.push_back({pass.name, pass.seconds, share(pass.seconds), pass.calls, rate});
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const PassShare& a, const PassShare& b) { return a.seconds > b.seconds; });
  const double rest = std::max(0.0, wall - times.seconds());
  shares.push_back({"everything else", rest, share(rest), 0, 0});
  return shares;
}

std::string passes_toml(const std::vector<PassShare>& shares) {
  std::string text;
  for (const PassShare& pass : shares)
    text += fmt::format(
        "\n[[passes]]\nname = {}\nseconds = {:.4g}\nshare = {:.4f}\ncalls = {}\n"
        "pairs_per_s = {:.4g}\n",
        toml_string(pass.name), pass.seconds, pass.share, pass.calls, pass.pair_rate);
  return text;
}

PageTable pass_table(const std::vector<PassShare>& shares) {
  PageTable table;
  table.caption = "Where the computing time went";
  table.header = {"pass", "time [s]", "share [%]", "calls", "million pairs/s"};
  for (const PassShare& pass : shares)
    table.rows.push_back({pass.name, fmt::format("{:.2f}", pass.seconds),
                          fmt::format("{:.1f}", 100 * pass.share),
                          pass.calls > 0 ? fmt::format("{}", pass.calls) : "-",
                          pass.pair_rate > 0 ? fmt::format("{:.1f}", 1e-6 * pass.pair_rate) : "-"});
  return table;
}

std::string solver_toml(const SolverTotals& totals) {
  return fmt::format(
      "\n[solver]\nmean_dt = {:.5g}\nmean_iterations = {:.4g}\nsteps_per_second = {:.5g}\n",
      totals.mean_dt(), totals.mean_iterations(), totals.steps_per_second());
}

std::string solver_text(const SolverTotals& totals) {
  const double rate = totals.steps_per_second();
  std::string text =
      fmt::format("{} of {:.3g} ms in the mean, {:.{}f} steps/s", counted(totals.steps, "step"),
                  1e3 * totals.mean_dt(), rate, rate < 10 ? 2 : 0);
  if (totals.iterations > 0)
    text +=
        fmt::format(", {:.1f} iterations of the viscous solve a step", totals.mean_iterations());
  return text;
}

}  // namespace sabo
