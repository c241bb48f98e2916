// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_OUTLOOK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_OUTLOOK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_experience_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_frame_2.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What to expect of a frame, before any work is done that a rebuild would discard. Looks at a
// sample of the edges: at very few if the frame is calm, at more if some of them are broken, or if
// mending was in vain lately.
template <class State>
class Update_outlook_2
{
public:
  Update_outlook_2(const State& state, const Repair_experience_2& experience,
                   std::size_t price_of_rebuild)
    : m_frame(state)
  {
    constexpr std::size_t few = 32, most = 1024, next_to_none = 2;
    const bool may_be_calm = !experience.has_failed_recently();
    if (may_be_calm && is_nearly_proved(few, next_to_none))
      return;
    Sample taken = sample(few);
    if (may_be_calm && taken.broken < next_to_none)
      return;
    const std::size_t edges = m_frame.number_of_edges(), size = (std::min)(edges / 8, most);
    if (size > few)
      taken = sample(size);
    // Where most edges are at the hull, a broken one takes several flips: on a circle five.
    const std::size_t broken = edges * taken.broken / (std::max)(taken.inner, std::size_t(1));
    m_steps = Cost_model_2::steps(broken, edges);
    m_is_hopeless = experience.is_hopeless(taken.size, taken.broken) ||
                    price_of_mending(broken) > price_of_rebuild;
  }

  // Whether a rebuild costs less than mending.
  bool is_hopeless() const { return m_is_hopeless; }
  // In how many steps to take the frame.
  unsigned steps() const { return m_steps; }

private:
  struct Sample
  {
    std::size_t size, inner, broken;
  };

  // Two of five broken edges are uncertain where mending costs as much as a rebuild. In several
  // steps it costs an eighth less. A quarter more than necessary, because a sample may be wrong.
  std::size_t price_of_mending(std::size_t broken) const
  {
    const std::size_t price = Cost_model_2::mending(broken * 3 / 5, broken * 2 / 5) * 4 / 5;
    return m_steps == 1 ? price : price * 7 / 8;
  }

  // A sample of about `size` edges, or of all, takes one of so many.
  std::size_t stride(std::size_t size) const { return 1 + m_frame.number_of_edges() / size; }
  std::size_t number_sampled(std::size_t size) const
  {
    return (m_frame.number_of_edges() + stride(size) - 1) / stride(size);
  }

  // Counts the edges of a sample of a kind. Threads share them.
  using Kind = bool (Update_outlook_2::*)(Edge_index) const;
  std::size_t count_sampled(std::size_t size, Kind is_of_kind) const
  {
    using Parts = typename State::Parts;
    const std::size_t step = stride(size);
    return Parts::sum(number_sampled(size), Parts::size_for(64),
                      [&](std::size_t i, std::size_t beyond) {
                        std::size_t number = 0;
                        for (; i < beyond; ++i)
                          number += (this->*is_of_kind)(Edge_index(i * step));
                        return number;
                      });
  }
  bool is_inner(Edge_index e) const { return !m_frame.is_at_infinity(e); }
  bool is_broken(Edge_index e) const { return !m_frame.is_delaunay(e); }
  bool is_unproved(Edge_index e) const { return is_inner(e) && !m_frame.proves_delaunay(e); }

  // Whether the filter alone proves the edges of a sample, all but less than so many. It is asked
  // first, because every frame pays for it.
  bool is_nearly_proved(std::size_t size, std::size_t many) const
  {
    return count_sampled(size, &Update_outlook_2::is_unproved) < many;
  }

  Sample sample(std::size_t size) const
  {
    return {number_sampled(size), count_sampled(size, &Update_outlook_2::is_inner),
            count_sampled(size, &Update_outlook_2::is_broken)};
  }

  const Dynamic_frame_2<State> m_frame;
  bool m_is_hopeless = false;
  unsigned m_steps = 1;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_OUTLOOK_2_H
