// Text inside HTML, SVG and XML.
#pragma once

#include <string>
#include <string_view>

namespace wellspaced {

/// `text` as it must stand between tags or in a quoted attribute: & < > and " are named, control
/// characters, which XML forbids, become '_'.
std::string escape_markup(std::string_view text);

}  // namespace wellspaced
