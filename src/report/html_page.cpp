#include "report/html_page.hpp"

#include <span>
#include <string_view>

#include "report/embedded.hpp"
#include <fmt/format.h>

#include "io/output/base64.hpp"
#include "io/output/json.hpp"
#include "io/output/markup.hpp"

namespace sabo {
namespace {

constexpr const char* class_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return " good";
    case Tone::caution:
      return " caution";
    case Tone::alarm:
      return " alarm";
    case Tone::plain:
      break;
  }
  return "";
}

std::string cells_html(const std::vector<std::string>& cells, const char* element,
                       const char* attribute = "") {
  std::string html = "<tr>";
  for (const std::string& cell : cells)
    html += fmt::format("<{0}{1}>{2}</{0}>", element, attribute, escaped(cell));
  return html + "</tr>\n";
}

std::string numbers_json(const std::vector<double>& values) {
  std::string json = "[";
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) json += ',';
    json += json_number(values[k]);
  }
  return json + ']';
}

std::string dashes_json(std::string_view dashes) {
  std::string json(dashes);
  for (char& c : json)
    if (c == ' ') c = ',';
  return fmt::format("[{}]", json);
}

std::string series_json(const LineChart& chart, std::size_t k) {
  const ChartSeries& series = chart.series[k];
  const ChartStyle style = chart_style(chart, k);
  return fmt::format(
      "{{\"name\":{},\"colour\":\"{}\",\"dash\":{},\"hasLine\":{},\"hasMarkers\":{},\"x\":{},\"y\":"
      "{}}}",
      json_string(series.name.empty() ? chart.y_title : series.name), style.colour,
      dashes_json(style.dashes), series.has_line, series.has_markers, numbers_json(series.x),
      numbers_json(series.y));
}

std::string chart_json(const LineChart& chart) {
  std::string series, references, marks;
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    if (k > 0) series += ',';
    series += series_json(chart, k);
  }
  for (const ChartReference& line : chart.references)
    references += fmt::format("{}{{\"y\":{},\"label\":{}}}", references.empty() ? "" : ",",
                              json_number(line.y), json_string(line.label));
  for (const ChartMark& mark : chart.marks)
    marks += fmt::format("{}{{\"x\":{},\"label\":{},\"low\":{},\"high\":{}}}",
                         marks.empty() ? "" : ",", json_number(mark.x), json_string(mark.label),
                         mark.low ? json_number(*mark.low) : "null",
                         mark.high ? json_number(*mark.high) : "null");
  return fmt::format(
      "{{\"title\":{},\"x\":{},\"y\":{},\"hasZero\":{},\"series\":[{}],\"references\":[{}],"
      "\"marks\":[{}]}}",
      json_string(chart.title), json_string(chart.x_title), json_string(chart.y_title),
      chart.has_zero, series, references, marks);
}

std::string source_html(const std::string& text) {
  return text.empty() ? "" : fmt::format("<p class=\"source\">{}</p>", escaped(text));
}

}  // namespace

void HtmlPage::title(const std::string& kind, const std::string& title,
                     const std::string& subtitle) {
  body_ += fmt::format("<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p class=\"subtitle\">{}</p>\n",
                       escaped(kind), escaped(title), escaped(subtitle));
}

void HtmlPage::section(const std::string& title) {
  sections_.push_back(title);
  body_ += fmt::format("<h2 id=\"s{0}\">{0}. {1}</h2>\n", sections_.size(), escaped(title));
}

void HtmlPage::heading(const std::string& title) {
  body_ += fmt::format("<h3>{}</h3>\n", escaped(title));
}

void HtmlPage::text(const std::string& text, bool is_lead) {
  body_ += fmt::format("<p{}>{}</p>\n", is_lead ? " class=\"lead\"" : "", escaped(text));
}

void HtmlPage::source(const std::string& text) { body_ += source_html(text) + "\n"; }

void HtmlPage::notice(Tone tone, const std::string& strong, const std::string& text) {
  body_ += fmt::format("<div class=\"notice{}\"><strong>{}</strong> {}</div>\n", class_of(tone),
                       escaped(strong), escaped(text));
}

