#include "post/result_folder.hpp"

#include <array>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/case_file/text_check.hpp"
#include "io/case_file/toml_string.hpp"
#include "io/case_file/toml_tree.hpp"
#include "io/output/csv.hpp"
#include "io/output/file.hpp"
#include "io/output/read_file.hpp"
#include "run/own_folder.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = "result.toml";
constexpr std::array<const char*, 3> parts{"maps", "pictures", "tables"};

/// What the marker of a folder says it is; "" without one.
std::string kind_of(const fs::path& folder) {
  const auto text = read_file(folder / marker, largest_text);
  Faults faults;
  const auto root = text ? parse_toml(*text, marker, faults) : std::nullopt;
  return root ? text_at(table_at(*root, "result"), "kind").value_or("") : "";
}

std::string marker_text(const std::string& kind, const std::vector<fs::path>& runs) {
  std::string text = fmt::format("# Written by sabo.\n[result]\nkind = {}\nversion = {}\nruns = [",
                                 toml_string(kind), toml_string(build_version));
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::error_code error;
    text += (k > 0 ? ", " : "") + toml_string(fs::absolute(runs[k], error).lexically_normal());
  }
  return text + "]\n";
}

}  // namespace

ResultFolder::ResultFolder(fs::path folder, const std::string& kind,
                           const std::vector<fs::path>& runs)
    : root_(std::move(folder)) {
  std::error_code error;
  if (holds_own_files(
          root_, [&] { return kind_of(root_) == kind; }, "this command"))
    for (const char* part : parts) fs::remove_all(root_ / part, error);
  for (const char* part : parts) make_folder(root_ / part);
  write(marker, marker_text(kind, runs));
}

void ResultFolder::write(const std::string& name, const std::string& content) const {
  write_file_atomically(root_ / name, content);
}

void ResultFolder::write_table(const std::string& name, const PageTable& table) {
  std::string text = csv_line(table.header);
  for (const std::vector<std::string>& row : table.rows) text += csv_line(row);
  const std::string file = fmt::format("tables/{}", name);
  write(file, text);
  list(file, table.caption);
}

void ResultFolder::add_picture(const std::string& name, const std::string& svg,
                               const std::string& caption, bool is_wide) {
  const std::string file = "pictures/" + name;
  write(file, svg);
  pictures_.push_back({{file}, caption, is_wide});
}

fs::path ResultFolder::write_page(IndexPage page) {
  page.pictures = pictures_;
  page.files = files_;
  write("index.html", index_html(page));
  return root_ / "index.html";
}

}  // namespace sabo
