// A sweep into FILE.h5, chunk by chunk.
#pragma once

#include <string>

#include "cromer/cluster/rows_file.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// Lays the file out, or with `resume` opens what there is.
Result<RowsFile> open_sweep_file(const SweepPlan& plan, const std::string& path, bool resume,
                                 const std::string& command, const Watch& watch);

/// Makes what the file lacks. The result has the rows where they fit in memory, else none. An Error comes
/// with what is finished kept in the file.
Result<SweepResult> fill_sweep_file(RowsFile& file, SweepPlan plan, const SweepOptions& options,
                                    const ChunkMaker& make, const Watch& watch);

}  // namespace cromer::core
