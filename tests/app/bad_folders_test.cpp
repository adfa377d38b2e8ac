#include <string>

#include "app/bad_input.hpp"

// Wrong run folders and checkpoints; names that are not wrong.

namespace sabo {
namespace {

TEST_F(BadInput, RunFolders) {
  const Outcome run = in("good", "OMP_NUM_THREADS=1 sabo run . -o run");
  ASSERT_EQ(run.code, 0) << run.text;
  expect_refused({
      {"none", ":", "nowhere", "sabo info nowhere"},
      {"a folder that is none", "mkdir x", "x", "sabo info x"},
      {"no manifest", "rm run/manifest.toml", "manifest|run", "sabo info run"},
      {"an empty manifest", ": >run/manifest.toml", "manifest|run", "sabo report run"},
      {"a manifest cut off", "head -c 40 run/manifest.toml >m; mv m run/manifest.toml",
       "manifest|run", "sabo report run"},
      {"a manifest of bytes", "head -c 4000 /dev/urandom >run/manifest.toml", "manifest|run",
       "sabo compare run run"},
      {"no maps", "rm -r run/maps", "maps", "sabo compare run run"},
      {"no frames", "rm -r run/frames", "frames|flow.pvd", "sabo plot run --times 0"},
      {"frames that are none", "echo x >run/frames/flow.pvd", "flow.pvd",
       "sabo plot run --times 0"},
      {"a frame that is gone", "rm run/frames/flow_*.vtp", "flow_", "sabo plot run --times 0"},
      {"a frame cut off", "for f in run/frames/flow_*.vtp; do head -c 900 $f >f; mv f $f; done",
       "flow_", "sabo plot run --times 0"},
      {"frames of bytes", "for f in run/frames/flow_*.vtp; do head -c 9000 /dev/urandom >$f; done",
       "flow_", "sabo plot run --times 0"},
      {"a time that is none", ":", "times", "sabo plot run --times x"},
      {"a map that is none", "echo x >run/maps/pfd.tif", "pfd", "sabo compare run run"},
      {"a survey that is gone", ":", "gone.tif", "sabo compare run --observed gone.tif"},
      {"no survey", ":", "observed|survey", "sabo compare run"},
      {"rules that are gone", ":", "gone.toml", "sabo hazard run --rules gone.toml"},
      {"rules that are none", "echo '[[[' >r.toml", "r.toml", "sabo hazard run --rules r.toml"},
      {"periods for other runs", ":", "periods", "sabo hazard run --periods 30,100"},
      {"an unknown format", ":", "format", "sabo export run --format shape"},
      {"a depth below zero", ":", "depths", "sabo export run --depths=-1"},
      {"an unknown language", ":", "language", "sabo report run --language xx"},
      {"another run that is none", "mkdir x", "x", "sabo report run --compare x"},
      {"the same run twice over", ":", "run", "sabo run . -o run"},
      {"a sweep over nothing", ":", "vary", "sabo sweep . --vary material.density="},
      {"a sweep over an unknown key", ":", "densty", "sabo sweep . --vary material.densty=1,2"},
      {"a sweep without an end", ":", "vary|step|values",
       "sabo sweep . --vary material.density=1:1e9:1e-9"},
      {"a study of no spacing", ":", "spacings", "sabo study . --spacings 0"},
  });
}

TEST_F(BadInput, Checkpoints) {
  const Outcome run = in("good", "OMP_NUM_THREADS=1 sabo run . -o run --overwrite");
  ASSERT_EQ(run.code, 0) << run.text;
  const char* const resume = "sabo run run --resume --duration 0.2";
  const char* const lost = "is lost|no checkpoint";
  expect_refused({
      {"none", "rm -r run/checkpoint", lost, resume},
      {"an empty one", "for f in run/checkpoint/*.sabo; do : >$f; done", lost, resume},
      {"cut off in its head", "truncate -s 10 run/checkpoint/*.sabo", lost, resume},
      {"cut off behind its head", "truncate -s 21 run/checkpoint/*.sabo", lost, resume},
      {"cut off in the middle", "truncate -s 2000 run/checkpoint/*.sabo", lost, resume},
      {"longer than it was", "for f in run/checkpoint/*.sabo; do echo x >>$f; done", lost, resume},
      {"of random bytes", "for f in run/checkpoint/*.sabo; do head -c 9000 /dev/urandom >$f; done",
       lost, resume},
      {"of zeros", "for f in run/checkpoint/*.sabo; do head -c 9000 /dev/zero >$f; done", lost,
       resume},
      {"of text", "for f in run/checkpoint/*.sabo; do echo checkpoint >$f; done", lost, resume},
      {"of another format",
       "for f in run/checkpoint/*.sabo; do printf '\\377' | dd of=$f bs=1 seek=16 conv=notrunc; "
       "done",
       lost, resume},
      {"a folder", "for f in run/checkpoint/*.sabo; do rm $f; mkdir $f; done", lost, resume},
      {"a link to itself", "for f in run/checkpoint/*.sabo; do rm $f; ln -s $f $f; done", lost,
       resume},
      {"a pipe without a writer", "for f in run/checkpoint/*.sabo; do rm $f; mkfifo $f; done", lost,
       resume},
      {"a device without an end", "for f in run/checkpoint/*.sabo; do ln -sf /dev/zero $f; done",
       lost, resume},
      {"larger than memory", "truncate -s 100G run/checkpoint/*.sabo", lost, resume},
      {"of another spacing", ":", "numerics.spacing", "sabo run run --resume --spacing 2"},
      {"of another material", "sed -i 's/1800/1900/' run/case.toml", "density", resume},
      {"of another DEM", "sed -i 's/^100 100/101 100/' dem.asc", "dem.asc",
       "sabo run . -o run --resume --duration 0.2"},
      {"of a DEM that is gone", "rm dem.asc", "dem.asc",
       "sabo run . -o run --resume --duration 0.2"},
      {"of another structure", "sed -i 's/height = 4/height = 5/' run/case.toml", "height", resume},
      {"of a run that has finished", ":", "has finished", "sabo run run --resume"},
      {"of a case that is gone", "rm run/case.toml", "case", resume},
      {"to be overwritten as well", ":", "overwrite|resume", "sabo run run --resume --overwrite"},
      {"to branch from, in no run", ":", "nowhere",
       "sabo run . -o out --branch-at 0.1 --from nowhere"},
      {"to branch from, before the first", ":", "no checkpoint|duration",
       "sabo run . -o out --branch-at 0.001 --from run"},
      {"to branch from, at no time", ":", "branch", "sabo run . -o out --branch-at nan --from run"},
      {"to branch from, without a run", ":", "from", "sabo run . -o out --branch-at 0.1"},
      {"to branch from, without a time", ":", "branch", "sabo run . -o out --from run"},
      {"to branch from, with another spacing", ":", "spacing",
       "sabo run . -o out --branch-at 0.1 --from run --spacing 2"},
      {"to branch from into itself", ":", "output: is the run that this one starts from",
       "sabo run . -o run --branch-at 0.1 --from run"},
      {"to branch from and to overwrite", ":", "output: is the run that this one starts from",
       "sabo run . -o ./run --overwrite --branch-at 0.1 --from run"},
  });
}

// What looks odd and is not wrong.
TEST_F(BadInput, OddNamesAreRead) {
  for (const char* name : {"土石流 2010", "a 'b' \"c\"", "$(touch x)", "-o", "ünï—code", "a;b&c"}) {
    const fs::path place = *folder_ / "odd" / name;
    fs::remove_all(*folder_ / "odd");
    fs::create_directories(*folder_ / "odd");
    fs::copy(*folder_ / "good", place, fs::copy_options::recursive);
    fs::rename(place / "dem.asc", place / (std::string(name) + ".asc"));
    fs::create_symlink(std::string(name) + ".asc", place / "dem.asc");
    const Outcome outcome = in("odd", "for d in ./*; do sabo check \"$d\" --no-forecast; done");
    EXPECT_EQ(outcome.code, 0) << name << outcome.text;
  }
}

}  // namespace
}  // namespace sabo
