// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Only edges that are proved Delaunay are skipped, however their vertices move, and however numbers
// are rounded.

#include "oracle.h"
#include "replaced_heap.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Safe_edges_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <ostream>
#include <utility>

namespace {

using namespace CGAL::Dynamic_Delaunay_triangulations_2;
using internal::Edge_slack_2;
using Generator = std::mt19937;

// -------------------------------------------------------------------------------------------------
// What is true, decided exactly.

double between(Generator& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

double power_of_ten(Generator& random, double low, double high)
{
  return std::pow(10, between(random, low, high));
}

Epick::Point_2 point(const Position_2& p)
{
  return Epick::Point_2(p.x, p.y);
}

bool is_left_turn(const Position_2& p, const Position_2& q, const Position_2& r)
{
  return CGAL::orientation(point(p), point(q), point(r)) == CGAL::LEFT_TURN;
}

// How far p is from q, compared with t: by rationals, unless it is obvious.
CGAL::Comparison_result compare_distance(const Position_2& p, const Position_2& q, double t)
{
  const double x = p.x - q.x, y = p.y - q.y;
  const double square = x * x + y * y, bound = t * t;
  if (square < bound * (1 - 0x1p-47))
    return CGAL::SMALLER;
  if (square > bound * (1 + 0x1p-47))
    return CGAL::LARGER;
  using Exact = CGAL::Exact_rational;
  const Exact dx = Exact(p.x) - Exact(q.x), dy = Exact(p.y) - Exact(q.y), exact_t(t);
  return CGAL::compare(Exact(dx * dx + dy * dy), Exact(exact_t * exact_t));
}

// The largest double below `above` for which `is_proved` holds, provided that it holds for all
// smaller ones; 0 if it holds for no tolerance that is large enough to be used.
template <class Proof>
double largest_tolerance(double above, const Proof& is_proved)
{
  double proved = 2 * Edge_slack_2::smallest_tolerance;
  if (!(above > proved) || !is_proved(proved))
    return 0;
  for (;;) {
    const double middle = proved + (above - proved) / 2;
    if (!(middle > proved && middle < above))
      return proved;
    (is_proved(middle) ? proved : above) = middle;
  }
}

// The largest tolerance, one that is a few doubles less, or one that is much less.
double tolerance_below(double largest, Generator& random)
{
  switch (random() % 4) {
  case 0:
    return largest;
  case 1:
    return largest * (1 - double(random() % 4) * 0x1p-53);
  case 2:
    return largest * between(random, 0.5, 1);
  default:
    return (std::max)(largest * power_of_ten(random, -9, 0), 2 * Edge_slack_2::smallest_tolerance);
  }
}

// -------------------------------------------------------------------------------------------------
// An adversary, who moves every vertex by at most t, exactly.

Position_2 operator-(const Position_2& p, const Position_2& q)
{
  return {p.x - q.x, p.y - q.y};
}

Position_2 normal(const Position_2& p)
{
  return {-p.y, p.x};
}

Position_2 backward(const Position_2& p)
{
  return {-p.x, -p.y};
}

Position_2 any_direction(Generator& random)
{
  const double angle = between(random, 0, 2 * CGAL_PI);
  return {std::cos(angle), std::sin(angle)};
}

Position_2 step_along(const Position_2& p, const Position_2& direction, double length)
{
  const double norm = std::hypot(direction.x, direction.y);
  if (!(norm > 0))
    return p;
  return {p.x + direction.x / norm * length, p.y + direction.y / norm * length};
}

// Moves p by at most t, and by nearly t unless rounding forbids it.
Position_2 moved(const Position_2& p, const Position_2& direction, double t)
{
  for (const double share : {1 - 0x1p-46, 1 - 0x1p-30, 0.99, 0.7, 0.5}) {
    const Position_2 q = step_along(p, direction, t * share);
    if (compare_distance(p, q, t) != CGAL::LARGER)
      return q;
  }
  return p;
}

// Moves p by at most t, to the farthest along `direction` of the doubles around the target.
Position_2 moved_to_the_last_bit(const Position_2& p, const Position_2& direction, double t)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Position_2 best = moved(p, direction, t);
  const auto progress = [&](const Position_2& q) {
    return (q.x - p.x) * direction.x + (q.y - p.y) * direction.y;
  };
  const Position_2 target = step_along(p, direction, t);
  for (const double x :
       {std::nextafter(target.x, -infinity), target.x, std::nextafter(target.x, infinity)})
    for (const double y :
         {std::nextafter(target.y, -infinity), target.y, std::nextafter(target.y, infinity)})
      if (progress({x, y}) > progress(best) && compare_distance(p, {x, y}, t) != CGAL::LARGER)
        best = {x, y};
  return best;
}

// -------------------------------------------------------------------------------------------------
// Quadrilaterals: the edge from b to c, a on its left, d on its right.

struct Quadrilateral
{
  Position_2 a, b, c, d;

  std::array<Position_2*, 4> corners() { return {&a, &b, &c, &d}; }
};

std::ostream& operator<<(std::ostream& out, const Quadrilateral& q)
{
  out << std::hexfloat;
  for (const Position_2& p : {q.a, q.b, q.c, q.d})
    out << " (" << p.x << ", " << p.y << ")";
  return out << std::defaultfloat;
}

Edge_2 edge_of(Index source, Index target, Index left, Index right)
{
  return {Vertex_index(source), Vertex_index(target), Vertex_index(left), Vertex_index(right)};
}

Edge_slack_2 slack_of(const Quadrilateral& q)
{
  const std::array<Position_2, 5> positions{q.a, q.a, q.b, q.c, q.d}; // 0 is at infinity
  const Edge_2 edge = edge_of(2, 3, 1, 4);
  return Edge_slack_2(edge, internal::Plane_2::corners(edge, positions));
}

Quadrilateral on_its_two_sides(Quadrilateral q)
{
  if (is_left_turn(q.d, q.b, q.c))
    std::swap(q.a, q.d);
  return q;
}

Quadrilateral any_four(Generator& random)
{
  const auto any = [&] {
    const double x = between(random, -1, 1);
    return Position_2{x, between(random, -1, 1)};
  };
  return on_its_two_sides({any(), any(), any(), any()});
}

Quadrilateral four_of_a_lattice(Generator& random)
{
  const auto any = [&] {
    const double x = double(random() % 5);
    return Position_2{x, double(random() % 5)};
  };
  return on_its_two_sides({any(), any(), any(), any()});
}

Quadrilateral nearly_cocircular(Generator& random)
{
  std::array<double, 4> angles;
  for (double& angle : angles)
    angle = between(random, 0, 2 * CGAL_PI);
  std::sort(angles.begin(), angles.end());
  const double off = power_of_ten(random, -14, -0.5);
  const auto at = [&](int i, double radius) {
    return Position_2{radius * std::cos(angles[std::size_t(i)]),
                      radius * std::sin(angles[std::size_t(i)])};
  };
  return {at(3, 1 + off * between(random, 0, 1)), at(0, 1 - off * between(random, 0, 1)),
          at(2, 1 - off * between(random, 0, 1)), at(1, 1 + off * between(random, 0, 1))};
}

Quadrilateral nearly_collinear(Generator& random)
{
  const double height = power_of_ten(random, -12, -1), angle = between(random, 0, 2 * CGAL_PI);
  const auto at = [&](double x, double y) {
    x += between(random, -0.3, 0.3) * height;
    y = (y + between(random, -0.3, 0.3)) * height;
    return Position_2{x * std::cos(angle) - y * std::sin(angle),
                      x * std::sin(angle) + y * std::cos(angle)};
  };
  return {at(-between(random, 0.1, 1), 0), at(0, -1), at(0, 1), at(between(random, 0.1, 1), 0)};
}

// A random scale and offset of a configuration.
struct Placement
{
  double scale = 1, offset = 0;

  explicit Placement(Generator& random)
  {
    switch (random() % 4) {
    case 0:
      scale = power_of_ten(random, -90, 90);
      break;
    case 1:
      scale = power_of_ten(random, -3, 3);
      offset = 1e9;
      break;
    case 2:
      offset = std::floor(power_of_ten(random, 0, 15));
      break;
    default:
      break;
    }
  }

