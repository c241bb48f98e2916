// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_TRIANGULATION_BASE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_TRIANGULATION_BASE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <initializer_list>
#include <istream>
#include <iterator>
#include <ostream>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What all triangulations of moving points have in common, in the plane and in space: ids, calls for
one point and for ranges, which do what the calls for iterators do, and checkpoints. Programs use it
as a part of these classes alone.

\tparam Derived the class of triangulations.
\tparam PointType its points.
\tparam Report what its calls return that change points.
*/
template <class Derived, class PointType, class Report>
class Dynamic_triangulation_base
{
protected:
  /// \cond
  using Identity_map = boost::typed_identity_property_map<PointType>;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;
  template <class Map>
  using If_map = Dynamic_Delaunay_triangulations_2::internal::If_map<Map>;
  template <class Iterator>
  using First_of = Dynamic_Delaunay_triangulations_2::internal::First_of<Iterator>;
  template <class Iterator>
  using Second_of = Dynamic_Delaunay_triangulations_2::internal::Second_of<Iterator>;
  /// \endcond

public:
  /// \name Types
  /// @{

  /// a point.
  using Point = PointType;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// what a call returns that changes points.
  using Update_report = Report;

  /// @}
  /// \name Motion
  /// @{

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class PointMap = Identity_map, class = If_range<Range>,
            class = If_map<PointMap>>
  Report update(const Range& range, const PointMap& point_map = PointMap())
  {
    return derived().update(std::begin(range), std::end(range), point_map);
  }

  /// moves the points of a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>>
  Report move(const Range& range, const IdMap& id_map = IdMap(),
              const PointMap& point_map = PointMap())
  {
    return derived().move(std::begin(range), std::end(range), id_map, point_map);
  }

  /// moves one point.
  Report move(size_type id, const Point& point)
  {
    const std::pair<size_type, Point> mover(id, point);
    return derived().move(&mover, &mover + 1);
  }

  /// @}
  /// \name Insertion and Removal
  /// @{

  /// inserts a point, and returns its id, the smallest free one. Throws what the insertion of a
  /// range throws; then nothing has changed.
  size_type insert(const Point& point)
  {
    size_type id = 0;
    insert(&point, &point + 1, &id);
    return id;
  }

  /// inserts the points of a range. Their ids are written to `ids` first, in the same order, if it
  /// is given.
  template <class InputIterator, class OutputIterator = Emptyset_iterator>
  Report insert(InputIterator first, InputIterator beyond, OutputIterator ids = OutputIterator())
  {
    return derived().insert(first, beyond, Identity_map(), ids);
  }

  /// inserts the points of a range with `begin()` and `end()`.
  template <class Range, class OutputIterator = Emptyset_iterator, class = If_range<Range>>
  Report insert(const Range& range, OutputIterator ids = OutputIterator())
  {
    return derived().insert(std::begin(range), std::end(range), Identity_map(), ids);
  }

  /// reads the points by `point_map` from the values of a range with `begin()` and `end()`.
  template <class Range, class PointMap, class OutputIterator, class = If_range<Range>>
  Report insert(const Range& range, const PointMap& point_map, OutputIterator ids)
  {
    return derived().insert(std::begin(range), std::end(range), point_map, ids);
  }

  /// removes a point; its id is free from then on. Throws what the removal of a range throws; then
  /// nothing has changed.
  Report remove(size_type id) { return derived().remove(&id, &id + 1); }

  /// removes the points whose ids are in a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Report remove(const Range& ids)
  {
    return derived().remove(std::begin(ids), std::end(ids));
  }

  /// removes the points with these ids.
  Report remove(std::initializer_list<size_type> ids)
  {
    return derived().remove(ids.begin(), ids.end());
  }

  /// @}
  /// \name Points and Ids
  /// @{

