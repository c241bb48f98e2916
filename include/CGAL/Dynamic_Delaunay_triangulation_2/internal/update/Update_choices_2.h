// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_CHOICES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_CHOICES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_tools_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_mender_2.h>

#include <type_traits>

namespace CGAL {
template <class... Repairs>
class Chosen_repair_2;
}

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The classifier, the repair and the policy that the user has chosen, as functions. They are called
// a few times in an update, so the kernel does not depend on their types, and is compiled once for
// all of them.
template <class State>
class Update_choices_2
{
public:
  using Frame = Dynamic_frame_2<State>;
  using Classification = Dynamic_classification_2<State>;
  using Mender = Dynamic_mender_2<Repair_tools_2<State>>;

  template <class Classifier, class Repair, class Policy>
  Update_choices_2(Classifier& classifier, Repair& repair, Policy& policy)
    : m_is_exact(is_classifier_exact(classifier))
    , m_is_repair_usual(is_usual(repair))
    , m_classifier(&classifier)
    , m_repair(&repair)
    , m_policy(&policy)
    , m_classify([](void* c, const Frame& frame, Classification& classified) {
      (*static_cast<Classifier*>(c))(frame, classified);
    })
    , m_inform([](void* c, const Frame& frame) {
      inform_classifier(*static_cast<Classifier*>(c), frame);
    })
    , m_mend([](void* r, Mender& mender) { (*static_cast<Repair*>(r))(mender); })
    , m_wants_rebuild(
          [](void* p, const Frame& frame) { return static_cast<Policy*>(p)->wants_rebuild(frame); })
  {
  }

  bool is_exact() const { return m_is_exact; }

  // Whether a sample of edges may decide that everything is rebuilt, or mended in steps. Any other
  // repair has to be called once, whatever is broken.
  bool may_sample() const { return m_is_exact && m_is_repair_usual; }

  void classify(const Frame& frame, Classification& classified) const
  {
    m_classify(m_classifier, frame, classified);
  }
  // Tells the classifier of what is new.
  void inform(const Frame& frame) const { m_inform(m_classifier, frame); }
  void mend(Mender& mender) const { m_mend(m_repair, mender); }
  bool wants_rebuild(const Frame& frame) const { return m_wants_rebuild(m_policy, frame); }

private:
  template <class Repair>
  static bool is_usual(const Repair&)
  {
    return std::is_base_of_v<Hold_and_flip_repair_2, Repair>;
  }
  template <class... Repairs>
  static bool is_usual(const Chosen_repair_2<Repairs...>& repair)
  {
    return repair.visit([](const auto& chosen) { return is_usual(chosen); });
  }

  bool m_is_exact, m_is_repair_usual;
  void *m_classifier, *m_repair, *m_policy;
  void (*m_classify)(void*, const Frame&, Classification&);
  void (*m_inform)(void*, const Frame&);
  void (*m_mend)(void*, Mender&);
  bool (*m_wants_rebuild)(void*, const Frame&);
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_CHOICES_2_H