  void apply(Position_2& p) const { p = {p.x * scale + offset, p.y * scale - offset}; }
};

Quadrilateral any_quadrilateral(Generator& random)
{
  using Maker = Quadrilateral (*)(Generator&);
  constexpr Maker makers[] = {any_four, four_of_a_lattice, nearly_cocircular, nearly_cocircular,
                              nearly_collinear};
  Quadrilateral q = makers[random() % 5](random);
  const Placement placement(random);
  for (Position_2* p : q.corners())
    placement.apply(*p);
  return q;
}

// The center of the annulus between b, c and a, d: where the bisectors of bc and of ad meet.
Position_2 center_of(const Quadrilateral& q)
{
  const Position_2 bc = q.c - q.b, ad = q.d - q.a;
  const Position_2 between_chords{(q.a.x - q.b.x + q.d.x - q.c.x) / 2,
                                  (q.a.y - q.b.y + q.d.y - q.c.y) / 2};
  const double along = (between_chords.x * ad.x + between_chords.y * ad.y) /
                       (normal(bc).x * ad.x + normal(bc).y * ad.y);
  return {q.b.x + bc.x / 2 + along * normal(bc).x, q.b.y + bc.y / 2 + along * normal(bc).y};
}

template <class Move>
Quadrilateral squeezed(const Quadrilateral& q, double t, const Move& move)
{
  const Position_2 o = center_of(q);
  return {move(q.a, o - q.a, t), move(q.b, q.b - o, t), move(q.c, q.c - o, t),
          move(q.d, o - q.d, t)};
}

Quadrilateral scattered(Quadrilateral q, double t, Generator& random)
{
  for (Position_2* p : q.corners())
    *p = moved(*p, any_direction(random), t);
  return q;
}

Quadrilateral moved_to_corners(Quadrilateral q, double t, Generator& random)
{
  constexpr Position_2 directions[] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                       {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  for (Position_2* p : q.corners())
    *p = moved(*p, directions[random() % 8], t);
  return q;
}

// True if the edge is strictly Delaunay, or a face is not counterclockwise: the proof's promise.
bool promise_is_kept(const Quadrilateral& q)
{
  return !is_left_turn(q.a, q.b, q.c) || !is_left_turn(q.d, q.c, q.b) ||
         CGAL::side_of_oriented_circle(point(q.a), point(q.b), point(q.c), point(q.d)) ==
             CGAL::ON_NEGATIVE_SIDE;
}

double largest_safe(const Edge_slack_2& slack, double above)
{
  return largest_tolerance(above, [&](double t) { return slack.is_safe(t); });
}

TEST(Edge_slack, calls_no_edge_safe_that_motion_within_the_tolerance_breaks)
{
  Generator random(1);
  std::size_t proved = 0;
  for (int i = 0; i < 500000; ++i) {
    const Quadrilateral q = any_quadrilateral(random);
    const Edge_slack_2 slack = slack_of(q);
    const double largest = largest_safe(slack, slack.value());
    if (largest == 0)
      continue;
    const double t = tolerance_below(largest, random);
    ASSERT_TRUE(slack.is_safe(t)) << t << q;
    ASSERT_TRUE(promise_is_kept(squeezed(q, t, moved))) << t << q;
    ASSERT_TRUE(promise_is_kept(scattered(q, t, random))) << t << q;
    ASSERT_TRUE(promise_is_kept(moved_to_corners(q, t, random))) << t << q;
    ++proved;
  }
  EXPECT_GT(proved, 200000u);
}

TEST(Edge_slack, leaves_room_for_every_rounding_at_narrow_annuli)
{
  Generator random(2);
  std::size_t proved = 0;
  for (int i = 0; i < 200000; ++i) {
    Quadrilateral q = nearly_cocircular(random);
    const Edge_slack_2 slack = slack_of(q);
    const double t = largest_safe(slack, slack.value());
    if (t == 0 || t > 1e-6)
      continue;
    ASSERT_TRUE(promise_is_kept(squeezed(q, t, moved_to_the_last_bit))) << t << q;
    ++proved;
  }
  EXPECT_GT(proved, 10000u);
}

TEST(Edge_slack, is_nearly_all_that_there_is)
{
  Generator random(3);
  std::size_t proved = 0, broken = 0;
  for (int i = 0; i < 20000; ++i) {
    const Quadrilateral q = nearly_cocircular(random);
    const Edge_slack_2 slack = slack_of(q);
    if (slack.value() < 1e-9 || largest_safe(slack, slack.value()) == 0)
      continue;
    ++proved;
    EXPECT_GT(largest_safe(slack, slack.value()), 0.9999 * slack.value());
    broken += !promise_is_kept(squeezed(q, 1.001 * slack.value(), moved));
  }
  EXPECT_GT(proved, 1000u);
  EXPECT_GT(4 * broken, 3 * proved); // the others turn a face over
}

TEST(Edge_slack, sees_no_safety_in_ties_flat_or_inverted_faces_and_what_a_double_cannot_hold)
{
  constexpr double t = 2 * Edge_slack_2::smallest_tolerance;
  const Quadrilateral square{{0, 1}, {0, 0}, {1, 1}, {1, 0}};
  const Quadrilateral flat{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  const Quadrilateral inverted{{3, 0}, {0, -1}, {0, 1}, {-3, 0}};
  const Quadrilateral one_place{{1, 2}, {1, 2}, {1, 2}, {1, 2}};
  const Quadrilateral rhombus{{-3, 0}, {0, -1}, {0, 1}, {3, 0}};
  EXPECT_TRUE(slack_of(rhombus).is_safe(0.9));
  for (const auto& q : {square, flat, inverted, one_place})
    for (const double scale : {1e-150, 1., 1e150, 1e250}) {
      Quadrilateral scaled = q;
      for (Position_2* p : scaled.corners())
        *p = {p->x * scale, p->y * scale};
      EXPECT_FALSE(slack_of(scaled).is_safe(t)) << scaled;
    }
  for (const double scale : {1e-110, 1e200, 1e300}) {
    Quadrilateral scaled = rhombus;
    for (Position_2* p : scaled.corners())
      *p = {p->x * scale, p->y * scale};
    EXPECT_FALSE(slack_of(scaled).is_safe(t)) << scaled;
  }
}

// -------------------------------------------------------------------------------------------------
// Stars: a vertex, the ring of its neighbors, and what lies beyond each edge of that.

class Star
{
public:
  explicit Star(Generator& random)
    : m_degree(4 + Index(random() % 5))
    , m_positions(2 + 2 * m_degree)
  {
    const double height = random() % 2 == 0 ? 1 : power_of_ten(random, -6, 0);
    const double turn = between(random, 0, 1);
    for (Index i = 0; i < m_degree; ++i) {
      place(ring(i), i + turn, between(random, 0.7, 1.3), height);
      place(beyond(i), i + turn + 0.5, between(random, 1.2, 3), height);
    }
    place(center, 0, 0, height);
    const Placement placement(random);
    for (Position_2& p : m_positions)
      placement.apply(p);
  }

  Index degree() const { return m_degree; }

  // The i-th face at the center.
  std::array<Position_2, 3> face(Index i) const
  {
    return {m_positions[center], m_positions[ring(i)], m_positions[ring(i + 1)]};
  }

  // The largest tolerance with which all three edges of the i-th face are safe.
  double tolerance(Index i) const
  {
    const Edge_2 spoke{center, ring(i), ring(i + 1), ring(i + m_degree - 1)};
    const Edge_2 next{center, ring(i + 1), ring(i + 2), ring(i)};
    const Edge_2 rim{ring(i), ring(i + 1), center, beyond(i)};
    double largest = std::numeric_limits<double>::infinity();
    for (const Edge_2& edge : {spoke, next, rim}) {
      const Edge_slack_2 slack(edge, internal::Plane_2::corners(edge, m_positions));
      largest = (std::min)(largest, largest_safe(slack, slack.value()));
    }
    return largest;
  }

private:
  static constexpr Vertex_index center{1};
  Vertex_index ring(Index i) const { return Vertex_index(2 + i % m_degree); }
  Vertex_index beyond(Index i) const { return Vertex_index(2 + m_degree + i); }

  void place(Vertex_index v, double i, double radius, double height)
  {
    const double angle = 2 * CGAL_PI * i / m_degree;
    m_positions[v] = {radius * std::cos(angle), radius * std::sin(angle) * height};
  }

  Index m_degree;
  Position_vector m_positions;
};

// Moves one corner towards the opposite edge, and the ends of this edge towards the corner.
std::array<Position_2, 3> flattened(std::array<Position_2, 3> face, std::size_t corner, double t)
{
  Position_2 &p = face[corner], &q = face[(corner + 1) % 3], &r = face[(corner + 2) % 3];
  const Position_2 inward = normal(r - q);
  p = moved(p, backward(inward), t);
  q = moved(q, inward, t);
  r = moved(r, inward, t);
  return face;
}

TEST(Edge_slack, keeps_faces_between_safe_edges_counterclockwise)
{
  Generator random(4);
  std::size_t proved = 0;
  for (int i = 0; i < 40000; ++i) {
    const Star star(random);
    for (Index f = 0; f < star.degree(); ++f) {
      const double largest = star.tolerance(f);
      if (largest == 0)
        continue;
      ++proved;
      const double t = tolerance_below(largest, random);
      auto face = star.face(f);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto flat = flattened(face, corner, t);
        ASSERT_TRUE(is_left_turn(flat[0], flat[1], flat[2])) << "star " << i << ", face " << f;
      }
      for (Position_2& p : face)
        p = moved(p, any_direction(random), t);
      ASSERT_TRUE(is_left_turn(face[0], face[1], face[2])) << "star " << i << ", face " << f;
    }
  }
  EXPECT_GT(proved, 50000u);
}

// -------------------------------------------------------------------------------------------------
// The hull: from p to q and on to w.

struct Turn
{
  Position_2 p, q, w;

  // The edge from q to w with p opposite to it, or the one from q to infinity.
  Edge_slack_2 slack(const Edge_2& edge) const
  {
    const std::array<Position_2, 4> positions{p, p, q, w};
    return Edge_slack_2(edge, internal::Plane_2::corners(edge, positions)); // 0 is at infinity
  }
  double length() const { return internal::distance(p, q) + internal::distance(q, w); }

  bool is_left() const { return is_left_turn(p, q, w); }
  // True if the turn is by less than a right angle, to either side.
  bool is_slight() const { return CGAL::angle(point(p), point(q), point(w)) == CGAL::OBTUSE; }
};

const Edge_2 hull_edges[] = {edge_of(3, 2, 0, 1), edge_of(2, 3, 1, 0)},
             corners[] = {edge_of(0, 2, 1, 3), edge_of(2, 0, 3, 1)};

std::ostream& operator<<(std::ostream& out, const Turn& turn)
{
  return out << Quadrilateral{turn.p, turn.q, turn.w, {0, 0}};
}

// A turn that may be to the left, to the right, or straight.
Turn nearly_straight_turn(Generator& random)
{
  const auto p = any_direction(random);
  const double reach = between(random, 0.5, 2), scatter = power_of_ten(random, -17, -10);
  const auto off = [&] { return between(random, -1, 1) * scatter; };
  const double x = off(), y = off();
  const double noise = random() % 2 == 0 ? 0 : off();
  return {p, {x, y}, {-p.x * reach + noise, -p.y * reach}};
}

Turn distinct_turn(Generator& random)
{
  const double height = random() % 2 == 0 ? 1 : power_of_ten(random, -12, 0);
  const double length = random() % 2 == 0 ? 1 : power_of_ten(random, -6, 0);
  const double sign = random() % 8 == 0 ? -1 : 1, angle = between(random, 0, 2 * CGAL_PI);
  const double turn = random() % 4 == 0 ? 0 : angle; // along the axes bounds are as tight as can be
  const auto at = [&](double x, double y) {
    y *= sign * height;
    return Position_2{x * std::cos(turn) - y * std::sin(turn),
                      x * std::sin(turn) + y * std::cos(turn)};
  };
  const double before = between(random, 0, 1), after = between(random, 0, 1);
  return {at(-length, before), at(0, 0), at(between(random, -1, 1), after)};
}

Turn any_turn(Generator& random)
{
  Turn turn = random() % 4 == 0 ? nearly_straight_turn(random) : distinct_turn(random);
  if (random() % 2 == 0)
    return turn;
  const Placement placement(random);
  for (Position_2* p : {&turn.p, &turn.q, &turn.w})
    placement.apply(*p);
  return turn;
}

// The corner is pushed inwards and its neighbors outwards, across the chord or across the edges;
// or it is pulled out of the circle over the chord, against which the turn is a right angle.
std::vector<Turn> moved_adversarially(const Turn& turn, double t, Generator& random)
{
  const auto along = [&](const Position_2& p, const Position_2& q, const Position_2& w) {
    return Turn{moved(turn.p, p, t), moved(turn.q, q, t), moved(turn.w, w, t)};
  };
  const Position_2 chord = turn.w - turn.p, inward = normal(chord);
  const Position_2 back = turn.p - turn.q, on = turn.w - turn.q;
  const Position_2 bisector{back.x + on.x, back.y + on.y};
  std::vector<Turn> turns{
      along(backward(inward), inward, backward(inward)),
      along(inward, backward(inward), inward),
      along(normal(back), inward, backward(normal(on))),
      along(chord, backward(bisector), backward(chord)),
      along(bisector, backward(bisector), bisector),
      along(chord, chord, backward(chord)),
      along(backward(back), bisector, backward(on)),
  };
  for (int i = 0; i < 3; ++i)
    turns.push_back(along(any_direction(random), any_direction(random), any_direction(random)));
  return turns;
}

TEST(Edge_slack, keeps_the_hull_turning_left_where_it_is_safe)
{
  Generator random(5);
  std::size_t proved = 0;
  for (int i = 0; i < 40000; ++i) {
    const Turn turn = any_turn(random);
    const double largest = largest_safe(turn.slack(corners[0]), turn.length());
    for (const Edge_2& edge : {hull_edges[0], hull_edges[1], corners[1]})
      ASSERT_EQ(largest, largest_safe(turn.slack(edge), turn.length())) << turn;
    if (largest == 0)
      continue;
    ++proved;
    const double t = tolerance_below(largest, random);
    for (const Turn& other : moved_adversarially(turn, t, random))
      ASSERT_TRUE(other.is_left()) << t << turn;
  }
  EXPECT_GT(proved, 10000u);
}

TEST(Edge_slack, keeps_the_hull_from_turning_back_on_itself_where_it_says_so)
{
  Generator random(6);
  std::size_t proved = 0, straight = 0;
  for (int i = 0; i < 40000; ++i) {
    const Turn turn = any_turn(random);
    for (const Edge_2& edge : hull_edges)
      ASSERT_TRUE(turn.slack(edge).keeps_turning_angle(1e300));
    const auto keeps = [&](double t) { return turn.slack(corners[0]).keeps_turning_angle(t); };
    const double largest = largest_tolerance(turn.length(), keeps);
    if (largest == 0)
      continue;
    ++proved;
    straight += !turn.slack(corners[1]).is_safe(largest);
    const double t = tolerance_below(largest, random);
    ASSERT_TRUE(turn.slack(corners[1]).keeps_turning_angle(t)) << t << turn;
    for (const Turn& other : moved_adversarially(turn, t, random))
      ASSERT_TRUE(other.is_left() || other.is_slight()) << t << turn;
  }
  EXPECT_GT(proved, 10000u);
  EXPECT_GT(straight, 1000u);
}

// -------------------------------------------------------------------------------------------------
// Which vertices have moved.

std::vector<Vertex_index> moved_vertices(const Position_vector& positions,
                                         const Position_vector& references, double tolerance)
{
  std::vector<Vertex_index> vertices;
  EXPECT_TRUE(internal::append_moved(positions, references, tolerance, positions.size(), vertices));
  return vertices;
}

// Expects exactly the vertices beyond the tolerance, except within a few roundings of it.
void expect_who_has_moved(const Position_vector& positions, const Position_vector& references,
                          double tolerance)
{
  const auto vertices = moved_vertices(positions, references, tolerance);
  ASSERT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
  auto next = vertices.begin();
  for (Vertex_index v(1); v < Index(positions.size()); ++v) {
    const bool is_named = next != vertices.end() && *next == v;
    next += is_named;
    const auto is_within = [&](double t) {
      return compare_distance(positions[v], references[v], t) != CGAL::LARGER;
    };
    ASSERT_TRUE(is_named || is_within(tolerance)) << "vertex " << v;
    ASSERT_FALSE(is_named && is_within(tolerance * (1 - 1e-14))) << "vertex " << v;
  }
  ASSERT_EQ(next, vertices.end());
}

TEST(Displacements, miss_no_vertex_beyond_the_tolerance_at_any_scale_and_place)
{
  Generator random(7);
  for (int round = 0; round < 300; ++round) {
    const Placement placement(random);
    const double tolerance = placement.scale * power_of_ten(random, -9, -1);
    const std::size_t vertices = 1 + random() % (round % 10 == 0 ? 3000 : 60);
    Position_vector references(vertices, {std::nan(""), std::nan("")});
    auto positions = references;
    for (std::size_t v = 1; v < vertices; ++v) {
      references[v] = any_direction(random);
      placement.apply(references[v]);
      const double share = random() % 2 == 0 ? 1 : between(random, 0, 1.5);
      const auto direction = random() % 4 == 0 ? Position_2{1, 0} : any_direction(random);
      positions[v] = step_along(references[v], direction, tolerance * share);
    }
    ASSERT_NO_FATAL_FAILURE(expect_who_has_moved(positions, references, tolerance));
  }
}

// A tolerance that is the largest double below the displacement.
double tolerance_just_missed(const Position_2& p, const Position_2& q)
{
  double t = std::hypot(p.x - q.x, p.y - q.y) * (1 + 0x1p-50);
  while (compare_distance(p, q, t) != CGAL::LARGER)
    t = std::nextafter(t, 0);
  return t;
}

TEST(Displacements, tell_the_tolerance_from_the_next_double)
{
  Generator random(8);
  for (int round = 0; round < 5000; ++round) {
    const double scale = power_of_ten(random, -90, 90);
    Position_vector references(34, {0, 0}), positions(34, {0, 0});
    const Vertex_index v(1 + random() % 33);
    const double x = between(random, -1, 1) * scale;
    positions[v] = {x, between(random, -1, 1) * scale};
    const double t = tolerance_just_missed(positions[v], references[v]);
    EXPECT_EQ(moved_vertices(positions, references, t), std::vector<Vertex_index>(1, v));
    positions[v] = {std::nextafter(t, 2 * t), 0};
    EXPECT_EQ(moved_vertices(positions, references, t), std::vector<Vertex_index>(1, v));
    EXPECT_TRUE(moved_vertices(positions, references, t * (1 + 1e-14)).empty());
  }
}

TEST(Displacements, are_the_same_in_any_number_of_lanes)
{
  Generator random(9);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t vertices = 1 + random() % 100;
    Position_vector references(vertices), positions(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      references[v] = any_direction(random);
      positions[v] = step_along(references[v], any_direction(random),
                                random() % 20 == 0 ? between(random, 0, 2) : 0.5);
      if (random() % 100 == 0)
        (random() % 2 == 0 ? positions[v].x : references[v].y) = std::nan("");
    }
    const Vertex_index first(random() % vertices);
    const Index beyond = Index(vertices);
    const auto moved = [&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      std::vector<Vertex_index> list;
      internal::append_moved_in_lanes<lanes>(positions.data(), references.data(), first, beyond,
                                             0.25, list);
      return list;
    };
    const std::vector<Vertex_index> expected = moved(std::integral_constant<int, 1>());
    EXPECT_EQ(moved(std::integral_constant<int, internal::usual_lanes>()), expected);
    EXPECT_EQ(internal::call_with_lanes(moved), expected);
  }
}

TEST(Displacements, count_those_who_are_nowhere_as_moved)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (Vertex_index v(1); v < 40; ++v)
    for (const Position_2& nan_point : {Position_2{nan, 0}, {0, nan}, {nan, nan}, {infinity, 0}}) {
      const Position_vector references(40, {0, 0});
      auto positions = references;
      positions[v] = nan_point;
      EXPECT_EQ(moved_vertices(positions, references, 1e100), std::vector<Vertex_index>(1, v));
      EXPECT_EQ(moved_vertices(references, positions, 1e100), std::vector<Vertex_index>(1, v));
    }
}

