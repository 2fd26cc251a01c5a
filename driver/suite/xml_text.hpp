// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::suite {

/// The text for use between tags or within a quoted attribute of XML 1.0: `<`, `>`, `&` and quotes
/// are escaped, and so are line feeds and tabs in an attribute, where a reader would take them for
/// blanks. Characters that XML 1.0 has no way to write (its section 2.2) and bytes that are no
/// UTF-8 become U+FFFD.
std::string xml_text(std::string_view text);
std::string xml_attribute(std::string_view text);

}  // namespace slipbench::driver::suite
