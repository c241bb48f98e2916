// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PROOF_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PROOF_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_search_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_cover_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_zone_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Proves that the faces with an owned corner are faces of the triangulation of all points, and asks
// other ranks about those for which it cannot.
//
// A point of another rank that this rank does not hold is outside of its zone, and within the
// outline. So a finite face is proved if the part of its closed disk within the outline is in the
// zone; an infinite face if no corner of the outline is beyond its edge. All other faces are
// *open*: ranks that may have points in their regions are asked, and send those that they have not
// sent yet, at first a few near ones. These become ghosts, and faces change. Rounds repeat until
// each question about a face that still exists is answered completely. Then a zone that has become
// too small or old is computed anew from the faces, so that the next frames need not ask.
//
// In a periodic space a rank asks itself as well, for images of its own points.
template <class Space>
class Distributed_proof_2
{
  using Kernel = typename Space::Kernel;
  using Shift = typename Space::Shift;
  using Points = Distributed_points_2<Space>;
  using Outline = typename Space::template Outline<Points>;
  using Search = Distributed_search_2<Points>;
  using Question = Distributed_question_2;
  using Questions = std::vector<Question>;

public:
  Distributed_proof_2(Distributed_ranks_2& ranks, Points& points)
    : m_ranks(ranks)
    , m_points(points)
    , m_cover(m_outline)
  {
  }

  // The number of rounds of questions.
  std::size_t number_of_rounds() const { return m_rounds; }
  // The number of frames that needed questions.
  std::size_t number_of_asking_frames() const { return m_asking_frames; }

  // Proves all faces with an owned corner. Collective. Without `trusts_zones` every finite face is
  // open: all ranks that may have points in its disk are asked.
  Update_report_2 run(bool trusts_zones = true)
  {
    Update_report_2 report;
    if (has_no_others())
      return report;
    ++m_zone_age;
    m_outline.gather(m_ranks, m_points);
    m_answered.assign(m_ranks.size(), {});
    Questions open = open_questions(trusts_zones);
    if (!m_ranks.is_any(!open.empty()))
      return report;
    ++m_asking_frames;
    const std::size_t opened = open.size();
    publish_boxes();
    for (std::size_t limit = points_per_answer;; limit *= 4) {
      const std::vector<Questions> questions = posed(open, limit / 4);
      if (!m_ranks.is_any(std::any_of(questions.begin(), questions.end(),
                                      [](const Questions& some) { return !some.empty(); })))
        break;
      ++m_rounds;
      report += ask(questions, limit);
      open = open_questions(trusts_zones);
    }
    renew_zone(opened);
    return report;
  }

  // Prepares the next proof as far as that needs no positions of ghosts. Call it when own points
  // have changed, and zones were deformed.
  void prepare()
  {
    if (has_no_others())
      return;
    if (m_zone.follow(m_points.own_zone()))
      m_density.set_zone(m_zone);
    mark_own_points();
  }

  // Call it when all points have been replaced.
  void forget_zone()
  {
    set_zone(Distributed_zone_2());
    m_uncovered = 0;
  }

private:
  static constexpr std::size_t boxes_per_rank = 16;
  static constexpr std::size_t points_per_answer = 4; // in the first round, then 4 times as many
  static constexpr int zone_lifetime = 16;            // frames; the next questions renew it
  static constexpr std::size_t marks_at_once = 4096;  // points between two calls of `progress()`
  static constexpr double smallest_margin = 1, largest_margin = 8; // cells

  // True if this rank owns the only image of each point.
  bool has_no_others() const { return m_ranks.size() == 1 && !Space::is_periodic; }