TEST(Displacements, are_given_up_when_too_many_have_moved)
{
  const Position_vector references(3000, {0, 0});
  for (const std::size_t count : {0u, 1u, 4u, 5u, 6u, 2999u}) {
    auto positions = references;
    for (std::size_t i = 0; i < count; ++i)
      positions[2999 - i] = {2, 0};
    std::vector<Vertex_index> vertices;
    EXPECT_EQ(internal::append_moved(positions, references, 1, 5, vertices), count <= 5);
  }
}

// -------------------------------------------------------------------------------------------------
// The proofs of a list of edges.

TEST(Edge_proofs, of_a_list_are_those_of_the_whole)
{
  Generator random(10);
  Position_vector positions(1, {std::nan(""), std::nan("")});
  for (int i = 0; i < 60; ++i) {
    const double x = double(random() % 8);
    positions.push_back({x, double(random() % 8)});
  }
  std::vector<Edge_2> edges(997);
  for (Edge_2& edge : edges)
    for (auto* v : {&edge.source, &edge.target, &edge.left, &edge.right})
      *v = Vertex_index(random() % positions.size());
  std::vector<Edge_index> all;
  internal::append_unproved<internal::Plane_2>(edges.data(), positions, 0, Index(edges.size()),
                                               all);
  ASSERT_LT(all.size(), edges.size());
  for (std::size_t size = 0; size < 300; ++size) {
    const std::vector<Edge_index> before(1, Edge_index(7)); // what is there stays
    std::vector<Edge_index> list(size), expected = before, unproved = before;
    for (Edge_index& e : list)
      e = Edge_index(random() % edges.size());
    for (const Edge_index e : list)
      if (std::binary_search(all.begin(), all.end(), e))
        expected.push_back(e);
    internal::append_unproved_of<internal::Plane_2>(edges.data(), positions, list, unproved);
    EXPECT_EQ(unproved, expected);
  }
}

