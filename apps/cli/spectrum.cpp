#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <utility>

#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/hdf5.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/os/process.h"
#include "cromer/read/in_file.h"
#include "cromer/report/file.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/tasks/option/choice.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "many_files.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// What this command writes beside the common files.
struct SpectrumOutput {
  OutputOptions common{};
  std::string fourier{}, motion{};
  bool tripartite = false;
};

/// Checks one of the further files, all of which are .csv, and none of the other `files` the command writes.
Result<void> check_csv(const char* option, const std::string& file, const char* not_csv,
                       std::initializer_list<std::pair<const char*, const std::string*>> files,
                       const std::vector<std::string>& inputs) {
  if (file.empty()) return {};
  if (!file.ends_with(".csv")) return Error{not_csv, {{"file", file}}};
  for (const auto& [name, other] : files)
    if (file == *other)
      return Error{"two_outputs_one_file", {{"first", name}, {"second", option}, {"file", file}}};
  OutputOptions same;
  same.output = file;
  return check_outputs(same, inputs, option);
}

Result<void> check_output(const SpectrumOutput& output, const SpectrumOptions& options,
                          const std::vector<std::string>& inputs) {
  if (auto good = check_outputs(output.common, inputs); !good) return good;
  if (output.tripartite && output.common.plot.empty()) return Error{"tripartite_without_plot"};
  if (output.tripartite && options.shock && options.shock_response != name(ShockResponse::pseudo_velocity))
    return Error{"tripartite_of_shock"};
  const std::pair<const char*, const std::string*> table{"-o", &output.common.output},
      fourier{"--fourier", &output.fourier};
  if (auto good = check_csv("--fourier", output.fourier, "fourier_is_csv", {table}, inputs); !good)
    return good;
  return check_csv("--motion", output.motion, "motion_is_csv", {table, fourier}, inputs);
}

/// The files of each motion: one, or the two components of one.
using Motions = std::vector<std::vector<std::string>>;

Result<Motions> motions_of(const RecordingFiles& found, const std::string& files) {
  const bool two_alone = found.files.size() == 2 && !found.of_folder;
  const auto typed =
      files.empty() ? Result<std::size_t>(two_alone ? 1 : 0) : choice<2>("files", files, {"each", "pairs"});
  if (!typed) return typed.error();
  const std::size_t of_each = *typed + 1;
  std::error_code none;
  for (const std::string& file : found.files)
    if (!std::filesystem::exists(file, none)) return read_file(file).error();
  if (found.files.size() % of_each != 0) return Error{"no_pairs", {{"files", found.files.size()}}};
  Motions motions;
  for (auto file = found.files.begin(); file != found.files.end();
       file += static_cast<std::ptrdiff_t>(of_each))
    motions.emplace_back(file, file + static_cast<std::ptrdiff_t>(of_each));
  return motions;
}

Result<SpectrumResult> spectrum_of(const std::vector<std::string>& files, const SpectrumOptions& options,
                                   const Watch& watch) {
  const auto recordings = open_recordings(files, options.read);
  if (!recordings) return recordings.error();
  return response_spectrum(*recordings, options, watch);
}

/// `cromer spectrum` of one motion, from the files to the exit status.
int run_one(const std::vector<std::string>& files, const SpectrumOptions& options,
            const SpectrumOutput& output, const Arguments& arguments) {
  const auto result = spectrum_of(files, options, watching(output.common.quiet));
  clear_progress();
  if (!result) return refuse(result.error());
  if (result->interrupted) {
    if (output.common.json) print(to_json(*result, false));
    complain("interrupted; nothing is written");
    tell(result->notices, output.common);
    return no_success;
  }
  const std::string head = provenance(output.common, "spectrum", arguments);
  return give(
      {.text = [&] { return spectrum_text(*result); },
       .json = [&] { return to_json(*result, false); },
       .csv = [&] { return spectrum_csv(*result, head); },
       .whole_json = [&] { return to_json(*result, true); },
       .tables = [&] { return spectrum_tables(*result, command_line("spectrum", arguments)); },
       .figure = [&] { return output.tripartite ? tripartite_figure(*result) : spectrum_figure(*result); },
       .other_files = [&]() -> Result<void> {
         if (!output.fourier.empty())
           if (auto good = write_file(output.fourier, fourier_csv(*result, head)); !good) return good;
         return output.motion.empty() ? Result<void>{} : write_file(output.motion, ground_csv(*result, head));
       },
       .notices = result->notices},
      output.common);
}

