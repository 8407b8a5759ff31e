#include "wellspaced/io/report/report.hpp"

#include <string_view>

#include "wellspaced/io/report/report_data.hpp"
#include "wellspaced/io/report/report_templates.hpp"
#include "wellspaced/io/text/markup.hpp"

namespace wellspaced {
namespace {

// What a word between two @ signs of the page stands for.
std::string content_of(std::string_view word, const HtmlReport& report) {
  if (word == "TITLE") return escape_markup(report.title);
  if (word == "STYLE") return std::string(kReportCss);
  if (word == "SCRIPT") return std::string(kReportScript);
  return report_data(report);
}

}  // namespace

std::string report_html(const HtmlReport& report) {
  const std::string_view page = kReportHtml;
  std::string html;
  std::size_t done = 0;
  for (std::size_t open = page.find('@'); open != page.npos; open = page.find('@', done)) {
    const std::size_t close = page.find('@', open + 1);
    html += page.substr(done, open - done);
    html += content_of(page.substr(open + 1, close - open - 1), report);
    done = close + 1;
  }
  return html += page.substr(done);
}

}  // namespace wellspaced