// -------------------------------------------------------------------------------------------------
// Classifiers that are watched.

// Does what Circumcircle_classifier_2 does, but looks for safe edges whenever it has none, and
// counts the frames in which it skips edges.
struct Eager_classifier
{
  static constexpr bool is_exact = true;
  internal::Safe_edges_2 safe_edges;
  std::vector<Edge_index> unproved;
  std::size_t frames_skipping = 0;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    safe_edges.take_changes(frame);
    unproved.clear();
    const bool skips = safe_edges.holds() && safe_edges.append_unproved(frame, unproved);
    frames_skipping += skips;
    if (!skips) {
      unproved.resize(frame.number_of_edges());
      std::iota(unproved.begin(), unproved.end(), Edge_index(0));
    }
    for (const Edge_index e : unproved)
      examine(frame, e, classified);
    if (skips && safe_edges.hull_turns_once())
      classified.set_hull_turns_once();
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    safe_edges.learn(frame);
    if (!safe_edges.holds() && frame.positions_are_exact() && !frame.everything_is_new())
      safe_edges.start(frame, 20);
  }

  template <class Frame, class Classification>
  static void examine(const Frame& frame, Edge_index e, Classification& classified)
  {
    const auto state = frame.edge_state(e);
    if (state == Edge_state_2::ILLEGAL)
      classified.add_illegal_edge(e);
    else if (state != Edge_state_2::DELAUNAY)
      classified.add_edge(e);
  }
};

// Examines every edge in every frame.
struct Tireless_classifier
{
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    for (Edge_index e(0); e < frame.number_of_edges(); ++e)
      Eager_classifier::examine(frame, e, classified);
  }
};

// How often the hull turns around: the sum of its turning angles.
template <class Frame>
long number_of_turns(const Frame& frame)
{
  double sum = 0;
  frame.for_each_incident_edge(internal::infinite_index, [&](Edge_index e) {
    const Edge_2& edge = frame.edge(e);
    const bool is_outgoing = edge.source == internal::infinite_index;
    const Position_2& v = frame.position(is_outgoing ? edge.target : edge.source);
    const Position_2 on = frame.position(is_outgoing ? edge.right : edge.left) - v;
    const Position_2 here = v - frame.position(is_outgoing ? edge.left : edge.right);
    sum += std::atan2(here.x * on.y - here.y * on.x, here.x * on.x + here.y * on.y);
  });
  return std::lround(sum / (2 * CGAL_PI));
}

struct Failure
{
};