/// The spectra of all motions in their order, each as if it were alone. After an interruption those that were
/// not finished are missing.
std::vector<MotionSpectra> spectra_of(const Motions& motions, const SpectrumOptions& options,
                                      const Watch& watch) {
  std::vector<std::optional<MotionSpectra>> all(motions.size());
  for_each_file(motions.size(), watch, [&](std::size_t i, const Watch& of_one) {
    try {
      auto result = spectrum_of(motions[i], options, of_one);
      if (result && result->interrupted) return;
      if (result) result->forget();
      all[i] = MotionSpectra{motions[i], std::move(result)};
    } catch (const std::bad_alloc&) {
      all[i] = MotionSpectra{motions[i], Error{"no_memory_for_motion"}};
    }
  });
  std::vector<MotionSpectra> done;
  for (auto& each : all)
    if (each) done.push_back(*std::move(each));
  return done;
}

const std::vector<std::string>& files_named(const MotionSpectra& motion) { return motion.files; }
const std::vector<std::string>& files_named(const std::vector<std::string>& files) { return files; }

/// The file that each motion is called by.
template <class Motion>
std::vector<std::string> first_files(const std::vector<Motion>& motions) {
  std::vector<std::string> files;
  for (const Motion& motion : motions) files.push_back(files_named(motion).front());
  return files;
}

bool names(const Notice& notice, const std::string& file) {
  return std::any_of(notice.values.begin(), notice.values.end(), [&](const NoticeValue& each) {
    const auto* text = std::get_if<std::string>(&each.value);
    return text && *text == file;
  });
}

Notice of_motion(const MotionSpectra& motion, const Notice& what) {
  return names(what, motion.files[0]) ? what : in_file(motion.files[0], what);
}

/// What there is to say of the motions: each kind of notice once, of the first motion it is said of.
std::vector<Notice> said_of(const std::vector<MotionSpectra>& motions) {
  struct Kind {
    std::string code;
    Notice first;
    std::size_t motions;
  };
  std::vector<Kind> kinds;
  for (const MotionSpectra& motion : motions) {
    if (!motion.succeeded()) continue;
    std::vector<std::string> counted;
    for (const Notice& notice : motion.result->notices) {
      if (std::find(counted.begin(), counted.end(), notice.code) != counted.end()) continue;
      counted.push_back(notice.code);
      const auto known = std::find_if(kinds.begin(), kinds.end(),
                                      [&](const Kind& kind) { return kind.code == notice.code; });
      if (known == kinds.end())
        kinds.push_back({notice.code, of_motion(motion, notice), 1});
      else
        ++known->motions;
    }
  }
  std::vector<Notice> said;
  for (Kind& kind : kinds)
    said.push_back(kind.motions == 1 ? std::move(kind.first)
                                     : Notice{"like_of_others",
                                              {{"what", std::move(kind.first)},
                                               {"others", kind.motions - 1},
                                               {"all", motions.size()}}});
  return said;
}

