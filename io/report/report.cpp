#include "wellspaced/io/report/report.hpp"

#include <string_view>

#include "wellspaced/io/report/report_data.hpp"
#include "wellspaced/io/report/report_page.hpp"
#include "wellspaced/io/report/report_templates.hpp"
#include "wellspaced/io/text/markup.hpp"

namespace wellspaced {

std::string report_html(const HtmlReport& report) {
  return fill_page(kReportHtml, [&](std::string_view word) {
    if (word == "TITLE") return escape_markup(report.title);
    if (word == "STYLE") return std::string(kReportCss);
    if (word == "SCRIPT") return std::string(kReportScript);
    return report_data(report);
  });
}

}  // namespace wellspaced