// Checks the edges that `Classifier` names and what it claims of the hull. If it is told to, it
// then names a vertex without need, or throws.
template <class Classifier>
struct Audited
{
  static constexpr bool is_exact = true;
  Classifier classifier;
  std::shared_ptr<bool> fails = std::make_shared<bool>(false);
  std::shared_ptr<bool> raises_alarm = std::make_shared<bool>(false);
  std::size_t frames = 0, hull_claims = 0;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    classifier(frame, classified);
    ++frames;
    if (!classified.is_everything())
      check_edges(frame, classified);
    if (std::exchange(*raises_alarm, false))
      classified.add_vertex(Vertex_index(1));
    if (std::exchange(*fails, false))
      throw Failure();
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    classifier.after_update(frame);
  }

private:
  template <class Frame, class Classification>
  void check_edges(const Frame& frame, const Classification& classified)
  {
    std::vector<bool> named(frame.number_of_edges());
    for (const Edge_index e : classified.edges())
      named[e] = true;
    std::size_t missed = 0, named_in_vain = 0;
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const bool is_delaunay = frame.is_delaunay(e);
      missed += !is_delaunay && !named[e];
      named_in_vain += is_delaunay && named[e];
    }
    EXPECT_EQ(missed, 0u);
    EXPECT_EQ(named_in_vain, 0u);
    if (classified.hull_turns_once())
      check_hull(frame);
  }

  template <class Frame>
  void check_hull(const Frame& frame)
  {
    ++hull_claims;
    EXPECT_EQ(number_of_turns(frame), 1);
    bool is_convex = true;
    frame.for_each_incident_edge(internal::infinite_index, [&](Edge_index e) {
      is_convex = is_convex && frame.is_delaunay(e);
    });
    EXPECT_TRUE(!is_convex || frame.hull_turns_once());
  }
};

std::size_t frames_known_to_skip(const Audited<Eager_classifier>& audited)
{
  return audited.classifier.frames_skipping;
}

// This classifier does not count frames, but claims that the hull turns once only if it skips.
std::size_t frames_known_to_skip(const Audited<CGAL::Circumcircle_classifier_2>& audited)
{
  return audited.hull_claims;
}

// -------------------------------------------------------------------------------------------------
// Clouds that tremble.

template <class Kernel>
struct Mean_positions
{
  std::string name;
  typename Cloud<Kernel>::Points points;
  std::size_t still = 0; // so many, from the first one on, do not move at all
};

Mean_positions<Epick> jittered_lattice(std::size_t side, double jitter)
{
  Mean_positions<Epick> means{"lattice with exact rows on its hull", {}, 0};
  Cloud<Epick> cloud(21);
  Cloud<Epick>::Points inside;
  const double last = double(side - 1);
  for (const auto& p : cloud.grid(side, side))
    if (p.x() == 0 || p.y() == 0 || p.x() == last || p.y() == last)
      means.points.push_back(p);
    else
      inside.push_back(cloud.shifted(p, jitter));
  means.still = means.points.size();
  means.points.insert(means.points.end(), inside.begin(), inside.end());
  return means;
}

// A block in the middle of the lattice is left as it is.
Mean_positions<Epick> lattice_with_ties(std::size_t side)
{
  Cloud<Epick> cloud(22);
  Mean_positions<Epick> means{"lattice with a block of ties", cloud.grid(side, side), 0};
  const double middle = double(side) / 2;
  for (auto& p : means.points)
    if (std::abs(p.x() - middle) > 3 || std::abs(p.y() - middle) > 3)
      p = cloud.shifted(p, 0.1);
  return means;
}

Mean_positions<Epick> hexagonal_lattice(std::size_t side)
{
  Mean_positions<Epick> means{"hexagonal lattice", Cloud<Epick>::grid(side, side), 0};
  for (auto& p : means.points) {
    const double x = p.x(), y = p.y();
    p = Epick::Point_2(x + y / 2, y * std::sqrt(0.75));
  }
  return means;
}

Mean_positions<Epick> circle_around_a_cloud()
{
  Cloud<Epick> cloud(23);
  Mean_positions<Epick> means{"circle around a cloud", cloud.on_circle(36), 0};
  for (const auto& p : cloud.uniform(300))
    means.points.emplace_back(4 * p.x() - 34, 4 * p.y() - 34);
  return means;
}

Mean_positions<Epick> clusters()
{
  Cloud<Epick> cloud(24);
  Mean_positions<Epick> means{"clusters", cloud.uniform(40), 0};
  for (std::size_t i = 0; i < 360; ++i)
    means.points.push_back(cloud.shifted(means.points[i % 40], i % 3 == 0 ? 0.001 : 0.1));
  return means;
}

std::vector<Mean_positions<Epick>> all_means()
{
  Cloud<Epick> cloud(25);
  const auto uniform = cloud.uniform(350);
  return {{"uniform", uniform, 0},
          {"uniform, far from the origin", scaled<Epick>(uniform, 1, 1e9), 0},
          jittered_lattice(20, 0.1),
          lattice_with_ties(20),
          hexagonal_lattice(18),
          {"circle", cloud.on_circle(36), 0},
          circle_around_a_cloud(),
          clusters()};
}

// So many points that a jump leaves most edges as they are.
Mean_positions<Epick> many()
{
  return {"many", Cloud<Epick>(26).uniform(2500), 0};
}

// Every point goes round on an ellipse of its own, all of them slowly, some a little farther.
template <class Kernel>
class Trembling
{
public:
  using Points = typename Cloud<Kernel>::Points;

  Trembling(const Mean_positions<Kernel>& means, double amplitude, double drift = 0,
            unsigned seed = 31)
    : m_means(means)
    , m_drift(drift)
  {
    Generator random(seed);
    for (std::size_t i = 0; i < means.points.size(); ++i) {
      const double reach = i < means.still      ? 0
                           : random() % 80 == 0 ? 8 * amplitude
                                                : between(random, 0, amplitude);
      m_orbits.push_back({reach, 2 * CGAL_PI / between(random, 100, 500),
                          between(random, 0, 2 * CGAL_PI), any_direction(random)});
    }
  }

  Points at(int frame) const
  {
    Points points;
    for (std::size_t i = 0; i < m_orbits.size(); ++i) {
      const Orbit& orbit = m_orbits[i];
      const double angle = orbit.speed * frame + orbit.phase, way = m_drift * frame;
      points.emplace_back(
          m_means.points[i].x() + orbit.reach * std::cos(angle) + way * orbit.drift.x,
          m_means.points[i].y() + orbit.reach * std::sin(2 * angle) / 2 + way * orbit.drift.y);
    }
    return points;
  }

private:
  struct Orbit
  {
    double reach, speed, phase;
    Position_2 drift;
  };

  Mean_positions<Kernel> m_means;
  std::vector<Orbit> m_orbits;
  double m_drift;
};

// Sometimes moves one or two points elsewhere; some frames later they are at their own places.
template <class Kernel>
class Jumps
{
public:
  using Points = typename Cloud<Kernel>::Points;

  explicit Jumps(unsigned seed)
    : m_random(seed)
  {
  }

  void apply(Points& points)
  {
    if (m_random() % 8 == 0)
      for (std::size_t& away : m_away)
        away = m_random() % points.size();
    if (m_random() % 4 == 0)
      m_away.fill(no_vertex);
    for (const std::size_t away : m_away)
      if (away < points.size())
        points[away] = elsewhere(points, points[away]);
  }

private:
  static constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();
  using Point = typename Kernel::Point_2;

  // A place beyond the neighbors, far away among the other points, or beyond all of them.
  Point elsewhere(const Points& points, const Point& p)
  {
    const Point& q = points[m_random() % points.size()];
    const double x = CGAL::to_double(q.x() - p.x()), y = CGAL::to_double(q.y() - p.y());
    const double nearby = 1 / (1 + std::hypot(x, y)), far = between(m_random, 0, 1.3);
    const double share = m_random() % 2 == 0 ? nearby : far;
    return Point(p.x() + share * x, p.y() + share * y);
  }

  Generator m_random;
  std::array<std::size_t, 2> m_away{no_vertex, no_vertex};
};

