#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sabo {

/// A table; columns after the first are numbers and stand to the right.
struct PageTable {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// A figure of one picture or several, one below the other.
struct PagePicture {
  std::vector<std::string> files;  ///< relative to the page
  std::string caption;
  bool is_wide = false;  ///< takes the whole width, a map for instance
};

struct PageFile {
  std::string path;  ///< relative to the page
  std::string what;  ///< one line
};

/// The front page of a run folder. All texts are plain; they are escaped when written.
struct IndexPage {
  std::string title = {};
  std::string subtitle = {};
  std::string note = {};  ///< set apart at the top, e.g. "generated terrain"; "" for none
  std::vector<std::pair<std::string, std::string>> facts = {};
  std::vector<PageTable> tables = {};
  std::vector<PagePicture> pictures = {};
  int columns = 2;                      ///< of pictures on a wide screen
  std::vector<PageTable> details = {};  ///< below the pictures
  std::vector<PageFile> files = {};
  std::string remarks = {};  ///< below the tables: how to read them
  std::string warning = {};  ///< below the note: why not to trust the results; "" for none
};

/// One HTML file without scripts that needs nothing but the pictures beside it.
std::string index_html(const IndexPage& page);

}  // namespace sabo
