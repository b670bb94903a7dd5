// Tests that the man page, the completions and the manual name exactly the commands and options
// that --help shows.

#include <array>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "core/error.hpp"
#include "run_process.hpp"
#include "scene/scene.hpp"

namespace aerostat::test {
namespace {

using Words = std::set<std::string>;

std::string repository_file(const std::string& path) {
  const std::string text = read_bytes(std::string(AEROSTAT_SOURCE_DIR) + "/" + path);
  EXPECT_FALSE(text.empty()) << path;
  return text;
}

/// Returns all matches of group 1 of the pattern.
Words all_of(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::multiline);
  Words words;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    words.insert((*at)[1]);
  }
  return words;
}

const std::string kOption = "(--[a-z][a-z-]*)";

Words options_in(const std::string& text) {
  return all_of(text, kOption);
}

/// Returns the text after `from` up to `to`. Fails the test if there is no such part.
std::string part(const std::string& text, const std::string& from, const std::string& to) {
  const auto start = text.find(from);
  EXPECT_NE(start, std::string::npos) << from;
  if (start == std::string::npos) return "";
  const auto end = text.find(to, start + from.size());
  return text.substr(start + from.size(), end - start - from.size());
}

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The text of --help for each command. The empty name is the program itself.
class Help {
 public:
  explicit Help(const std::function<std::string(std::vector<std::string>)>& ask)
      : text(ask({"--help"})) {
    commands = all_of(part(text, "Subcommands:\n", "\n\n") + "\n", "^  ([a-z-]+) ");
    options[""] = shown(text);
    for (const std::string& command : commands) options[command] = shown(ask({command, "--help"}));
  }

  std::string text;
  Words commands;
  std::map<std::string, Words> options;

 private:
  static Words shown(const std::string& help) {
    return all_of(part(help, "Options:\n", "\n\n") + "\n", "^  (?:-.,)?" + kOption);
  }
};

class DocsOfHelp : public CliTest {
 protected:
  Help help() const {
    return Help([this](const std::vector<std::string>& arguments) { return run(arguments).out; });
  }
};

TEST_F(DocsOfHelp, HelpIsUnderstood) {
  const Help asked = help();
  EXPECT_GE(asked.commands.size(), 7u);
  EXPECT_EQ(asked.options.at(""), (Words{"--help", "--version"}));
  EXPECT_GE(asked.options.at("render").size(), 14u);
}

TEST_F(DocsOfHelp, TheManPageIsComplete) {
  const Help asked = help();
  const std::string page =
      std::regex_replace(repository_file("packaging/man/aerostat.1"), std::regex(R"(\\-)"), "-");
  EXPECT_EQ(all_of(page, "^\\.SS aerostat ([a-z-]+)"), asked.commands);
  for (const std::string& command : asked.commands) {
    EXPECT_EQ(options_in(part(page, ".SS aerostat " + command + "\n", "\n.S")),
              asked.options.at(command))
        << command;
  }
  const Words shared = options_in(part(page, ".SH \"COMMON OPTIONS\"\n", "\n.SH"));
  for (const std::string& option : asked.options.at("")) EXPECT_EQ(shared.count(option), 1u);
  for (const std::string& name : all_of(asked.text, "^  ([A-Z]+_[A-Z_]+) ")) {
    EXPECT_TRUE(contains(part(page, ".SH ENVIRONMENT", ".SH"), name));
  }
  const std::string codes = part(asked.text, "Exit codes:", "\n\n");
  for (const std::string& code : all_of(codes, "\\b([0-9]+)\\b")) {
    EXPECT_TRUE(contains(part(page, ".SH \"EXIT STATUS\"", ".SH ENV"), code));
  }
}

/// Returns the rows of a table on a page of the manual by their first cells, without backquotes and
/// header.
std::map<std::string, std::string> table_of(const std::string& page, const std::string& header) {
  std::map<std::string, std::string> rows;
  std::istringstream lines(part(page, header, "\n\n"));
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, std::regex(R"(\| ([^|]*) \| ([^|]*) \|.*)"))) {
      rows[match[1]] = match[2];
    }
  }
  return rows;
}

const char* const kPage = "docs/manual/command-line.md";

TEST_F(DocsOfHelp, TheManualListsTheChannelsOfAnExr) {
  ASSERT_EQ(run(small_render("snow", {"--spp", "1", "-o", "a.exr"})).code, 0);
  const Imf::InputFile file((folder_ / "a.exr").c_str());
  std::map<std::string, std::string> channels;
  const Imf::ChannelList& list = file.header().channels();
  for (auto at = list.begin(); at != list.end(); ++at) {
    channels[at.name()] = at.channel().type == Imf::UINT ? "32-bit unsigned" : "32-bit float";
  }
  std::map<std::string, std::string> told;
  for (const auto& [names, type] :
       table_of(repository_file(kPage), "| channel | type | what it is |\n|---|---|---|\n")) {
    for (const std::string& name : all_of(names, "`([A-Za-z.]+)`")) told[name] = type;
  }
  EXPECT_EQ(told, channels);
}

TEST_F(DocsOfHelp, TheManualListsTheIds) {
  std::map<std::string, std::string> ids;
  for (std::uint32_t id = 0; id < scene::kObjectCount; ++id) {
    ids[std::to_string(id)] = scene::object_name(static_cast<scene::ObjectId>(id));
  }
  EXPECT_EQ(table_of(repository_file(kPage), "| `id` | object |\n|---|---|\n"), ids);
}