template <class Dynamic>
void expect_followed(Dynamic& dt, const std::vector<typename Dynamic::Point>& points,
                     bool looks_closer)
{
  ASSERT_TRUE(dt.update(points.begin(), points.end()).certified);
  ASSERT_TRUE(dt.is_certified());
  if (looks_closer) {
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  ASSERT_FALSE(testing::Test::HasFailure()) << "found by the audit";
}

template <class Dynamic, class Motion>
void expect_followed(Dynamic& dt, int frames, const Motion& points_at)
{
  for (int frame = 0; frame < frames; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    ASSERT_NO_FATAL_FAILURE(expect_followed(dt, points_at(frame), frame % 10 == 9));
  }
}

template <class Classifier>
class Skipping : public testing::Test
{
protected:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Audited<Classifier>>;
  using Points = Cloud<Epick>::Points;

  static Dynamic triangulation_of(const Points& points)
  {
    return Dynamic(points.begin(), points.end());
  }

  // Follows points from `points_at(0)` on. Returns the triangulation after the last frame.
  template <class Motion>
  static Dynamic followed(int frames, const Motion& points_at)
  {
    Dynamic dt = triangulation_of(points_at(0));
    expect_followed(dt, frames, points_at);
    return dt;
  }

  static Dynamic followed(int frames, const Trembling<Epick>& trembling)
  {
    return followed(frames, [&](int frame) { return trembling.at(frame); });
  }
};

using Skipping_classifiers = testing::Types<CGAL::Circumcircle_classifier_2, Eager_classifier>;
TYPED_TEST_SUITE(Skipping, Skipping_classifiers);

TYPED_TEST(Skipping, follows_clouds_that_tremble_at_any_amplitude)
{
  for (const auto& means : all_means())
    for (const double amplitude : {1e-7, 1e-5, 1e-4, 1e-3, 1e-2}) {
      SCOPED_TRACE(testing::Message() << means.name << ", amplitude " << amplitude);
      ASSERT_NO_FATAL_FAILURE(this->followed(200, {means, amplitude}));
    }
}

// If nothing were skipped, the other tests would prove nothing.
TYPED_TEST(Skipping, happens_in_max_frames_of_calm_clouds)
{
  for (const auto& means : all_means()) {
    if (means.name == "circle") // nothing but ties
      continue;
    SCOPED_TRACE(means.name);
    const auto dt = this->followed(100, {means, 1e-6});
    EXPECT_EQ(dt.classifier().frames, 100u);
    const bool hull_keeps_changing = means.name == "hexagonal lattice";
    EXPECT_GT(frames_known_to_skip(dt.classifier()), hull_keeps_changing ? 20u : 50u);
  }
}

// The slack that one edge in twenty is below.
template <class Dynamic>
double tight_slack(const Dynamic& dt)
{
  std::vector<double> slacks;
  for (const Edge_2& edge : dt.frame().edges())
    if (edge.left != 0 && edge.right != 0 && !dt.frame().is_infinite(edge))
      slacks.push_back(
          Edge_slack_2(edge, internal::Plane_2::corners(edge, dt.frame().positions())).value());
  const auto place = slacks.begin() + std::ptrdiff_t(slacks.size() / 20);
  std::nth_element(slacks.begin(), place, slacks.end());
  return *place;
}

TYPED_TEST(Skipping, follows_clouds_whose_points_are_all_at_the_edge_of_the_tolerance)
{
  for (const double share : {0.3, 0.9, 0.999, 1.001, 1.1, 1.5})
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(testing::Message() << "share " << share << ", seed " << seed);
      Cloud<Epick> cloud(seed);
      const auto points = cloud.uniform(500);
      auto dt = this->triangulation_of(points);
      expect_followed(dt, 12, [&](int) { return points; });
      const double reach = share * tight_slack(dt);
      ASSERT_NO_FATAL_FAILURE(expect_followed(dt, 60, [&](int frame) {
        auto others = points;
        for (std::size_t i = 0; i < points.size(); ++i)
          if (share <= 1 || int(i) % 60 == frame) // few of the points that move too far
            others[i] =
                point(moved({points[i].x(), points[i].y()}, any_direction(cloud.random()), reach));
        return others;
      }));
    }
}

TYPED_TEST(Skipping, follows_clouds_that_tremble_and_drift)
{
  for (const auto& means : all_means())
    for (const double drift : {1e-6, 1e-4, 1e-3}) {
      SCOPED_TRACE(testing::Message() << means.name << ", drift " << drift);
      ASSERT_NO_FATAL_FAILURE(this->followed(200, {means, 1e-4, drift}));
    }
}

TYPED_TEST(Skipping, follows_calm_clouds_in_which_single_points_jump)
{
  for (const auto& means : all_means())
    for (const double amplitude : {1e-6, 1e-3}) {
      SCOPED_TRACE(testing::Message() << means.name << ", amplitude " << amplitude);
      const Trembling<Epick> trembling(means, amplitude);
      Jumps<Epick> jumps(41);
      auto dt = this->triangulation_of(trembling.at(0));
      ASSERT_NO_FATAL_FAILURE(expect_followed(dt, 300, [&](int frame) {
        auto points = trembling.at(frame);
        jumps.apply(points);
        return points;
      }));
    }
}

TYPED_TEST(Skipping, follows_a_calm_cloud_in_which_a_point_jumps_and_comes_back)
{
  const Trembling<Epick> trembling(many(), 1e-5);
  const auto dt = this->followed(300, [&](int frame) {
    auto points = trembling.at(frame);
    if (frame % 20 > 10) {
      const auto jumper = std::size_t(frame / 20);
      points[jumper] = Epick::Point_2(points[jumper].x() + 1, points[jumper].y() + 0.5);
    }
    return points;
  });
  EXPECT_GT(frames_known_to_skip(dt.classifier()), 100u);
}

TYPED_TEST(Skipping, follows_tiny_clouds_that_jump_and_tremble)
{
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<Epick> cloud(seed);
    const Mean_positions<Epick> means{"tiny", cloud.uniform(3 + seed % 80), 0};
    const Trembling<Epick> trembling(means, power_of_ten(cloud.random(), -8, -1), 0, seed);
    Jumps<Epick> jumps(seed);
    ASSERT_NO_FATAL_FAILURE(this->followed(60, [&](int frame) {
      auto points = trembling.at(frame);
      if (frame > 20)
        jumps.apply(points);
      return points;
    }));
  }
}

TYPED_TEST(Skipping, follows_what_is_still_for_long_and_then_moves_and_stops_again)
{
  for (const auto& means : all_means()) {
    SCOPED_TRACE(means.name);
    const Trembling<Epick> motion(means, 0, 0.03);
    ASSERT_NO_FATAL_FAILURE(this->followed(160, [&](int frame) {
      return motion.at(frame < 60 ? 0 : frame < 80 ? frame - 60 : frame < 120 ? 20 : frame - 100);
    }));
  }
}

TYPED_TEST(Skipping, follows_a_calm_cloud_that_is_elsewhere_for_one_frame)
{
  Cloud<Epick> cloud(42);
  const Mean_positions<Epick> means{"uniform", cloud.uniform(300), 0};
  const Trembling<Epick> trembling(means, 1e-5);
  this->followed(
      120, [&](int frame) { return frame % 30 == 25 ? cloud.uniform(300) : trembling.at(frame); });
}

TYPED_TEST(Skipping, follows_points_that_meet_and_part_in_a_calm_cloud)
{
  const Trembling<Epick> trembling({"uniform", Cloud<Epick>(43).uniform(300), 0}, 1e-5);
  this->followed(150, [&](int frame) {
    auto points = trembling.at(frame);
    if (frame % 25 > 15)
      points[std::size_t(frame / 25)] = points[100];
    return points;
  });
}

// A point leaves the hull next to a corner, which becomes a dent. The infinite edges at the
// neighbors of the corner then have other opposite vertices, though they are not at the new point.
TYPED_TEST(Skipping, follows_a_point_that_comes_to_the_hull_next_to_a_corner_and_passes_it)
{
  auto points = Cloud<Epick>(44).uniform(300);
  for (const auto& corner : Cloud<Epick>::grid(2, 2))
    points.emplace_back(20 * corner.x() - 1, 20 * corner.y() - 1);
  points.emplace_back(1e-5 - 1, 1e-4 - 1);
  auto dt = this->triangulation_of(points);
  expect_followed(dt, 30, [&](int frame) {
    const double x = frame < 25 ? 1e-5 : -1e-5, y = frame < 20 ? 1e-4 : -1e-4;
    points.back() = Epick::Point_2(x - 1, y - 1);
    return points;
  });
}

