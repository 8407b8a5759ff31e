// The page, style and script of the report: the files report.html, report.css and report*.js beside
// this header, compiled in by embed.cmake; and reproduce/chapter.css.
#pragma once

#include <string_view>

namespace wellspaced {

extern const std::string_view kReportHtml;
extern const std::string_view kReportCss;
extern const std::string_view kReportScript;
extern const std::string_view kChapterCss;

}  // namespace wellspaced
