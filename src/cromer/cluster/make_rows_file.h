// Work into a file, on the ranks where there are some and on this machine's processors where not.
#pragma once

#include "cromer/cluster/ranks.h"
#include "cromer/cluster/rows_file.h"

namespace cromer {

/// Makes what the file lacks and closes it, whichever way that ends; `ranks` may be null. Only for the first
/// rank; the others help(). An Error is the disk's or a rank's: what is finished is kept.
Result<ChunksEnd> make_rows_file(RowsFile& file, const ChunkedRows& work, Ranks* ranks, int threads,
                                 const Watch& watch);

}  // namespace cromer
