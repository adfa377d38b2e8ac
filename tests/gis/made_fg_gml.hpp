#pragma once

#include <filesystem>
#include <string>

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace sabo {

/// A tile of the GSI base map as GSI writes it, but small: 3 x 2 cells of 0.2 seconds, whose
/// north-west corner is at 45 N, 141 E.
struct MadeFgGml {
  std::string tuples =
      "地表面,1.25\n地表面,2.\n表層面,3\n海水面,-9999.\n内水面,-5.5\nその他,6.00\n";
  std::string start = "<gml:startPoint>0 0</gml:startPoint>";
  double south_cells = 2;  ///< southern edge, in cells south of 45 N
  double west_cells = 0;   ///< western edge, in cells east of 141 E
  double seconds = 0.2;    ///< cell size
  std::string srs = "fguuid:jgd2011.bl";
  std::string date = "2016-10-01";
  std::string order = "+x-y";
  std::string low = "0 0";
  std::string high = "2 1";
  int columns = 3;
  int rows = 2;

  std::string corners() const {
    const double cell = seconds / 3600;
    const double south = 45 - south_cells * cell;
    const double west = 141 + west_cells * cell;
    return fmt::format(
        "<gml:lowerCorner>{:.9f} {:.9f}</gml:lowerCorner>\n"
        "<gml:upperCorner>{:.9f} {:.9f}</gml:upperCorner>",
        south, west, south + rows * cell, west + columns * cell);
  }

  std::string text() const {
    return fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>
<Dataset xmlns:gml="http://www.opengis.net/gml/3.2" gml:id="Dataset1">
<gml:name>made by a test</gml:name>
<DEM gml:id="DEM001">
<lfSpanFr gml:id="DEM001-1"><gml:timePosition>{0}</gml:timePosition></lfSpanFr>
<devDate gml:id="DEM001-2"><gml:timePosition>{0}</gml:timePosition></devDate>
<mesh>68410000</mesh>
<coverage gml:id="DEM001-3">
<gml:boundedBy><gml:Envelope srsName="{1}">
{2}
</gml:Envelope></gml:boundedBy>
<gml:gridDomain><gml:Grid dimension="2" gml:id="DEM001-4"><gml:limits><gml:GridEnvelope>
<gml:low>{3}</gml:low>
<gml:high>{4}</gml:high>
</gml:GridEnvelope></gml:limits><gml:axisLabels>x y</gml:axisLabels></gml:Grid></gml:gridDomain>
<gml:rangeSet><gml:DataBlock>
<gml:tupleList>
{5}</gml:tupleList>
</gml:DataBlock></gml:rangeSet>
<gml:coverageFunction><gml:GridFunction>
<gml:sequenceRule order="{6}">Linear</gml:sequenceRule>
{7}
</gml:GridFunction></gml:coverageFunction>
</coverage>
</DEM>
</Dataset>
)",
        date, srs, corners(), low, high, tuples, order, start);
  }
};

/// Adds a file to a .zip, which is made when it is not there.
inline void write_into_zip(const std::filesystem::path& zip, const std::string& name,
                           const std::string& content) {
  const std::string path = "/vsizip/{" + zip.string() + "}/" + name;
  VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
  ASSERT_TRUE(file);
  EXPECT_EQ(VSIFWriteL(content.data(), 1, content.size(), file), content.size());
  EXPECT_EQ(VSIFCloseL(file), 0);
}

}  // namespace sabo