TEST_F(DocsOfHelp, ExitCodesAreThoseOfErrors) {
  Words codes{"0", "143"};
  for (const ErrorKind kind :
       {ErrorKind::usage, ErrorKind::bad_data, ErrorKind::no_device, ErrorKind::internal,
        ErrorKind::io, ErrorKind::exhausted, ErrorKind::interrupted}) {
    codes.insert(std::to_string(static_cast<int>(kind)));
  }
  EXPECT_EQ(all_of(part(help().text, "Exit codes:", "interrupted"), "\\b([0-9]+)\\b"), codes);
  Words told;
  for (const auto& [cell, unused] :
       table_of(repository_file(kPage), "| exit code | meaning |\n|---|---|\n")) {
    told.merge(all_of(cell, "([0-9]+)"));
  }
  EXPECT_EQ(told, codes);
}

TEST_F(DocsOfHelp, ManPagesHaveADateAndTheVersion) {
  const std::string version = run({"--version"}).out;
  for (const char* page : {"packaging/man/aerostat.1", "packaging/man/aerostat-viewer.1"}) {
    std::smatch match;
    const std::string text = repository_file(page);
    ASSERT_TRUE(std::regex_search(
        text, match, std::regex(R"re(^\.TH \S+ 1 "\d{4}-\d\d-\d\d" "(aerostat [0-9.]+)")re")))
        << page;
    EXPECT_EQ(match[1].str() + "\n", version) << page;
  }
}

/// Returns the words that bash offers after `line`.
Words bash_offers(const std::string& line) {
  const std::string command = "bash -c 'source \"" AEROSTAT_SOURCE_DIR
                              "/packaging/completions/aerostat.bash\"; COMP_LINE=\"" +
                              line +
                              "\"; COMP_POINT=${#COMP_LINE}; COMP_WORDS=(\"" AEROSTAT_BINARY
                              "\"); _aerostat; echo \"${COMPREPLY[@]}\"'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  std::array<char, 256> chunk;
  while (std::fgets(chunk.data(), static_cast<int>(chunk.size()), pipe.get()) != nullptr) {
    text += chunk.data();
  }
  return words_of(text);
}

TEST_F(DocsOfHelp, BashCompletes) {
  const Help asked = help();
  EXPECT_EQ(bash_offers("aerostat "), asked.commands);
  EXPECT_EQ(bash_offers("aerostat --"), asked.options.at(""));
  for (const std::string& command : asked.commands) {
    EXPECT_EQ(bash_offers("aerostat " + command + " --"), asked.options.at(command)) << command;
  }
  EXPECT_EQ(bash_offers("aerostat render --quality "), (Words{"draft", "standard", "final"}));
  EXPECT_EQ(bash_offers("aerostat render x --quality=f"), (Words{"final"}));
  EXPECT_EQ(bash_offers("aerostat contact-sheet --device c"), (Words{"cpu"}));
}

/// Returns the options that a part of the zsh file names, including those of the arrays that it
/// uses.
Words zsh_options(const std::string& file, const std::string& text) {
  Words options = options_in(text);
  for (const std::string& array : all_of(text, R"(\$([a-z]+))")) {
    if (file.find("\n  " + array + "=(") == std::string::npos) continue;
    options.merge(zsh_options(file, part(file, "\n  " + array + "=(", ")\n")));
  }
  return options;
}

TEST_F(DocsOfHelp, ZshCompletes) {
  const Help asked = help();
  const std::string file = repository_file("packaging/completions/_aerostat");
  EXPECT_EQ(all_of(part(file, "commands=(\n", "\n  )") + "\n", "^ +'([a-z-]+):"), asked.commands);
  for (const std::string& command : asked.commands) {
    EXPECT_EQ(zsh_options(file, part(file, "        " + command + ")\n", ";;")),
              asked.options.at(command))
        << command;
  }
  EXPECT_EQ(zsh_options(file, part(file, "_arguments -C", "\n")), asked.options.at(""));
}

TEST_F(DocsOfHelp, FishCompletes) {
  const Help asked = help();
  const std::string file = repository_file("packaging/completions/aerostat.fish");
  std::map<std::string, Words> options;
  Words commands;
  std::istringstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("complete ", 0) != 0) continue;
    Words where = asked.commands;
    where.insert("");
    std::smatch match;
    if (std::regex_search(line, match, std::regex("subcommand_from ([^'\"]+)"))) {
      const std::string list = match[1];
      where = words_of(list[0] == '$' ? part(file, "set -l " + list.substr(1) + " '", "'") : list);
    } else if (line.find("use_subcommand") != std::string::npos) {
      where = {""};
      if (std::regex_search(line, match, std::regex(" -a ([a-z-]+)"))) commands.insert(match[1]);
    }
    if (!std::regex_search(line, match, std::regex(" -l ([a-z-]+)"))) continue;
    for (const std::string& command : where) options[command].insert("--" + match[1].str());
  }
  EXPECT_EQ(commands, asked.commands);
  EXPECT_EQ(options, asked.options);
}

}  // namespace
}  // namespace aerostat::test