// -------------------------------------------------------------------------------------------------
// A hull that comes to wind twice, all faces counterclockwise and all edges Delaunay.

// A cloud with a corner between A, below, and C, to the right of v = (0, 0). Outside there, two
// points are on the hull. On its loop, one is above v and the other one on its left: the faces of
// the same four edges at v then wind around it twice, and the hull has a loop inside.
class Corner_with_a_loop
{
public:
  using Points = Cloud<Epick>::Points;

  explicit Corner_with_a_loop(double size, int side = 20)
    : m_size(size)
    , m_points({{0, 0}, {0, -size}, {size, 0}})
  {
    Generator random(51);
    const auto bulge = [&](int i) { return 0.05 * i * (side - i) / side; };
    for (int i = 1; i < side; ++i) {
      m_points.emplace_back(-i, -size - bulge(i));
      m_points.emplace_back(size + bulge(i), i);
      for (int k = 1; k < side; ++k) {
        const double x = -i + between(random, -0.2, 0.2);
        m_points.emplace_back(x, k + between(random, -0.2, 0.2));
      }
    }
  }

  Points outside() const { return between_loop_and_outside(1); }
  Points on_loop() const { return between_loop_and_outside(0); }

  Points between_loop_and_outside(double share) const
  {
    Points points = m_points;
    points.push_back(on_the_way({0.5, 0.87}, {0.6, -0.95}, share));
    points.push_back(on_the_way({-0.87, -0.5}, {0.95, -0.6}, share));
    return points;
  }

private:
  Epick::Point_2 on_the_way(const Position_2& from, const Position_2& to, double share) const
  {
    return Epick::Point_2(m_size * (from.x + share * (to.x - from.x)),
                          m_size * (from.y + share * (to.y - from.y)));
  }

  double m_size;
  Points m_points;
};

template <class Dynamic>
void expect_deception_is_found_out(Dynamic& dt, const Cloud<Epick>::Points& points)
{
  const std::size_t claims = dt.classifier().hull_claims;
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_EQ(report.classified, 0u); // the exact predicates of edges do not see the loop
  EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::STUCK);
  EXPECT_EQ(dt.classifier().hull_claims, claims);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

template <class Dynamic>
void stay(Dynamic& dt, const Cloud<Epick>::Points& points, int frames = 12)
{
  expect_followed(dt, frames, [&](int) { return points; });
}

// Takes references with points at the loop's places but without a loop; then the points leave.
template <class Dynamic>
void walk_outside(Dynamic& dt, const Corner_with_a_loop& corner)
{
  stay(dt, corner.on_loop());
  expect_followed(
      dt, 20, [&](int frame) { return corner.between_loop_and_outside(double(frame + 1) / 20); });
}

TYPED_TEST(Skipping, is_not_deceived_by_a_loop_of_points_that_jump_however_small_it_is)
{
  for (const double size : {1e-4, 1.}) { // smaller than the tolerance, or larger
    const Corner_with_a_loop corner(size);
    auto dt = this->triangulation_of(corner.outside());
    stay(dt, corner.outside());
    ASSERT_TRUE(size < 1 || dt.classifier().hull_claims > 0);
    expect_deception_is_found_out(dt, corner.on_loop());
  }
}

TYPED_TEST(Skipping, is_not_deceived_by_a_loop_of_points_that_come_back_to_their_references)
{
  const Corner_with_a_loop corner(1);
  auto dt = this->triangulation_of(corner.on_loop());
  walk_outside(dt, corner);
  ASSERT_GT(dt.classifier().hull_claims, 0u);
  expect_deception_is_found_out(dt, corner.on_loop());
}

TYPED_TEST(Skipping, is_not_deceived_by_a_loop_seen_in_a_frame_that_was_given_up)
{
  const Corner_with_a_loop corner(1);
  auto dt = this->triangulation_of(corner.on_loop());
  walk_outside(dt, corner);
  const auto loop = corner.on_loop();
  *dt.classifier().fails = true;
  EXPECT_THROW(dt.update(loop.begin(), loop.end()), Failure);
  stay(dt, corner.outside(), 1);
  expect_deception_is_found_out(dt, loop);
}

// -------------------------------------------------------------------------------------------------
// Exceptions, and all that a classifier may be combined with.

// A property map that throws for one of the points.
template <class Point>
struct Faulty_map
{
  using key_type = Point;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;
  const Point* fault;

  friend reference get(const Faulty_map& map, const Point& p)
  {
    if (&p == map.fault)
      throw Failure();
    return p;
  }
};

// Throws before it has begun, or after flips.
struct Faulty_repair
{
  std::shared_ptr<int> fault = std::make_shared<int>(0);

  template <class Mender>
  void operator()(Mender& mender) const
  {
    const int now = std::exchange(*fault, 0);
    if (now == 1)
      throw Failure();
    if (now == 2) {
      mender.flip();
      throw Failure();
    }
    CGAL::Hold_and_flip_repair_2()(mender);
  }
};

// An update that may fail in any way.
template <class Dynamic>
void update_with_faults(Dynamic& dt, const std::vector<typename Dynamic::Point>& points,
                        Generator& random)
{
  const bool is_unreadable = random() % 8 == 0;
  const Faulty_map<typename Dynamic::Point> map{is_unreadable ? &points[random() % points.size()]
                                                              : nullptr};
  *dt.classifier().fails = random() % 8 == 0;
  *dt.classifier().raises_alarm = random() % 16 == 0;
  *dt.repair().fault = int(random() % 6);
  try {
    EXPECT_TRUE(dt.update(points.begin(), points.end(), map).certified);
  } catch (const Failure&) {
    if (random() % 3 == 0) {
      EXPECT_TRUE(dt.mend().certified);
    }
  }
  *dt.classifier().fails = *dt.classifier().raises_alarm = false;
  *dt.repair().fault = 0;
}

template <class Classifier, class Kernel = Epick>
using With_faults = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Audited<Classifier>,
                                                           CGAL::With_repair_2<Faulty_repair>>;

template <class Kernel, class Classifier>
void expect_it_goes_on_after_failures(const Mean_positions<Kernel>& means, int frames)
{
  const Trembling<Kernel> trembling(means, 3e-4);
  Jumps<Kernel> jumps(61);
  Generator random(62);
  auto points = trembling.at(0);
  With_faults<Classifier, Kernel> dt(points.begin(), points.end());
  for (int frame = 0; frame < frames; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    points = trembling.at(frame);
    jumps.apply(points);
    points = scaled<Kernel>(points, 1); // doubles
    update_with_faults(dt, points, random);
    if (frame % 10 == 9) {
      ASSERT_NO_FATAL_FAILURE(expect_followed(dt, points, true));
    }
  }
}

TYPED_TEST(Skipping, goes_on_after_updates_that_failed_in_any_way)
{
  for (const auto& means : all_means()) {
    SCOPED_TRACE(means.name);
    ASSERT_NO_FATAL_FAILURE((expect_it_goes_on_after_failures<Epick, TypeParam>(means, 300)));
  }
  ASSERT_NO_FATAL_FAILURE((expect_it_goes_on_after_failures<Epick, TypeParam>(many(), 200)));
}

TYPED_TEST(Skipping, is_not_deceived_by_a_loop_seen_in_a_frame_that_was_not_repaired)
{
  const Corner_with_a_loop corner(1);
  const auto loop = corner.on_loop();
  With_faults<TypeParam> dt(loop.begin(), loop.end());
  walk_outside(dt, corner);
  *dt.classifier().raises_alarm = true;
  *dt.repair().fault = 1;
  EXPECT_THROW(dt.update(loop.begin(), loop.end()), Failure);
  stay(dt, corner.outside(), 1);
  expect_deception_is_found_out(dt, loop);
}

TYPED_TEST(Skipping, knows_what_a_repair_has_changed_that_failed)
{
  const auto home = many().points;
  With_faults<TypeParam> dt(home.begin(), home.end());
  stay(dt, home);
  for (std::size_t jumper = 0; jumper < 20; ++jumper) {
    auto points = home;
    points[jumper] = CGAL::midpoint(home[jumper], home[jumper + 700]);
    *dt.repair().fault = 2;
    EXPECT_THROW(dt.update(points.begin(), points.end()), Failure);
    ASSERT_NO_FATAL_FAILURE(expect_followed(dt, home, true));
  }
}

