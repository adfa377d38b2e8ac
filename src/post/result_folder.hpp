#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/output/index_page.hpp"

namespace sabo {

/// The folder of what is made of finished runs. A file result.toml says what it is, from which runs
/// and by which version.
class ResultFolder {
 public:
  /// Makes the folder; maps, pictures and tables of an earlier result of the same kind ("compare",
  /// "hazard", ...) are removed. Throws CaseError when it holds anything else, RunError when it
  /// cannot be made.
  ResultFolder(std::filesystem::path folder, const std::string& kind,
               const std::vector<std::filesystem::path>& runs);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path maps() const { return root_ / "maps"; }

  /// Writes a file; `name` is relative to the folder.
  void write(const std::string& name, const std::string& content) const;
  /// A line for the page of what a file holds.
  void list(const std::string& name, const std::string& what) { files_.push_back({name, what}); }
  /// Writes a table as CSV to tables/ and lists it.
  void write_table(const std::string& name, const PageTable& table);
  /// Writes a picture to pictures/ and keeps it for the page.
  void add_picture(const std::string& name, const std::string& svg, const std::string& caption,
                   bool is_wide);
  /// Writes index.html with the pictures and files so far; returns its path.
  std::filesystem::path write_page(IndexPage page);

 private:
  std::filesystem::path root_;
  std::vector<PagePicture> pictures_;
  std::vector<PageFile> files_;
};

}  // namespace sabo
