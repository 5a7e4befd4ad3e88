#include "cli/sweep/contradictions.hpp"

#include "lib/export/sweep/hdf5.hpp"

namespace loadpath::cli {

using exports::Hdf5File;

std::string contradiction(const SweepOptions& options) {
  if (!options.status.empty() && !(options.file + options.out).empty())
    return "'--status' is about a folder as it is: it takes neither a project file nor --out";
  const int aims = !options.minimise.empty() + !options.maximise.empty() + !options.seek.empty() +
                   (options.influence || options.sobol != 0);
  if (aims > 1) return "use one of '--minimise', '--maximise', '--seek' and '--influence' at a time";
  if (aims == 1 && (!options.out.empty() || !options.csv.empty() || !options.hdf5.empty() || !options.pareto.empty()))
    return "'--out', '--csv', '--hdf5' and '--pareto' are about a sweep over all points";
  if (!options.seek.empty() + (options.influence || options.sobol != 0) > 0 && options.quantile > 0.0)
    return "'--quantile' is about designs: it does not go with --seek or --influence";
  if (options.minimise.empty() && options.maximise.empty() && options.pareto.empty() && !options.such_that.empty())
    return "'--such-that' is a constraint of --minimise, --maximise or --pareto";
  if (options.out.empty() && (options.resume || !options.shard.empty() || !options.merge.empty() || options.no_columns))
    return "'--resume', '--shard', '--merge' and '--no-columns' are about a folder: name it with --out DIR";
  if (!options.merge.empty() && (!options.shard.empty() || options.resume))
    return "'--merge' puts shards together; it solves none";
  if (!options.csv.empty() && (options.resume || !options.merge.empty()))
    return "'--csv' has every point from the first: it does not go with --resume or --merge";
  if (!options.hdf5.empty() && (options.resume || !options.merge.empty() || !options.shard.empty()))
    return "'--hdf5' has every point of the sweep: it does not go with --resume, --shard or --merge";
  if (!options.hdf5.empty() && !Hdf5File::is_there())
    return "this program was built without HDF5 (LOADPATH_HDF5); '--out DIR' writes columns that numpy reads";
  return {};
}

}  // namespace loadpath::cli
