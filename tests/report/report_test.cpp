#include <vector>

#include "report/embedded.hpp"
#include "report/html_check.hpp"
#include "report/made_run.hpp"
#include "report/run_record.hpp"
#include "support/fault_of.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::AllOf;
using testing::Not;

MATCHER_P(HasPiece, piece, "holds " + std::string(piece)) {
  return arg.html.find(std::string(piece)) != std::string::npos;
}

std::string nesting_fault(const ReportText& report) { return check_html(report.html).fault; }

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t at = text.find(piece); at != text.npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

TEST(Report, SaysWhatTheFilesOfTheRunSay) {
  const ReportText html = MadeRun().report();
  EXPECT_THAT(html,
              AllOf(HasPiece("<h1>A valley</h1>"),
                    HasPiece("The front moved 27.5 m along the path and reached at most 9.8"),
                    HasPiece("It arrived at “wall” after 1.2 s"),
                    // 40 of 64 m3; the greatest discharge of the series is its second row.
                    HasPiece("At the end 40 m³ (62 %) were upstream of “wall”, and 20 m³"),
                    HasPiece("The greatest discharge was 23.4 m³/s, at section “s1” after 1.0 s")));
  // The table of sections: peak, its time, 25 m3 forward less 0.75 backward.
  EXPECT_THAT(html, HasPiece("<td>s1</td><td>–</td><td>23.4</td><td>1.0</td><td>24.2</td>"));
  // The table of the front, by the quantities of the run: 27.5 m, 9.75 m/s.
  EXPECT_THAT(html, AllOf(HasPiece("<td>Run-out</td><td>27.5</td><td>m</td>"),
                          HasPiece("<td>Greatest speed</td><td>9.8</td><td>m/s</td>")));
  // 64 released - 40 - 20 - 4 left the map.
  EXPECT_THAT(html, HasPiece("<td>Not accounted for</td><td>0.00</td>"));
  // Zones: 0.8 m where 0.5 m were observed.
  EXPECT_THAT(html, HasPiece("<td>0.5 (survey)</td><td>0.30</td>"));
  // Energy: 1.4 of 2 MJ; densities of the rows after the first.
  EXPECT_THAT(html, HasPiece("<td>Friction and viscosity</td><td>1.4</td><td>70.00 %</td>"));
  EXPECT_THAT(html, HasPiece("<td>0.9910 – 1.0234</td>"));
  EXPECT_THAT(html, HasPiece("<td>dem.tif</td><td>0123abcd</td>"));
  EXPECT_THAT(html, HasPiece("Jop, Forterre &amp; Pouliquen, Nature 441"));
}

TEST(Report, DrawsMapsAndChartsWithScaleNorthAndUnits) {
  const ReportText html = MadeRun().report();
  EXPECT_EQ(count_of(html.html, "data:image/png;base64,"), 7u) << "location, five maps, resolution";
  EXPECT_EQ(count_of(html.html, ">N</text>"), 7u);
  EXPECT_EQ(count_of(html.html, "contours every"), 7u);
  EXPECT_EQ(count_of(html.html, "<figure class=\"chart\">"), 8u);
  EXPECT_THAT(html, AllOf(HasPiece(">discharge [m³/s]</text>"), HasPiece(">depth [m]</text>"),
                          HasPiece(">distance along the path [m]</text>")));
  // The same in the data of the live chart; the wall stands at 19 m of the path, on ground at 20 m.
  EXPECT_THAT(html, HasPiece("{\"x\":19,\"label\":\"wall\",\"low\":20,\"high\":23}"));
  EXPECT_THAT(html, HasPiece("\"y\":[0,23.45,5]"));
}

TEST(Report, IsWellFormedAndAsksForNothing) {
  for (const Language language : {Language::en, Language::ja}) {
    const ReportText html = MadeRun().report(language);
    EXPECT_EQ(nesting_fault(html), "");
    for (const std::string& reference : check_html(html.html).references)
      EXPECT_TRUE(reference.starts_with('#') || reference.starts_with("data:"))
          << reference.substr(0, 80);
    EXPECT_THAT(html, HasPiece("default-src 'none'; img-src data:"));
    EXPECT_THAT(html, HasPiece("script-src 'sha256-" + std::string(report_script_hash()) + "'"));
  }
}

TEST(Report, IsWrittenInJapanese) {
  const MadeRun run;
  const ReportText html = run.report(Language::ja);
  EXPECT_TRUE(std::filesystem::exists(run.root() / "report_ja.html"));
  EXPECT_THAT(html, AllOf(HasPiece("<html lang=\"ja\">"), HasPiece("土石流数値解析"),
                          HasPiece(">流量 [m³/s]</text>"), HasPiece("最大流動深"),
                          HasPiece("捕捉量(wall)")));
  EXPECT_THAT(html, Not(HasPiece("Long profile")));
}

