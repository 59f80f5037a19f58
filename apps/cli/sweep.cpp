#include "cromer/tasks/sweep/sweep.h"
#include "cromer/os/process.h"

#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "cromer/base/grid.h"
#include "cromer/base/quantity.h"
#include "cromer/cluster/disk.h"
#include "cromer/cluster/ranks.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/report/csv.h"
#include "cromer/report/file.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// [bytes] for the rows: written out as CSV they take six times as much (measured), as JSON twice that.
double memory_for_rows(bool json) { return os::memory() / (json ? 16 : 8); }

/// [bytes] of rows in a file that are read back only to say what was found.
constexpr double memory_to_look_through = 200e6;

/// Joins the other processes where mpirun or srun started several.
Result<std::unique_ptr<Ranks>> join_ranks(const RankPlace& place) {
  if (place.ranks == 1) return std::unique_ptr<Ranks>();
  auto joined = Ranks::join(place);
  if (!joined) return joined.error();
  return std::make_unique<Ranks>(*std::move(joined));
}

/// On the ranks, where there are some.
ChunkMaker maker_on(Ranks* ranks) {
  return [ranks](const ChunkedRows& work, const std::vector<std::uint64_t>& chunks, int threads,
                 const ChunkSink& sink, const Watch& watch) {
    return ranks ? ranks->make_chunks(work, chunks, threads, sink, watch)
                 : make_chunks(work, chunks, threads, sink, watch);
  };
}

/// The work of every rank but the first. The first one says what there is to say.
int help_first_rank(Ranks& ranks, const SweepOptions& options) {
  const auto plan = plan_sweep(options);
  if (plan)
    ranks.help(plan->rows, options.threads.value_or(0), watching(true));
  else
    ranks.cannot_help(in_words(plan.error()));
  return done;
}

/// `more` is said with what there is to say of the sweep.
int show(const SweepResult& result, const OutputOptions& output, const std::string& command,
         const std::vector<Notice>& more) {
  const bool into_file = !output.output.empty() && *file_format(output.output, true) == FileFormat::hdf5;
  const bool any = result.counts.not_settled < result.plan.rows.rows;
  Answer answer{.text = [&] { return sweep_text(result); },
                .json = [&] { return to_json(result); },
                .csv = [&] { return sweep_csv(result, command); },
                .notices = notices_of(result),
                .good = any && result.counts.ok() && !result.interrupted};
  answer.notices.insert(answer.notices.end(), more.begin(), more.end());
  if (!result.rows.empty()) answer.figure = [&] { return sweep_figure(result); };
  if (result.interrupted)
    answer.failures.push_back(fmt::format("interrupted after {} of {} points{}", result.done,
                                          result.plan.rows.rows, into_file ? "; --resume goes on" : ""));
  if (const std::vector<Notice> points = failure_notices(result); !points.empty())
    answer.failures.push_back(in_words(Error{"points_in_trouble", {{"points", points}}}));
  return give(answer, output);
}

struct TrajectoryOptions {
  std::string path{};   ///< FILE.csv; "" none
  long long every = 1;  ///< keep every Nth state, > 0
};

/// Checks, before the sweep, that the file can be written and has room on the disk. Returns how large it will
/// be.
Result<Notice> check_trajectories(const SweepPlan& plan, const TrajectoryOptions& options) {
  const auto format = file_format(options.path);
  if (!format || *format != FileFormat::csv || options.path == "-")
    return Error{"trajectories_are_csv", {{"file", options.path}}};
  if (auto good = check_writable(options.path); !good) return good.error();
  const auto states = count_trajectory_states(plan, options.every);
  if (!states) return states.error();
  // Numbers have 18 characters or so where they are not round.
  const double bytes = *states * 18.0 * static_cast<double>(plan.swept.size() + 3);
  if (auto good = fits_on_disk(options.path, bytes); !good)
    return Error{"trajectories_do_not_fit", {{"what", good.error().notice}}};
  return Notice{"trajectories_size",
                {{"points", plan.rows.rows},
                 {"states", *states},
                 {"size", bytes_in_words(bytes)},
                 {"file", options.path}}};
}

/// Columns: the swept options, t, x and v; rows in the order of the sweep's. What there is to say is
/// returned: points that ran away, or an interruption, after which what came before it is in the file.
Result<Notice> write_trajectories(const SweepPlan& plan, const TrajectoryOptions& options,
                                  const std::string& command, const Watch& watch) {
  Notice said;
  const auto written = write_file(options.path, [&](const PieceSink& write) -> Result<void> {
    const std::vector<std::string> comments{command};
    bool first = true;
    const auto sink = [&](const std::vector<double>& values, const Trajectory& states) {
      std::string rows;
      append_trajectory(rows, plan, values, states, first ? comments : std::vector<std::string>{}, first);
      first = false;
      return write(rows);
    };
    const auto run = run_trajectories(plan, options.every, sink, watch);
    if (!run) return run.error();
    if (run->failed > 0)
      said = Notice{"trajectories_ended_early", {{"failed", run->failed}, {"points", plan.rows.rows}}};
    if (run->interrupted)
      said = Notice{"trajectories_interrupted",
                    {{"done", run->points + run->failed}, {"points", plan.rows.rows}}};
    return {};
  });
  if (!written) return written.error();
  return said;
}

}  // namespace

