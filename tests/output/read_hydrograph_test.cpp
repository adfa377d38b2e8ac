#include "io/output/read_hydrograph.hpp"

#include <cmath>
#include <string>

#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace sabo {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Hydrograph hydrograph_of(const std::string& text) {
  return parse_hydrograph(text, "inflow[1].hydrograph", "q.csv");
}

TEST(ReadHydrograph, TakesColumnsInAnyOrderWithOrWithoutUnits) {
  const Hydrograph h = hydrograph_of(
      "\xEF\xBB\xBF"
      "Discharge [m3/s], time\r\n0,0\r\n\r\n 2.5 ,10\r\n");
  EXPECT_THAT(h.time, ElementsAre(0, 10));
  EXPECT_THAT(h.discharge, ElementsAre(0, 2.5));
  EXPECT_TRUE(h.speed.empty());
  EXPECT_THAT(hydrograph_of("time [s],discharge [m3/s],speed [m/s]\n0,0,0\n1,2,3").speed,
              ElementsAre(0, 3));  // the last line needs no end
}

TEST(ReadHydrograph, SaysWhatIsWrongAndWhere) {
  const struct {
    const char* text;
    const char* message;
  } cases[] = {{"", "q.csv is empty"},
               {"time,discharge\n", "has 0 rows"},
               {"time,discharge\n0,1\n", "has 1 row"},
               {"0,1\n1,2\n", "line 1: \"0\" is not a column of a hydrograph"},
               {"time,flow\n", "\"flow\" is not a column"},
               {"time,speed\n0,1\n", "has no column discharge"},
               {"time,time\n", "two columns of time"},
               {"time,discharge\n0,1\n1,2,3\n", "line 3: has 3 fields instead of 2"},
               {"time,discharge\n0,1\n0,2\n", "line 3: time 0 s is not after 0 s"},
               {"time,discharge\n0,1\n1,-2\n", "line 3: discharge -2 is out of range"},
               {"time,discharge\n0,nan\n", "discharge \"nan\" is no number"},
               {"time,discharge\n0,1e99\n", "out of range"},
               {"time,discharge\n0,1 m3\n", "\"1 m3\" is no number"},
               {"time;discharge\n0;1\n", "is not a column"},
               {"time,discharge\n0,\"1\n", "a quote that stays open"},
               {"time,discharge\n0,0\n1,0\n", "has no discharge"},
               {"time,discharge,speed\n0,0,0\n1,2,0\n", "a discharge of 2 m3/s has no speed"}};
  for (const auto& [text, message] : cases) {
    const std::string fault = to_string(fault_of([text = text] { hydrograph_of(text); }));
    EXPECT_THAT(fault, HasSubstr("inflow[1].hydrograph")) << text;
    EXPECT_THAT(fault, HasSubstr(message)) << text;
  }
}

RC_GTEST_PROP(ReadHydrograph, TakesOrRefusesAnyText, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("0123456789.,-eE+\"\n\r\t naifmtdscp[]/")));
  for (const std::string& all :
       {text, "time,discharge\n" + text, "time,discharge,speed\n0,1,1\n" + text}) {
    try {
      const Hydrograph h = hydrograph_of(all);
      RC_ASSERT(h.volume() > 0 && std::isfinite(h.volume()));
    } catch (const CaseError&) {
    }
  }
}

}  // namespace
}  // namespace sabo
