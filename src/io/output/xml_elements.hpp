#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sabo {

/// One tag of an XML text. The views are of that text.
struct XmlTag {
  std::string_view name;  ///< with a leading "/" where it closes an element
  std::vector<std::pair<std::string_view, std::string_view>> attributes;  ///< as written
  std::string_view text;  ///< between this tag and the next one

  /// Value of an attribute with its escapes undone; nothing if the tag has none of that name.
  std::optional<std::string> attribute(std::string_view wanted) const;
};

/// The tags of a text in their order, in the form in which this folder writes them: a declaration,
/// attributes in double quotes, no comments. Nothing when the text has another form.
std::optional<std::vector<XmlTag>> xml_tags(std::string_view text);

/// Undoes escaped().
std::string unescaped(std::string_view text);

}  // namespace sabo
