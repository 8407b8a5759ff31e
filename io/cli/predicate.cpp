// wellspaced predicate: one exact sign a line.
#include <array>

#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::size_t kMostCoordinates = 15;
using Coordinates = std::array<double, kMostCoordinates>;

Point2 point2(const Coordinates& c, std::size_t i) { return {c[2 * i], c[2 * i + 1]}; }
Point3 point3(const Coordinates& c, std::size_t i) {
  return {c[3 * i], c[3 * i + 1], c[3 * i + 2]};
}

struct Predicate {
  std::string_view name;
  std::size_t coordinates;
  int (*sign)(const Coordinates& c);
};

constexpr std::array<Predicate, 4> kPredicates = {{
    {"orient2d", 6,
     [](const Coordinates& c) { return orient2d(point2(c, 0), point2(c, 1), point2(c, 2)); }},
    {"incircle", 8,
     [](const Coordinates& c) {
       return incircle(point2(c, 0), point2(c, 1), point2(c, 2), point2(c, 3));
     }},
    {"orient3d", 12,
     [](const Coordinates& c) {
       return orient3d(point3(c, 0), point3(c, 1), point3(c, 2), point3(c, 3));
     }},
    {"insphere", 15,
     [](const Coordinates& c) {
       return insphere(point3(c, 0), point3(c, 1), point3(c, 2), point3(c, 3), point3(c, 4));
     }},
}};

constexpr std::size_t kCorpusFields = 2;  // the expected sign and a tag

const Predicate* find_predicate(std::string_view name) {
  for (const Predicate& predicate : kPredicates)
    if (predicate.name == name) return &predicate;
  return nullptr;
}

int read_and_decide(Scanner& scanner, const Predicate& predicate) {
  Coordinates c{};
  for (std::size_t i = 0; i < predicate.coordinates; ++i) c[i] = scanner.number("coordinate");
  if (scanner.more())
    scanner.fail(ErrorCode::kUnreadable,
                 {"more than ", predicate.coordinates, " coordinates on a line"});
  return scanner.ok() ? predicate.sign(c) : 0;
}

Result<int> run_predicate(Arguments& arguments, Session& session) {
  const Predicate* const predicate = find_predicate(arguments.operands()[0]);
  if (predicate == nullptr)
    return Error{ErrorCode::kUsage,
                 {"predicate: ", in_quotes(arguments.operands()[0]),
                  " is none of orient2d, incircle, orient3d, insphere"}};
  const std::string& path = arguments.operands()[1];
  const auto text = read_input(path, session.largest_input());
  if (!text) return text.error();
  const Progress progress = session.progress();
  Scanner scanner(*text, {display_name(path), progress});
  const std::size_t skipped = arguments.has("--corpus") ? kCorpusFields : 0;
  const std::string output = session.options().output.empty() ? "-" : session.options().output;
  const Status written = session.outputs().add(output, [&](TextWriter& out) {
    while (scanner.next_line()) {
      scanner.skip_fields(skipped);
      out << read_and_decide(scanner, *predicate) << '\n';
    }
  });
  if (!scanner.ok()) return scanner.error();
  if (!written) return written.error();
  return kExitOk;
}

constexpr std::array kPredicateOptions = {
    Option{"--corpus", "", "skip the first two fields of each line (the sign and a tag)"},
};

}  // namespace

extern const Command kPredicate;
const Command kPredicate = {.name = "predicate",
                            .operands = "KIND FILE",
                            .summary =
                                "print one exact sign (-1, 0, 1) for each line of "
                                "coordinates; KIND: orient2d, incircle, orient3d, insphere",
                            .least_operands = 2,
                            .most_operands = 2,
                            .options = kPredicateOptions,
                            .run = run_predicate};

}  // namespace wellspaced::cli
