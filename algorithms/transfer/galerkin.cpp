#include "wellspaced/algorithms/transfer/galerkin.hpp"

#include <algorithm>

#include "wellspaced/kernel/graph.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

OperatorSize size_of(const SparsityPattern& a) {
  OperatorSize size{a.entries(), 0, 0};
  for (Index i = 0; i < a.rows(); ++i) size.row_max = std::max(size.row_max, a.row(i).size());
  if (a.rows() > 0) size.row_mean = static_cast<double>(size.entries) / a.rows();
  return size;
}

}  // namespace

SparsityPattern operator_pattern(const TriangleMesh& mesh) {
  const Graph graph = mesh_graph(mesh);
  SparsityPattern pattern;
  pattern.columns = graph.nodes();
  pattern.column.reserve(graph.arcs.size() + graph.nodes());
  for (Index v = 0; v < graph.nodes(); ++v) {
    pattern.column.push_back(v);
    for (const Graph::Arc& arc : graph.arcs_of(v)) pattern.column.push_back(arc.target);
    sort(std::span(pattern.column).subspan(pattern.first.back()));
    pattern.end_row();
  }
  return pattern;
}

SparsityPattern galerkin_pattern(const SparsityPattern& a, const SparsityPattern& p,
                                 const Progress& progress) {
  const SparsityPattern restriction = transposed(p);
  SparsityPattern product;
  product.columns = p.columns;
  std::vector<Index> seen(p.columns, kNoIndex), seen_fine(p.rows(), kNoIndex);
  ProgressMeter meter(progress, "measure", p.columns, 1 << 12);
  for (Index i = 0; i < p.columns && meter.step(); ++i) {
    for (const Index u : restriction.row(i))
      for (const Index v : a.row(u)) {
        if (seen_fine[v] == i) continue;
        seen_fine[v] = i;
        for (const Index j : p.row(v)) {
          if (seen[j] == i) continue;
          seen[j] = i;
          product.column.push_back(j);
        }
      }
    sort(std::span(product.column).subspan(product.first.back()));
    product.end_row();
  }
  return product;
}

std::vector<OperatorSize> operator_sizes(const TriangleMesh& finest,
                                         std::span<const Transfer> transfers,
                                         const Progress& progress) {
  SparsityPattern a = operator_pattern(finest);
  std::vector<OperatorSize> sizes{size_of(a)};
  ProgressParts parts(progress, "measure", transfers.size());
  for (std::size_t k = 0; k < transfers.size() && parts.go_on(k); ++k) {
    a = galerkin_pattern(a, transfers[k].prolongation, parts.part(k));
    sizes.push_back(size_of(a));
  }
  return sizes;
}

double operator_complexity(std::span<const OperatorSize> sizes) {
  double sum = 0;
  for (const OperatorSize& size : sizes) sum += static_cast<double>(size.entries);
  return sum / static_cast<double>(sizes[0].entries);
}

}  // namespace wellspaced
