#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(BenchCommand, WritesJsonWithAnEntryForEveryPart) {
  const TemporaryFolder folder;
  const std::string file = (folder / "bench.json").string();
  const Outcome bench = run_shell("sabo bench --quick --threads 1 --json '" + file + "'");
  ASSERT_EQ(bench.code, 0) << bench.text;
  EXPECT_THAT(bench.text, HasSubstr("What a step is made of"));
  const std::string check =
      "import json, sys\n"
      "bench = json.load(open(sys.argv[1]))\n"
      "assert bench['threads'] == 1 and bench['version'] and bench['date'] and bench['cpu']\n"
      "names = [r['name'] for r in bench['results']]\n"
      "assert len(names) == len(set(names)), 'a name twice'\n"
      "for part in ('peak', 'passes', 'steps', 'threads', 'particles', 'dry_terrain',\n"
      "             'dam_break'):\n"
      "    assert any(n.startswith(part + '/') for n in names), part\n"
      "for sweep in ('force sweep', 'motion sweep', 'wall pressure', 'force and matrix',\n"
      "              'near motion', 'shifting', 'viscous solve'):\n"
      "    assert any(n.endswith('/' + sweep + '/share of peak') for n in names), sweep\n"
      "for part in ('steps', 'threads', 'particles', 'dry_terrain', 'dam_break'):\n"
      "    for method in ('fast', 'paper'):\n"
      "        assert any(n.startswith(part + '/' + method + '/') for n in names), part\n"
      "for r in bench['results']:\n"
      "    assert 0 < r['low'] <= r['value'] <= r['high'], r\n";
  folder.write("check.py", check);
  const Outcome read = run_shell("python3 '" + (folder / "check.py").string() + "' '" + file + "'");
  EXPECT_EQ(read.code, 0) << read.text;
}

TEST(BenchCommand, MeasuresOneMethodAlone) {
  const Outcome bench = run_shell("sabo bench --quick --threads 1 --only steps --method fast");
  ASSERT_EQ(bench.code, 0) << bench.text;
  EXPECT_THAT(bench.text, HasSubstr("What a step is made of, method fast"));
  EXPECT_THAT(bench.text, Not(HasSubstr("method paper\n")));
  const Outcome unknown = run_shell("sabo bench --method quick");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.text, HasSubstr("there is no method \"quick\"; give fast or paper"));
}

TEST(BenchCommand, NamesThePartsThatThereAre) {
  const Outcome outcome = run_shell("sabo bench --only steps,pases");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("there is no part \"pases\"; give some of peak, passes"));
  EXPECT_EQ(run_shell("sabo bench --threads 0").code, 2);
}

TEST(BenchCommand, DoesNotPassOverALimitThatItCannotKeep) {
  const Outcome outcome = run_shell("sabo bench --quick --largest 100000");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("--largest: is for flows on a card"));
}

}  // namespace
}  // namespace sabo