  /// the number of points, coincident ones included.
  size_type number_of_points() const { return derived().point_ids().number_of_points(); }
  /// one more than the largest id ever in use. It never decreases.
  size_type number_of_ids() const { return derived().point_ids().number_of_ids(); }
  /// whether a point has this id.
  bool has_id(size_type id) const { return derived().point_ids().is_taken(id); }

  /// the id of the representative of this point: of all points that coincide with it, the one that
  /// was there first.
  /// \throws Unknown_id_error_2 if no point has this id.
  size_type representative(size_type id) const
  {
    return derived().point_ids().representative(vertex_of(id));
  }

  /// @}
  /// \name Checkpoints
  /// Writes and reads the triangulation as a file, \ref DynamicDelaunayTriangulation2Checkpoints. A
  /// run continues from a checkpoint as if it had not been interrupted: equal calls have equal
  /// results. `Point` has to be the point of a kernel. Coordinates have to be doubles, or fractions
  /// of integers as those of `Exact_predicates_exact_constructions_kernel`. Other types do not
  /// compile, since they may hold more than a checkpoint would keep.
  /// @{

  /// writes the triangulation, the ids of its points, in periodic space the cell, all numbers of
  /// vertices and faces or cells, and whether it is certified. Not written are the settings and
  /// what they remember, and the user's data in vertices and faces. Cost: linear, about 150 bytes a
  /// point in the plane, and some 250 in space.
  /// \throws Checkpoint_error_2 if the stream fails, after which the written part is unusable;
  /// also, before anything is written, if the last call has left points without a vertex, or in
  /// space without cells, because an exception ended it.
  void write_checkpoint(std::ostream& out) const
  {
    derived().write_file(out, derived().checkpoint_subject(), [](auto&) {});
  }

  /// replaces everything but the settings by what a file has. In periodic space the cell is
  /// replaced, too, and may become a slab or cease to be one. The user's data are as in new
  /// vertices and faces; property maps stay valid. A classifier is told that everything is new.
  ///
  /// The file is validated. Each number and id must occur exactly once. In the plane the faces must
  /// be a triangulated sphere with all points, or in a periodic cell a torus that covers the cell
  /// once; in space the cells must fit together and cover it once. A triangulation that is marked
  /// as certified, as all are in space, must be Delaunay by exact predicates. Reads exactly what
  /// was written, and leaves the rest of the stream unread. Cost: linear, in space that of sorting
  /// the facets; memory in proportion to what is read, in addition to what this triangulation uses.
  /// \throws Checkpoint_error_2 if the file is refused. Whatever is thrown, nothing changes, unless
  /// the visitor throws it while it is told what changes.
  void read_checkpoint(std::istream& in)
  {
    derived().read_file(
        in, derived().checkpoint_subject(), [](auto&, const auto&) {}, [] {});
  }

  /// writes a checkpoint, whatever mode CGAL's `set_mode()` has given to the stream. Where
  /// `write_checkpoint()` would throw `Checkpoint_error_2`, the stream fails (`failbit`).
  friend std::ostream& operator<<(std::ostream& out, const Derived& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::write_to_stream(out, dt);
  }

  /// skips white space, then reads a checkpoint. Where `read_checkpoint()` would throw
  /// `Checkpoint_error_2`, the stream fails (`failbit`), and the triangulation does not change.
  friend std::istream& operator>>(std::istream& in, Derived& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::read_from_stream(in, dt);
  }

  /// @}

protected:
  /// \cond
  Derived& derived() { return static_cast<Derived&>(*this); }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  void check_id(size_type id) const
  {
    if (!has_id(id))
      throw Unknown_id_error_2(id, number_of_ids());
  }
  // The vertex of a point. Throws if there is none.
  auto vertex_of(size_type id) const
  {
    check_id(id);
    return derived().point_ids().vertex(Dynamic_Delaunay_triangulations_2::Point_id(id));
  }
  /// \endcond
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_TRIANGULATION_BASE_H
