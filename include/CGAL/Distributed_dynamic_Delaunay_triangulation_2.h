// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Message_exchange_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

Another rank of a distributed triangulation was given bad input, and throws its own error. Nothing
changes on any rank.
*/
class Distributed_input_error_2 : public Dynamic_Delaunay_triangulation_error_2
{
public:
  /// \cond
  explicit Distributed_input_error_2(int rank)
    : Dynamic_Delaunay_triangulation_error_2("rank " + std::to_string(rank) +
                                             " was given bad input, and says which")
    , m_rank(rank)
  {
  }
  /// \endcond

  /// the first rank with bad input.
  int rank() const { return m_rank; }

private:
  int m_rank;
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The Delaunay triangulation of moving points of the plane that are spread over the ranks of an MPI
communicator. Each rank owns some points, and holds copies of points of other ranks, its *ghosts*.
All functions that are called *collective* must be called by all ranks.

After construction and after each update every face with a corner that the rank owns is proved to be
one of the triangulation of all points: no point of any rank is strictly inside of its circumcircle,
and all points on that circle are held. Where more than three points are on an empty circle, the
diagonals go to the one with the smallest id, whatever rank asks. So edges and faces depend only on
points and ids, not on how many ranks there are or what they own.

Proof: a face whose closed circumdisk has no other points inside is part of a cell of the Delaunay
complex of all points, and so is an infinite face with no point beyond its hull edge. The faces
around an owned vertex close around it, so they are all that the complex has there; and as points on
their circles are held, the rank holds each of these cells whole.

Where all points are on a line every rank holds all of them.

\tparam Kernel a CGAL kernel with exact predicates whose points have coordinates of type `double`.
*/
template <class Kernel>
class Distributed_dynamic_Delaunay_triangulation_2
{
  static_assert(
      Dynamic_Delaunay_triangulations_2::internal::has_double_coordinates<typename Kernel::Point_2>,
      "the coordinates of distributed points must be of type double");

  using Dynamic = Dynamic_Delaunay_triangulation_2<Kernel>;
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;
  using Mirror = Dynamic_Delaunay_triangulations_2::internal::Neighborhood_mirror_2;
  using Message = Dynamic_Delaunay_triangulations_2::internal::Message_2;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;

public:
  /// a point.
  using Point = typename Kernel::Point_2;
  /// an id, unique over all ranks.
  using Id = std::int64_t;
  /// the type of counts.
  using size_type = std::size_t;

  /// triangulates the points of all ranks. Collective. The rank owns the points of its range, in
  /// this order. \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \pre no id is given on two ranks.
  /// \throws Non_finite_coordinate_error_2 or Coordinate_range_error_2 (`id()` is the place in the
  /// range), Repeated_id_error_2, or Distributed_input_error_2 on the other ranks.
  template <class InputIterator>
  Distributed_dynamic_Delaunay_triangulation_2(MPI_Comm communicator, InputIterator first,
                                               InputIterator beyond)
    : m_communicator(communicator)
    , m_exchange(m_communicator.handle)
    , m_rank(rank_in(m_communicator.handle))
    , m_ranks(size_of(m_communicator.handle))
    , m_exports(m_ranks)
    , m_imports(m_ranks)
  {
    const Floating_point floating_point;
    agree([&] {
      std::set<Id> ids;
      for (; first != beyond; ++first) {
        auto&& value = *first;
        check(value.second, m_points.size());
        if (!ids.insert(value.first).second)
          throw Repeated_id_error_2(value.first);
        m_ids.push_back(value.first);
        m_points.push_back(value.second);
      }
    });
    m_owned = m_points.size();
    std::vector<size_type> local;
    m_dt.insert(m_points.begin(), m_points.end(), std::back_inserter(local));
    prove();
  }

