// Which folder may include which: the includes are read and held to the list of the architecture. And no two
// types have one name, nor do two files that are compiled as one unit give one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace CROMER_FILE {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::map<std::string, std::set<std::string>> list = {
      {"base", {}},
      {"os", {"base"}},
      {"model", {"base"}},
      {"methods", {"base"}},
      {"read", {"base"}},
      {"live", {"base", "os", "read"}},
      {"report", {"base", "os"}},
      {"run", {"base", "methods"}},
      {"analysis", {"base", "model", "methods", "run"}},
      {"ensemble", {"base", "model", "methods", "run", "analysis"}},
      {"cluster", {"base", "os", "ensemble"}},
      {"identify/least_squares", {"base", "analysis", "identify"}},
      {"identify/motion",
       {"base", "model", "methods", "run", "analysis", "identify", "identify/least_squares"}},
      {"identify/start",
       {"base", "model", "methods", "run", "analysis", "identify", "identify/least_squares",
        "identify/motion"}},
      {"identify/diagnose",
       {"base", "model", "methods", "run", "analysis", "identify", "identify/least_squares",
        "identify/motion"}},
      {"identify/modal", {"base", "analysis", "identify/least_squares"}},
      {"identify/choose",
       {"base", "model", "methods", "run", "analysis", "identify", "identify/least_squares",
        "identify/motion", "identify/start", "identify/diagnose"}},
      {"identify",
       {"base", "model", "methods", "run", "analysis", "identify/least_squares", "identify/motion",
        "identify/start", "identify/diagnose", "identify/choose"}},
      {"identify/network", {"base", "model", "methods", "analysis", "identify/least_squares"}},
      {"tasks/option", {"base"}},
      {"tasks/inspect", {"base", "analysis", "read"}},
      {"tasks/methods", {"base", "model", "methods", "analysis", "tasks/option"}},
      {"tasks/network", {"base", "model", "identify/network", "read", "report", "tasks/option"}},
      {"tasks/modes",
       {"base", "model", "methods", "analysis", "identify", "read", "tasks/option", "tasks/methods",
        "tasks/network"}},
      {"tasks/simulate",
       {"base", "model", "methods", "run", "analysis", "read", "report", "tasks/option", "tasks/methods"}},
      {"tasks/network_fit",
       {"base", "model", "analysis", "identify", "read", "tasks/option", "tasks/fit", "tasks/network",
        "tasks/modes"}},
      {"tasks/network_run",
       {"base", "model", "methods", "run", "analysis", "tasks/option", "tasks/methods", "tasks/network",
        "tasks/modes", "tasks/simulate"}},
      {"tasks/curves",
       {"base", "model", "methods", "run", "analysis", "tasks/option", "tasks/methods", "tasks/simulate"}},
      {"tasks/spectrum", {"base", "model", "analysis", "ensemble", "read", "tasks/option", "tasks/simulate"}},
      {"tasks/sweep",
       {"base", "model", "methods", "run", "analysis", "ensemble", "tasks/option", "tasks/simulate"}},
      {"tasks/fit",
       {"base", "model", "methods", "run", "analysis", "identify", "read", "tasks/option", "tasks/inspect",
        "tasks/simulate"}},
      {"tasks/recognise",
       {"base", "model", "methods", "run", "analysis", "read", "tasks/option", "tasks/methods",
        "tasks/simulate"}},
      {"tasks/compare",
       {"base", "model", "methods", "run", "analysis", "identify", "read", "tasks/option", "tasks/simulate",
        "tasks/fit"}},
      {"tasks/record", {"base", "os", "live", "report", "tasks/option", "tasks/fit"}},
      {"tasks", {"tasks", "read", "report"}},
      {"documents/words", {"base"}},
      {"documents",
       {"documents/words", "base", "model", "analysis", "identify", "read", "live", "report", "cluster",
        "tasks"}},
      {"figures", {"base", "model", "analysis", "identify", "report", "tasks", "documents"}},
      {"study", {"base", "model", "analysis", "read", "report", "tasks", "documents", "figures"}},
      {"door", {"base", "model", "analysis", "identify", "read", "report", "tasks", "documents", "figures"}},
  };
  return list;
}

