#include "cli/sweep/contradictions.hpp"

#include "lib/export/sweep/hdf5.hpp"

namespace loadpath::cli {

using exports::Hdf5File;

std::string contradiction(const SweepOptions& options) {
  if (!options.status.empty() && !(options.file + options.out).empty())
    return "'--status DIR' only reads a folder: leave out the project file and --out";
  const int aims = !options.minimise.empty() + !options.maximise.empty() + !options.seek.empty() +
                   (options.influence || options.sobol != 0);
  if (aims > 1) return "use one of '--minimise', '--maximise', '--seek' and '--influence' at a time";
  if (aims == 1 && (!options.out.empty() || !options.csv.empty() || !options.hdf5.empty() || !options.pareto.empty()))
    return "'--out', '--csv', '--hdf5' and '--pareto' need a sweep over all points: leave out the search";
  if (!options.seek.empty() + (options.influence || options.sobol != 0) > 0 && options.quantile > 0.0)
    return "'--quantile' cannot be given with --seek or --influence";
  if (options.minimise.empty() && options.maximise.empty() && options.pareto.empty() && !options.such_that.empty())
    return "'--such-that' needs --minimise, --maximise or --pareto";
  if (options.out.empty() && (options.resume || !options.shard.empty() || !options.merge.empty() || options.no_columns))
    return "'--resume', '--shard', '--merge' and '--no-columns' need a folder: add --out DIR";
  if (!options.merge.empty() && (!options.shard.empty() || options.resume))
    return "'--merge' only joins shards: leave out --shard and --resume";
  if (!options.csv.empty() && (options.resume || !options.merge.empty()))
    return "'--csv' writes every point from the first: it cannot be given with --resume or --merge";
  if (!options.hdf5.empty() && (options.resume || !options.merge.empty() || !options.shard.empty()))
    return "'--hdf5' writes every point of the sweep: it cannot be given with --resume, --shard or --merge";
  if (!options.hdf5.empty() && !Hdf5File::is_there())
    return "this program was built without HDF5 (LOADPATH_HDF5); '--out DIR' writes columns that numpy reads";
  return {};
}

}  // namespace loadpath::cli
