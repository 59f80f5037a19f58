#include "cromer/tasks/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>
#include <span>
#include <utility>

#include "commands.h"
#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/text.h"
#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/read/in_file.h"
#include "cromer/report/file.h"
#include "cromer/tasks/fit/said_of_runs.h"
#include "cromer/tasks/fit/spring_options.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/open_recording.h"
#include "fit_files.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "watching.h"

namespace cromer::core::cli {
namespace {

/// `cromer fit --static`, from the files to the exit status.
int run_static(const std::vector<std::string>& files, const FitOptions& fit, const SpringOptions& options,
               const OutputOptions& output) {
  const auto recordings = open_recordings(files, fit.read);
  if (!recordings) return refuse(recordings.error());
  const auto found = fit_static(*recordings, static_options(fit, options));
  if (!found) return refuse(found.error());
  return give({.text = [&] { return static_text(*found); },
               .json = [&] { return to_json(*found); },
               .csv = [&] { return static_csv(*found); },
               .figure = [&] { return static_figure(*found); },
               .notices = found->notices},
              output);
}

std::vector<std::string> files_of(const std::vector<FittedRecording>& fits) {
  std::vector<std::string> files;
  for (const FittedRecording& fitted : fits) files.push_back(fitted.file);
  return files;
}

/// Whether there is no line only because fits did not succeed, which is no wrong input: the masses given
/// differ.
bool lacks_points(const Error& why, const std::vector<Quantity>& masses) {
  const auto differ = [](const Quantity& one, const Quantity& other) { return one.value != other.value; };
  return why.notice.code == "mass_line_of_one_mass" &&
         std::adjacent_find(masses.begin(), masses.end(), differ) != masses.end();
}

/// Checks that the --motion file can be written without losing another.
Result<void> check_motion(const std::string& motion, const OutputOptions& output,
                          const std::vector<std::string>& inputs) {
  if (motion.empty()) return {};
  if (!motion.ends_with(".csv")) return Error{"motion_is_csv", {{"file", motion}}};
  if (motion == output.output)
    return Error{"two_outputs_one_file", {{"first", "-o"}, {"second", "--motion"}, {"file", motion}}};
  OutputOptions same;
  same.output = motion;
  return check_outputs(same, inputs, "--motion");
}

/// The fits and, where one was asked for, the line through them; and which files an interruption has left
/// out.
Answer answer_of(const std::vector<FittedRecording>& fits, const std::optional<MassLine>& line,
                 const std::vector<std::string>& missing, bool many) {
  Answer answer{.text =
                    [&fits, &line, many] {
                      const std::string of_fits = many || line ? fit_table(fits) : fit_text(fits);
                      return line ? of_fits + mass_line_text(*line) : of_fits;
                    },
                .json = [&fits, &line, &missing,
                         many] { return line ? to_json(fits, *line) : to_json(fits, many, {}, missing); },
                .csv = [&fits, &line] { return line ? mass_line_csv(*line) : fit_csv(fits); },
                .figure = [&fits, &line] { return line ? mass_line_figure(*line) : fit_figure(fits); }};
  for (auto of_file = fits.begin(), end = of_file; of_file != fits.end(); of_file = end) {
    end = std::find_if(of_file, fits.end(), [&](const auto& each) { return each.file != of_file->file; });
    for (Notice& notice : said_of_runs(std::span<const FittedRecording>(of_file, end)))
      answer.notices.push_back(many ? in_file(of_file->file, std::move(notice)) : std::move(notice));
  }
  for (const auto& fitted : fits)
    if (!fitted.succeeded()) answer.failures.push_back(failure_text(fitted));
  if (line) answer.notices.insert(answer.notices.end(), line->notices.begin(), line->notices.end());
  return answer;
}

/// `cromer fit --network`, from the file to the exit status.
int run_network_fit(const std::string& network_file, const std::vector<std::string>& files,
                    const FitOptions& options, const OutputOptions& output,
                    const std::vector<TypedOption>& given, const std::vector<Option>& of_task) {
  for (const auto& [name, text] : given)
    if (std::any_of(of_task.begin(), of_task.end(),
                    [&, &typed = name](const Option& o) { return o.name == typed; }) &&
        !is_fit_option_of_networks(name))
      return refuse(Error{"fit_option_not_of_networks", {{"option", name}}});
  if (files.size() != 1) return refuse(Error{"network_fit_of_one_file", {{"files", files.size()}}});
  const auto network = open_network_file(network_file);
  if (!network) return refuse(network.error());
  const auto recording = open_recording(files.front(), options.read);
  if (!recording) return refuse(recording.error());
  const Watch watch = watching(output.quiet);
  const auto fitted = fit_network(*recording, *network, network_file, options, watch);
  clear_progress();
  if (!fitted) return refuse(fitted.error());
  Answer answer{.text = [&] { return network_fit_text(*fitted); },
                .json = [&] { return to_json(*fitted); },
                .csv = [&] { return network_fit_csv(*fitted); },
                .figure = [&] { return network_fit_figure(*fitted); },
                .notices = fitted->notices,
                .good = fitted->succeeded()};
  if (!fitted->message.empty())
    answer.failures.push_back(fmt::format("{}: {}", fitted->file, in_words(fitted->message)));
  return give(answer, output);
}

}  // namespace

int run_fit(const Arguments& arguments) {
  FitOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "fit",
      .description =
          "The law of motion of a free or a driven oscillation, with uncertainties, from its "
          "recording. No start values are needed. A FOLDER stands for the recordings right in it, by "
          "their endings (.csv, .txt, .lvm, .zip, ...); folders in it are not searched. Frequency, "
          "damping ratio, quality factor and decrement are those of the whole law at the amplitude of "
          "the first used sample.",
      .files = "FILE|FOLDER...",
      .options = options_of(options),
      .example =
          "  cromer fit lab.csv --mass \"217.6 ± 0.3 g\" --disc-diameter \"12 cm\" --segment \"30 "
          "s\" --plot fit.svg\n"
          "  cromer fit rig.csv --force-column Force --hold-out \"25 %\"\n"
          "  cromer fit pendulums.csv --network data/networks/pendulums_open.toml"};
  SpringOptions spring;
  const auto of_spring = options_of(spring);
  syntax.options.insert(syntax.options.end(), of_spring.begin(), of_spring.end());
  const std::vector<Option> of_task = syntax.options;
  add_output_options(syntax.options, output, {},
                     "a table with a row for each recording as .csv, or the document as .json");
  std::string motion;
  syntax.options.push_back(
      {"motion", &motion, "", Range::any,
       "the motion sample by sample as .csv: t, measured, fitted x and v, energy, residual", "none",
       "Output"});
  std::string network;
  syntax.options.push_back({"network", &network, "", Range::any,
                            "file (.toml) of masses and links whose values \"?\" are found, from a recording "
                            "with a column for each mass",
                            "none", "A network of masses"});
  std::vector<std::string> files;
  std::vector<TypedOption> given;
  if (const auto status = parse(syntax, arguments, files, &given)) return *status;
  if (auto good = check_fit_options(options); !good) return refuse(good.error());
  if (auto good = check_spring_options(spring); !good) return refuse(good.error());
  if (!options.mass.empty() && (spring.mass_line || spring.held))
    return refuse(fmt::format("--mass: {} takes the masses from --masses, one for each; leave --mass out",
                              spring.held ? "--static" : "--mass-line"));
  const auto found = recording_files(files);
  if (!found) return refuse(found.error());
  if (auto good = check_outputs(output, found->files); !good) return refuse(good.error());
  if (!network.empty()) {
    if (!motion.empty()) return refuse(Error{"fit_option_not_of_networks", {{"option", "motion"}}});
    return run_network_fit(network, found->files, options, output, given, of_task);
  }
  if (auto good = check_motion(motion, output, found->files); !good) return refuse(good.error());
  if (spring.held && !motion.empty())
    return refuse("--motion has no meaning with --static: a mass at rest has no motion");
  if (spring.held) return run_static(found->files, options, spring, output);