  // Calls f(question) for each face with one of the corners whose number is not 0.
  template <class Function>
  void for_each_face(const std::vector<std::uint8_t>& are_corners, const Function& f) const
  {
    const auto frame = m_points.dt().frame();
    const Index faces = frame.number_of_faces();
    for (Face_index g(0); g < faces; ++g) {
      std::array<Vertex_index, 3> face = frame.face(g);
      const auto owned =
          std::find_if(face.begin(), face.end(), [&](Vertex_index v) { return are_corners[v] != 0; });
      if (owned == face.end())
        continue;
      const Position_2 focus = frame.position(*owned);
      const auto infinite = std::find(face.begin(), face.end(), infinite_index);
      if (infinite != face.end()) {
        std::rotate(face.begin(), infinite, face.end());
        const Position_2 p = frame.position(face[1]), q = frame.position(face[2]);
        f(Question{Question::HALF_PLANE, {p.x, p.y, q.x, q.y, 0, 0}, focus.x, focus.y});
        continue;
      }
      const Position_2 p = frame.position(face[0]), q = frame.position(face[1]),
                       r = frame.position(face[2]);
      f(Question{Question::CIRCLE, {p.x, p.y, q.x, q.y, r.x, r.y}, focus.x, focus.y});
    }
  }

  Questions open_questions(bool trusts_zone)
  {
    using Point = typename Kernel::Point_2;
    Questions open;
    if (m_points.dt().frame().number_of_faces() == 0 && !m_points.owned().empty()) {
      const Position_2 p = m_points.position(m_points.owned().front());
      open.push_back({Question::EVERYTHING, {}, p.x, p.y});
    }
    const std::vector<std::uint8_t> corners =
        trusts_zone ? sparse_vertices() : m_points.owned_vertices();
    for_each_face(corners, [&](const Question& question) {
      const Position_2 p = question.corner(0), q = question.corner(1);
      const bool is_proved = question.kind == Question::CIRCLE
                                 ? trusts_zone && m_cover.is_covered(question, m_zone)
                                 : !m_outline.is_any_beyond(Point(p.x, p.y), Point(q.x, q.y));
      if (!is_proved)
        open.push_back(question);
    });
    return open;
  }

  // The vertices of own points whose faces may reach out of the zone, for all that density tells.
  std::vector<std::uint8_t> sparse_vertices()
  {
    m_density.find_dense(m_zone, [&](const auto& add) {
      m_points.for_each_ghost([&](Index place) { add(m_points.position(place)); });
    });
    return m_points.owned_vertices([&](std::size_t k) { return !m_density.is_dense(k); });
  }

  void mark_own_points()
  {
    const std::vector<Index>& owned = m_points.owned();
    m_density.clear(owned.size());
    for (std::size_t k = 0; k < owned.size(); ++k) {
      if (k % marks_at_once == 0)
        m_ranks.exchange().progress();
      m_density.add_own(k, m_zone, m_points.position(owned[k]));
    }
  }

  // Gathers boxes around stretches of the own points of all ranks.
  void publish_boxes()
  {
    std::vector<Box_2> own(boxes_per_rank);
    const std::vector<Index>& owned = m_points.owned();
    for (std::size_t k = 0; k < owned.size(); ++k)
      own[k * boxes_per_rank / owned.size()].add(m_points.position(owned[k]));
    m_boxes = m_ranks.gather(own).values;
  }

  // Returns for each rank the questions for which it may own points, and has not answered
  // completely. A question goes to the nearest ranks first, as their answers may be enough.
  std::vector<Questions> posed(const Questions& open, std::size_t ranks_at_once) const
  {
    std::vector<Questions> questions(m_ranks.size());
    std::vector<std::pair<double, std::size_t>> candidates;
    for (const Question& question : open) {
      candidates.clear();
      for (std::size_t r = 0; r < m_ranks.size(); ++r) {
        if (m_answered[r].count(question) > 0)
          continue;
        const double nearest = squared_distance_to(r, question);
        if (nearest < Box_2::infinity)
          candidates.emplace_back(nearest, r);
      }
      std::sort(candidates.begin(), candidates.end());
      for (std::size_t k = 0; k < (std::min)(candidates.size(), ranks_at_once); ++k)
        questions[candidates[k].second].push_back(question);
    }
    return questions;
  }

