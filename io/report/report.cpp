#include "wellspaced/io/report/report.hpp"

#include <string_view>

#include "wellspaced/io/report/report_data.hpp"
#include "wellspaced/io/report/report_templates.hpp"

namespace wellspaced {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

// What a word between two @ signs of the page stands for.
std::string content_of(std::string_view word, const Report& report) {
  if (word == "TITLE") return escaped(report.title);
  if (word == "STYLE") return std::string(kReportCss);
  if (word == "SCRIPT") return std::string(kReportScript);
  return report_data(report);
}

}  // namespace

std::string report_html(const Report& report) {
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
