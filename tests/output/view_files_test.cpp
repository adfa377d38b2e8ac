#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "io/output/base64.hpp"
#include "io/output/json.hpp"
#include "io/output/view_frame.hpp"
#include "io/output/view_scene.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
  const auto of = [](const std::string& text) { return base64_of(std::as_bytes(std::span(text))); };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(JsonString, EndsNoElementAndNoString) {
  EXPECT_EQ(json_string("</script><!-- \"\\ & '"),
            R"("\u003c/script\u003e\u003c!-- \"\\ \u0026 '")");
}

TEST(JsonString, KeepsUtf8AndReplacesWhatIsNot) {
  EXPECT_EQ(json_string("\xE6\xB2\xA2"), "\"\xE6\xB2\xA2\"");
  EXPECT_EQ(json_string("a\xFF\nb\xE2\x80\xA8"
                        "c"),
            "\"a\\ufffd b c\"");
}

RC_GTEST_PROP(JsonString, HasNothingThatEndsItWhateverTheText, (const std::string& text)) {
  const std::string made = json_string(text);
  RC_ASSERT(made.size() >= 2 && made.front() == '"' && made.back() == '"');
  RC_ASSERT(made.find_first_of("<>&\n\r", 0) == std::string::npos);
  std::size_t k = 1;
  while (made[k] != '"') k += made[k] == '\\' ? 2 : 1;
  RC_ASSERT(k == made.size() - 1);
}

TEST(Quantised, GoesFromTheLeastToTheGreatest) {
  EXPECT_EQ(quantised(-5, -5, 5), 0);
  EXPECT_EQ(quantised(5, -5, 5), 65535);
  EXPECT_EQ(quantised(0, -5, 5), 32768);
  EXPECT_EQ(quantised(7, 7, 7), 0);
}

TEST(ViewFrame, HoldsTwelveBytesForAParticle) {
  ViewFrame frame;
  frame.id = {0, 1};
  frame.values = {{{1, 3}, {2, 2}, {0, 1}, {0, 8}, {0, 4}, {-10, 10}}};
  // The first particle has the least of each kind (0), the second the greatest (FF FF), except for
  // y, where both are the same (0): 12 bytes 0, then FF FF 00 00 and eight times FF.
  EXPECT_EQ(view_frame_script(7, frame),
            "sabo_frame({\"number\":7,\"count\":2,\"low\":[1,2,0,0,0,-10],"
            "\"high\":[3,2,1,8,4,10],\"ids\":\"\",\n"
            "\"values\":\"AAAAAAAAAAAAAAAA//8AAP//////////\"});\n");
  EXPECT_EQ(view_bytes_per_particle, 12u);
}

TEST(ViewFrame, NamesItsParticlesWhereSomeHaveLeft) {
  ViewFrame frame;
  frame.id = {0, 2};
  for (auto& values : frame.values) values = {0, 0};
  EXPECT_THAT(view_frame_script(0, frame), HasSubstr("\"ids\":\"AAAAAAIAAAA=\""));
}

TEST(ViewFrame, WithoutParticlesIsAFrame) {
  EXPECT_THAT(view_frame_script(3, {}), HasSubstr("\"count\":0,\"low\":[0,0,0,0,0,0]"));
}

TEST(ViewScene, EscapesEveryNameAndMarksHoles) {
  ViewScene scene;
  scene.title = scene.note = scene.run = "</script>";
  scene.solids.push_back({"</script>", {}});
  scene.lines.push_back({MapLine::Kind::section, "</script>", {{{1, 2, 0}, {3, 4, 0}}, false}});
  scene.ground = Raster(Grid{.columns = 2, .rows = 2});
  scene.ground.values = {100, 102, Raster::no_data, 101};
  scene.frames = {{0, 0, 5}, {1, 2.5, 4}};
  const std::string script = view_scene_script(scene);
  EXPECT_THAT(script, Not(HasSubstr("<")));
  EXPECT_THAT(script, HasSubstr("\"frames\":[[0,0,5],[1,2.5,4]]"));
  EXPECT_THAT(script, HasSubstr("\"kind\":\"section\",\"name\":\"\\u003c/script\\u003e\","
                                "\"points\":[[1,2],[3,4]]"));
  // 0, 65534, 65535 (none) and 32767, the lowest byte first.
  EXPECT_THAT(script, HasSubstr("\"low\":100,\"high\":102,\n\"heights\":\"AAD+/////38=\""));
}

}  // namespace
}  // namespace sabo
