// SPDX-License-Identifier: Apache-2.0
// Completion of commands, options and their words in a shell, from the declarations of the
// commands.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/cli/declare.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::cli {
namespace {

/// One option, or what stands without a name, of a command.
struct Word {
  std::vector<std::string> names;    ///< "--output", "-o"; none of what stands without a name
  std::vector<std::string> choices;  ///< what may follow; none: anything, or a file
  std::string text;                  ///< what it does, one line
  bool has_value = false;
  bool is_list = false;
};

/// Names of an option as they are typed.
std::vector<std::string> typed_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

std::vector<Word> words_of(const CLI::App& command) {
  std::vector<Word> words;
  for (const CLI::Option* const option : command.get_options()) {
    Word word{typed_names(*option),
              {},
              option->get_description(),
              option->get_expected_max() != 0,
              option->get_items_expected_max() > 1};
    std::replace(word.text.begin(), word.text.end(), '\n', ' ');
    // "csv|npy|h5" are words; "FILE|DIR" stand for some.
    const std::string type = option->get_type_name();
    const auto is_small = [](char c) {
      return c == '|' || c == '-' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    };
    if (word.has_value && !type.empty() && std::all_of(type.begin(), type.end(), is_small)) {
      word.choices = CLI::detail::split(type, '|');
    }
    words.push_back(std::move(word));
  }
  return words;
}

/// Puts a text into quotes of a shell, of which `quote` is the escaped form of one inside.
std::string quoted(std::string_view text, std::string_view quote) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string(quote) : std::string(1, c);
  return all + "'";
}

std::string bash_script(const std::vector<const CLI::App*>& commands) {
  std::string names;
  std::string values;
  std::string options;
  for (const CLI::App* const command : commands) {
    names += command->get_name() + " ";
    std::string own;
    for (const Word& word : words_of(*command)) {
      own += fmt::format("{} ", fmt::join(word.names, " "));
      if (!word.has_value) continue;
      std::string cases;
      for (const std::string& name : word.names)
        cases += fmt::format("'{} {}'|", command->get_name(), name);
      if (cases.empty() && word.choices.empty()) continue;
      if (cases.empty()) {
        options += fmt::format("    '{} '[!-]*|'{} ') words='{}' ;;\n", command->get_name(),
                               command->get_name(), fmt::join(word.choices, " "));
        continue;
      }
      cases.pop_back();
      values +=
          fmt::format("    {}) words='{}'; value=1 ;;\n", cases, fmt::join(word.choices, " "));
    }
    options += fmt::format("    '{} '-*) words='{}' ;;\n", command->get_name(), own);
  }
  return fmt::format(R"(# bash completion of slipbench: source <(slipbench completion bash)
_slipbench() {{
  local typed=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words= value=
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{}--help --version --verbose' -- "$typed")
    return
  fi
  case "$command $before" in
{}  esac
  [ -n "$value" ] || case "$command $typed" in
{}  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$typed")
}}
complete -o default -F _slipbench slipbench
)",
                     names, values, options);
}

std::string fish_script(const std::vector<const CLI::App*>& commands) {
  std::string script = "# fish completion of slipbench: slipbench completion fish | source\n";
  for (const CLI::App* const command : commands) {
    const std::string& name = command->get_name();
    script += fmt::format("complete -c slipbench -f -n __fish_use_subcommand -a {} -d {}\n", name,
                          quoted(command->get_description(), "\\'"));
    for (const Word& word : words_of(*command)) {
      script += fmt::format("complete -c slipbench -n '__fish_seen_subcommand_from {}'", name);
      for (const std::string& own : word.names) {
        script += own.starts_with("--") ? " -l " + own.substr(2) : " -s " + own.substr(1);
      }
      if (word.has_value && !word.names.empty()) script += word.choices.empty() ? " -r" : " -x";
      if (!word.choices.empty()) script += fmt::format(" -a '{}'", fmt::join(word.choices, " "));
      script += fmt::format(" -d {}\n", quoted(word.text, "\\'"));
    }
  }
  return script;
}

std::string zsh_script(const std::vector<const CLI::App*>& commands) {
  std::string names;
  std::string options;
  // In _arguments a text may hold neither its brackets nor a colon.
  const auto plain = [](std::string text) {
    for (char& c : text) {
      if (c == '[' || c == ']' || c == ':' || c == '\\') c = ' ';
    }
    return text;
  };
  for (const CLI::App* const command : commands) {
    names += "    " +
             quoted(command->get_name() + ":" + plain(command->get_description()), "'\\''") + "\n";
    options += fmt::format("    {}) _arguments -S", command->get_name());
    for (const Word& word : words_of(*command)) {
      const std::string value = !word.has_value ? ""
                                : word.choices.empty()
                                    ? ":value:_files"
                                    : fmt::format(":value:({})", fmt::join(word.choices, " "));
      if (word.names.empty()) {
        options += " " + quoted((word.is_list ? "*" : "") + value, "'\\''");
      }
      for (const std::string& name : word.names) {
        options += " " + quoted(fmt::format("*{}[{}]{}", name, plain(word.text), value), "'\\''");
      }
    }
    options += " ;;\n";
  }
  return fmt::format(R"(#compdef slipbench
# zsh completion of slipbench: slipbench completion zsh > a folder of $fpath/_slipbench
_slipbench() {{
  local -a commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  shift words
  (( CURRENT-- ))
  case ${{words[1]}} in
{}  esac
}}
# Loaded as a function the file is called for its first words; read by source it only defines.
if [[ ${{funcstack[1]-}} == _slipbench ]]; then
  _slipbench "$@"
else
  compdef _slipbench slipbench
fi
)",
                     names, options);
}

}  // namespace

void declare_completion(CLI::App& app, Command& command) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* declared =
      app.add_subcommand("completion", "Print what completes commands and options in a shell");
  declared->add_option("SHELL", *shell, "Which shell")
      ->type_name("bash|zsh|fish")
      ->check(one_of({"bash", "zsh", "fish"}))
      ->required();
  declared->footer(
      "Examples:\n"
      "  slipbench completion zsh > ~/.zfunc/_slipbench\n"
      "  source <(slipbench completion bash)\n"
      "  slipbench completion fish > ~/.config/fish/completions/slipbench.fish");
  declared->callback([shell, &app, &command] {
    command = [shell, &app] {
      const std::vector<const CLI::App*> commands = std::as_const(app).get_subcommands({});
      const auto script = *shell == "bash"  ? bash_script
                          : *shell == "zsh" ? zsh_script
                                            : fish_script;
      terminal::print(script(commands));
      return base::kExitOk;
    };
  });
}

}  // namespace slipbench::driver::cli