  // How near to the focus a rank may own points in the region; infinity if it owns none there.
  double squared_distance_to(std::size_t r, const Question& question) const
  {
    double nearest = Box_2::infinity;
    const Box_2 region = m_outline.box_for(question).common_part(question.box());
    for (std::size_t k = r * boxes_per_rank; k < (r + 1) * boxes_per_rank; ++k)
      m_points.space().for_each_shift(m_boxes[k], region, [&](const Shift& shift) {
        const Box_2 box = m_boxes[k].moved(m_points.space().vector(shift));
        if (!m_points.is_own_image(r, shift) && question.may_meet<Kernel>(box))
          nearest = (std::min)(nearest, box.squared_distance(question.x, question.y));
      });
    return nearest;
  }

  Update_report_2 ask(const std::vector<Questions>& questions, std::size_t limit)
  {
    std::vector<Message_2> messages = m_ranks.empty_messages();
    std::vector<Message_2> answers = m_ranks.empty_messages();
    for (std::size_t r = 0; r < m_ranks.size(); ++r)
      for (const Question& question : questions[r])
        messages[r].write(question);
    std::vector<Message_2> asked = m_ranks.send(std::move(messages));
    if (!asked.empty()) {
      const Search search(m_points);
      for (Message_2& message : asked)
        answer(search, message, answers[std::size_t(message.rank())], limit);
    }
    std::vector<typename Points::Coming> coming;
    for (Message_2& message : m_ranks.send(std::move(answers))) {
      const auto r = std::size_t(message.rank());
      for (const Question& question : questions[r]) {
        if (message.template read<std::uint64_t>() != 0)
          m_answered[r].insert(question);
        for (auto n = message.template read<std::uint64_t>(); n > 0; --n) {
          const auto shift = message.template read<Shift>();
          coming.push_back({r, shift, message.template read<typename Points::Sent>()});
        }
      }
    }
    return m_points.import(coming);
  }

  // An image of an own point that is in a region, and that the asking rank does not hold.
  struct Found
  {
    double squared_distance; // from the focus
    Index place;
    Shift shift;

    friend bool operator<(const Found& f, const Found& g)
    {
      return std::tie(f.squared_distance, f.place, f.shift) <
             std::tie(g.squared_distance, g.place, g.shift);
    }
  };

  // Answers each question with up to `limit` points near the focus, in its region, that the asking
  // rank does not hold, and tells whether these are all.
  void answer(const Search& search, Message_2& questions, Message_2& answers, std::size_t limit)
  {
    const auto r = std::size_t(questions.rank());
    while (!questions.is_read()) {
      std::vector<Found> found = find_inside(search, questions.template read<Question>(), r, limit);
      const std::size_t sent = (std::min)(limit, found.size());
      std::partial_sort(found.begin(), found.begin() + std::ptrdiff_t(sent), found.end());
      answers.write(std::uint64_t(sent == found.size()));
      answers.write(std::uint64_t(sent));
      for (std::size_t k = 0; k < sent; ++k) {
        answers.write(found[k].shift);
        answers.write(m_points.sent(found[k].place, found[k].shift));
        m_points.export_to(r, found[k].place, found[k].shift);
      }
    }
  }

  // Returns all points of an answer; or, if there are more than `limit`, at least those in a square
  // around the focus that contains more than `limit`.
  std::vector<Found> find_inside(const Search& search, const Question& question, std::size_t rank,
                                 std::size_t limit) const
  {
    const Box_2 box = m_outline.box_for(question);
    const Box_2 focus{question.x, question.y, question.x, question.y};
    for (double reach = (std::max)(4 * search.cell_size(), box.longer_side() / 256);; reach *= 4) {
      const Box_2 part = box.common_part(focus.enlarged(reach));
      std::vector<Found> found = find_inside(search, question, rank, part);
      if (found.size() > limit || part == box)
        return found;
    }
  }