  const Watch watch = watching(output.quiet);
  auto fits = fit_all(*found, options, watch);
  clear_progress();
  if (!fits) return refuse(fits.error());
  const bool interrupted = watch.interrupted();
  std::vector<std::string> missing;
  if (interrupted) {
    missing = missing_of(found->files, files_of(*fits));
    complain(interrupted_at("results", "files", found->files.size(), missing));
  }
  const bool good = !interrupted && std::all_of(fits->begin(), fits->end(),
                                                [](const auto& each) { return each.succeeded(); });
  std::optional<MassLine> line;
  std::optional<Error> no_line;
  if (spring.mass_line && !interrupted) {
    auto through = mass_line(*fits, spring.masses);
    if (through)
      line = *std::move(through);
    else if (!good && lacks_points(through.error(), spring.masses))
      no_line = Error{"no_mass_line", {{"what", through.error().notice}}};
    else
      return refuse(through.error());
  }
  Answer answer = answer_of(*fits, line, missing, found->many);
  answer.good = good;
  if (no_line) answer.failures.push_back(in_words(*no_line));
  answer.notices.insert(answer.notices.end(), found->notes.begin(), found->notes.end());
  if (!motion.empty()) answer.other_files = [&] { return write_table(motion, motion_csv(*fits)); };
  return give(answer, output);
}

}  // namespace cromer::core::cli
