// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RECORDED_MOTION_H
#define SCENARIO_RUNNER_RECORDED_MOTION_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/space/Cell_3.h"
#include "scenario_runner/Text_input.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

// The text that a file has as the id of a point, by the number that stands for it.
using Point_name_list = std::vector<std::string>;

// What is wrong with a frame, and in which line of its file.
struct Frame_flaw
{
  std::string message;
  std::size_t line;
};

// Ids ascending, each once; points in the same order.
struct Recorded_frame
{
  double time = 0.0;
  std::vector<std::int64_t> ids;
  std::vector<Point> points;
  std::optional<Cell> cell{}; // none where its box is not periodic
  std::int64_t number = 0;    // in the file, ascending: of the frame, or of the time step
  std::shared_ptr<const Point_name_list> names{}; // of all frames; null where ids are numbers
  // The third coordinates: 0 where the file has none, NaN where it has something else than a finite
  // number. Empty if all are 0.
  std::vector<double> heights{};
  std::optional<Cell_3> box{}; // of which the cell is a section; none where it is not periodic
  // Why it cannot be in the plane, or in space; mostly it can.
  std::optional<Frame_flaw> flaw_in_plane{};
  std::optional<Frame_flaw> flaw_in_space{};
};

using Recording = std::vector<Recorded_frame>;

// Whether the numbers of frames ascend, and whether all frames have the same ids.
bool do_numbers_ascend(const Recording& recording);
bool has_fixed_population(const Recording& recording);

// \throws Scenario_error if a frame cannot be in the plane: the section of its box is flat.
void check_in_plane(const std::string& file, const Recording& recording);

// A motion, in the plane or in space, that shows the frames of a recording, one after another.
template <class Base>
class Played_motion : public Base
{
public:
  Played_motion(std::string name, Recording recording)
    : Base(std::move(name))
    , m_recording(std::move(recording))
    , m_has_numbers(do_numbers_ascend(m_recording))
  {
    if (m_recording.empty()) {
      throw std::invalid_argument("a recorded motion needs at least one frame");
    }
  }

  const std::vector<std::int64_t>& ids() const override { return frame().ids; }
  double time() const override { return frame().time; }
  std::optional<std::int64_t> frame_number() const override
  {
    return m_has_numbers ? std::optional(frame().number) : std::nullopt;
  }
  const std::vector<std::string>* names() const override { return frame().names.get(); }
  bool has_fixed_population() const override { return scenario::has_fixed_population(m_recording); }
  bool population_changed() const override { return m_population_changed; }
  std::size_t frames() const override { return m_recording.size() - 1; }

  bool advance(const Neighbor_edges&) override
  {
    if (m_current + 1 == m_recording.size()) {
      return false;
    }
    m_population_changed = m_recording[m_current].ids != m_recording[m_current + 1].ids;
    ++m_current;
    return true;
  }

protected:
  const Recorded_frame& frame() const { return m_recording[m_current]; }
  const Recording& all_frames() const { return m_recording; }

private:
  Recording m_recording;
  bool m_has_numbers; // which ascend
  std::size_t m_current = 0;
  bool m_population_changed = false;
};

// A recording in the plane, or its projection onto the plane.
class Recorded_motion : public Played_motion<Motion>
{
public:
  using Played_motion<Motion>::Played_motion;

  const std::vector<Point>& points() const override { return frame().points; }
  std::optional<Cell> cell() const override { return frame().cell; }
};

// What a table's columns are, where their names do not tell: of each pair the first is `frame`,
// `time`, `id`, `x`, `y` or `z`, the second the title of that column; or the first words alone, in
// the order of the columns, and a dash for any other column.
struct Table_columns
{
  std::vector<std::pair<std::string, std::string>> by_title{};
  std::vector<std::string> in_order{};

  bool empty() const { return by_title.empty() && in_order.empty(); }
};

// Columns from a text as `frame,id,-,x,y` or `frame=t,id=label`.
// \throws std::invalid_argument, with what is allowed
Table_columns table_columns(const std::string& text);

// Tables of positions, a row for a point in a frame, in the dialects of R, pandas, PeTrack and
// others. `frame`, `id`, `x`, `y` and, if they are there, `time` and `z` are looked up by name in a
// header, further columns are ignored. Rows come in any order; lines that begin with # are
// comments. \throws Scenario_error, in which the text is called `file`
Recording parse_csv(const std::string& file, std::string_view text,
                    const Table_columns& columns = {});

// The text dumps of the molecular dynamics program LAMMPS. Coordinates are taken from the first of
// the column pairs `x y`, `xu yu`, `xs ys`, `xsu ysu` that is there, and from the third column of
// its kind, as `z`, if it is there; the last two are fractions of the box. Atoms and columns come
// in any order, further columns are ignored. A box that is periodic is the frame's box, also if it
// is tilted, and where it is so in x or y its section is the frame's cell. \throws Scenario_error,
// in which the text is called `file`
Recording parse_lammps_dump(const std::string& file, std::string_view text);

// XYZ files, extended or not. Points are known by the property `id`, or else by their places in the
// frame. A Lattice that is periodic is the frame's box, and where it is so in its first or second
// vector its section is the frame's cell.
// \throws Scenario_error, in which the text is called `file`
Recording parse_xyz(const std::string& file, std::string_view text);

// The data files of MTrackJ. A point is known by its track, and a frame by its time.
// \throws Scenario_error, in which the text is called `file`
Recording parse_mtrackj(const std::string& file, std::string_view text);

enum class Recording_format { TABLE, LAMMPS_DUMP, XYZ, MTRACKJ };

// The extensions of recordings, for messages.
inline const std::string recording_extensions =
    ".csv, .tsv, .txt, .pp, .lammpstrj, .dump, .xyz, .extxyz or .mdf";

// The name of a file without the extension of what compressed it.
std::filesystem::path without_gz(const std::filesystem::path& file);

// The format by the extension of a file, compressed or not; nothing if that does not tell.
std::optional<Recording_format> format_by_name(const std::string& path);

// Parses a text of any of these formats: its beginning tells which, or else the name of its file.
// \throws Scenario_error, in which the text is called `file`
Recording parse_recording(const std::string& file, std::string_view text,
                          const Table_columns& columns = {});

// Read a file; the path - stands for standard input.
bool is_standard_input(const std::string& path);
Recording read_recording(const std::string& path, const Table_columns& columns = {});
Recording read_csv_motion(const std::string& path);
Recording read_lammps_dump(const std::string& path);
Recording read_xyz_motion(const std::string& path);

} // namespace scenario

#endif // SCENARIO_RUNNER_RECORDED_MOTION_H