  std::vector<Found> find_inside(const Search& search, const Question& question, std::size_t rank,
                                 const Box_2& box) const
  {
    std::vector<Found> found;
    const auto& space = m_points.space();
    space.for_each_shift(search.box(), box.common_part(question.box()), [&](const Shift& shift) {
      const Position_2 v = space.vector(shift);
      const Question moved = question.moved_back(v);
      search.for_each_inside(moved, box.moved({-v.x, -v.y}), [&](Index place) {
        const Position_2 p = m_points.position(place);
        if (box.contains(p.x + v.x, p.y + v.y) && !m_points.is_held_by(rank, place, shift))
          found.push_back({squared_distance(p, {moved.x, moved.y}), place, shift});
      });
    });
    return found;
  }

  // Renews the zone if it leaves more faces open than when it was new, or is old: else another
  // would not be better. Failing early widens the margin, failing late narrows it.
  void renew_zone(std::size_t opened)
  {
    const bool is_renewed = opened > m_uncovered || m_zone_age >= zone_lifetime;
    if (is_renewed) {
      if (opened > m_uncovered)
        m_margin *= m_zone_age < zone_lifetime / 2   ? 1.5
                    : m_zone_age > 2 * zone_lifetime ? 0.75
                                                     : 1;
      m_margin = (std::min)((std::max)(m_margin, smallest_margin), largest_margin);
      set_zone(zone_around_faces());
      m_zone_age = 0;
      m_uncovered = open_questions(true).size();
    }
    m_points.publish(is_renewed ? &m_zone : nullptr);
  }

  void set_zone(Distributed_zone_2 zone)
  {
    m_zone = std::move(zone);
    m_density.set_zone(m_zone);
    mark_own_points();
  }

  Distributed_zone_2 zone_around_faces() const
  {
    Box_2 box;
    for (const Index place : m_points.owned())
      box.add(m_points.position(place));
    double size = usual_diameter() / 2;
    if (box.is_empty() || !(size > 0))
      return Distributed_zone_2();
    const double extent = box.longer_side();
    const double most = double(Distributed_zone_2::most_cells - 1);
    const double coordinates = (std::max)(box.largest_x(), box.largest_y());
    size = (std::max)({size, extent / (most - 40), Space::finest_zone * coordinates});
    const double reach = (std::max)(16 * size, (std::min)(extent, (most * size - extent) / 2));
    Distributed_zone_2 zone(box.enlarged(reach), size, m_points.space().basis());
    for_each_face(m_points.owned_vertices(), [&](const Question& question) {
      if (question.kind == Question::CIRCLE)
        m_cover.extend(question, zone, m_margin * size);
    });
    zone.sum_up();
    return zone;
  }

  // The median diameter of the disks that have finite boxes; 0 if there is none.
  double usual_diameter() const
  {
    std::vector<double> diameters;
    for_each_face(m_points.owned_vertices(), [&](const Question& question) {
      const Box_2 box = question.kind == Question::CIRCLE ? question.box_of_disk() : Box_2();
      if (box.width() < Box_2::infinity && !box.is_empty())
        diameters.push_back(box.width());
    });
    if (diameters.empty())
      return 0;
    const auto middle = diameters.begin() + std::ptrdiff_t(diameters.size() / 2);
    std::nth_element(diameters.begin(), middle, diameters.end());
    return *middle;
  }

  Distributed_ranks_2& m_ranks;
  Points& m_points;
  Outline m_outline;
  Distributed_cover_2<Kernel, Outline> m_cover;
  Distributed_zone_2 m_zone;
  Distributed_density_2 m_density;
  double m_margin = smallest_margin;
  int m_zone_age = 0;
  std::size_t m_uncovered = 0;                // how many faces the zone left open when it was new
  std::vector<Box_2> m_boxes;                 // of all ranks
  std::vector<std::set<Question>> m_answered; // by ranks
  std::size_t m_rounds = 0, m_asking_frames = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PROOF_2_H