// False if memory ran out.
template <class Dynamic>
bool update_in_scarcity(Dynamic& dt, const std::vector<typename Dynamic::Point>& points,
                        long allocations)
{
  try {
    const replaced_heap::Scarcity scarcity(allocations);
    dt.update(points.begin(), points.end());
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

TEST(Index_set, is_as_it_was_after_an_insertion_that_failed)
{
  internal::Index_set<Vertex_index> set;
  set.clear(1000);
  for (Vertex_index i(0); i < 1000; ++i) {
    try {
      const replaced_heap::Scarcity scarcity(0);
      set.insert(i);
    } catch (const std::bad_alloc&) {
      ASSERT_FALSE(set.contains(i)) << i;
      ASSERT_TRUE(set.insert(i)) << i;
    }
    ASSERT_EQ(set.size(), i + 1);
  }
}

TYPED_TEST(Skipping, goes_on_when_memory_has_run_out_for_the_references)
{
  const Trembling<Epick> motion({"uniform", Cloud<Epick>(74).uniform(300), 0}, 0, 1e-3);
  for (long allocations = 0; allocations < 40; ++allocations) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    auto dt = this->triangulation_of(motion.at(0));
    int frame = 0;
    while (frame < 12 && update_in_scarcity(dt, motion.at(0), allocations))
      ++frame;
    stay(dt, motion.at(0), 2);
    expect_followed(dt, 30, [&](int later) { return motion.at(later); });
    if (this->HasFatalFailure())
      return;
  }
}

// A point jumps, and memory runs out at each of the allocations in turn; then the point jumps on,
// or comes back.
TYPED_TEST(Skipping, goes_on_when_memory_has_run_out_for_a_repair)
{
  const auto home = Cloud<Epick>(75).uniform(600);
  for (std::size_t jumper = 0; jumper < 2; ++jumper)
    for (long allocations = 0, fails = 1; fails > 0; ++allocations) {
      SCOPED_TRACE(testing::Message() << jumper << ", " << allocations << " allocations");
      auto dt = this->triangulation_of(home);
      for (int frame = 0; frame < 12; ++frame)
        dt.update(home.begin(), home.end());
      auto points = home;
      points[jumper] = CGAL::midpoint(home[jumper], home[jumper + 200]);
      fails = !update_in_scarcity(dt, points, allocations);
      points[jumper] = CGAL::midpoint(home[jumper], home[jumper + 300]);
      ASSERT_NO_FATAL_FAILURE(expect_followed(dt, jumper % 2 == 0 ? home : points, true));
    }
}

template <class Repair>
class Skipping_with : public testing::Test
{
};

using Repairs = testing::Types<CGAL::Border_splice_repair_2, CGAL::Flip_repair_2,
                               CGAL::Relocation_repair_2, CGAL::Rebuild_repair_2>;
TYPED_TEST_SUITE(Skipping_with, Repairs);

TYPED_TEST(Skipping_with, any_repair_is_exact)
{
  const Trembling<Epick> trembling({"uniform", Cloud<Epick>(63).uniform(300), 0}, 1e-3);
  Jumps<Epick> jumps(64);
  const auto first = trembling.at(0);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Audited<Eager_classifier>,
                                         CGAL::With_repair_2<TypeParam>>
      dt(first.begin(), first.end());
  expect_followed(dt, 200, [&](int frame) {
    auto points = trembling.at(frame);
    if (frame % 60 > 20)
      jumps.apply(points);
    return points;
  });
  EXPECT_GT(frames_known_to_skip(dt.classifier()), 50u);
}

TYPED_TEST(Skipping, starts_afresh_where_a_used_classifier_is_copied)
{
  const Trembling<Epick> one({"uniform", Cloud<Epick>(65).uniform(300), 0}, 1e-6);
  const Trembling<Epick> other({"uniform", Cloud<Epick>(66).uniform(300), 0}, 1e-2);
  auto first = this->triangulation_of(one.at(0));
  expect_followed(first, 20, [&](int frame) { return one.at(frame); });
  const auto points = other.at(0);
  typename TestFixture::Dynamic second(points.begin(), points.end(), first.classifier());
  expect_followed(second, 20, [&](int frame) { return other.at(frame); });
  second = std::move(first);
  expect_followed(second, 20, [&](int frame) { return one.at(20 + frame); });
}

TEST(Skipping_of_exact_coordinates, goes_on_after_updates_that_failed_in_any_way)
{
  const Mean_positions<Epeck> means{"uniform", Cloud<Epeck>(72).uniform(100), 0};
  expect_it_goes_on_after_failures<Epeck, Eager_classifier>(means, 200);
}

TEST(Skipping_of_exact_coordinates, rests_while_they_are_no_doubles)
{
  const Trembling<Epeck> trembling({"uniform", Cloud<Epeck>(67).uniform(120), 0}, 1e-4);
  Jumps<Epeck> jumps(68);
  const auto first = trembling.at(0);
  CGAL::Dynamic_Delaunay_triangulation_2<Epeck, Audited<Eager_classifier>> dt(first.begin(),
                                                                              first.end());
  for (int frame = 0; frame < 150; ++frame) {
    auto points = trembling.at(frame);
    if (frame % 50 > 30)
      jumps.apply(points);
    points = scaled<Epeck>(points, 1);
    const bool are_doubles = frame % 20 != 19;
    if (!are_doubles)
      points[5] = Epeck::Point_2(Epeck::FT(1) / 3, points[5].y());
    EXPECT_TRUE(dt.update(points.begin(), points.end()).certified);
    EXPECT_EQ(dt.frame().positions_are_exact(), are_doubles);
    if (frame % 10 == 9) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
  EXPECT_GT(frames_known_to_skip(dt.classifier()), 60u);
}

template <class Classifier>
void expect_the_same_as_without_skipping(const Mean_positions<Epick>& means, double amplitude,
                                         double drift)
{
  const Trembling<Epick> trembling(means, amplitude, drift);
  const auto first = trembling.at(0);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier> skipping(first.begin(), first.end());
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Tireless_classifier> tireless(first.begin(),
                                                                              first.end());
  for (int frame = 0; frame < 250; ++frame) {
    const auto points = trembling.at(frame);
    const auto report = skipping.update(points.begin(), points.end());
    const auto same = tireless.update(points.begin(), points.end());
    ASSERT_EQ(report.classified, same.classified) << "frame " << frame;
    ASSERT_EQ(report.flips, same.flips) << "frame " << frame;
    ASSERT_EQ(report.rebuild_reason, same.rebuild_reason) << "frame " << frame;
    const auto are_equal = [](const Edge_2& e, const Edge_2& f) {
      return e.source == f.source && e.target == f.target && e.left == f.left && e.right == f.right;
    };
    const auto &edges = skipping.frame().edges(), &others = tireless.frame().edges();
    ASSERT_TRUE(std::equal(edges.begin(), edges.end(), others.begin(), others.end(), are_equal))
        << "frame " << frame;
  }
}

TYPED_TEST(Skipping, changes_nothing_about_any_frame)
{
  for (const auto& means : all_means())
    for (const double amplitude : {1e-5, 1e-3})
      for (const double drift : {0., 1e-4}) {
        SCOPED_TRACE(testing::Message()
                     << means.name << ", amplitude " << amplitude << ", drift " << drift);
        ASSERT_NO_FATAL_FAILURE(
            expect_the_same_as_without_skipping<TypeParam>(means, amplitude, drift));
      }
}

// The edge between the two points is safe, while both of its faces are inverted.
TYPED_TEST(Skipping, names_each_broken_edge_of_two_close_points_that_change_places)
{
  auto points = Cloud<Epick>(71).uniform(300);
  points.emplace_back(points[0].x() + 1e-4, points[0].y() + 1e-4);
  auto dt = this->triangulation_of(points);
  stay(dt, points);
  std::swap(points.front(), points.back());
  expect_followed(dt, points, true);
}

// References that have held for long are taken anew.
TYPED_TEST(Skipping, follows_what_is_calm_for_a_thousand_frames)
{
  const Mean_positions<Epick> means{"uniform", Cloud<Epick>(73).uniform(300), 0};
  this->followed(1200, {means, 1e-4});
}

} // namespace
