#include "wellspaced/io/reproduce/published.hpp"

#include <algorithm>

namespace wellspaced {
namespace {

// Source: Dafna Talmor, Well-Spaced Points for Numerical Methods, doctoral thesis, Carnegie Mellon
// University, 1997. One array a table, in the order of the thesis; a row a line.
constexpr double kDash = kNotPrinted;

// clang-format off
// ---- Tables 8.3 to 8.8
constexpr PublishedLevel kGrid1Function[] = {
    {1000000, 45.00, 45.00, 45.00, 45.00, 0, 0, kDash, kDash},
    {236187, 22.62, 22.62, 22.62, 22.62, 0, 0, 8.55, 22.83},
    {44556, 16.86, 18.30, 18.43, 20.12, 0, 0, 11.41, 30.83},
    {10088, 19.35, 19.82, 17.10, 18.72, 0, 0, 9.92, 24.17},
    {2416, 20.50, 21.34, 15.26, 18.18, 0, 0, 9.51, 22.50},
    {607, 21.62, 22.70, 16.70, 20.54, 0, 0, 9.19, 20.33},
    {159, 23.95, 24.89, 18.43, 20.11, 0, 0, 9.02, 18.83},
    {43, 26.92, 28.23, 17.19, 21.83, 0, 0, 8.58, 16.00},
    {19, 32.75, 38.81, 23.35, 29.30, 0, 0, 7.14, 13.33},
    {5, kDash, kDash, 22.75, 33.94, 0, 0, 5.46, 7.83},
    {4, kDash, kDash, 45.00, 45.00, 0, 0, 1.58, 2.17},
};
constexpr PublishedLevel kGrid1Mis[] = {
    {1000000, 45.00, 45.00, 45.00, 45.00, 0, 0, kDash, kDash},
    {236120, 22.62, 22.62, 22.62, 22.62, 0, 0, 8.55, 23.17},
    {56206, 15.26, 17.23, 18.43, 18.43, 0, 0, 9.42, 25.50},
    {13421, 17.03, 18.20, 13.11, 15.96, 0, 0, 9.54, 23.33},
    {3205, 16.65, 18.71, 13.06, 16.27, 0, 0, 9.56, 21.67},
    {771, 18.60, 20.70, 15.34, 16.64, 0, 0, 9.52, 21.00},
    {185, 15.97, 21.93, 16.32, 17.41, 0, 0, 9.51, 18.67},
    {41, 21.67, 25.50, 15.21, 18.01, 0, 0, 9.60, 17.50},
    {10, 16.47, 33.05, 11.67, 16.46, 0, 0, 10.94, 17.83},
    {5, kDash, kDash, 37.83, 39.67, 0, 0, 3.96, 4.67},
    {4, kDash, kDash, 45.00, 45.00, 0, 0, 1.00, 2.00},
};
constexpr PublishedLevel kGrid10Function[] = {
    {1000000, 5.71, 5.71, 5.71, 5.71, 9940090, 39920, kDash, kDash},
    {432944, 11.31, 11.31, 11.31, 11.31, 0, 0, 4.35, 12.00},
    {185342, 18.29, 18.29, 18.29, 19.11, 0, 0, 4.86, 17.20},
    {85310, 21.37, 21.91, 25.87, 26.91, 0, 0, 4.28, 15.40},
    {21594, 19.22, 19.88, 19.03, 20.90, 0, 0, 8.41, 20.80},
    {5518, 20.19, 21.76, 16.62, 18.73, 0, 0, 8.74, 22.00},
    {1450, 21.04, 22.28, 16.70, 18.47, 0, 0, 8.75, 20.40},
    {394, 22.36, 23.39, 15.07, 19.25, 0, 0, 8.57, 18.60},
    {114, 23.94, 27.17, 19.86, 21.43, 0, 0, 8.02, 16.40},
    {35, kDash, kDash, 14.40, 21.69, 0, 0, 7.26, 13.60},
    {13, kDash, kDash, 22.10, 27.15, 0, 0, 5.16, 9.60},
    {6, kDash, kDash, 8.40, 10.04, 0, 7, 4.39, 9.60},
    {4, kDash, kDash, 5.71, 6.57, 0, 8, 1.93, 2.80},
    {4, kDash, kDash, 5.71, 5.71, 0, 2, 1.00, 2},
};
constexpr PublishedLevel kGrid10Mis[] = {
    {1000000, 5.71, 5.71, 5.71, 5.71, 9940090, 39920, kDash, kDash},
    {235736, 5.10, 5.21, 4.58, 4.69, 157947, 8437, 12.92, 75.40},
    {58795, 6.43, 6.73, 4.67, 4.93, 1212, 1330, 10.32, 46.60},
    {13975, 5.71, 6.83, 4.33, 4.88, 22, 229, 9.65, 54.20},
    {3215, 5.85, 7.62, 3.84, 5.26, 11, 99, 9.83, 56.80},
    {675, 3.40, 7.13, 3.10, 5.22, 11, 41, 10.66, 65.20},
    {108, 5.48, 7.95, 3.56, 4.75, 9, 38, 13.85, 61.40},
    {11, kDash, kDash, 2.89, 3.62, 0, 33, 29.76, 54.80},
    {4, kDash, kDash, 5.71, 5.71, 0, 10, 5.10, 6.80},
};
constexpr PublishedLevel kCrackFunction[] = {
    {10183, 37.01, 37.01, 44.94, 44.94, 0, 0, kDash, kDash},
    {3635, 15.07, 18.32, 18.43, 23.88, 0, 0, 5.37, 46.27},
    {2379, 17.10, 18.36, 18.43, 20.83, 0, 0, 2.44, 42.00},
    {1300, 14.03, 18.01, 18.43, 22.38, 0, 0, 3.06, 46.60},
    {466, 17.13, 19.92, 16.70, 21.71, 0, 0, 5.39, 54.57},
    {79, 17.35, 25.21, 18.43, 24.64, 0, 0, 12.22, 50.70},
    {6, kDash, kDash, 45.00, 45.00, 0, 0, 35.88, 45.93},
};
constexpr PublishedLevel kCrackMis[] = {
    {10183, 37.01, 37.01, 44.94, 44.94, 0, 0, kDash, kDash},
    {3028, 13.83, 14.43, 8.13, 12.56, 0, 0.06, 7.93, 20.30},
    {726, 3.97, 10.38, 4.40, 9.68, 0.5, 0.46, 8.74, 19.30},
    {175, 3.22, 7.98, 7.77, 12.99, 1.26, 0.13, 8.83, 18.73},
    {42, 3.46, 8.32, 8.35, 14.08, 1.2, 0.13, 8.98, 17.83},
    {12, 2.29, 8.79, 3.61, 13.87, 1.1, 0.23, 8.50, 14.27},
    {7, 30.12, 30.12, 4.69, 39.89, 0, 0.23, 5.91, 7.67},
    {6, kDash, kDash, 45.00, 45.00, 0, 0, 1.85, 2.75},
};
constexpr PublishedLevel kAirfoil1Function[] = {
    {4253, 17.20, 17.20, 8.18, 8.18, 0, 1, kDash, kDash},
    {1583, 17.25, 19.40, 17.97, 20.31, 0, 0, 4.48, 78.87},
    {462, 20.32, 22.73, 16.66, 21.50, 0, 0, 6.30, 52.60},
    {51, 23.26, 31.31, 6.93, 9.68, 0, 0.33, 18.27, 47.77},
    {13, kDash, kDash, 2.62, 2.62, 0, 4, 8.04, 23.03},
};
constexpr PublishedLevel kAirfoil1Mis[] = {
    {4253, 17.20, 17.20, 8.18, 8.18, 0, 1, kDash, kDash},
    {1028, 8.89, 12.30, 8.22, 11.95, 0.1, 0.2, 8.65, 17.40},
    {259, 4.31, 9.08, 5.84, 10.16, 0.93, 0.73, 8.63, 19.17},
    {62, 3.12, 9.56, 0.21, 0.74, 1.06, 8.93, 9.43, 31.30},
    {19, kDash, kDash, 0.78, 1.63, 0, 6.96, 6.22, 13.83},
    {14, kDash, kDash, 2.62, 2.62, 0, 4.1, 1.46, 3.83},
    {13, kDash, kDash, 2.62, 2.62, 0, 0.4, 0.94, 1.00},
};
constexpr PublishedLevel kAirfoil2Function[] = {
    {6691, 1.60, 1.60, 2.65, 2.65, 0.2, 2.13, kDash, kDash},
    {1727, 10.44, 13.91, 12.26, 15.69, 0, 0, 7.30, 48.47},
    {568, 16.72, 19.50, 16.11, 16.11, 0, 0, 4.86, 58.53},
    {196, 18.88, 19.63, 16.11, 16.11, 0, 0, 5.06, 49.73},
    {18, 36.18, 43.28, 2.31, 2.99, 0, 0.86, 24.62, 46.47},
    {7, kDash, kDash, 1.23, 1.23, 0, 0.1, 5.99, 10.53},
};
constexpr PublishedLevel kAirfoil2Mis[] = {
    {6691, 1.60, 1.60, 2.65, 2.65, 0.2, 2.13, kDash, kDash},
    {1644, 4.11, 6.14, 5.00, 9.54, 5.36, 0.56, 8.92, 31.67},
    {392, 2.54, 7.03, 5.21, 9.33, 2.93, 1.06, 9.04, 22.30},
    {97, 1.29, 4.82, 0.90, 3.78, 4.1, 4.7, 8.94, 19.60},
    {27, 2.33, 9.08, 0.77, 1.75, 1.43, 7.06, 8.58, 17.13},
    {8, kDash, kDash, 0.43, 0.90, 0, 4.7, 7.25, 11.17},
    {7, kDash, kDash, 1.23, 1.23, 0, 3, 1.18, 2.40},
};
constexpr PublishedLevel kAirfoil3Function[] = {
    {15606, 3.58, 3.58, 23.67, 23.67, 5, 0, kDash, kDash},
    {2749, 15.37, 18.78, 16.74, 21.64, 0, 0, 9.40, 88.43},
    {1219, 18.45, 21.17, 16.57, 20.89, 0, 0, 3.67, 56.07},
    {522, 20.36, 23.60, 2.67, 4.28, 0, 2.1, 3.74, 49.53},
    {186, 20.98, 25.08, 0.66, 0.66, 0, 10.43, 5.10, 48.27},
    {26, 39.83, 48.02, 0.26, 0.35, 0, 14.1, 16.71, 49.03},
    {15, kDash, kDash, 0.08, 0.08, 0, 15, 4.31, 15.93},
};
constexpr PublishedLevel kAirfoil3Mis[] = {
    {15606, 3.58, 3.58, 23.67, 23.67, 5, 0, kDash, kDash},
    {3708, 4.43, 8.62, 13.47, 16.66, 1.53, 0, 8.69, 18.53},
    {908, 2.19, 6.85, 5.96, 12.23, 3.56, 0.33, 8.77, 20.80},
    {175, 1.18, 4.62, 0.03, 0.05, 6.13, 25, 11.88, 91.13},
    {44, 0.36, 6.14, 0.08, 0.08, 2.1, 15.86, 8.63, 23.27},
    {17, kDash, kDash, 0.08, 0.08, 0, 14.86, 4.87, 14.23},
    {15, kDash, kDash, 0.08, 0.08, 0, 15, 1.33, 4.50},
};

// ---- Sections 8.4.1 to 8.4.3
constexpr PublishedWork kPathDepth[] = {
    {107, 52, 108, 53, 74, 20, 74, 22, 39, 8, 51, 14, 86, 18, 121, 42},
    {71, 34, 71, 35, 35, 15, 34, 14, 42, 13, 45, 16, 59, 22, 61, 22},
    {65, 31, 55, 28, 25, 11, 21, 10, 32, 13, 25, 11, 46, 18, 44, 18},
    {55, 28, 37, 19, 16, 7, 6, 3, 25, 11, 11, 6, 38, 14, 23, 11},
    {41, 22, 19, 10, 9, 4, kDash, kDash, 15, 8, 3, 1, 28, 13, 14, 7},
    {31, 16, 7, 3, 4, 2, kDash, kDash, 7, 4, kDash, kDash, 19, 9, 6, 2},
    {19, 10, kDash, kDash, kDash, kDash, kDash, kDash, 3, 1, kDash, kDash, 14, 6, kDash, kDash},
    {11, 5, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, 7, 3, kDash, kDash},
    {5, 2, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash},
};
constexpr PublishedWork kNodeSearch[] = {
    {69, 5, 69, 5, 55, 5, 108, 4, 39, 5, 68, 4, 61, 4, 132, 4},
    {41, 7, 77, 6, 41, 5, 82, 4, 43, 5, 96, 4, 52, 5, 93, 5},
    {39, 7, 86, 6, 41, 5, 91, 4, 45, 5, 94, 5, 44, 5, 102, 5},
    {45, 6, 97, 5, 47, 4, 54, 12, 43, 5, 86, 4, 46, 6, 99, 6},
    {42, 5, 89, 4, 47, 6, kDash, kDash, 42, 5, 19, 7, 47, 6, 99, 9},
    {42, 5, 81, 3, 23, 12, kDash, kDash, 43, 4, kDash, kDash, 52, 6, 27, 15},
    {41, 4, kDash, kDash, kDash, kDash, kDash, kDash, 18, 6, kDash, kDash, 53, 7, kDash, kDash},
    {34, 3, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, 49, 14, kDash, kDash},
};
constexpr PublishedWork kEdgeSearch[] = {
    {40, 14, 51, 15, 41, 8, 96, 11, 38, 11, 98, 23, 56, 19, 129, 30},
    {18, 5, 48, 7, 37, 7, 62, 22, 56, 15, 144, 27, 51, 9, 75, 14},
    {31, 6, 16, 4, 37, 7, 62, 22, 41, 13, 81, 14, 39, 8, 78, 15},
    {17, 4, 11, 5, 40, 10, 53, 18, 49, 11, 65, 23, 40, 9, 25, 5},
    {8, 4, 19, 9, 38, 16, kDash, kDash, 16, 7, 17, 10, 32, 6, 36, 12},
    {10, 5, 65, 44, 27, 10, kDash, kDash, 33, 14, kDash, kDash, 11, 4, 46, 10},
    {11, 6, kDash, kDash, kDash, kDash, kDash, kDash, 16, 10, kDash, kDash, 17, 6, kDash, kDash},
    {16, 10, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, 63, 13, kDash, kDash},
    {27, 18, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, kDash, 31, 8, kDash, kDash},
};

// ---- Table 8.1
constexpr PublishedMesh kSuite[] = {
    {"crack", {10183, 20141, 15.43, 1305, 37.00, 97.61, 0, 0}},
    {"airfoil1", {4253, 8034, 9.55, 841, 8.18, 117.08, 1, 7}},
    {"airfoil2", {6691, 13057, 12.93, 1009, 7.11, 163.94, 9, 284}},
    {"airfoil3", {15606, 30269, 14.89, 2032, 9.39, 138.48, 1, 24}},
};

// ---- Section 6.1
constexpr PublishedDegradation kDegradation[] = {
    {33.6, 6}, {23.9, 36}, {16.5, 216}, {11.17, 1296}, {7.5, 7778},
    {5.01, 46656}, {3.34, 279936}, {2.23, 1679616}, {1.49, 10077696}, {0.99, 60466176},
};

// ---- Not from the thesis: found by matching its sizes (section 8.2 gives their numbers).
constexpr Index kAirfoil1Special[] = {0, 265, 1191, 1271, 2153, 2354, 2452, 2918, 2922, 3283, 3496, 3998, 4242};
constexpr Index kAirfoil3Special[] = {0, 538, 704, 2136, 2451, 4814, 9044, 9634, 11193, 12169, 12836, 14028, 14619, 15241, 15267};
constexpr Index kCrackSpecial[] = {0, 20, 40, 4237, 10111, 10182};
// clang-format on

constexpr PublishedSequence kSequences[] = {
    {"grid1", "function", 6, false, kGrid1Function},
    {"grid1", "mis", 6, false, kGrid1Mis},
    {"grid10", "function", 5, true, kGrid10Function},
    {"grid10", "mis", 5, true, kGrid10Mis},
    {"crack", "function", 30, false, kCrackFunction},
    {"crack", "mis", 30, false, kCrackMis},
    {"airfoil1", "function", 30, false, kAirfoil1Function},
    {"airfoil1", "mis", 30, false, kAirfoil1Mis},
    {"airfoil2", "function", 30, false, kAirfoil2Function},
    {"airfoil2", "mis", 30, false, kAirfoil2Mis},
    {"airfoil3", "function", 30, false, kAirfoil3Function},
    {"airfoil3", "mis", 30, false, kAirfoil3Mis},
};

}  // namespace

const PublishedSequence* published_sequence(std::string_view mesh, std::string_view method) {
  const auto* const found = std::ranges::find_if(
      kSequences, [&](const PublishedSequence& s) { return s.mesh == mesh && s.method == method; });
  return found == std::end(kSequences) ? nullptr : found;
}

std::span<const PublishedWork> published_path_depth() { return kPathDepth; }
std::span<const PublishedWork> published_node_search() { return kNodeSearch; }
std::span<const PublishedWork> published_edge_search() { return kEdgeSearch; }
std::span<const PublishedMesh> published_suite() { return kSuite; }
std::span<const PublishedDegradation> published_degradation() { return kDegradation; }

std::span<const Index> special_points_of(std::string_view mesh) {
  if (mesh == "crack") return kCrackSpecial;
  if (mesh == "airfoil1") return kAirfoil1Special;
  if (mesh == "airfoil3") return kAirfoil3Special;
  return {};
}

}  // namespace wellspaced
