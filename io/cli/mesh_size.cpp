#include "wellspaced/io/cli/mesh_size.hpp"

#include <utility>

#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/text/numbers.hpp"

namespace wellspaced::cli {

Result<WantedSize> read_size(int dimension, const Arguments& arguments, Session& session) {
  WantedSize wanted;
  const auto value = arguments.value("--size");
  if (!value) return wanted;
  const ParsedNumber number = parse_number(*value);
  if (number.status == NumberStatus::kOk) {
    if (!(number.value > 0)) return Error{ErrorCode::kUsage, "mesh: --size must be positive"};
    wanted.constant = number.value;
    return wanted;
  }
  auto background = read_geometry(*value, session.reading());
  if (!background) return background.error();
  const Attributes& attributes = background->point_attributes;
  if (background->dimension != dimension || attributes.columns == 0)
    return Error{ErrorCode::kUsage,
                 {display_name(*value), ": a size needs points in ",
                  dimension == 2 ? "the plane" : "space", " with an attribute, the size"}};
  wanted.sizes.resize(background->point_count());
  for (std::size_t v = 0; v < wanted.sizes.size(); ++v)
    wanted.sizes[v] = attributes.values[v * attributes.columns];
  wanted.background = std::move(*background);
  return wanted;
}

}  // namespace wellspaced::cli