TEST(Report, EscapesTitlesAndNames) {
  const std::string evil = "<script>alert(1)</script><img src=x onerror=alert(2)>";
  const MadeRun run(evil + "]]>&amp;");
  std::string manifest = MadeRun::manifest("failed", evil);
  for (std::size_t at = manifest.find("\"wall\""); at != manifest.npos;
       at = manifest.find("\"wall\"", at))
    manifest.replace(at, 6, "\"" + evil + "\"");
  run.write("manifest.toml", manifest);
  run.write("series/discharge.csv",
            "time [s],\"" + evil + "\"\" net discharge [m3/s]\",x\n0,0,0\n1,2,0\n");
  run.write("series/loads.csv", "time [s]," + evil + " force x [N]\n0,0\n1,2\n");
  run.write("observed/result.toml", "[result]\nruns = [\"" + evil + "\"]\n");
  run.write("observed/tables/a.csv", evil + ",b\n" + evil + ",1\n");
  run.write("observed/pictures/a<b>.svg", "<svg><script>alert(3)</script></svg>");
  write_plan(run.root() / "maps" / "plan.geojson",
             {{MapLine::Kind::path, "", {{{1, 10, 0}, {39, 10, 0}}, false}},
              {MapLine::Kind::dam, evil, {{{20, 0, 23}, {20, 20, 23}}, true}}},
             "");
  const ReportText html = run.report();
  EXPECT_THAT(html, Not(HasPiece("<script>alert")));
  EXPECT_THAT(html, Not(HasPiece("<img src=x")));
  EXPECT_THAT(html, HasPiece("&lt;script&gt;alert(1)&lt;/script&gt;"));
  // One for our script, and one for the data of each chart.
  EXPECT_EQ(count_of(html.html, "</script>"), 1 + count_of(html.html, "<figure class=\"chart\">"));
  EXPECT_EQ(nesting_fault(html), "");
}

TEST(Report, SaysHowTheRunEnded) {
  const MadeRun run;
  EXPECT_THAT(run.report(), Not(HasPiece("The run failed")));
  run.write("manifest.toml", MadeRun::manifest("interrupted", ""));
  EXPECT_THAT(run.report(), HasPiece("The run was interrupted.</strong> All results are those of "
                                     "the first 2.0 s"));
  run.write("manifest.toml", MadeRun::manifest("failed", "the disk is full"));
  EXPECT_THAT(run.report(), HasPiece("The run failed. Its results must not be used"));
  EXPECT_THAT(run.report(), HasPiece("Reason: the disk is full."));
}

TEST(Report, SaysThatARunIsTooCoarse) {
  const MadeRun run;
  EXPECT_THAT(run.report(), HasPiece("notice alarm\"><strong>Too coarse"));
  std::string manifest = MadeRun::manifest("finished", "");
  manifest.replace(manifest.find("3.25"), 4, "4.5");
  run.write("manifest.toml", manifest);
  EXPECT_THAT(run.report(), HasPiece("notice caution\"><strong>Barely resolved"));
  manifest.replace(manifest.find("4.5"), 3, "5.5");
  run.write("manifest.toml", manifest);
  EXPECT_THAT(run.report(),
              AllOf(HasPiece("notice good\"><strong>Resolved"), Not(HasPiece("Too coarse"))));
}

TEST(Report, BearsAnyMissingFile) {
  for (const char* file :
       {"case.toml", "maps/ground.tif", "maps/pfd.tif", "maps/dep.tif", "maps/rel.tif",
        "maps/res.tif", "maps/plan.geojson", "series/front.csv", "series/discharge.csv",
        "series/volumes.csv", "series/energy.csv", "maps", "series"}) {
    const MadeRun run;
    run.remove(file);
    const ReportText html = run.report();
    EXPECT_EQ(nesting_fault(html), "") << file;
    EXPECT_THAT(html, HasPiece("Files that could not be read:")) << file;
    EXPECT_THAT(html, HasPiece(file)) << file;
  }
}

TEST(Report, BearsARunThatIsStillGoing) {
  const MadeRun run;
  run.remove("maps");
  run.write("manifest.toml", "[run]\nend = \"running\"\nreason = \"\"\n");
  run.write("series/front.csv",
            "time [s],position [m],displacement [m],velocity [m/s]\n0,1,0,0\n1,2");
  const ReportText html = run.report();
  EXPECT_THAT(html, HasPiece("The run has not ended."));
  EXPECT_EQ(nesting_fault(html), "");
}

TEST(Report, BearsBrokenFiles) {
  const MadeRun run;
  run.write("maps/dep.tif", "no raster");
  run.write("maps/plan.geojson", "{\"type\": \"FeatureCollection\", \"features\": [{}, 3");
  run.write("series/volumes.csv", "\"\n,,,\n1e999,nan\n");
  run.write("series/energy.csv", "\n\n\n");
  run.write("case.toml", "title = [");
  EXPECT_EQ(nesting_fault(run.report()), "");
}

