// The pages, style and scripts of reports: the files report.html, solid.html, report.css and *.js
// beside this header, compiled in by embed.cmake; and reproduce/chapter.css.
#pragma once

#include <string_view>

namespace wellspaced {

extern const std::string_view kReportHtml;
extern const std::string_view kReportCss;
extern const std::string_view kReportScript;
extern const std::string_view kSolidHtml;
extern const std::string_view kSolidScript;
extern const std::string_view kChapterCss;

}  // namespace wellspaced
