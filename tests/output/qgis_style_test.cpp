#include "io/output/qgis_style.hpp"

#include <memory>

#include <cpl_minixml.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/xml_elements.hpp"

namespace sabo {
namespace {

using XmlPtr = std::unique_ptr<CPLXMLNode, decltype(&CPLDestroyXMLNode)>;

/// The document, whose root is where QGIS looks for it; well-formed, or the test fails.
XmlPtr parsed(const std::string& style) {
  XmlPtr tree(CPLParseXMLString(style.c_str()), &CPLDestroyXMLNode);
  EXPECT_TRUE(tree) << style;
  return tree;
}

std::string value(const XmlPtr& tree, const char* path) {
  return CPLGetXMLValue(tree.get(), path, "missing");
}

std::vector<const CPLXMLNode*> items(const XmlPtr& tree, const char* path, const char* name) {
  std::vector<const CPLXMLNode*> list;
  const CPLXMLNode* above = CPLGetXMLNode(tree.get(), path);
  for (const CPLXMLNode* node = above ? above->psChild : nullptr; node; node = node->psNext)
    if (node->eType == CXT_Element && std::string(node->pszValue) == name) list.push_back(node);
  return list;
}

TEST(QgisStyle, FlowHasTheColoursOfThePictures) {
  const XmlPtr tree = parsed(qgis_flow_style("depth <m> & \"more\"", 0.05, 4));
  EXPECT_EQ(value(tree, "=qgis.pipe.rasterrenderer.type"), "singlebandpseudocolor");
  EXPECT_EQ(value(tree, "=qgis.pipe.rasterrenderer.band"), "1");
  const char* shader = "=qgis.pipe.rasterrenderer.rastershader.colorrampshader";
  EXPECT_EQ(value(tree, (std::string(shader) + ".colorRampType").c_str()), "INTERPOLATED");
  const auto ramp = items(tree, shader, "item");
  ASSERT_EQ(ramp.size(), 9u);
  EXPECT_STREQ(CPLGetXMLValue(ramp[4], "value", ""), "2");
  EXPECT_EQ(CPLGetXMLValue(ramp[4], "color", ""), hex(flow_colour(0.5)));
  EXPECT_STREQ(CPLGetXMLValue(ramp[0], "label", ""), "0 depth <m> & \"more\"");
  EXPECT_EQ(value(tree,
                  "=qgis.pipe.rasterrenderer.rasterTransparency.singleValuePixelList."
                  "pixelListEntry.max"),
            "0.05");
}

TEST(QgisStyle, StepsEndWhereTheNextBegins) {
  const auto steps = difference_steps(2);
  const XmlPtr tree = parsed(qgis_step_style("change [m]", steps));
  const auto ramp = items(tree, "=qgis.pipe.rasterrenderer.rastershader.colorrampshader", "item");
  ASSERT_EQ(ramp.size(), 7u);
  EXPECT_STREQ(CPLGetXMLValue(ramp[0], "value", ""), "-2");
  EXPECT_STREQ(CPLGetXMLValue(ramp[3], "value", ""), "0.2");
  EXPECT_STREQ(CPLGetXMLValue(ramp[6], "value", ""), "inf");
  EXPECT_EQ(CPLGetXMLValue(ramp[6], "color", ""), hex(step_colour(steps, 2.5)));
}

TEST(QgisStyle, ClassesHaveAnEntryEach) {
  const XmlPtr tree = parsed(qgis_class_style({{2, "a > b", {255, 0, 16}}, {1, "b", {}}}));
  EXPECT_EQ(value(tree, "=qgis.pipe.rasterrenderer.type"), "paletted");
  const auto entries = items(tree, "=qgis.pipe.rasterrenderer.colorPalette", "paletteEntry");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_STREQ(CPLGetXMLValue(entries[0], "value", ""), "2");
  EXPECT_STREQ(CPLGetXMLValue(entries[0], "color", ""), "#ff0010");
  EXPECT_STREQ(CPLGetXMLValue(entries[0], "label", ""), "a > b");
}

TEST(QgisStyle, GroundIsAHillshade) {
  EXPECT_EQ(value(parsed(qgis_ground_style()), "=qgis.pipe.rasterrenderer.type"), "hillshade");
}

TEST(DifferenceSteps, AreSymmetricAboutZero) {
  const auto steps = difference_steps(1);
  for (const double size : {0.05, 0.2, 0.5, 3.0}) {
    std::size_t up = 0, down = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (steps[k].colour == step_colour(steps, size)) up = k;
      if (steps[k].colour == step_colour(steps, -size)) down = k;
    }
    EXPECT_EQ(up + down, 6u) << size;
  }
}

TEST(ColourText, IsReadBack) {
  EXPECT_EQ(colour_of(hex({1, 171, 255})), (Colour{1, 171, 255}));
  for (const char* wrong : {"", "#12345", "1234567", "#12345g", "#-1-1-1"})
    EXPECT_FALSE(colour_of(wrong)) << wrong;
}

}  // namespace
}  // namespace sabo