  /// moves the points that this rank owns to these positions, in the order of `owned_ids()`.
  /// Collective.
  ///
  /// Each rank sends the positions of points that others hold as ghosts, and updates its own
  /// triangulation. Then it asks the ranks whose points may be inside of circumcircles; what they
  /// answer becomes ghosts, until there are no questions.
  /// \throws Point_count_error_2, Non_finite_coordinate_error_2 or Coordinate_range_error_2, or
  /// Distributed_input_error_2 on the other ranks; nothing has changed then on any rank.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    std::vector<Point> next;
    agree([&] {
      for (; first != beyond; ++first) {
        const Point& p = *first;
        if (next.size() == m_owned)
          throw Point_count_error_2(m_owned, m_owned + 1);
        check(p, next.size());
        next.push_back(p);
      }
      if (next.size() != m_owned)
        throw Point_count_error_2(m_owned, next.size());
    });
    std::copy(next.begin(), next.end(), m_points.begin());
    move_ghosts();
    m_is_certified = false;
    Update_report_2 report = m_dt.update(m_points.begin(), m_points.end());
    report += prove();
    return report;
  }

  /// the ids of the points that this rank owns, in the order of updates.
  std::vector<Id> owned_ids() const
  {
    return std::vector<Id>(m_ids.begin(), m_ids.begin() + std::ptrdiff_t(m_owned));
  }
  /// the number of points that this rank owns.
  size_type number_of_owned_points() const { return m_owned; }
  /// the number of points of other ranks that this one holds.
  size_type number_of_ghosts() const { return m_points.size() - m_owned; }
  /// how often ranks have asked each other since construction.
  size_type number_of_rounds() const { return m_rounds; }
  /// messages and bytes that this rank has sent since construction, but for collective calls.
  size_type number_of_messages() const { return m_exchange.sent_messages(); }
  /// the same in bytes.
  size_type number_of_bytes() const { return m_exchange.sent_bytes(); }
  /// whether every face with an owned corner is proved. False only if an exception ended a call.
  bool is_certified() const { return m_is_certified; }

  /// calls `f(i, j)` for each finite edge whose smaller id, `i`, this rank owns: over all ranks,
  /// once for each edge. Of points that coincide, the one with the smallest id has the edges.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    const std::vector<Index> label = labels();
    if (m_dt.frame().number_of_faces() == 0) {
      m_dt.for_each_edge([&](size_type i, size_type j) {
        call(f, label[m_dt.frame().vertex(i)], label[m_dt.frame().vertex(j)]);
      });
      return;
    }
    for_each_cell(label, [&](const std::vector<Corner>& corners, std::size_t apex) {
      const std::size_t n = corners.size();
      for (std::size_t k = 0; k < n; ++k) {
        const Index a = corners[k].label, b = corners[(k + 1) % n].label;
        if (m_ids[a] < m_ids[b] || corners[k].is_on_hull)
          call(f, a, b);
        if (k >= 2 && k + 1 < n)
          call(f, corners[apex].label, corners[(apex + k) % n].label);
      }
    });
  }

  /// calls `f(ids)` for each finite face whose smallest id this rank owns: over all ranks, once for
  /// each face. `ids` is an array of three ids, counterclockwise, the smallest one first.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    for_each_cell(labels(), [&](const std::vector<Corner>& corners, std::size_t apex) {
      const std::size_t n = corners.size();
      if (corners[apex].label >= m_owned)
        return;
      for (std::size_t k = 1; k + 1 < n; ++k)
        f(std::array<Id, 3>{m_ids[corners[apex].label], m_ids[corners[(apex + k) % n].label],
                            m_ids[corners[(apex + k + 1) % n].label]});
    });
  }

