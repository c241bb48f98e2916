// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_ORDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_ORDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Spreads points evenly over ranks. Each rank gets a stretch of the Hilbert curve through the box
// of all points, by sorting with regular samples (H. Shi, J. Schaeffer, Parallel sorting by regular
// sampling, 1992). Points in one cell of the curve are in the order of their ids. Keeps where
// points went, so that the user's data can follow them.
class Distributed_order_2
{
  using Id = Distributed_id_2;
  using Entry = Distributed_entry_2;

public:
  // Distributes points. Returns those of this rank, in their order along the curve. Collective.
  template <class Space>
  std::vector<Entry> distribute(Distributed_ranks_2& ranks, const Space& space,
                                const std::vector<Entry>& own)
  {
    const std::vector<Key> keys = keys_of(ranks, space, own);
    const std::vector<Key> splitters = find_splitters(ranks, keys);
    m_destinations.clear();
    const std::vector<Sent> arrived = ranks.delivered<Sent>([&](const auto& post) {
      for (std::size_t k = 0; k < own.size(); ++k) {
        const auto r = std::size_t(std::upper_bound(splitters.begin(), splitters.end(), keys[k]) -
                                   splitters.begin());
        m_destinations.push_back(r);
        post(r, {keys[k], own[k]});
      }
    });
    m_origins.resize(arrived.size());
    std::iota(m_origins.begin(), m_origins.end(), std::size_t(0));
    std::sort(m_origins.begin(), m_origins.end(),
              [&](std::size_t k, std::size_t l) { return arrived[k].key < arrived[l].key; });
    std::vector<Entry> entries;
    for (const std::size_t k : m_origins)
      entries.push_back(arrived[k].entry);
    return entries;
  }

  // Forgets the last distribution: this rank has owned, and owns, so many points.
  void stay(const Distributed_ranks_2& ranks, std::size_t size)
  {
    m_destinations.assign(size, std::size_t(ranks.rank()));
    m_origins.resize(size);
    std::iota(m_origins.begin(), m_origins.end(), std::size_t(0));
  }

  // How many points this rank owned before the last distribution.
  std::size_t size_before() const { return m_destinations.size(); }

  // Returns data of the points that this rank owns now, given those of its points before.
  // Collective.
  template <class T>
  std::vector<T> carry(Distributed_ranks_2& ranks, const std::vector<T>& data) const
  {
    const std::vector<T> arrived = ranks.delivered<T>([&](const auto& post) {
      for (std::size_t k = 0; k < data.size(); ++k)
        post(m_destinations[k], data[k]);
    });
    std::vector<T> carried;
    for (const std::size_t k : m_origins)
      carried.push_back(arrived[k]);
    return carried;
  }

private:
  struct Key
  {
    std::uint64_t place;
    Id id;

    friend bool operator<(const Key& a, const Key& b)
    {
      return std::tie(a.place, a.id) < std::tie(b.place, b.id);
    }
  };
  struct Sent
  {
    Key key;
    Entry entry;
  };
  struct Sample
  {
    Key key;
    double weight; // how many points it stands for
  };

  static constexpr std::size_t samples_per_rank = 64;

  template <class Space>
  static std::vector<Key> keys_of(Distributed_ranks_2& ranks, const Space& space,
                                  const std::vector<Entry>& own)
  {
    Box_2 box;
    std::vector<typename Space::Image> images;
    for (const Entry& entry : own) {
      images.push_back(space.first_image({entry.x, entry.y}));
      box.add({images.back().x, images.back().y});
    }
    box.x_high = ranks.largest(box.x_high);
    box.y_high = ranks.largest(box.y_high);
    box.x_low = -ranks.largest(-box.x_low);
    box.y_low = -ranks.largest(-box.y_low);
    // Halves, as the difference of two doubles may overflow.
    const double half = (std::max)(box.x_high / 2 - box.x_low / 2, box.y_high / 2 - box.y_low / 2);
    const auto cell = [&](double coordinate, double low) {
      const double part = half > 0 ? (coordinate / 2 - low / 2) / half : 0;
      return std::uint32_t((std::min)(part * 0x1p16, 0x1p16 - 1));
    };
    const Hilbert_curve_2 curve;
    std::vector<Key> keys;
    for (std::size_t k = 0; k < own.size(); ++k)
      keys.push_back(
          {curve.place(cell(images[k].x, box.x_low), cell(images[k].y, box.y_low)), own[k].id});
    return keys;
  }

  // Returns splitters: rank r gets the keys from splitter r - 1 on that are less than splitter r.
  static std::vector<Key> find_splitters(Distributed_ranks_2& ranks, std::vector<Key> keys)
  {
    std::sort(keys.begin(), keys.end());
    const std::size_t n = keys.size(), number = (std::min)(n, samples_per_rank);
    std::vector<Sample> samples;
    for (std::size_t k = 0; k < number; ++k)
      samples.push_back({keys[k * n / number], double(n) / double(number)});
    std::vector<Sample> all = ranks.gather(samples).values;
    std::sort(all.begin(), all.end(),
              [](const Sample& a, const Sample& b) { return a.key < b.key; });
    double total = 0, sum = 0;
    for (const Sample& sample : all)
      total += sample.weight;
    std::vector<Key> splitters;
    for (const Sample& sample : all) {
      while (splitters.size() + 1 < ranks.size() &&
             sum >= total * double(splitters.size() + 1) / double(ranks.size()) - 1e-6)
        splitters.push_back(sample.key);
      sum += sample.weight;
    }
    return splitters;
  }

  std::vector<std::size_t> m_destinations; // the ranks that the points before went to
  std::vector<std::size_t> m_origins;      // of the points since: their numbers in order of arrival
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_ORDER_2_H
