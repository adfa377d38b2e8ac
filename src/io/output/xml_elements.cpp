#include "io/output/xml_elements.hpp"

#include <algorithm>
#include <array>

namespace sabo {
namespace {

constexpr std::string_view declaration = "<?xml version=\"1.0\"?>\n";
constexpr std::string_view white = " \t\r\n";

std::string_view trimmed_front(std::string_view text) {
  const std::size_t first = text.find_first_not_of(white);
  return first == text.npos ? std::string_view() : text.substr(first);
}

// Takes what stands before `mark` off the front, the mark too; nothing without a mark.
std::optional<std::string_view> take_until(std::string_view& text, char mark) {
  const std::size_t end = text.find(mark);
  if (end == text.npos) return {};
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end + 1);
  return taken;
}

// The inside of a tag: its name and its attributes.
bool read_tag(std::string_view inside, XmlTag& tag) {
  if (!inside.empty() && inside.back() == '/') inside.remove_suffix(1);
  const std::size_t end_of_name = std::min(inside.find_first_of(white), inside.size());
  tag.name = inside.substr(0, end_of_name);
  if (tag.name.empty()) return false;
  inside = trimmed_front(inside.substr(end_of_name));
  while (!inside.empty()) {
    const auto name = take_until(inside, '=');
    if (!name || name->empty() || inside.empty() || inside.front() != '"') return false;
    inside.remove_prefix(1);
    const auto value = take_until(inside, '"');
    if (!value) return false;
    tag.attributes.emplace_back(*name, *value);
    inside = trimmed_front(inside);
  }
  return true;
}

}  // namespace

std::optional<std::string> XmlTag::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes) {
    if (key == wanted) return unescaped(value);
  }
  return {};
}

std::optional<std::vector<XmlTag>> xml_tags(std::string_view text) {
  if (!text.starts_with(declaration)) return {};
  text.remove_prefix(declaration.size());
  std::vector<XmlTag> tags;
  while (!text.empty()) {
    if (text.front() != '<') return {};
    text.remove_prefix(1);
    const auto inside = take_until(text, '>');
    XmlTag tag;
    if (!inside || inside->find('<') != inside->npos || !read_tag(*inside, tag)) return {};
    tag.text = text.substr(0, text.find('<'));
    text.remove_prefix(tag.text.size());
    tags.push_back(std::move(tag));
  }
  return tags;
}

std::string unescaped(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> escapes{
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}}};
  std::string out;
  while (!text.empty()) {
    std::size_t taken = 1;
    char character = text.front();
    for (const auto& [escape, meaning] : escapes) {
      if (!text.starts_with(escape)) continue;
      taken = escape.size();
      character = meaning;
    }
    out += character;
    text.remove_prefix(taken);
  }
  return out;
}

}  // namespace sabo