void HtmlPage::numbers(const std::vector<std::pair<std::string, std::string>>& pairs) {
  if (pairs.empty()) return;
  body_ += "<dl class=\"numbers\">\n";
  for (const auto& [label, value] : pairs)
    body_ += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(label), escaped(value));
  body_ += "</dl>\n";
}

void HtmlPage::list(const std::vector<std::string>& items) {
  body_ += "<ul class=\"plain\">\n";
  for (const std::string& item : items) body_ += fmt::format("<li>{}</li>\n", escaped(item));
  body_ += "</ul>\n";
}

void HtmlPage::table(const ReportTable& table) {
  if (table.rows.empty()) return;
  const bool is_short = table.rows.size() <= 12;
  body_ += fmt::format("<div class=\"scroll{}{}\"><table>\n", table.is_of_words ? " words" : "",
                       is_short ? " short" : "");
  if (!table.caption.empty())
    body_ += fmt::format("<caption>{}</caption>\n", escaped(table.caption));
  if (!table.header.empty())
    body_ += fmt::format("<thead>{}</thead>\n", cells_html(table.header, "th", " scope=\"col\""));
  body_ += "<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) body_ += cells_html(row, "td");
  body_ += "</tbody></table>" + source_html(table.source) + "</div>\n";
}

void HtmlPage::chart(LineChart chart, const std::string& source) {
  chart.id = new_id();
  chart.has_dashes = true;
  chart.height = 280;  // three stand on a page of A4
  body_ += fmt::format(
      "<figure class=\"chart\">\n{}<script type=\"application/json\">{}</script>\n"
      "<figcaption>{}</figcaption></figure>\n",
      chart_svg(chart), chart_json(chart), source_html(source));
}

void HtmlPage::picture(const std::string& svg, const std::string& source) {
  body_ +=
      fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", svg, source_html(source));
}

void HtmlPage::foreign_picture(const std::string& svg, const std::string& name) {
  body_ += fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/svg+xml;base64,{1}\"><figcaption>{2}"
      "</figcaption></figure>\n",
      escaped(name), base64_of(std::as_bytes(std::span(svg))), source_html(name));
}

void HtmlPage::key(const std::vector<std::pair<MapLine::Kind, std::string>>& entries) {
  if (entries.empty()) return;
  body_ += "<ul class=\"key\">\n";
  for (const auto& [kind, label] : entries) {
    const LineStyle style = style_of(kind);
    body_ += fmt::format(
        "<li><svg viewBox=\"0 0 30 10\" aria-hidden=\"true\"><line x1=\"0\" y1=\"5\" x2=\"30\" "
        "y2=\"5\" stroke=\"{}\" stroke-width=\"{}\"{}/></svg>{}</li>\n",
        style.colour, style.width, style.dashes, escaped(label));
  }
  body_ += "</ul>\n";
}

std::string HtmlPage::new_id() { return fmt::format("f{}-", ++ids_); }

std::string HtmlPage::contents_html() const {
  std::string html = "<nav><ol>\n";
  for (std::size_t k = 0; k < sections_.size(); ++k)
    html += fmt::format("<li><a href=\"#s{}\">{}</a></li>\n", k + 1, escaped(sections_[k]));
  return html + "</ol></nav>\n";
}

std::string HtmlPage::html(const PageFrame& frame) const {
  std::string body = body_;
  if (const std::size_t mark = body.find(contents_mark); mark != body.npos)
    body.replace(mark, 1, contents_html());
  return fmt::format(
      "<!doctype html>\n<html lang=\"{0}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'; script-src 'sha256-{1}'; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{2}</title>\n<style>{3}</style>\n</head>\n<body>\n<main>\n{4}<footer>{5}</footer>\n"
      "</main>\n<script>{6}</script>\n</body>\n</html>\n",
      frame.language, report_script_hash(), escaped(frame.title), report_style(), body,
      escaped(frame.footer), report_script());
}

}  // namespace sabo
