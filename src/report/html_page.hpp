#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/output/map_line.hpp"
#include "io/output/svg_chart.hpp"

namespace sabo {

/// A table of plain texts; columns after the first stand to the right.
struct ReportTable {
  std::string caption = {};
  std::vector<std::string> header = {};
  std::vector<std::vector<std::string>> rows = {};
  std::string source = {};   ///< where its numbers are found
  bool is_of_words = false;  ///< all columns stand to the left
};

enum class Tone { plain, good, caution, alarm };

/// What all pages of a language have in common.
struct PageFrame {
  std::string language = {};  ///< of HTML: "en"
  std::string title = {};     ///< of the window
  std::string footer = {};
};

/// One HTML file that needs nothing else: script, style and pictures are in it, and its security
/// policy forbids every request. All texts are plain; they are escaped here.
class HtmlPage {
 public:
  void title(const std::string& kind, const std::string& title, const std::string& subtitle);
  /// The contents stand here: a link to each section.
  void contents() { body_ += contents_mark; }
  void section(const std::string& title);
  void heading(const std::string& title);
  void text(const std::string& text, bool is_lead = false);
  void source(const std::string& text);
  void notice(Tone tone, const std::string& strong, const std::string& text);
  /// Labels with the numbers that matter most.
  void numbers(const std::vector<std::pair<std::string, std::string>>& pairs);
  void list(const std::vector<std::string>& items);
  void table(const ReportTable& table);
  /// Drawn, for paper, and as data that the script of the page shows with values.
  void chart(LineChart chart, const std::string& source);
  /// A picture of our own, put in as it is.
  void picture(const std::string& svg, const std::string& source);
  /// A picture from a file, whatever it holds: shown as an image, whose scripts do not run.
  void foreign_picture(const std::string& svg, const std::string& name);
  /// Names of the lines on maps.
  void key(const std::vector<std::pair<MapLine::Kind, std::string>>& entries);

  /// For ids within pictures: another one with each call.
  std::string new_id();

  std::string html(const PageFrame& frame) const;

 private:
  static constexpr const char* contents_mark = "\x01";  // no text holds it, see escaped()

  std::string contents_html() const;

  std::string body_;
  std::vector<std::string> sections_;
  int ids_ = 0;
};

}  // namespace sabo
