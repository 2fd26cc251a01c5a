// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/new_case.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/shell_word.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/commands/minimal_case.hpp"
#include "driver/terminal/print.hpp"
#include "law/connection/connection_type.hpp"

namespace slipbench::driver::commands {

int new_command(const NewOptions& options) {
  const std::string text = minimal_case(options.type);
  if (text.empty()) {
    std::vector<std::string_view> known;
    law::for_each_connection_type(
        [&]<class Type>(std::type_identity<Type>) { known.push_back(Type::kInfo.name); });
    return terminal::refuse(
        base::kExitBadInput,
        fmt::format(
            "no connection type '{}'; {}", options.type,
            base::did_you_mean(options.type, known, "'slipbench list connections' shows all")));
  }
  if (options.output.empty()) {
    terminal::print(text);
    return base::kExitOk;
  }
  const auto failed = [&] {
    return terminal::refuse(base::kExitEnvironment,
                            errno == EEXIST
                                ? options.output +
                                      ": is there already and is not replaced; choose another "
                                      "name or remove it"
                                : options.output + ": " + std::generic_category().message(errno));
  };
  errno = 0;
  std::FILE* file = std::fopen(options.output.c_str(), "wx");
  if (file == nullptr) return failed();
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !written) return failed();
  terminal::print(
      base::printable(fmt::format("{}: a case of {}; run it with: slipbench run {}", options.output,
                                  options.type, base::shell_word(options.output))) +
      "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
