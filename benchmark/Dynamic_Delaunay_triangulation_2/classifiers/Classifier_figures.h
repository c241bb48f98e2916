// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_CLASSIFIER_FIGURES_H
#define CLASSIFIERS_CLASSIFIER_FIGURES_H

#include "../common/Cases.h"
#include "../common/Statistics.h"
#include "Classifier_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace classifiers {

using common::Figures;

// Leaves out undefined figures, such as the precision of a classifier that names no vertex.
inline void add(const std::string& name, double value, Figures& figures)
{
  if (std::isfinite(value)) {
    figures[name] = value;
  }
}

inline double sum(const std::vector<Cost_terms>& terms, double Cost_terms::*term)
{
  return common::sum(common::values_of(terms, term));
}

// Vertices a frame.
inline void add_confusion(const Classifier_record& record, Figures& figures)
{
  const Confusion& confusion = record.confusion;
  const auto frames = static_cast<double>(record.asked);
  add("TP", confusion.true_positives / frames, figures);
  add("FP", confusion.false_positives / frames, figures);
  add("FN", confusion.false_negatives / frames, figures);
  add("TN", confusion.true_negatives / frames, figures);
  add("precision", confusion.precision(), figures);
  add("recall", confusion.recall(), figures);
  add("FDR", confusion.false_discovery_rate(), figures);
  add("edges", confusion.edge_recall(), figures);
}

// Nanoseconds a point: means, which add up.
inline void add_cost(const Classifier_record& record, double points, Figures& figures)
{
  const double divisor = points * static_cast<double>(record.terms.size());
  const double classifier =
      (sum(record.terms, &Cost_terms::classify) + sum(record.terms, &Cost_terms::after_update)) /
      divisor;
  const double repair = sum(record.terms, &Cost_terms::repair) / divisor;
  const double total = sum(record.terms, &Cost_terms::total) / divisor;
  add("CC", classifier, figures);
  add("TC", repair, figures);
  add("CC+TC", classifier + repair, figures);
  add("TCC", total, figures);
  add("rest", total - classifier - repair, figures);
  add("TC/PC", repair * points * static_cast<double>(record.frames) / record.classified, figures);
}

inline void add_validity(const Classifier_record& record, Figures& figures)
{
  if (!record.validity.empty()) {
    add("MCC_min", *std::min_element(record.validity.begin(), record.validity.end()), figures);
    add("MCC_mean", common::mean(record.validity), figures);
  }
}

inline common::Case_result result_of(const Classifier_record& record, const Figures& figures)
{
  return {figures, 1e-9 * sum(record.terms, &Cost_terms::total)};
}

inline common::Case_result classifier_result(const Recorded_frames& recording,
                                             const Classifier_record& record)
{
  const auto points = static_cast<double>(recording.front().size());
  Figures figures;
  add("points", points, figures);
  add("frames", static_cast<double>(record.frames), figures);
  add_confusion(record, figures);
  add_cost(record, points, figures);
  add_validity(record, figures);
  add("rebuilt", record.rebuilds / static_cast<double>(record.frames), figures);
  return result_of(record, figures);
}

inline common::Case_result padding_result(const Classifier_record& record)
{
  const auto frames = static_cast<double>(record.frames);
  Figures figures;
  add("frames", frames, figures);
  add("right", static_cast<double>(record.right_frames) / frames, figures);
  add("wrong", record.wrong_edges / frames, figures);
  add("padded", record.padded / frames, figures);
  add("enlargements", record.enlargements / frames, figures);
  add("rebuilt", record.rebuilds / frames, figures);
  return result_of(record, figures);
}

// `records` of always_static, always_dynamic, hybrid and key_frames, in this order.
inline common::Case_result policy_result(const Recorded_frames& recording,
                                         const std::vector<std::string>& names,
                                         const std::vector<Policy_record>& records)
{
  const auto points = static_cast<double>(recording.front().size());
  const auto frames = static_cast<double>(recording.size() - 1);
  Figures figures;
  add("points", points, figures);
  add("frames", frames, figures);
  common::Case_result result;
  for (std::size_t i = 0; i != names.size(); ++i) {
    const double nanoseconds = common::sum(records[i].nanoseconds);
    add(names[i], nanoseconds / frames / points, figures);
    result.seconds += 1e-9 * nanoseconds;
  }
  const double best = (std::min)(figures.at("always_static"), figures.at("always_dynamic"));
  add("of_best", figures.at("hybrid") / best, figures);
  add("dyn_rebuilt", records[1].rebuilds / frames, figures);
  add("hyb_rebuilt", records[2].rebuilds / frames, figures);
  result.figures = figures;
  return result;
}

} // namespace classifiers

#endif // CLASSIFIERS_CLASSIFIER_FIGURES_H
