#include "run/batch.hpp"

#include <algorithm>
#include <new>
#include <system_error>

#include <fmt/format.h>

#include "io/output/file.hpp"
#include "run/own_folder.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

class Queue {
 public:
  Queue(const BatchOptions& options, BatchResult& result) : options_(options), result_(result) {}

  std::optional<BatchRecord> make(const BatchRun& run, const std::string& heading) {
    const fs::path folder = options_.folder / run.folder;
    if (auto record = finished_record(folder, run.c)) {
      tell(heading + " is there already");
      return record;
    }
    tell(heading);
    const RunResult made = run_or_tell(run.c, folder);
    if (made.end == RunEnd::interrupted) result_.end = RunEnd::interrupted;
    if (made.end == RunEnd::failed) fail(run, made.reason);
    if (made.end != RunEnd::finished) return std::nullopt;
    auto record = finished_record(folder, run.c);
    if (!record) fail(run, "its manifest cannot be read back, or its inputs have changed");
    return record;
  }

 private:
  /// What keeps a run from starting is a failure of that run alone.
  RunResult run_or_tell(const Case& c, const fs::path& folder) const try {
    return run_case(c, {folder, FormerRun::replaced, options_.on_progress, options_.stop, false});
  } catch (const std::bad_alloc&) {
    return failure("not enough memory");
  } catch (const std::exception& error) {
    return failure(error.what());
  }

  static RunResult failure(const std::string& reason) {
    RunResult result;
    result.end = RunEnd::failed;
    result.reason = reason;
    return result;
  }

  void fail(const BatchRun& run, const std::string& reason) {
    result_.end = RunEnd::failed;
    if (!result_.reason.empty()) result_.reason += "\n";
    result_.reason += run.folder + ": " + reason;
  }

  void tell(const std::string& line) const {
    if (options_.on_run) options_.on_run(line);
  }

  const BatchOptions& options_;
  BatchResult& result_;
};

}  // namespace

void prepare_batch(const fs::path& folder, const std::string& kind) {
  std::error_code error;
  const fs::path mark = folder / (kind + ".toml");
  holds_own_files(
      folder, [&] { return fs::exists(mark, error); }, "a " + kind);
  make_folder(folder);
  if (!fs::exists(mark, error)) write_file_atomically(mark, fmt::format("[{}]\n", kind));
}

std::vector<std::optional<BatchRecord>> make_runs(const std::vector<BatchRun>& runs,
                                                  const BatchOptions& options,
                                                  BatchResult& result) {
  std::vector<std::optional<BatchRecord>> records(runs.size());
  Queue queue(options, result);
  for (std::size_t k = 0; k < runs.size() && result.end != RunEnd::interrupted; ++k) {
    records[k] =
        queue.make(runs[k], fmt::format("Run {} of {}: {}", k + 1, runs.size(), runs[k].folder));
    if (records[k]) records[k]->folder = runs[k].folder;
  }
  return records;
}

std::string missing_runs_text(const std::vector<std::optional<BatchRecord>>& records,
                              const BatchResult& result) {
  const auto missing = std::ranges::count_if(records, [](const auto& r) { return !r; });
  if (missing == 0) return "";
  return fmt::format("{} of {} runs are missing, which {}", missing, records.size(),
                     result.end == RunEnd::interrupted ? "were not made yet" : "failed");
}

}  // namespace sabo