/// The layer a path below src/cromer belongs to: the longest name of the list that begins it; "" if none
/// does.
std::string layer_of(const std::string& path) {
  std::string best;
  for (const auto& [layer, seen] : allowed())
    if (path.rfind(layer + "/", 0) == 0 && layer.size() > best.size()) best = layer;
  return best;
}

/// What is wrong with one include, or "".
std::string complaint(const std::string& file, const std::string& included) {
  const std::string from = layer_of(file), to = layer_of(included);
  if (from.empty()) return file + " lies in no folder of the architecture";
  if (included == "version.h")
    return from == "study" || from == "door" || from == "documents" || from == "tasks/record"
               ? ""
               : file + " includes version.h, which only what writes files may";
  // What the door shows are types that all of the house uses; cromer.h is for strangers.
  if (included.find('/') == std::string::npos)
    return included == "cromer.h" ? file + " includes all of the door: include what it uses" : "";
  if (to.empty()) return file + " includes " + included + ", which lies in no folder of the architecture";
  // Who sees a folder sees its rooms.
  const std::string house = to.substr(0, to.find('/'));
  const bool own = house == from.substr(0, from.find('/'));
  if (from == to || allowed().at(from).count(to) ||
      ((!own || from == house) && allowed().at(from).count(house)))
    return "";
  return file + " (" + from + ") may not include " + included + " (" + to + ")";
}

TEST(Layers, includes_keep_to_the_architecture) {
  const fs::path root = fs::path(CROMER_SOURCE_DIR) / "src" / "cromer";
  const std::regex include(R"(^\s*#\s*include\s*"([^"]+)\")");
  int files = 0, includes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const auto ending = entry.path().extension();
    if (ending != ".h" && ending != ".cpp") continue;
    ++files;
    const std::string file = fs::relative(entry.path(), root).string();
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      ++includes;
      const std::string name = match[1];
      ASSERT_EQ(name.rfind("cromer/", 0), 0u)
          << file << " includes \"" << name << "\": write it from the root, \"cromer/...\"";
      EXPECT_EQ(complaint(file, name.substr(7)), "");
    }
  }
  EXPECT_GT(files, 50);
  EXPECT_GT(includes, 100);
}

TEST(Layers, the_door_includes_nothing_from_within) {
  const fs::path root = fs::path(CROMER_SOURCE_DIR) / "include" / "cromer";
  const std::regex include(R"(^\s*#\s*include\s*[<"](cromer/[^">]+)[">])");
  int files = 0;
  for (const auto& entry : fs::directory_iterator(root)) {
    ++files;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      EXPECT_EQ(std::string(match[1]).find('/', 7), std::string::npos) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(files, 10);
  EXPECT_LT(files, 20);  // and version.h, which CMake makes
}

/// Types that the headers of src/cromer define, by namespace and name, and where.
std::map<std::string, std::set<std::string>> types_of_headers() {
  const fs::path root = fs::path(CROMER_SOURCE_DIR) / "src" / "cromer";
  const std::regex opens(R"(^namespace ([\w:]+) \{$)"), closes(R"(^\}  // namespace)");
  const std::regex type(R"(^(struct|class|enum|enum class) (\w+)( final)?( : [^{]+)? \{)");
  std::map<std::string, std::set<std::string>> found;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".h") continue;
    std::vector<std::string> within;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      std::smatch match;
      if (std::regex_search(line, match, opens))
        within.push_back(match[1]);
      else if (std::regex_search(line, closes) && !within.empty())
        within.pop_back();
      else if (std::regex_search(line, match, type))
        found[(within.empty() ? "" : within.back()) + "::" + match[2].str()].insert(entry.path().string());
    }
  }
  return found;
}

// Two types of one name break the rule of one definition, though no file includes both headers.
TEST(Layers, no_two_types_have_one_name) {
  const auto types = types_of_headers();
  EXPECT_GT(types.size(), 200u);
  for (const auto& [name, headers] : types)
    EXPECT_EQ(headers.size(), 1u) << name << ": " << *headers.begin() << ", " << *headers.rbegin();
}

