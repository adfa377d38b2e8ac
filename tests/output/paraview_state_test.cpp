#include "io/output/paraview_state.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "io/output/xml_elements.hpp"

namespace sabo {
namespace {

ParaviewState state(bool has_bodies) {
  return {"/runs/a & b/frames", has_bodies, 60, 3, {{10, 20, 5}, {110, 60, 15}}};
}

/// What every loader of states relies on: numbers given once, and no reference to one not given.
void expect_whole(const std::string& text) {
  const std::string document = "<?xml version=\"1.0\"?>\n" + text;
  const auto tags = xml_tags(document);
  ASSERT_TRUE(tags);
  std::set<std::string> objects, used;
  for (const XmlTag& tag : *tags) {
    if (tag.name == "Proxy" && tag.attribute("group"))
      EXPECT_TRUE(objects.insert(*tag.attribute("id")).second) << *tag.attribute("id");
    else if (tag.name == "Proxy")
      used.insert(*tag.attribute("value"));
    else if (tag.name == "Item" && tag.attribute("id"))
      used.insert(*tag.attribute("id"));
    else if (tag.name == "Item")
      used.insert(*tag.attribute("view"));
  }
  for (const std::string& id : used) EXPECT_TRUE(objects.contains(id)) << id;
  EXPECT_EQ(used, objects);  // and nothing lies about that is not shown or filed
}

TEST(ParaviewState, NamesEachObjectOnceAndNoOther) {
  expect_whole(paraview_state(state(true)));
  expect_whole(paraview_state(state(false)));
}

TEST(ParaviewState, ReadsTheFilesOfTheRun) {
  const std::string with = paraview_state(state(true)), without = paraview_state(state(false));
  for (const char* file : {"flow.pvd", "surface.pvd", "ground.vtp", "bodies.vtp"})
    EXPECT_NE(with.find(std::string("value=\"/runs/a &amp; b/frames/") + file), with.npos) << file;
  EXPECT_EQ(without.find("bodies.vtp"), without.npos);
}

TEST(ParaviewState, LooksAtTheMiddleOfTheFlowFromBesideIt) {
  const std::string text = paraview_state(state(false));
  // 100 m long along x: 120 m to the south and up.
  const auto element = [&](const std::string& property) {
    const std::size_t at = text.find("<Property name=\"" + property + "\"");
    return text.substr(at, text.find("</Property>", at) - at);
  };
  const std::string focus = element("CameraFocalPoint"), eye = element("CameraPosition");
  for (const char* part : {"index=\"0\" value=\"60\"", "index=\"1\" value=\"40\"", "value=\"10\""})
    EXPECT_NE(focus.find(part), focus.npos) << focus;
  for (const char* part : {"index=\"0\" value=\"60\"", "value=\"-80\"", "value=\"130\""})
    EXPECT_NE(eye.find(part), eye.npos) << eye;
}

}  // namespace
}  // namespace sabo
