// Every sentence, once: by its code, in English and German.
//
// In a sentence {name} stands for the value of that name as it is, and
//   {rate:.3g}        for a number written so; .4f and .2e likewise
//   {rows:row|rows}   for a count with its noun, "3 rows"; {rows?is|are} for the word alone
//   {laws:and}        for several, "a, b and c"; {laws:or} likewise; {laws} is "a, b, c"
//   {unit: }          for a text with a blank before it, and for nothing where it is empty
//   {value:n}         for a text of numbers, which gets its decimal comma in German
//   {doubt:A}         for a notice with a capital letter at its beginning, unless it begins with a name
//   {--step}          for an option, "--step" on the command line and "step" elsewhere
//   {|{--to}|handle}  for the first to users of program and library, and for the second on the page; each may
//                     be empty, and hold places
//   {option:option}   for an option whose name is a value
//   {@line}           for a place in a file, "line 7", and of arrays "sample 7"
//   {{ and }}         for braces.
// A value that is a notice itself is put in by its own sentence; several are joined by "; ".
#pragma once

#include <span>
#include <string_view>

namespace cromer::core {

/// What an entry is for.
enum class Use {
  wrong_if_ignored,  ///< the severities of notices, see cromer/notice.h
  worth_knowing,
  detail,
  error,   ///< why there is no result, and the cure
  clause,  ///< a part of another sentence
};

struct Entry {
  std::string_view code;
  Use use;
  std::string_view english;
  std::string_view german;
};

/// All entries; those of each folder stand in the file of its name. In the page, those of the tasks it has.
std::span<const std::span<const Entry>> catalogue();

extern const std::span<const Entry> words_of_base, words_of_read, words_of_live, words_of_identify,
    words_of_fit, words_of_simulate, words_of_recognise, words_of_sweep, words_of_spectrum, words_of_options,
    words_of_files, words_of_masses, words_of_study, words_of_door, words_of_program, words_of_report,
    words_of_page, words_of_modes, words_of_networks, words_of_curves, words_of_program_fits;

/// The entry of a code; nullptr where there is none.
const Entry* find_entry(std::string_view code);

}  // namespace cromer::core