/// The names that a file gives to functions, types and constants of its own, in `namespace {`.
std::set<std::string> own_names(const fs::path& file) {
  const std::regex type(R"(^(?:template <.*> )?(?:struct|class|enum|enum class) (\w+))"),
      alias(R"(^using (\w+) =)"), function(R"(^[\w\[][^(={]*[ &*](\w+)\()"),
      constant(R"(^(?:inline |static )*const(?:expr)?\b[^=({]*?(\w+)(?:\[\])? ?[={])");
  std::set<std::string> names;
  bool within = false;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (line == "namespace {")
      within = true;
    else if (line == "}  // namespace")
      within = false;
    else if (within && !line.starts_with("TEST") &&
             (std::regex_search(line, match, type) || std::regex_search(line, match, alias) ||
              std::regex_search(line, match, function) || std::regex_search(line, match, constant)))
      names.insert(match[1]);
  }
  return names;
}

/// The names that two files below a folder have in common, with both files. What is for another system is not
/// compiled with them.
std::vector<std::string> common_names(const fs::path& folder, const std::string& other_system) {
  std::map<std::string, fs::path> known;
  std::vector<std::string> common;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp" || entry.path().parent_path().filename() == "words" ||
        entry.path().parent_path().filename() == other_system)
      continue;
    for (const std::string& name : own_names(entry.path()))
      if (const auto [at, fresh] = known.emplace(name, entry.path()); !fresh)
        common.push_back(name + ": " + entry.path().string() + " and " + at->second.filename().string());
  }
  return common;
}

// Files of a folder are compiled as one unit: a second function of one name would be an overload of the
// first, and might be called in its place without a word.
TEST(Layers, no_two_files_of_a_unit_give_one_name) {
  const fs::path root = CROMER_SOURCE_DIR;
  int folders = 0;
  for (const auto& entry : fs::directory_iterator(root / "src" / "cromer")) {
    if (!entry.is_directory()) continue;
    ++folders;
    for (const char* other_system : {"windows", "posix"})
      EXPECT_THAT(common_names(entry.path(), other_system), testing::IsEmpty());
  }
  EXPECT_GT(folders, 14);
  for (const char* folder : {"apps/cli", "apps/serve", "tests/cli"})
    EXPECT_THAT(common_names(root / folder, "windows"), testing::IsEmpty());
}

// What differs between systems stands in src/cromer/os alone.
TEST(Layers, only_os_includes_headers_of_a_system) {
  const fs::path root = CROMER_SOURCE_DIR;
  const std::regex of_a_system(
      R"(^#\s*include <(unistd|fcntl|poll|dlfcn|termios|signal|ifaddrs|netdb|windows|winsock2|io|sys/.*|net/.*|netinet/.*|arpa/.*)\.h>)");
  std::size_t within = 0;
  for (const char* folder : {"src/cromer", "apps/cli", "apps/serve", "include"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".h" && ending != ".cpp") continue;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (!std::regex_search(line, of_a_system)) continue;
        const std::string file = fs::relative(entry.path(), root).string();
        EXPECT_TRUE(file.starts_with("src/cromer/os/")) << file << ": " << line;
        ++within;
      }
    }
  EXPECT_GT(within, 20u);
}

TEST(Layers, a_wrong_include_is_seen) {
  EXPECT_NE(complaint("model/propagate.h", "run/solve.h"), "");
  EXPECT_NE(complaint("model/propagate.h", "methods/rk4.h"), "");
  EXPECT_NE(complaint("report/figure.cpp", "analysis/energy.h"), "");
  EXPECT_NE(complaint("tasks/fit/fit.cpp", "report/file.h"), "");
  EXPECT_NE(complaint("tasks/simulate/simulate.cpp", "identify/law_fit.h"), "");
  EXPECT_NE(complaint("tasks/simulate/simulate.cpp", "tasks/fit/fit.h"), "");
  EXPECT_NE(complaint("misc/thing.h", "base/state.h"), "");
  EXPECT_EQ(complaint("tasks/fit/fit.cpp", "read/recording.h"), "");
}

}  // namespace CROMER_FILE
