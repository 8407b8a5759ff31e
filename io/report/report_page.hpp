// Pages with words between two @ signs, each of which stands for some text.
#pragma once

#include <string>
#include <string_view>

namespace wellspaced {

/// The page with content_of(word), a string, for each word. Requires: an even number of @ signs.
template <class ContentOf>
std::string fill_page(std::string_view page, ContentOf content_of) {
  std::string html;
  std::size_t done = 0;
  for (std::size_t open = page.find('@'); open != page.npos; open = page.find('@', done)) {
    const std::size_t close = page.find('@', open + 1);
    html += page.substr(done, open - done);
    html += content_of(page.substr(open + 1, close - open - 1));
    done = close + 1;
  }
  return html += page.substr(done);
}

}  // namespace wellspaced