int run_sweep(const Arguments& arguments) {
  SweepOptions options;
  OutputOptions output;
  output.hdf5 = true;
  Syntax syntax{
      .command = "sweep",
      .description =
          "The same run over grids of its options: low:high:points, low:high:points:log, or a list with "
          "commas. Grids multiply.",
      .files = "",
      .options = options_of(options),
      .example =
          "  cromer sweep --damping-ratio 0.02,0.05,0.1 --drive-amplitude 1 --drive-frequency 0.1:3:1000 \\\n"
          "    -o resonance.csv --plot resonance.svg\n"
          "  cromer sweep --cubic 0.05 --damping 0.1 --drive-amplitude 0.3 --drive-frequency 0.5:2:400 \\\n"
          "    --direction up --plot jump.svg",
      .refusal = sweep_refusal};
  add_output_options(syntax.options, output, {.provenance = true}, "the rows as .csv, .json or .h5");
  bool resume = false;
  syntax.options.push_back({"resume", &resume, "", Range::any, "go on with what FILE.h5 lacks",
                            "an unfinished file is left alone", "Output"});
  TrajectoryOptions trajectories;
  syntax.options.push_back({"trajectories", &trajectories.path, "", Range::any,
                            "FILE.csv: the motion of every point of a sweep with --until, in order", "",
                            "Output"});
  syntax.options.push_back({"every", &trajectories.every, "", Range::positive,
                            "of the trajectories keep every Nth state", "1", "Output"});
  const RankPlace place = rank_place();
  if (!place.first()) fall_silent();
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  auto ranks = join_ranks(place);
  if (!ranks) return refuse(ranks.error());
  if (!place.first()) return help_first_rank(**ranks, options);

  if (auto good = check_outputs(output); !good) return refuse(good.error());
  const bool into_file = !output.output.empty() && *file_format(output.output, true) == FileFormat::hdf5;
  if (resume && !into_file)
    return refuse("--resume: only an HDF5 file can be continued; name it with -o FILE.h5");
  const bool json = output.json || output.output.ends_with(".json");
  options.memory = memory_for_rows(json);
  const Watch watch = place.ranks > 1 ? watching_ranks(output.quiet) : watching(output.quiet);
  auto plan = plan_sweep(options);
  if (!plan) return refuse(plan.error());
  std::vector<Notice> size;  // of the trajectories
  if (!trajectories.path.empty()) {
    if (trajectories.path == output.output || trajectories.path == output.plot)
      return refuse(fmt::format("--trajectories: {} is another output's name", trajectories.path));
    const auto checked = check_trajectories(*plan, trajectories);
    if (!checked) return refuse(checked.error());
    size.push_back(*checked);
  } else if (trajectories.every != 1) {
    return refuse("--every: it thins trajectories; name their file with --trajectories FILE.csv");
  }
  const auto finish = [&](const SweepResult& result) {
    if (result.interrupted) size.clear();  // none are written
    const int status = show(result, output, provenance(output, "sweep", arguments), size);
    if (size.empty()) return status;
    const auto said =
        write_trajectories(result.plan, trajectories, provenance(output, "sweep", arguments), watch);
    clear_progress();
    if (!said) return refuse(said.error());
    if (said->empty()) return status;
    complain(in_words(*said));
    return static_cast<int>(no_success);
  };
  const ChunkMaker make = maker_on(ranks->get());
  if (!into_file) {
    const auto result = sweep(*std::move(plan), options, make, watch);
    clear_progress();
    return result ? finish(*result) : refuse(result.error());
  }
  if (output.json || !output.plot.empty()) {
    if (auto good =
            fits_in_memory(static_cast<double>(plan->rows.rows),
                           static_cast<double>(plan->rows.columns.size()) * sizeof(double), options.memory);
        !good)
      return refuse(in_words(good.error()) + ", or leave --json and --plot out");
  } else {
    options.memory = memory_to_look_through;
  }
  auto file = open_sweep_file(*plan, output.output, resume, command_line("sweep", arguments), watch);
  if (!file) {
    if (!watch.interrupted()) return refuse(file.error());
    complain(file.error());
    return no_success;
  }
  const auto result = fill_sweep_file(*file, *std::move(plan), options, make, watch);
  clear_progress();
  if (result) return finish(*result);
  complain(result.error());
  return no_success;
}

}  // namespace cromer::core::cli
