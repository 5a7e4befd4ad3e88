// The points of a sweep as one HDF5 file: a dataset of doubles in SI for each input and result, with the content of a
// manifest as attributes: of the file `program`, `project`, `input` (everything that the numbers follow from, as
// CRC-64), `seed`, `points`; of a dataset `name`, `unit`, `shown_in`, `number` (its place in the order), `words` (of
// a choice, whose indices it contains). The same points make the same bytes.
#pragma once

#include "lib/export/sweep/store.hpp"

#include <filesystem>
#include <memory>

namespace loadpath::exports {

class Hdf5File {
 public:
  /// Whether the program was built with HDF5 (LOADPATH_HDF5).
  static bool is_there();

  /// A new file for all points of the plan. A Fault if it cannot be written.
  static Outcome<Hdf5File> create(const std::filesystem::path& path, const SweepPlan& plan, const StoredSweep& sweep);
  /// The next points. A Message where the file cannot be written.
  Message append(const project::SolvedBlock& block);
  /// Ensures that everything appended is in the file.
  Message close();

  Hdf5File();
  ~Hdf5File();
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace loadpath::exports