/// `cromer spectrum` of many motions, from the files to the exit status.
int run_many(const Motions& files, std::vector<Notice> notes, const SpectrumOptions& options,
             const SpectrumOutput& output, const Arguments& arguments) {
  const Watch watch = watching(output.common.quiet);
  const std::vector<MotionSpectra> motions = spectra_of(files, options, watch);
  clear_progress();
  const bool interrupted = watch.interrupted();
  std::vector<std::string> missing;
  if (interrupted) {
    missing = missing_of(first_files(files), first_files(motions));
    complain(interrupted_at("spectra", "motions", files.size(), missing));
  }
  const auto succeeded = [](const MotionSpectra& motion) { return motion.succeeded(); };
  const bool any = std::any_of(motions.begin(), motions.end(), succeeded);
  Answer answer{.text = [&] { return spectra_text(motions); },
                .json = [&] { return to_json(std::span(motions), {}, missing); },
                .csv_pieces = [&](const PieceSink& write) -> Result<void> {
                  if (!any) return Error{"nothing_to_write", {{"file", output.common.output}}};
                  const std::string head = provenance(output.common, "spectrum", arguments);
                  bool first = true;
                  for (const MotionSpectra& motion : motions) {
                    if (!motion.succeeded()) continue;
                    std::string rows;
                    append_spectra(rows, motion, head, std::exchange(first, false));
                    if (auto good = write(rows); !good) return good;
                  }
                  return {};
                },
                .tables = [&] { return spectra_tables(motions, command_line("spectrum", arguments)); },
                .notices = said_of(motions),
                .good = !interrupted && std::all_of(motions.begin(), motions.end(), succeeded)};
  if (any) answer.figure = [&] { return spectra_figure(motions, output.tripartite); };
  for (const MotionSpectra& motion : motions)
    if (!motion.succeeded())
      answer.failures.push_back(in_words(of_motion(motion, motion.result.error().notice)));
  answer.notices.insert(answer.notices.end(), notes.begin(), notes.end());
  return give(answer, output.common);
}

}  // namespace

int run_spectrum(const Arguments& arguments) {
  SpectrumOptions options;
  SpectrumOutput output;
  output.common.hdf5 = true;
  Syntax syntax{
      .command = "spectrum",
      .description =
          "Response spectrum of a recorded acceleration: the largest displacement, pseudo-velocity and "
          "pseudo-acceleration that oscillators of many periods reach. Two files are the horizontal "
          "components of one motion: geometric mean, RotD50 and RotD100 come with them. More files, or a "
          "FOLDER with its recordings, are a motion each, in one table.",
      .files = "FILE|FOLDER...",
      .options = options_of(options),
      .example =
          "  cromer spectrum quake.AT2 --damping-ratio 2%,5% --periods 0.01:10:200:log --in-g -o "
          "spectrum.csv\n"
          "  cromer spectrum h1.AT2 h2.AT2 --peaks peer --plot spectrum.svg\n"
          "  cromer spectrum records/ --files pairs --in-g -o spectra.csv --plot spectra.svg\n"
          "  cromer spectrum drop.uff --shock --frequencies \"5:5000:200:log Hz\" --in-g --plot srs.svg"};
  std::string files;
  syntax.options.push_back({"files", &files, "", Range::any,
                            "each: every file is a motion of its own; pairs: two after each other are the "
                            "components of one",
                            "pairs of exactly two files, else each", "Several files"});
  add_output_options(syntax.options, output.common, {.provenance = true},
                     "the spectrum as .csv, .json or .h5");
  syntax.options.push_back({"fourier", &output.fourier, "", Range::any,
                            "the recording's Fourier amplitudes as .csv", "none", "Output"});
  syntax.options.push_back(
      {"motion", &output.motion, "", Range::any,
       "the ground sample by sample as .csv: acceleration, and velocity and displacement "
       "from rest at the first sample",
       "none", "Output"});
  syntax.options.push_back({"tripartite", &output.tripartite, "", Range::any,
                            "draw pseudo-velocity over lines of displacement and acceleration",
                            "pseudo-acceleration", "Output"});
  std::vector<std::string> names;
  if (const auto status = parse(syntax, arguments, names)) return *status;
  const auto found = recording_files(names);
  if (!found) return refuse(found.error());
  if (auto good = check_output(output, options, found->files); !good) return refuse(good.error());
  const auto motions = motions_of(*found, files);
  if (!motions) return refuse(motions.error());
  options.memory = os::memory() / 2;  // what is computed is written out once more as text
  if (motions->size() == 1 && !found->of_folder) return run_one(motions->front(), options, output, arguments);
  for (const auto& [option, file] : {std::pair{"fourier", &output.fourier}, {"motion", &output.motion}})
    if (!file->empty()) return refuse(Error{"file_of_one_motion", {{"option", option}}});
  if (auto good = check_spectrum_options(options, motions->front().size()); !good)
    return refuse(good.error());
  return run_many(*motions, found->notes, options, output, arguments);
}

}  // namespace cromer::core::cli