TEST(Report, ShowsLoadsBesideDesignFormulas) {
  const MadeRun run;
  EXPECT_THAT(run.report(), Not(HasPiece("Loads on structures")));
  run.write("series/loads.csv",
            "time [s],wall force x [N],wall force y [N],wall hydrostatic [N]\n"
            "0,0,0,0\n1,3000,4000,2500\n");
  run.write(
      "series/pressure_profiles.csv",
      "structure,time [s],bottom [m],top [m],force x [N],force y [N],width [m],pressure [Pa]\n"
      "wall,0,20,21,0,0,4,8000\nwall,1,20,21,0,0,4,9000\nwall,1,21,22,0,0,4,2000\nwall,2,2");
  run.write("manifest.toml", MadeRun::manifest("finished", "") +
                                 "[[load]]\nname = \"wall\"\npeak_force = 6500\npeak_time = 1.5\n"
                                 "filter = 0.1\nimpulse = [30e3, 40e3, 7]\nhydrostatic = 2500\n"
                                 "dynamic = 9000\nalpha = 2\n");
  const ReportText html = run.report();
  EXPECT_THAT(html, HasPiece("The greatest horizontal force was 6.5 kN, on “wall” after 1.5 s"));
  // The impulse is that along x and y, 30 and 40 kN s; a moment is not given.
  EXPECT_THAT(html, HasPiece("<td>wall</td><td>6.5</td><td>1.5</td><td>0.1</td><td>–</td>"
                             "<td>50</td><td>2.5</td><td>9</td><td>2</td>"));
  EXPECT_THAT(html, HasPiece("\"y\":[0,5]")) << "3 and 4 kN at right angles";
  EXPECT_THAT(html, HasPiece("\"y\":[0,2.5]")) << "a formula over time";
  EXPECT_THAT(html, HasPiece("{\"y\":9,\"label\":\"α ρ h v²\"}")) << "one at the peak only";
  EXPECT_THAT(html, HasPiece("\"x\":[20.5,21.5],\"y\":[9,2]")) << "greatest by height, kPa";
}

TEST(Report, SetsAnotherRunBesideThisOne) {
  const MadeRun run, other;
  std::string manifest = MadeRun::manifest("finished", "");
  manifest.replace(manifest.find("= 27.5"), 6, "= 25.0");
  other.write("manifest.toml", manifest);
  const ReportText html = run.report(Language::en, other.root());
  EXPECT_THAT(html, HasPiece("<td>Run-out of the front [m]</td><td>27.5</td><td>25</td><td>2.5</td>"
                             "<td>10.0 %</td>"));
  EXPECT_THAT(html, HasPiece("Discharge at s1"));
  EXPECT_THAT(html, Not(HasPiece("end at different times")));
}

TEST(Report, SaysThatTheOtherRunEndsAtAnotherTime) {
  const MadeRun run, other;
  std::string manifest = MadeRun::manifest("finished", "");
  manifest.replace(manifest.find("simulated_s = 2"), 15, "simulated_s = 9");
  other.write("manifest.toml", manifest);
  EXPECT_THAT(run.report(Language::en, other.root()),
              HasPiece("end at different times: this run at 2.0 s, the other one at 9.0 s"));
}

TEST(Report, ShowsWhatOtherCommandsLeftInTheRun) {
  const MadeRun run;
  EXPECT_THAT(run.report(), Not(HasPiece("Comparison")));
  run.write("compare/result.toml", "[result]\nruns = [\"/runs/with\", \"/runs/without\"]\n");
  run.write("compare/tables/quantities.csv", "quantity,a,b\nfront [m],10.56789,12\n");
  run.write("compare/pictures/reached.svg", "<svg/>");
  run.write("compare/pictures/front_01.svg", "<svg/>");
  run.write("hazard/result.toml", "[result]\nruns = []\n");
  const ReportText html = run.report();
  EXPECT_THAT(html, HasPiece("a: /runs/with; b: /runs/without"));
  EXPECT_THAT(html, HasPiece("<td>front [m]</td><td>10.6</td><td>12</td>"));
  EXPECT_EQ(count_of(html.html, "data:image/svg+xml;base64,PHN2Zy8+"), 1u) << "one of the two";
  EXPECT_THAT(html, HasPiece("Hazard classes</h2>"));
}

TEST(Report, RefusesWhatIsNoRun) {
  const TemporaryFolder folder;
  const Fault fault = fault_of([&] { write_report(folder / "nothing", {}); });
  EXPECT_THAT(fault.problem, testing::HasSubstr("is not the folder of a run"));
}

}  // namespace
}  // namespace sabo