private:
  struct Communicator
  {
    explicit Communicator(MPI_Comm other) { MPI_Comm_dup(other, &handle); }
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;
    ~Communicator() { MPI_Comm_free(&handle); }
    MPI_Comm handle;
  };
  struct Box
  {
    double x_low, y_low, x_high, y_high;

    static Box of_nothing() { return {infinity, infinity, -infinity, -infinity}; }
    static Box of_everything() { return {-infinity, -infinity, infinity, infinity}; }
    void add(double x, double y)
    {
      x_low = (std::min)(x_low, x), y_low = (std::min)(y_low, y);
      x_high = (std::max)(x_high, x), y_high = (std::max)(y_high, y);
    }
    bool meets(const Box& b) const
    {
      return x_low <= b.x_high && b.x_low <= x_high && y_low <= b.y_high && b.y_low <= y_high;
    }
    bool is_empty() const { return !(x_low <= x_high); }
  };
  enum Kind : std::int64_t { CIRCLE, HALF_PLANE, EVERYTHING };
  // Which points are in a region? `focus` is an owned corner: answers begin with what is near it.
  struct Question
  {
    Kind kind;
    std::array<double, 6> corners;
    Box box; // around the region
    double x, y;

    friend bool operator<(const Question& q, const Question& r)
    {
      return std::make_pair(q.kind, q.corners) < std::make_pair(r.kind, r.corners);
    }
    Point corner(std::size_t i) const { return Point(corners[2 * i], corners[2 * i + 1]); }
  };
  struct Entry
  {
    Id id;
    double x, y;
  };
  struct Corner
  {
    Index label;
    bool is_on_hull; // the edge to the next corner
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t boxes_per_rank = 16;
  static constexpr std::size_t points_per_answer =
      16; // in the first round, then four times as many

  static int rank_in(MPI_Comm communicator)
  {
    int rank;
    MPI_Comm_rank(communicator, &rank);
    return rank;
  }
  static std::size_t size_of(MPI_Comm communicator)
  {
    int size;
    MPI_Comm_size(communicator, &size);
    return std::size_t(size);
  }
  static void check(const Point& p, size_type place)
  {
    Dynamic_Delaunay_triangulations_2::internal::checked_position(p, place);
  }

  // Reads input; if that throws on any rank it throws on all of them.
  template <class Read>
  void agree(const Read& read)
  {
    std::exception_ptr error;
    try {
      read();
    } catch (...) {
      error = std::current_exception();
    }
    int first = error ? m_rank : int(m_ranks), lowest;
    MPI_Allreduce(&first, &lowest, 1, MPI_INT, MPI_MIN, m_communicator.handle);
    if (error)
      std::rethrow_exception(error);
    if (lowest < int(m_ranks))
      throw Distributed_input_error_2(lowest);
  }

  std::vector<Message> empty_messages() const
  {
    std::vector<Message> messages;
    for (std::size_t r = 0; r < m_ranks; ++r)
      messages.emplace_back(int(r));
    return messages;
  }

  void move_ghosts()
  {
    std::vector<Message> messages = empty_messages();
    for (std::size_t r = 0; r < m_ranks; ++r)
      for (const Index i : m_exports[r])
        messages[r].write(Position{m_points[i].x(), m_points[i].y()});
    for (Message& message : m_exchange(std::move(messages)))
      for (const Index i : m_imports[std::size_t(message.rank())]) {
        const Position p = message.template read<Position>();
        m_points[i] = Point(p.x, p.y);
      }
  }

  // Boxes around stretches of the owned points, of all ranks.
  void publish_boxes()
  {
    std::array<Box, boxes_per_rank> own;
    own.fill(Box::of_nothing());
    for (size_type i = 0; i < m_owned; ++i)
      own[i * boxes_per_rank / m_owned].add(m_points[i].x(), m_points[i].y());
    m_boxes.resize(m_ranks * boxes_per_rank);
    MPI_Allgather(own.data(), int(sizeof(own)), MPI_BYTE, m_boxes.data(), int(sizeof(own)),
                  MPI_BYTE, m_communicator.handle);
  }

  Update_report_2 prove()
  {
    Update_report_2 report;
    publish_boxes();
    std::vector<std::set<Question>> answered(m_ranks);
    for (std::size_t limit = points_per_answer;; limit *= 4) {
      const std::vector<std::vector<Question>> questions = find_questions(answered);
      std::uint64_t count = 0, sum;
      for (const auto& of_rank : questions)
        count += of_rank.size();
      MPI_Allreduce(&count, &sum, 1, MPI_UINT64_T, MPI_SUM, m_communicator.handle);
      if (sum == 0)
        break;
      ++m_rounds;
      ask(questions, limit, answered, report);
    }
    report.certified = m_is_certified = m_dt.is_certified();
    return report;
  }

  void ask(const std::vector<std::vector<Question>>& questions, std::size_t limit,
           std::vector<std::set<Question>>& answered, Update_report_2& report)
  {
    std::vector<Message> messages = empty_messages(), answers = empty_messages();
    for (std::size_t r = 0; r < m_ranks; ++r)
      for (const Question& question : questions[r])
        messages[r].write(question);
    for (Message& message : m_exchange(std::move(messages)))
      answer(message, answers[std::size_t(message.rank())], limit);
    std::vector<Point> coming;
    for (Message& message : m_exchange(std::move(answers))) {
      const auto r = std::size_t(message.rank());
      for (const Question& question : questions[r]) {
        if (message.template read<std::uint64_t>() != 0)
          answered[r].insert(question);
        for (auto n = message.template read<std::uint64_t>(); n > 0; --n) {
          const Entry entry = message.template read<Entry>();
          m_imports[r].push_back(Index(m_points.size()));
          m_ids.push_back(entry.id);
          m_points.push_back(Point(entry.x, entry.y));
          coming.push_back(m_points.back());
        }
      }
    }
    std::vector<size_type> local;
    report += m_dt.insert(coming.begin(), coming.end(), std::back_inserter(local));
  }

  // Sends the points in the regions that the other rank does not hold: those near the focus.
  void answer(Message& questions, Message& answers, std::size_t limit)
  {
    const auto r = std::size_t(questions.rank());
    std::vector<bool> is_exported(m_owned, false);
    for (const Index i : m_exports[r])
      is_exported[i] = true;
    while (!questions.is_read()) {
      const Question question = questions.template read<Question>();
      std::vector<std::pair<double, Index>> found;
      for (Index i = 0; i < m_owned; ++i)
        if (!is_exported[i] && contains(question, m_points[i]))
          found.emplace_back(std::hypot(m_points[i].x() - question.x, m_points[i].y() - question.y),
                             i);
      const std::size_t sent = (std::min)(limit, found.size());
      std::partial_sort(found.begin(), found.begin() + std::ptrdiff_t(sent), found.end());
      answers.write(std::uint64_t(sent == found.size()));
      answers.write(std::uint64_t(sent));
      for (std::size_t k = 0; k < sent; ++k) {
        const Index i = found[k].second;
        answers.write(Entry{m_ids[i], m_points[i].x(), m_points[i].y()});
        m_exports[r].push_back(i);
        is_exported[i] = true;
      }
    }
  }

  static bool contains(const Question& question, const Point& p)
  {
    const Kernel kernel;
    switch (question.kind) {
    case CIRCLE:
      return question.box.meets(Box{p.x(), p.y(), p.x(), p.y()}) &&
             kernel.side_of_oriented_circle_2_object()(question.corner(0), question.corner(1),
                                                       question.corner(2), p) != ON_NEGATIVE_SIDE;
    case HALF_PLANE:
      return kernel.orientation_2_object()(question.corner(0), question.corner(1), p) == LEFT_TURN;
    default:
      return true;
    }
  }

  // Whether the region may contain a point of a box.
  static bool may_meet(const Question& question, const Box& box)
  {
    if (box.is_empty())
      return false;
    if (question.kind == CIRCLE)
      return question.box.meets(box);
    return contains(question, Point(box.x_low, box.y_low)) ||
           contains(question, Point(box.x_low, box.y_high)) ||
           contains(question, Point(box.x_high, box.y_low)) ||
           contains(question, Point(box.x_high, box.y_high));
  }

  // A box around the circumcircle. With e = 2^-53 the sides u and v from one corner are off by e
  // times themselves, so that D = u x v is off by less than 8 e |u||v|. Where |u|^2 + |v|^2 is at
  // most 2^12 D, that is 2^-38 D. The radius is |u||v||u - v| / 2D; the numerators of the
  // circumcenter are off by less than 16 e |u||v| (|u| + |v|), and |u| + |v| is at most four radii:
  // so the circumcenter is off by less than 2^-34 radii. 2^-30 radii cover that, the rounding of
  // the radius, and second order; 2^-50 of the coordinates cover the last sums. Within the limits
  // of |u|^2 + |v|^2 nothing overflows, and what underflows is smaller than these by far.
  static Box box_around(const Position& p, const Position& q, const Position& r)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Position u = q - p, v = r - p;
    const double squares = dot(u, u) + dot(v, v), doubled_area = cross(u, v);
    if (!(squares > 0x1p-200 && squares < 0x1p200 && squares <= 0x1p12 * doubled_area))
      return Box::of_everything();
    const Position c = circumcenter(u, v);
    const double radius = std::hypot(c.x, c.y) * (1 + 0x1p-30);
    const double x = p.x + c.x, y = p.y + c.y;
    const double pad_x = radius + 0x1p-50 * (std::abs(p.x) + radius);
    const double pad_y = radius + 0x1p-50 * (std::abs(p.y) + radius);
    return {x - pad_x, y - pad_y, x + pad_x, y + pad_y};
  }

  // Those of all faces with an owned corner, by ranks.
  std::vector<std::vector<Question>>
  find_questions(const std::vector<std::set<Question>>& answered) const
  {
    std::vector<std::vector<Question>> questions(m_ranks);
    const auto pose = [&](const Question& question) {
      for (std::size_t r = 0; r < m_ranks; ++r) {
        const Box* const boxes = &m_boxes[r * boxes_per_rank];
        if (r != std::size_t(m_rank) && answered[r].count(question) == 0 &&
            std::any_of(boxes, boxes + boxes_per_rank,
                        [&](const Box& box) { return may_meet(question, box); }))
          questions[r].push_back(question);
      }
    };
    const auto frame = m_dt.frame();
    if (frame.number_of_faces() == 0 && m_owned > 0)
      pose({EVERYTHING, {}, Box::of_everything(), m_points[0].x(), m_points[0].y()});
    const std::vector<bool> is_owned = owned_vertices();
    for (Index f = 0; f < frame.number_of_faces(); ++f) {
      std::array<Index, 3> face = frame.face(f);
      const auto owned =
          std::find_if(face.begin(), face.end(), [&](Index v) { return is_owned[v]; });
      if (owned == face.end())
        continue;
      const Position focus = frame.position(*owned);
      const auto infinite = std::find(face.begin(), face.end(), Index(0));
      const bool is_finite = infinite == face.end();
      if (!is_finite)
        std::rotate(face.begin(), infinite, face.end());
      const Position p = frame.position(face[0]), q = frame.position(face[1]),
                     r = frame.position(face[2]);
      if (is_finite)
        pose({CIRCLE, {p.x, p.y, q.x, q.y, r.x, r.y}, box_around(p, q, r), focus.x, focus.y});
      else
        pose({HALF_PLANE, {q.x, q.y, r.x, r.y, 0, 0}, Box::of_everything(), focus.x, focus.y});
    }
    return questions;
  }

  // By vertices: whether a point there is owned.
  std::vector<bool> owned_vertices() const
  {
    const auto frame = m_dt.frame();
    std::vector<bool> is_owned(frame.number_of_vertices() + std::size_t(1), false);
    for (size_type i = 0; i < m_owned; ++i)
      is_owned[frame.vertex(i)] = true;
    return is_owned;
  }

  // By vertices: the point there with the smallest id.
  std::vector<Index> labels() const
  {
    const auto frame = m_dt.frame();
    std::vector<Index> labels(frame.number_of_vertices() + std::size_t(1), Index(m_points.size()));
    for (Index i = 0; i < m_points.size(); ++i) {
      Index& label = labels[frame.vertex(i)];
      if (label == m_points.size() || m_ids[i] < m_ids[label])
        label = i;
    }
    return labels;
  }

  template <class Function>
  void call(const Function& f, Index i, Index j) const
  {
    if (m_ids[j] < m_ids[i])
      std::swap(i, j);
    if (i < m_owned)
      f(m_ids[i], m_ids[j]);
  }

  // Calls f(corners, apex) for each finite cell of the Delaunay complex with an owned corner: the
  // points of one empty circle, counterclockwise, and the place of the one with the smallest id.
  template <class Function>
  void for_each_cell(const std::vector<Index>& label, const Function& f) const
  {
    const auto frame = m_dt.frame();
    const Mirror& mirror = frame.maintained().mirror();
    const std::vector<bool> is_owned = owned_vertices(), is_inner = inner_edges();
    std::vector<bool> is_seen(frame.number_of_faces(), false);
    std::vector<Corner> corners;
    for (Index face = 0; face < frame.number_of_faces(); ++face) {
      const std::array<Index, 3> v = frame.face(face);
      if (is_seen[face] || v[0] == 0 || v[1] == 0 || v[2] == 0)
        continue;
      const auto outward = [&](Index h) {
        is_seen[Mirror::face_of(h)] = true;
        while (is_inner[mirror.edge_of(h)]) {
          h = Mirror::next(mirror.twin(h));
          is_seen[Mirror::face_of(h)] = true;
        }
        return h;
      };
      corners.clear();
      bool has_owned = false;
      const Index first = outward(3 * face);
      Index h = first;
      do {
        const Index a = mirror.source(h);
        has_owned = has_owned || is_owned[a];
        corners.push_back({label[a], mirror.apex(mirror.twin(h)) == 0});
        h = outward(Mirror::next(h));
      } while (h != first);
      if (!has_owned)
        continue;
      const auto apex =
          std::min_element(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
            return m_ids[a.label] < m_ids[b.label];
          });
      f(corners, std::size_t(apex - corners.begin()));
    }
  }

  // By edges: whether all four corners are on one circle.
  std::vector<bool> inner_edges() const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const auto frame = m_dt.frame();
    std::vector<bool> is_inner(frame.number_of_edges(), false);
    std::vector<Index> unproved;
    frame.append_unproved(0, frame.number_of_edges(), unproved);
    const Vertex_predicates_2<std::decay_t<decltype(frame.maintained())>> predicates(
        frame.maintained());
    for (const Index e : unproved)
      if (!frame.is_at_infinity(e)) {
        const auto& edge = frame.edge(e);
        is_inner[e] = predicates.side_of_circle(edge.left, edge.source, edge.target, edge.right) ==
                      ON_ORIENTED_BOUNDARY;
      }
    return is_inner;
  }

  Communicator m_communicator;
  Dynamic_Delaunay_triangulations_2::internal::Message_exchange_2 m_exchange;
  int m_rank;
  std::size_t m_ranks;
  Dynamic m_dt; // its ids are the places in the two following arrays, owned points first
  std::vector<Id> m_ids;
  std::vector<Point> m_points;
  size_type m_owned = 0;
  // By ranks: owned points that the other one holds, and ghosts that it owns, in one order.
  std::vector<std::vector<Index>> m_exports, m_imports;
  std::vector<Box> m_boxes; // of all ranks
  size_type m_rounds = 0;
  bool m_is_certified = false;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
