#include <cmath>

#include "report/report_parts.hpp"

namespace sabo {
namespace {

/// Finished, stopped, failed or still going: what a reader must know before any number.
void tell_end(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const std::string end = run.text("run", "end");
  const std::string reason = run.text("run", "reason");
  const double reached = run.number("run", "simulated_s").value_or(0);
  if (end == "finished") {
    if (!reason.empty()) page.notice(Tone::plain, say("end.early"), reason);
  } else if (end == "interrupted") {
    page.notice(Tone::alarm, say("end.interrupted"),
                say("end.interrupted_means", fixed(reached, 1)));
  } else if (end == "failed") {
    page.notice(Tone::alarm, say("end.failed"), say("end.failed_means", reason));
  } else {
    page.notice(Tone::alarm, say("end.running"), say("end.running_means"));
  }
  if (end == "finished" && run.number("motion", "moving_volume") &&
      !run.is_true("motion", "at_rest"))
    page.notice(
        Tone::caution, say("end.moving"),
        say("end.moving_means", amount(*run.number("motion", "moving_volume")), fixed(reached, 1)));
}

void tell_if_coarse(Report& report) {
  const auto median = report.run.number("resolution", "median_layers");
  if (median && report.run.number("resolution", "wet_area").value_or(0) > 0)
    tell_resolution(report, *median, false);
}

/// Of the release and of what came through inflows, m3.
std::optional<double> released_volume(const Report& report) {
  const std::vector<TomlTable> volumes = report.run.list("volumes");
  return volumes.empty() ? report.run.number("release", "volume")
                         : number_at(volumes.front(), "released");
}

std::string sentence_of_volume(const Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const auto volume = run.number("release", "volume");
  if (!volume) return "";
  if (!run.list("inflow").empty())
    return say("summary.inflow", amount(released_volume(report).value_or(0)),
               fixed(run.number("run", "simulated_s").value_or(0), 1));
  return say("summary.volume", amount(*volume), amount(run.number("release", "area").value_or(0)),
             fixed(run.number("run", "simulated_s").value_or(0), 1));
}

std::string sentence_of_front(const Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const auto distance = run.quantity("front run-out [m]");
  const auto speed = run.quantity("peak front speed [m/s]");
  return distance && speed ? say("summary.front", amount(*distance), fixed(*speed, 1)) : "";
}

/// One for each dam.
std::string sentences_of_dams(const Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  std::string text;
  for (const TomlTable& row : run.list("volumes")) {
    const auto dam = text_at(row, "dam");
    const auto trapped = number_at(row, "trapped"), beyond = number_at(row, "beyond");
    const auto released = number_at(row, "released");
    if (!dam || !trapped || !beyond || !released) continue;
    const auto arrival = run.quantity("arrival at " + *dam + " [s]");
    text += arrival ? say("summary.arrival", *dam, fixed(*arrival, 1))
                    : say("summary.no_arrival", *dam);
    text += say("summary.trapped", amount(*trapped),
                percent(*released > 0 ? *trapped / *released : 0), amount(*beyond), *dam);
  }
  return text;
}

struct SectionPeak {
  std::string section;
  Peak peak;
};

std::optional<SectionPeak> greatest_discharge(Report& report) {
  std::optional<SectionPeak> greatest;
  const NumberTable* table = report.run.series("discharge.csv");
  if (!table) return greatest;
  for (const std::string& section : names_before(*table, " net discharge [m3/s]")) {
    const auto peak = peak_of(*table, section + " net discharge [m3/s]");
    if (peak && (!greatest || std::abs(peak->value) > std::abs(greatest->peak.value)))
      greatest = SectionPeak{section, *peak};
  }
  return greatest;
}

struct GreatestLoad {
  std::string body;
  double force = 0;  ///< N
  double time = 0;   ///< s
};

std::optional<GreatestLoad> greatest_load(const Report& report) {
  std::optional<GreatestLoad> greatest;
  for (const TomlTable& load : report.run.list("load")) {
    const auto force = number_at(load, "peak_force");
    if (!force || (greatest && *force <= greatest->force)) continue;
    greatest = GreatestLoad{text_at(load, "name").value_or(""), *force,
                            number_at(load, "peak_time").value_or(0)};
  }
  return greatest;
}

void tell_numbers(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  std::vector<std::pair<std::string, std::string>> pairs;
  const auto add = [&](const std::string& label, const std::optional<double>& value,
                       const std::string& unit) {
    if (value) pairs.emplace_back(label, amount(*value) + " " + unit);
  };
  add(say("number.released"), released_volume(report), "m³");
  add(say("number.runout"), run.quantity("front run-out [m]"), "m");
  add(say("number.front_speed"), run.quantity("peak front speed [m/s]"), "m/s");
  add(say("number.affected"), run.number("resolution", "wet_area"), "m²");
  if (const auto discharge = greatest_discharge(report))
    add(say("number.discharge", discharge->section), std::abs(discharge->peak.value), "m³/s");
  for (const TomlTable& row : run.list("volumes")) {
    const auto dam = text_at(row, "dam");
    if (!dam) continue;
    add(say("number.arrival", *dam), run.quantity("arrival at " + *dam + " [s]"), "s");
    add(say("number.trapped", *dam), number_at(row, "trapped"), "m³");
    add(say("number.beyond", *dam), number_at(row, "beyond"), "m³");
  }
  if (const auto load = greatest_load(report))
    add(say("number.load", load->body), load->force / 1000, "kN");
  page.numbers(pairs);
}

}  // namespace

void add_summary(Report& report) {
  const auto& [run, other, say, page, sharpness] = report;
  const std::string started = run.text("run", "started");
  const std::string version = run.text("run", "version");
  page.title(say("page.kind"), title_of(run),
             say("page.subtitle", started.empty() ? "–" : started.substr(0, 10),
                 version.empty() ? "–" : version));
  if (const std::string note = run.written("", "note"); !note.empty())
    page.notice(Tone::caution, say("page.note"), note);
  tell_end(report);
  tell_if_coarse(report);

  std::string text = say("summary.what") + sentence_of_volume(report) + sentence_of_front(report) +
                     sentences_of_dams(report);
  if (const auto discharge = greatest_discharge(report))
    text += say("summary.discharge", amount(std::abs(discharge->peak.value)), discharge->section,
                fixed(discharge->peak.time, 1));
  if (const auto load = greatest_load(report))
    text += say("summary.load", load->body, amount(load->force / 1000), fixed(load->time, 1));
  page.text(text, true);
  tell_numbers(report);
  page.source(data_line(report, {"manifest.toml", "series/discharge.csv"}));
  page.contents();
}

}  // namespace sabo
