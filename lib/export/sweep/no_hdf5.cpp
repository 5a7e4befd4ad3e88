// A build without HDF5: the program reports it before it solves anything.
#include "lib/export/sweep/hdf5.hpp"

namespace loadpath::exports {

struct Hdf5File::Parts {};

Hdf5File::Hdf5File() = default;
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;

bool Hdf5File::is_there() { return false; }
Outcome<Hdf5File> Hdf5File::create(const std::filesystem::path&, const SweepPlan&, const StoredSweep&) {
  return Fault{0, 1, say("this program was built without HDF5"), say("build it with -DLOADPATH_HDF5=ON")};
}
Message Hdf5File::append(const project::SolvedBlock&) { return {}; }
Message Hdf5File::close() { return {}; }

}  // namespace loadpath::exports
