#include "io/output/index_page.hpp"

#include <fmt/format.h>

#include "io/output/markup.hpp"
#include "io/output/svg.hpp"

namespace sabo {
namespace {

constexpr const char* style = R"(
  * { box-sizing: border-box; }
  body { margin: 0; background: #f5f7fa; color: #1f2933; line-height: 1.5; font-size: 16px; }
  main { max-width: 1180px; margin: 0 auto; padding: 40px 24px 64px; }
  h1 { margin: 0; font-size: 30px; line-height: 1.2; }
  h2 { margin: 40px 0 12px; font-size: 20px; }
  .subtitle { margin: 6px 0 0; color: #52606d; }
  .note { margin: 20px 0 0; padding: 10px 16px; border-left: 4px solid #e69f00;
    background: #fff8e6; border-radius: 4px; }
  .facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(220px, 1fr));
    gap: 1px; margin: 24px 0 0; border: 1px solid #e4e7eb; border-radius: 8px; overflow: hidden;
    background: #ffffff; }
  .facts div { padding: 12px 16px; box-shadow: 1px 1px 0 #e4e7eb; }
  .facts dt { font-size: 13px; color: #52606d; }
  .facts dd { margin: 2px 0 0; font-weight: 600; overflow-wrap: anywhere; }
  .card { background: #ffffff; border: 1px solid #e4e7eb; border-radius: 8px; overflow-x: auto; }
  table { width: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums; }
  th, td { padding: 9px 16px; text-align: right; border-top: 1px solid #e4e7eb; }
  th:first-child, td:first-child, .files td { text-align: left; }
  thead th { border-top: 0; font-size: 13px; font-weight: 600; color: #52606d; }
  .pictures { display: grid; gap: 16px; }
  .wide { grid-column: 1 / -1; }
  figure { margin: 0; padding: 12px; }
  figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; }
  figure a + a img { margin-top: 12px; }
  figcaption { margin-top: 8px; padding: 0 8px; font-size: 14px; color: #52606d; }
  a { color: #0b5cad; }
  @media (max-width: 800px) { .pictures { display: block; } figure { margin-bottom: 16px; } }
  @media print {
    body { background: #ffffff; font-size: 11pt; }
    main { max-width: none; padding: 0; }
    figure, table, .facts { break-inside: avoid; }
    h2 { break-after: avoid; }
  }
)";

std::string facts_html(const IndexPage& page) {
  if (page.facts.empty()) return "";
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [key, value] : page.facts) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(key), escaped(value));
  }
  return html + "</dl>\n";
}

std::string table_html(const PageTable& table) {
  std::string html =
      fmt::format("<h2>{}</h2>\n<div class=\"card\"><table>\n<thead><tr>", escaped(table.caption));
  for (const std::string& cell : table.header) {
    html += fmt::format("<th scope=\"col\">{}</th>", escaped(cell));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& cell : row) html += fmt::format("<td>{}</td>", escaped(cell));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string pictures_html(const IndexPage& page) {
  if (page.pictures.empty()) return "";
  std::string html = fmt::format(
      "<h2>Pictures</h2>\n<div class=\"pictures\" "
      "style=\"grid-template-columns: repeat({}, minmax(0, 1fr))\">\n",
      page.columns);
  for (const PagePicture& picture : page.pictures) {
    const std::string caption = escaped(picture.caption);
    html += fmt::format("<figure class=\"card{}\">", picture.is_wide ? " wide" : "");
    for (const std::string& file : picture.files) {
      html +=
          fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>", url_of(file), caption);
    }
    html += fmt::format("<figcaption>{}</figcaption></figure>\n", caption);
  }
  return html + "</div>\n";
}

std::string files_html(const IndexPage& page) {
  if (page.files.empty()) return "";
  std::string html = "<h2>Files</h2>\n<div class=\"card files\"><table><tbody>\n";
  for (const PageFile& file : page.files) {
    html += fmt::format("<tr><td><a href=\"{}\">{}</a></td><td>{}</td></tr>\n", url_of(file.path),
                        escaped(file.path), escaped(file.what));
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string index_html(const IndexPage& page) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n  body {{ font-family: {}; "
      "}}{}</style>\n</head>\n<body>\n<main>\n"
      "<h1>{}</h1>\n",
      escaped(page.title), svg_font, style, escaped(page.title));
  if (!page.subtitle.empty()) {
    html += fmt::format("<p class=\"subtitle\">{}</p>\n", escaped(page.subtitle));
  }
  if (!page.note.empty()) html += fmt::format("<p class=\"note\">{}</p>\n", escaped(page.note));
  if (!page.warning.empty())
    html += fmt::format("<p class=\"note\">Warning: {}</p>\n", escaped(page.warning));
  html += facts_html(page);
  for (const PageTable& table : page.tables) html += table_html(table);
  if (!page.remarks.empty())
    html += fmt::format("<p class=\"subtitle\">{}</p>\n", escaped(page.remarks));
  html += pictures_html(page);
  for (const PageTable& table : page.details) html += table_html(table);
  html += files_html(page);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace sabo
